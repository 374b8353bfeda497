/// Claims: what the judges of all methods share.
#pragma once

#include "grade/judge.h"
#include "state/state.h"

namespace vidno::grading {

/// Thrown by a judge; the step and the line are filled in by who has them.
struct False {
    Symptom symptom;
    std::string told, right;
    std::optional<std::uint64_t> step{};  // if it is not that of the current event
};

class Claims {
public:
    Claims(const SceneTruth& truth, const State& state, std::set<Difference>& differences, const Words& words)
        : say(words), truth_(truth), state_(state), differences_(differences) {}

protected:
    const Words& say;

    const SceneTruth& truth() const { return truth_; }
    const Scene& scene() const { return truth_.scene(); }
    const State& state() const { return state_; }  // before the event is taken
    void note(Difference difference) { differences_.insert(difference); }

    const std::string& id(int polygon) const { return scene().polygons[std::size_t(polygon)].id; }
    /// "the background", "A", "A or B" of the same colour.
    std::string owner_of(Color color) const;

    /// Throws False unless the polygon has an edge of that number.
    void judge_edge(int polygon, int edge) const;
    /// I1
    void judge_plane(const event::Plane& e) const;
    /// D1, and what comes to the same: z of a polygon at a point.
    void judge_depth(int polygon, double x, double y, double z) const;
    /// A depth behind which nothing may be.
    void judge_start(double z, const Bilingual& what) const;
    /// Claims that a pixel shows a colour.
    void judge_pixel(int column, int row, Color color);
    /// Which of two depths is nearer, as they were computed.
    void judge_comparison(double z, double against, bool nearer);
    /// Throws False if another depth is known to be the nearest so far.
    void judge_nearest_so_far(double told, const std::optional<double>& known) const;
    /// The pixels first <= column < end of a row are those between two ends of the polygon on the row's centre line.
    void judge_columns(int polygon, int row, int first, int end, const SceneTruth::Crossing& left,
                       const SceneTruth::Crossing& right) const;

    /// Why a pixel does not show a colour.
    std::string why_not(int column, int row, Color color) const;

    std::string pixel(int column, int row) const { return say.point(column, row); }

private:
    bool is_hole(int column, int row, Color color) const;

    const SceneTruth& truth_;
    const State& state_;
    std::set<Difference>& differences_;
};

}  // namespace vidno::grading
