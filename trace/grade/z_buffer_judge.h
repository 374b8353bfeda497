/// Judges the claims of the Z-buffer.
#pragma once

#include <map>

#include "grade/claims.h"

namespace vidno::grading {

class ZBufferJudge : public Claims {
public:
    using Claims::Claims;

    /// Notes where the program is done with each polygon. Without this call no polygon is judged to be done.
    void foresee(const std::vector<Event>& events) {
        last_steps_ = last_steps<event::Polygon>(events, [](const auto& e) { return e.polygon.index; });
    }
    /// Judges an event; call it before the state applies the event. Throws False.
    void take(const EventView& event, std::uint64_t step) {
        step_ = step;
        event.visit([this](const auto& e) { judge(e); });
        last_step_ = step;
    }
    /// Judges the last polygon and the final picture; call it after the last event. Throws False.
    void finish();

    /// The index of the current polygon, in words; empty if there is none.
    std::string place() const { return polygon_ ? std::to_string(*polygon_) : ""; }

private:
    struct Cell {
        std::optional<double> z;              // the program's depth
        int polygon = SeenPixel::background;  // the polygon that it shows
    };

    void judge(const auto&) const {}  // the other events claim nothing, or only what one of these claims too
    void judge(const event::Fault& e) const { judge_fault(e); }
    void judge(const event::Plane& e) { judge_plane(e); }
    void judge(const event::Clear& e);
    void judge(const event::Polygon& e);
    void judge(const event::Depth& e) const;
    void judge(const event::Edge& e) const;
    void judge(const event::Extent& e) const;
    void judge(const event::Scanline& e) const;
    void judge(const event::Leave& e) const;
    void judge(const event::AelAdd& e) const;
    void judge(const event::AelStep& e) const;
    void judge(const event::AelSort& e) const;
    void judge(const event::AelDrop& e) const;
    void judge(const event::ShownLine& e);
    void judge(const event::Slope& e) const;
    void judge(const event::Columns& e) const;
    void judge(const event::Pixel& e);
    void judge(const event::Span& e);

    void leave_polygon(int polygon, std::uint64_t begun) const;
    void judge_entry(int edge, double y, double x, double z) const;
    void judge_next_end(double next, const std::vector<int>& active) const;
    bool is_part_of_row(double left, double right, double y) const;
    bool is_next(double row, const std::optional<double>& height) const;
    void judge_covered(int column, int row) const;
    void judge_shown(int column, int row);
    double height() const { return state().z_buffer().last().y ? state().z_buffer().last().y->number : 0; }
    Cell& cell(int column, int row) { return cells_[{column, row}]; }

    std::optional<int> polygon_;
    LastSteps last_steps_;
    std::uint64_t step_ = 0, last_step_ = 0;
    std::uint64_t begun_ = 0;                    // the step at which the current polygon came
    std::map<std::pair<int, int>, Cell> cells_;  // the cells that were written, by column and row
    std::optional<double> cleared_;
    std::optional<event::ShownLine> line_;  // the last one
    std::optional<SceneTruth::Ends> ends_;  // between which its columns lie
};

}  // namespace vidno::grading
