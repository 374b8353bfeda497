/// Judges the claims of Weiler and Atherton's algorithm.
#pragma once

#include "grade/claims.h"

namespace vidno::grading {

class WeilerAthertonJudge : public Claims {
public:
    using Claims::Claims;

    /// Judges an event; call it before the state applies the event. Throws False.
    void take(const EventView& event, std::uint64_t step) {
        step_ = step;
        event.visit([this](const auto& e) { judge(e); });
    }
    /// Judges the visible regions together and the final picture; call it after the last event. Throws False.
    void finish();

    /// Empty: claims are about polygons only.
    std::string place() const { return ""; }

private:
    void judge(const auto&) const {}  // the other events claim nothing, or only what one of these claims too
    void judge(const event::Fault& e);
    void judge(const event::Plane& e) { judge_plane(e); }
    void judge(const event::Depth& e) const;
    void judge(const event::CutToArea& e) const;
    void judge(const event::PushList& e) const;
    void judge(const event::Beside& e) const;
    void judge(const event::Clipped& e) const;
    void judge(const event::Split& e) const;
    void judge(const event::Behind& e);
    void judge(const event::Order& e);
    void judge(const event::Show& e);
    void judge(const event::Row& e) const;
    void judge(const event::Paint& e);

    void judge_vertices(int polygon, const RegionLoops& region, const std::string& what) const;
    void judge_region(int polygon, const RegionLoops& region, const std::string& what) const;
    void judge_parts(const event::Clipped& e) const;
    bool crosses(const RegionLoops& region, double y, double left, double right) const;
    std::string not_shown() const;
    void judge_order(double z, double other, Sign order);

    std::uint64_t step_ = 0;
    std::string lost_;       // where an outline did not close, in words; empty if all did
    double shown_ = 0;       // the sum of the areas of visible regions
    bool in_floats_ = true;  // the visible regions
    bool tells_regions_ = false, paints_ = false;
};

}  // namespace vidno::grading
