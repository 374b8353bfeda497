/// CurveTruth: what is visible of the curves of a surface, column by column, in exact rationals. Where rounding may decide, both answers
/// are right: within 2^10 units in the last place of the largest coordinate.
#pragma once

#include <memory>
#include <optional>

#include "grade/scene_truth.h"
#include "vidno/floating_horizon/curves.h"

namespace vidno {

class CurveTruth {
public:
    CurveTruth(const CurveScene& scene, Precision precision);
    ~CurveTruth();

    const CurveScene& scene() const;

    /// The curve's height over a column or between two of its own; none where it has none.
    std::optional<double> height(int curve, double x) const;
    bool same_height(double told, double right) const;

    /// Over a column of the curve: may it be visible above, or below, the horizons of the curves before; must it be. Above and below are
    /// those of the screen.
    struct Sight {
        bool may_above, must_above, may_below, must_below;
        bool may() const { return may_above || may_below; }
        bool must() const { return must_above || must_below; }
    };
    Sight sight(int curve, int column) const;

    /// Whether the point between two columns lies on a horizon of the curves before, or a horizon begins or ends beside it.
    bool is_on_horizon(int curve, double x, double y) const;

private:
    struct Exactly;
    std::unique_ptr<const Exactly> exactly_;
};

}  // namespace vidno
