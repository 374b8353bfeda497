/// Judges the claims of Warnock's algorithm.
#pragma once

#include <array>
#include <map>

#include "grade/claims.h"
#include "grade/window_tree.h"

namespace vidno::grading {

class WarnockJudge : public Claims {
public:
    WarnockJudge(const SceneTruth& truth, const State& state, std::set<Difference>& differences, const Words& words)
        : Claims(truth, state, differences, words), tree_(truth.scene().area) {}

    /// Judges an event; call it before the state applies the event. Throws False.
    void take(const EventView& event, std::uint64_t step) {
        step_ = step;
        event.visit([this](const auto& e) { judge(e); });
        last_step_ = step;
    }
    /// Judges the final picture; call it after the last event. Throws False.
    void finish();

    /// The current window, in words: claims are about it.
    std::string place() const { return in_words(window_); }

private:
    using Corners = std::array<std::optional<double>, 4>;

    void judge(const auto&) const {}  // the other events claim nothing, or only what one of these claims too
    void judge(const event::Fault& e) const { judge_fault(e); }
    void judge(const event::Plane& e) { judge_plane(e); }
    void judge(const event::Push& e);
    void judge(const event::Skip& e) { tree_.skip(e.window); }
    void judge(const event::Pop& e);
    void judge(const event::Corners& e);
    void judge(const event::Box& e) const;
    void judge(const event::Discard& e);
    void judge(const event::Count& e);
    void judge(const event::Depth& e);
    void judge(const event::Compare& e);
    void judge(const event::Nearer& e);
    void judge(const event::Uncover&) { has_surround_ = false; }
    void judge(const event::Surround& e);
    void judge(const event::Orient& e);
    void judge(const event::Mark& e) const;
    void judge(const event::Cover& e);
    void judge(const event::Insider& e) const;
    void judge(const event::Summary& e);
    void judge(const event::Decide& e);
    void judge(const event::Fill& e);
    void judge(const event::Nearest& e);
    void judge(const event::PointColor& e);
    void judge(const event::ClipBegin& e);
    void judge(const event::ClipSide& e);
    void judge(const event::ClipSign& e) const;
    void judge(const event::ClipCross& e) const;
    void judge(const event::ClipKeep& e) const;
    void judge(const event::ClipDrop& e) const;
    void judge(const event::ClipResult& e);
    void judge(const event::Row& e) { rows_.push_back(e); }
    void judge(const event::Draw& e);

    void finish_window();
    void judge_shown(int column, int row, Color color);
    void judge_surrounded(Color color);
    void judge_surrounds(Color color) const;
    void judge_empty();
    void judge_single();
    void judge_follows(Case which) const;
    void judge_rows(int polygon);
    void judge_in_window(int column, int row, const std::string& claimed) const;
    void judge_parts();
    void judge_side_number(const event::ClipSide& e) const;
    std::string side_in_words(const event::ClipSide& e) const;
    bool looked_at(int polygon) const;
    int beyond_side(const ValueVertex& v) const;
    bool overlooks(int column, int row) const;
    bool needs(int column, int row, int polygon) const;
    bool is_pixel() const { return window_.width <= 1 && window_.height <= 1; }
    PixelRectangle pixels() const { return pixels_of(scene().area, window_); }

    /// Calls `with(column, row)` for each pixel of the current window.
    void for_pixels(auto&& with) const {
        const PixelRectangle all = pixels();
        for (int row = all.y; row < all.y + all.height; ++row) {
            for (int column = all.x; column < all.x + all.width; ++column) with(column, row);
        }
    }

    WindowTree tree_;
    std::uint64_t step_ = 0, last_step_ = 0;
    std::set<std::pair<int, int>> painted_;  // column and row

    // About the current window
    Window window_;
    std::optional<Case> decided_;
    std::optional<event::Summary> summary_;
    std::vector<int> counted_;
    bool tells_counts_ = false;  // the trace has counted polygons in some window
    // The program's nearest depths as of `nearer`, and as its comparisons since then leave them
    Corners nearest_, compared_;
    std::map<int, Corners> depths_;
    std::optional<bool> has_surround_;        // after `cover` and `uncover`
    std::optional<double> nearest_of_point_;  // in PointColor

    std::optional<std::pair<ValuePoint, ValuePoint>> side_;  // the side that clips now
    int sides_ = 0;                    // how many sides have clipped the polygon, including this one
    int clipped_ = -1;                 // the polygon that is being clipped; -1 if unknown
    std::vector<event::Row> rows_;     // since the last `draw`
    std::map<int, int> orientations_;  // for each polygon, the sign that the program gives to our positive side
};

}  // namespace vidno::grading
