/// Judges the claims of the floating horizon.
#pragma once

#include <map>
#include <set>

#include "grade/claims.h"
#include "grade/curve_truth.h"
#include "replay/floating_horizon_state.h"

namespace vidno::grading {

class FloatingHorizonJudge {
public:
    FloatingHorizonJudge(const CurveTruth& truth, const FloatingHorizonState& state, std::set<Difference>& differences,
                         const Words& words)
        : say(words), truth_(truth), state_(state), differences_(differences) {}

    /// Notes where the program is done with each curve. Without this call no curve is judged to be done.
    void foresee(const std::vector<Event>& events) {
        last_steps_ = last_steps<event::Curve>(events, [](const auto& e) { return e.curve; });
    }
    /// Judges an event; call it before the state applies the event. Throws False.
    void take(const EventView& event, std::uint64_t step) {
        step_ = step;
        event.visit([this](const auto& e) { judge(e); });
        last_step_ = step;
    }
    /// Judges the last curve, and those that never came; call it after the last event. Throws False.
    void finish();

    /// The index of the current curve, in words; empty if there is none.
    std::string place() const { return state_.values().curve ? std::to_string(*state_.values().curve) : ""; }

    /// The parts that the events draw of each curve.
    const std::map<int, DrawnParts>& drawn() const { return drawn_; }

private:
    using Side = CurveTruth::Side;
    using When = CurveTruth::When;

    void judge(const auto&) const {}  // the other events claim nothing, or only what one of these claims too
    void judge(const event::Horizons& e) const;
    void judge(const event::Curve& e);
    void judge(const event::SideEdge& e) const;
    void judge(const event::Visibility& e) const;
    void judge(const event::Intersection& e) const;
    void judge(const event::DrawLine& e);
    void judge(const event::Horizon& e);
    void judge(const event::Height& e) const;
    void judge(const event::Raise& e) { judge_raised(Side::upper, e.x, e.y.number, false); }
    void judge(const event::Lower& e) { judge_raised(Side::lower, e.x, e.y.number, false); }

    void leave_curve(int curve, std::uint64_t begun, bool is_farthest) const;
    void judge_drawn(int curve) const;
    void judge_claimed_horizons(int curve) const;
    void judge_start(Side side, const std::optional<Value>& start) const;
    void judge_column(int x) const;
    void judge_height(double x, double y) const;
    void judge_raised(Side side, int x, double y, bool is_edge);
    std::string end_in_words(const std::optional<std::pair<Sample, Sample>>& ends, bool is_left) const;
    /// Why the current curve has no point at x, and why it is not visible there.
    std::string reach_in_words(double x) const;
    std::string why_not_seen(double x) const;
    std::string horizon_in_words(Side side, int x, const std::optional<double>& y) const;
    int curve() const { return *state_.values().curve; }

    const Words& say;
    const CurveTruth& truth_;
    const FloatingHorizonState& state_;  // before the current event
    std::set<Difference>& differences_;
    std::map<int, DrawnParts> drawn_;
    bool tells_horizons_ = false;
    LastSteps last_steps_;
    std::uint64_t step_ = 0, last_step_ = 0;
    std::uint64_t begun_ = 0;  // the step at which the current curve came
    int farthest_ = 0;         // of the curves that have come
};

}  // namespace vidno::grading
