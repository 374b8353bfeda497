/// WorkedCurves: everything that someone who works a surface by hand writes down, taken from the trace of the exact
/// run.
#pragma once

#include <map>
#include <vector>

#include "floating_horizon_moment.h"

namespace vidno::figures {

/// Where a curve meets a horizon.
struct WorkedMeeting {
    ValuePoint point;
    bool upper;  // else the lower one
};

struct WorkedCurve {
    std::map<int, Value> heights{};  // over its columns
    std::map<int, VisibilityFlag> flags{};
    std::vector<WorkedMeeting> meetings{};
    FloatingHorizonState::Heights upper{}, lower{};  // after the curve and the right side edge to it, if there is one
    std::uint64_t step = 0;                          // at which it began
};

class WorkedCurves {
public:
    /// Runs the surface with the corrected procedures under `exact`.
    explicit WorkedCurves(const Surface& surface);
    WorkedCurves(const WorkedCurves&) = delete;
    WorkedCurves& operator=(const WorkedCurves&) = delete;

    const Surface& surface() const { return header_.scene; }
    const CurveScene& scene() const { return surface().curves; }
    const std::vector<WorkedCurve>& curves() const { return curves_; }
    const FloatingHorizonMoment& end() const { return end_; }

private:
    void hear(const event::Curve&);
    void hear(const event::Height& e) { curves_.back().heights[e.x] = e.y; }
    void hear(const event::Visibility& e) { curves_.back().flags[e.x] = e.flag; }
    void hear(const event::Intersection& e);
    void hear(const event::SideEdge& e);
    void hear(const auto&) {}
    /// As those after the current curve.
    void keep_horizons();

    FloatingHorizonHeader header_;
    FloatingHorizonMoment end_;
    std::vector<WorkedCurve> curves_;
};

}  // namespace vidno::figures
