/// PlaneDepths: depths that refer to their planes, for kernels that are always right.
///
/// A depth is a double and the plane that it belongs to. Doubles decide which of two depths is nearer where the bound
/// on their error allows it, otherwise the planes decide exactly.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

#include "../kernel.h"
#include "approximate_plane.h"
#include "filter_stage.h"
#include "pixel_block.h"

namespace vidno {

/// `Plane` is an ApproximatePlane with an exact comparison, `plane.exactly_nearer(than, x, y)`. `Tally` receives, for
/// each comparison, what decided it; it is passed by value and may hold a pointer.
template <class Plane, class Tally>
class PlaneDepths {
public:
    static constexpr bool has_infinity = true;

    using Interpolated = double;  // for display: the plane decides

    /// The depth of a plane at a point; the point is passed to each comparison.
    struct Depth {
        double value;
        const Plane* plane;

        explicit operator double() const { return value; }
    };

    class DepthBuffer;

    /// The depth of a plane, pixel by pixel along a row. It is not a sum of steps, so it does not drift.
    class Stepped {
    public:
        Stepped(const Plane& plane, Pixel first)
            : plane_(&plane),
              first_x_(first.x + 0.5),
              y_(first.y + 0.5),
              number_(plane.number),
              x_slope_(float(plane.x_slope)),
              first_(plane.fits_cells ? float(plane.depth(first_x_, y_)) : not_known) {}

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

    /// Stores the depth of the plane at the pixels first <= x < end of a row where it is nearer. Since it is not a sum
    /// of steps, a block of pixels is compared at once, as the function above compares one. A block with a pixel that
    /// its cell does not decide is done pixel by pixel; a depth that is not known is close to all others.
    [[gnu::noinline]] void store_nearer(const Plane& plane, const auto& row, int first,
                                        int end) const requires std::is_same_v<Tally, NoTally> {
        const auto slope = float(plane.x_slope);
        const float first_z = plane.fits_cells ? float(plane.depth(first + 0.5, row.y + 0.5)) : not_known;
        const Floats slopes{slope, slope, slope, slope};
        const Floats first_zs{first_z, first_z, first_z, first_z};
        Floats steps{0, 1, 2, 3};
        float* depths = row.about + (first - row.first_x);
        std::uint32_t* planes = row.plane + (first - row.first_x);
        for (int left = end - first; left > 0;
             left -= Block::pixels, depths += Block::pixels, planes += Block::pixels) {
            std::array<Floats, 2> z, stored;
            std::array<Ints, 2> nearer, close;
            for (int half = 0; half < 2; ++half) {
                stored[half] = Block::loaded<Floats>(depths + 4 * half);
                z[half] = steps * slopes + first_zs;
                steps += 4;
                const Floats difference = z[half] - stored[half];
                const Floats distance = std::bit_cast<Floats>(std::bit_cast<Ints>(difference) & all_but_sign);
                const Ints in_line = Ints{0, 1, 2, 3} + 4 * half < left;
                nearer[half] = (difference > cell_error) & in_line;
                close[half] = ~(distance > cell_error) & in_line;
            }
            if (!Block::any(nearer[0] | nearer[1] | close[0] | close[1])) continue;
            if (Block::any(close[0] | close[1])) [[unlikely]] {
                store_closely_nearer(plane, row, end - left, std::min(end - left + Block::pixels, end));
                continue;
            }
            const Ints number = Ints{} + int(plane.number);
            for (int half = 0; half < 2; ++half) {
                Block::store_where(nearer[half], std::bit_cast<Ints>(z[half]), std::bit_cast<Ints>(stored[half]),
                                   depths + 4 * half);
                Block::store_where(nearer[half], number, Block::loaded<Ints>(planes + 4 * half), planes + 4 * half);
            }
        }
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
    using Block = PixelBlock;
    using Floats = Block::Floats;
    using Ints = Block::Ints;
    static constexpr int all_but_sign = std::numeric_limits<int>::max();

    /// The same pixel by pixel.
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
    /// same way. As a float, stepped by at most 4, a depth within [-2, 2] is off by 14 roundoffs of 2^-24, and by its
    /// plane's error, a 16th of this.
    static constexpr float cell_error = 0x1p-18F;
    /// For planes that do not fit cells: NaN is neither greater nor less.
    static constexpr float not_known = std::numeric_limits<float>::quiet_NaN();

    std::vector<Plane> planes_;  // by number
    double depth_error_ = 0;     // two depths of kept planes that differ by more differ the same way exactly
    [[no_unique_address]] Tally tally_;
};

/// The plane that each pixel shows, and its approximate depth.
template <class Plane, class Tally>
class PlaneDepths<Plane, Tally>::DepthBuffer {
public:
    /// The plane and depth of a pixel. Together they take no more memory than a double.
    class Cell {
    public:
        Cell(float& about, std::uint32_t& plane, const Plane* planes, Pixel at)
            : about_(about), plane_(plane), planes_(planes), at_(at) {}

        float about() const { return about_; }
        const Plane& plane() const { return planes_[plane_]; }
        operator Depth() const { return {plane().depth(at_.x + 0.5, at_.y + 0.5), &plane()}; }
        explicit operator double() const { return Depth(*this).value; }
        void operator=(const Stepped& z) {
            about_ = z.about();
            plane_ = z.number();
        }

    private:
        float& about_;
        std::uint32_t& plane_;
        const Plane* planes_;
        Pixel at_;
    };
    struct Row {
        float* about;
        std::uint32_t* plane;
        const Plane* planes;
        int first_x, y;

        Cell operator[](int x) const { return {about[x - first_x], plane[x - first_x], planes, {x, y}}; }
        std::uint32_t number(int x) const { return plane[x - first_x]; }
    };

    void clear(const Area& area, const Depth& farthest) {
        area_ = area;
        // The last block may end after the last pixel.
        const auto size = std::size_t(area.width) * std::size_t(area.height) + Block::pixels;
        about_.assign(size, float(farthest.value));
        plane_.assign(size, farthest.plane->number);
        planes_ = farthest.plane - farthest.plane->number;
    }
    Cell at(int x, int y) { return row(y)[x]; }
    Row row(int y) {
        assert(area_.y <= y && y < area_.bottom());
        const auto before = std::size_t(y - area_.y) * std::size_t(area_.width);
        return {about_.data() + before, plane_.data() + before, planes_, area_.x, y};
    }

private:
    Area area_;
    std::vector<float> about_;
    std::vector<std::uint32_t> plane_;
    const Plane* planes_ = nullptr;
};

}  // namespace vidno
