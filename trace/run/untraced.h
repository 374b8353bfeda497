/// Runs without a trace: one translation unit for a few kernels, each compiled for its own numbers.
#pragma once

#include "run/run.h"

namespace vidno {

/// The request has no sink and is no mistake's.
Picture untraced_run(const RunRequest&);

/// A told run whose events nobody hears.
Picture told_to_nobody(RunRequest);

// By the kernels, the methods of the course

Picture untraced_float(const RunRequest&);
Picture untraced_double(const RunRequest&);
Picture untraced_bits(const RunRequest&);
Picture untraced_depth(const RunRequest&);     // zbuffer only
Picture untraced_filtered(const RunRequest&);  // the corrected edition only
Picture untraced_grid(const RunRequest&);      // the corrected edition only, of a snapped scene (snapped_scene.h)
Picture untraced_exact(const RunRequest&);

/// The Warnock family (vidno/family/family.h), of a scene that the method takes; the corrected edition only.
Picture untraced_family_float(const RunRequest&);
Picture untraced_family_double(const RunRequest&);
Picture untraced_family_bits(const RunRequest&);
Picture untraced_family_filtered(const RunRequest&);
Picture untraced_family_grid(const RunRequest&);  // of a snapped scene
Picture untraced_family_exact(const RunRequest&);

/// Weiler and Atherton's algorithm (vidno/weiler_atherton.h); the corrected edition only.
Picture untraced_weiler_atherton_float(const RunRequest&);
Picture untraced_weiler_atherton_double(const RunRequest&);
Picture untraced_weiler_atherton_bits(const RunRequest&);
Picture untraced_weiler_atherton_filtered(const RunRequest&);
Picture untraced_weiler_atherton_exact(const RunRequest&);

}  // namespace vidno
