/// CurveTruth: answers questions about curves in exact rationals, with a tolerance for programs that compute with
/// rounding. SceneTruth is the equivalent for polygons.
///
/// Rounding   An answer is open within the tolerance of the borderline: 2^10 units in the last place of the largest
///            height, in float 2^6. A claimed number that is no float is judged as one of double.
/// Touching   By the rule of vidno/floating_horizon/floating_horizon.h a point on a horizon is visible. A program may
///            also hide it.
/// Beginning  Between a column over which there is a horizon and one over which there is none, a line may end anywhere.
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "grade/scene_truth.h"
#include "vidno/floating_horizon/curves.h"
#include "vidno/floating_horizon/horizons.h"

namespace vidno {

/// The parts of a curve that a program draws, each from its left x to its right one.
using DrawnParts = std::vector<std::pair<double, double>>;

class CurveTruth {
public:
    enum class Side : unsigned char { upper, lower };
    enum class When : unsigned char {
        before,
        after
    };  // a curve; its left side edge is before it, its right one after it

    /// Copies the curves.
    CurveTruth(const CurveScene& scene, Precision precision);
    ~CurveTruth();

    const CurveScene& scene() const;

    /// The height of a curve at x, rounded to a double; none where the curve does not reach, or has a gap.
    std::optional<double> height(int curve, double x) const;
    /// Whether the curve has that height at x, within the tolerance.
    bool is_on_curve(int curve, double x, double y) const;
    /// Whether it is on a side edge that leads to an end of the curve.
    bool is_on_edge(int curve, int x, double y) const;
    /// Whether a claimed height is the right one.
    bool same_height(double claimed, double right) const;

    /// The outer ends of the curve's pieces; none if it has no piece.
    std::optional<std::pair<Sample, Sample>> ends(int curve) const;

    /// A horizon over a column of the area, before or after a curve; none if there is none.
    std::optional<double> horizon(int curve, When when, Side side, int x) const;
    /// Whether the horizon is that one, within the tolerance. Where there is none, it may be beyond all heights.
    bool is_horizon(int curve, When when, Side side, int x, const std::optional<double>& claimed) const;
    /// Whether the height lies beyond every curve on that side, so that a horizon may start there: an upper one below
    /// all, a lower one above all.
    bool is_beyond_all(Side side, double y) const;

    /// Whether the flag may be that of the curve over the column.
    bool may_be(int curve, int x, VisibilityFlag flag) const;
    /// Whether the curve meets a horizon at x, or a horizon begins or ends over that column.
    bool meets_horizon(int curve, double x) const;

    /// Whether the curve may be drawn at x, and whether it may be left out. Both where rounding or another rule may
    /// decide.
    bool may_show(int curve, double x) const;
    bool may_be_left_out(int curve, double x) const;
    /// An x between these two where the curve is hidden, or has a gap; none if it is visible throughout.
    std::optional<double> hidden_between(int curve, double from, double to) const;
    /// An x where the curve is visible and no part is drawn; none if there is none.
    std::optional<double> left_out(int curve, const DrawnParts& drawn) const;
    /// Whether a part of the curve that lies on a horizon is not drawn.
    bool leaves_out_touching(int curve, const DrawnParts& drawn) const;

    /// Over how many columns rounding may decide whether a curve is visible.
    int open_columns() const;
    /// Whether a curve meets a horizon just over a column.
    bool touches_on_column() const;
    /// Whether a judged height was that of a program in float: a float, though the right one is not.
    bool shows_single() const;

private:
    struct Exactly;
    std::unique_ptr<const Exactly> exactly_;
};

}  // namespace vidno
