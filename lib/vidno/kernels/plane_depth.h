/// PlaneDepth: a depth that refers to its plane, at a point or pixel by pixel along a row.
#pragma once

#include <cstdint>
#include <limits>

#include "../kernel.h"

namespace vidno {

/// The depth of a plane at a point; the point is passed to each comparison.
template <class Plane>
struct PlaneDepth {
    double value;
    const Plane* plane;

    explicit operator double() const { return value; }
};

/// In place of the depth in a cell, for planes that do not fit cells: NaN is neither greater nor less.
inline constexpr float depth_not_known = std::numeric_limits<float>::quiet_NaN();

/// The depth of a plane along a row. It is not a sum of steps, so it does not drift.
template <class Plane>
class SteppedPlaneDepth {
public:
    SteppedPlaneDepth(const Plane& plane, Pixel first)
        : plane_(&plane),
          first_x_(first.x + 0.5),
          y_(first.y + 0.5),
          number_(plane.number),
          x_slope_(float(plane.x_slope)),
          first_(plane.fits_cells ? float(plane.depth(first_x_, y_)) : depth_not_known) {}

    double value() const { return plane_->depth(first_x_ + steps_, y_); }
    const Plane& plane() const { return *plane_; }
    std::uint32_t number() const { return number_; }
    float about() const { return steps_ * x_slope_ + first_; }

    void operator+=(double /*step*/) { steps_ += 1; }
    explicit operator double() const { return value(); }

private:
    const Plane* plane_;
    double first_x_, y_;
    std::uint32_t number_;
    float steps_ = 0, x_slope_, first_;
};

}  // namespace vidno
