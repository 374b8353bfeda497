/// Claims: checks that the judges of all methods share.
#pragma once

#include <map>

#include "grade/judge.h"
#include "replay/state.h"

namespace vidno::grading {

/// Thrown by a judge for a false claim. The catcher adds the step and the line of the listing.
struct False {
    Symptom symptom;
    std::string claimed, right;           // what the trace claims, and what is right
    std::optional<std::uint64_t> step{};  // if the claim belongs to another event than the current one
};

/// The step of the last event of a kind about each polygon or curve, by its index. A program may return to a polygon,
/// so it is done with one only after that step. Empty unless the run reached its end.
using LastSteps = std::map<int, std::uint64_t>;

template <class E>
LastSteps last_steps(const std::vector<Event>& events, const auto& index_of) {
    LastSteps last;
    for (std::size_t i = 0; i < events.size(); ++i) {
        if (const E* found = events[i].get_if<E>()) last[index_of(*found)] = i + 1;
    }
    return last;
}

class Claims {
public:
    Claims(const SceneTruth& truth, const State& state, std::set<Difference>& differences, const Words& words)
        : say(words), truth_(truth), state_(state), differences_(differences) {}

protected:
    const Words& say;

    const SceneTruth& truth() const { return truth_; }
    const Scene& scene() const { return truth_.scene(); }
    const State& state() const { return state_; }  // before the current event
    void note(Difference difference) { differences_.insert(difference); }

    const std::string& id(int polygon) const { return scene().polygons[std::size_t(polygon)].id; }
    /// The polygons of that colour, or the background: "A", "A or B", "the background".
    std::string owner_of(Color color) const;

    /// Throws False unless the polygon has an edge of that index.
    void judge_edge(int polygon, int edge) const;
    /// Line I1: throws False unless the plane is the polygon's.
    void judge_plane(const event::Plane& e) const;
    /// Throws False: a run of the printed text failed at a line. Its write outside the area is a claim about that
    /// pixel.
    [[noreturn]] void judge_fault(const event::Fault& e) const;
    /// Line D1 and equivalent claims: throws False unless the polygon's depth at (x, y) is z.
    void judge_depth(int polygon, double x, double y, double z) const;
    /// Throws False unless z lies behind every polygon. `what` is the claim, with a place for z.
    void judge_start(double z, const Bilingual& what) const;
    /// Throws False unless the pixel may show the colour.
    void judge_pixel(int column, int row, Color color);
    /// Throws False unless `nearer` says whether z > against; either answer is right if rounding may have decided it.
    void judge_comparison(double z, double against, bool nearer);
    /// Throws False if the trace has reported a different nearest depth so far.
    void judge_nearest_so_far(double claimed, const std::optional<double>& known) const;
    /// Whether a claimed row at y, from left to right, is that of the polygon with these ends. It may end at the sides
    /// of the area or of the window, which it crosses, if the polygon goes on there.
    bool is_row(double y, double left, double right, const SceneTruth::Ends& ends, const Window& window) const;
    /// Throws False unless first <= column < end are the pixels of a row whose centres lie between the polygon's ends.
    void judge_columns(int polygon, int row, int first, int end, const SceneTruth::Crossing& left,
                       const SceneTruth::Crossing& right) const;

    /// In words, why a pixel does not show a colour.
    std::string why_not(int column, int row, Color color) const;

    std::string pixel(int column, int row) const { return say.point(column, row); }

private:
    bool is_hole(int column, int row, Color color) const;

    const SceneTruth& truth_;
    const State& state_;
    std::set<Difference>& differences_;
};

}  // namespace vidno::grading
