/// Curves for tests: a builder, and the rule of the floating horizon by brute force in exact rationals, written from
/// the rule and not from the procedures.
#pragma once

#include <CGAL/Exact_rational.h>

#include <optional>
#include <utility>
#include <vector>

#include "vidno/floating_horizon/curves.h"

namespace vidno::test {

class CurveSceneBuilder {
public:
    explicit CurveSceneBuilder(Area area);

    CurveSceneBuilder& curve(std::vector<Sample> samples);
    AdmittedCurves build() const;

private:
    CurveScene scene_;
};

/// Two level curves, one that crosses both, one that is hidden, one that touches.
AdmittedCurves some_curves();

/// The result of the rule for each curve, and the horizons after all of them.
class FloatingHorizonReference {
public:
    using Number = CGAL::Exact_rational;
    using Cell = std::optional<Number>;

    /// From x to x, both included.
    struct Interval {
        Number first, last;
        bool operator==(const Interval&) const = default;
    };
    struct CurveSeen {
        std::vector<bool> visible;     // over each column where it has a point
        std::vector<bool> on_horizon;  // there: as high as the upper or the lower one
        std::vector<Interval> parts;
    };

    explicit FloatingHorizonReference(const CurveScene& scene);

    const std::vector<CurveSeen>& curves() const { return seen_; }
    const Cell& upper(int x) const { return upper_[index(x)]; }
    const Cell& lower(int x) const { return lower_[index(x)]; }

    /// Whether the curve has a point at x, on the line between neighbouring samples that both have one; and its height
    /// there.
    static bool reaches(const Curve& curve, const Number& x);
    static Number height(const Curve& curve, const Number& x);

    /// Those that touch are put together.
    static std::vector<Interval> united(std::vector<Interval> parts);

private:
    std::size_t index(int x) const { return std::size_t(x - area_.x); }

    /// The outermost samples that are joined to a neighbour; none if the curve has gaps everywhere.
    using Ends = std::optional<std::pair<Sample, Sample>>;
    static Ends ends_of(const Curve& curve);

    void raise(int x, const Number& y);
    void raise_between(const Sample& a, const Sample& b);
    CurveSeen seen(const Curve& curve) const;

    Area area_;
    std::vector<Cell> upper_, lower_;
    std::vector<CurveSeen> seen_;
};

}  // namespace vidno::test
