/// Check: runs with every decision held against the truth.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "event.h"
#include "run.h"

namespace vidno {

/// Of one procedure, calls from it not included.
struct ProcedureVerdicts {
    Procedure procedure{};
    std::uint64_t decisions = 0;
    std::uint64_t wrong_for_operands = 0;      // the operation rounded
    std::uint64_t wrong_for_scene = 0;         // that, or its operands had drifted
    std::uint64_t undefined = 0;               // no truth: after a wrong turn
    std::optional<std::uint64_t> first_wrong;  // the step, from 1, of level `signs` that tells it or follows it
};

struct CheckReport {
    Picture picture;
    std::vector<ProcedureVerdicts> procedures{};  // those that decided, in the order of Procedure
    std::uint64_t intersections = 0;              // computed when clipping, under `float`, `double`, `bits`
    double farthest_off = 0;                      // of them, from the exact one, in pixels
    std::array<std::uint64_t, filter_stage_names.size()> decided_by{};  // under `filtered`: how many at each stage
    std::uint64_t wrong_pixels = 0;                                     // against the picture rule

    /// Whether any decision or pixel is wrong.
    bool found_something() const;
};

/// What the scene should show: by the picture rule, or by what the method varies of it.
Picture right_picture(const Scene& scene, Method method = Method::zbuffer);

/// Runs the request's scene. Under `filtered`, `grid` and `exact` the decisions are compared with those of a run under
/// `exact`, until they part. The pixels are held against the right picture: of the same scene, or of what it was before it
/// was snapped. `hear` is told every step.
CheckReport check_run(
    const RunRequest& request, const Picture& right,
    const std::function<void(const Event&)>& hear = [](const auto&) {});

/// The same run told to the request's writer: each decision with its truth, each wrong one followed by `disagree`.
Picture trace_checked(const RunRequest& request);

/// Traces a run to the end of its file, checked or not; false if the writer's limit ended it, so that it is partial.
bool write_trace(RunRequest request, TraceWriter& writer, bool checked);

}  // namespace vidno
