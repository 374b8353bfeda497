/// Check: runs in which every decision is compared with the truth.
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

/// What the scene should show, by the picture rule or by the method's variation of it.
Picture right_picture(const AdmittedScene& scene, Method method = Method::zbuffer);

/// Runs the request's scene. Under `filtered`, `grid` and `exact` the decisions are compared with those of a run under
/// `exact`, until they diverge. The pixels are compared with `right`, the right picture of the scene, or of the scene
/// before it was snapped. `hear` hears every step. `findings`, if given, are collected from the run; under `filtered`,
/// `grid` and `exact`, from the run under `exact`.
CheckReport check_run(
    const RunRequest& request, const Picture& right, const HearEvent& hear = [](const auto&) {},
    FindingList* findings = nullptr);

struct FloatingHorizonCheckReport : DecisionReport {
    DrawnLines lines;
    /// The columns of all curves. A column is wrong if a hidden curve is drawn there, or a visible one is not.
    std::uint64_t columns = 0, wrong_columns = 0;

    bool found_something() const { return wrong_columns > 0 || any_wrong(); }
};

/// Runs the curves and compares every decision of Visibility, and under `float`, `double` and `bits` every comparison,
/// with the exact one along the path that was taken. Compares the lines with those of the corrected procedures in exact
/// arithmetic. `hear` hears each event of level `signs`.
FloatingHorizonCheckReport check_run(
    const FloatingHorizonRequest& request, const HearEvent& hear = [](const auto&) {}, FindingList* findings = nullptr);

}  // namespace vidno
