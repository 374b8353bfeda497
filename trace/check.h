/// Check: runs with every decision held against the truth.
#pragma once

#include "decision_count.h"
#include "run.h"

namespace vidno {

struct CheckReport : DecisionReport {
    Picture picture;
    std::uint64_t wrong_pixels = 0;  // against the picture rule

    bool found_something() const { return wrong_pixels > 0 || any_wrong(); }
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
