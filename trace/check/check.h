/// Check: runs with every decision held against the truth.
#pragma once

#include "check/decision_count.h"
#include "check/findings.h"
#include "run/floating_horizon_run.h"
#include "run/run.h"

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
/// was snapped. `hear` hears every step; `findings`, if there are to be some, are drawn up of it: under `filtered`, `grid` and `exact` of
/// the run under `exact`.
CheckReport check_run(
    const RunRequest& request, const Picture& right, const HearEvent& hear = [](const auto&) {},
    FindingList* findings = nullptr);

struct FloatingHorizonCheckReport : DecisionReport {
    DrawnLines lines;
    /// The columns of all curves. In a wrong one a hidden curve is drawn, or a visible one is not.
    std::uint64_t columns = 0, wrong_columns = 0;

    bool found_something() const { return wrong_columns > 0 || any_wrong(); }
};

/// Runs the curves with every decision of Visibility, and under `float`, `double` and `bits` every comparison, held against
/// the exact one along the path that was taken; the lines, against those of the corrected procedures in exact arithmetic.
/// `hear` hears each event of level `signs`.
FloatingHorizonCheckReport check_run(
    const FloatingHorizonRequest& request, const HearEvent& hear = [](const auto&) {}, FindingList* findings = nullptr);

}  // namespace vidno
