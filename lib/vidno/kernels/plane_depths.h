/// PlaneDepths: depths that refer to their planes, for kernels that are always right.
///
/// A depth is a double and the plane that it belongs to. Doubles decide which of two depths is nearer where the bound
/// on their error allows it, otherwise the planes decide exactly.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

#include "../kernel.h"
#include "approximate_plane.h"
#include "filter_stage.h"
#include "plane_depth.h"
#include "plane_depth_buffer.h"
#include "store_nearer.h"

namespace vidno {

/// `Plane` is an ApproximatePlane with an exact comparison, `plane.exactly_nearer(than, x, y)`. `Tally` receives, for
/// each comparison, what decided it; it is passed by value and may hold a pointer.
template <class Plane, class Tally>
class PlaneDepths {
public:
    static constexpr bool has_infinity = true;

    using Interpolated = double;  // for display: the plane decides

    using Depth = PlaneDepth<Plane>;
    using Stepped = SteppedPlaneDepth<Plane>;
    using DepthBuffer = PlaneDepthBuffer<Plane>;

    /// The point lies no farther out than the scene's vertices and windows do.
    Depth depth(const Plane& plane, const auto& point) const {
        return {plane.depth(double(point.x), double(point.y)), &plane};
    }
    Depth farthest() const { return {-infinity, &planes_[0]}; }
    double finite(const Depth& z) const { return z.value; }

    bool nearer(const Depth& z, const Depth& than, const auto& at) const {
        const double difference = z.value - than.value;
        if (std::abs(difference) > depth_error_) {
            tally_(FilterStage::scene);
            return difference > 0;
        }
        return nearer_by_operands(z, than, at);
    }

    double zero() const { return 0; }

    /// Steps on the stored plane, which caches its exact coefficients.
    Stepped to_step(double, const Plane& plane, Pixel from) const { return {planes_[plane.number], from}; }
    const Stepped& to_store(const Stepped& z) const { return z; }

    /// The cell alone decides if its bound allows it.
    bool nearer(const Stepped& z, const auto& cell, Pixel at) const {
        const float difference = z.about() - cell.about();
        if (std::abs(difference) > cell_error) {
            tally_(FilterStage::scene);
            return difference > 0;
        }
        return closely_nearer(z.plane(), cell.plane(), at.x, at.y);
    }

    /// Stores the depth of the plane at the pixels first <= x < end of a row where it is nearer.
    void store_nearer(const Plane& plane, const auto& row, int first,
                      int end) const requires std::is_same_v<Tally, NoTally> {
        store_nearer_blocks(plane, row, first, end, cell_error,
                            [&](int from, int to) { store_closely_nearer(plane, row, from, to); });
    }

protected:
    static constexpr double infinity = std::numeric_limits<double>::infinity();

    explicit PlaneDepths(Tally tally = {}) : tally_(tally) {}

    /// Called before all planes: adds "no polygon yet" and reserves room.
    void expect_planes(std::size_t count) {
        planes_.reserve(count + 1);
        planes_.emplace_back().at_origin = -infinity;
    }

    /// Numbers the plane, and keeps a copy.
    Plane keep(Plane plane, const auto& vertices) {
        const auto within_cells = [&](const auto& v) { return std::abs(plane.depth(double(v.x), double(v.y))) < 2; };
        plane.fits_cells = plane.error < cell_error / 16 && std::all_of(vertices.begin(), vertices.end(), within_cells);
        plane.number = std::uint32_t(planes_.size());
        depth_error_ = std::max(depth_error_, 4 * plane.error);
        return planes_.emplace_back(plane);
    }

    void tell(FilterStage stage) const { tally_(stage); }

private:
    /// Stores the depth pixel by pixel.
    [[gnu::noinline]] void store_closely_nearer(const Plane& plane, const auto& row, int first, int end) const {
        Stepped z = to_step(0, plane, {first, row.y});
        for (int x = first; x < end; ++x, z += 0) {
            auto cell = row[x];
            if (nearer(z, cell, Pixel{x, row.y})) cell = z;
        }
    }

    [[gnu::noinline]] bool nearer_by_operands(const Depth& z, const Depth& than, const auto& at) const {
        const double difference = z.value - than.value;
        const bool certain = std::abs(difference) > 2 * (z.plane->error + than.plane->error);
        tally_(certain ? FilterStage::operands : FilterStage::exact);
        return certain ? difference > 0 : exactly_nearer(*z.plane, *than.plane, at);
    }

    // Takes x and y, not a Pixel, so that they stay in registers where this is not called.
    [[gnu::noinline]] bool closely_nearer(const Plane& plane, const Plane& than, int x, int y) const {
        const auto z = [&](const Plane& of) { return Depth{of.depth(x + 0.5, y + 0.5), &of}; };
        return nearer(z(plane), z(than), Pixel{x, y});
    }

    [[gnu::noinline]] static bool exactly_nearer(const Plane& plane, const Plane& than, const auto& at) {
        if (plane.number == 0 || than.number == 0) return plane.number != 0;
        return plane.exactly_nearer(than, double(at.x), double(at.y));
    }
    [[gnu::noinline]] static bool exactly_nearer(const Plane& plane, const Plane& than, Pixel at) {
        return exactly_nearer(plane, than, Point<double>{at.x + 0.5, at.y + 0.5});
    }

    /// If two depths of planes that fit cells differ by more than this as stored in cells, the exact depths differ the
    /// same way. A depth within [-2, 2] is off by 12 roundoffs of 2^-24: 4 for the slope as a float and 4 for its
    /// product with the steps, since they make at most 4, 2 for the depth where they begin and 2 for the sum. It is off
    /// by twice its plane's error, too, which is less than a 16th of this.
    static constexpr float cell_error = 0x1p-18F;

    std::vector<Plane> planes_;  // by number
    double depth_error_ = 0;     // two depths of kept planes that differ by more differ the same way exactly
    [[no_unique_address]] Tally tally_;
};

}  // namespace vidno
