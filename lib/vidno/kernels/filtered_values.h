/// FilteredValues: what the kernel `filtered` computes with. Beside each double stands what it is a double of.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "../warnock/initialize_polygon.h"
#include "bounded.h"
#include "exact.h"

namespace vidno {

class FilteredValues {
public:
    static constexpr bool has_infinity = true;

    using Coordinate = Given;
    using Number = Bounded;
    using Interpolated = double;  // to be shown: the plane decides

    /// z = x_slope x + y_slope y + at_origin, wrong by at most the error at any point of the scene.
    struct Plane {
        double x_slope = 0, y_slope = 0, at_origin = 0;
        double error = 0;
        bool fits_cells = false;            // at its polygon's vertices
        std::uint32_t number = 0;           // 0: no plane, infinitely far
        double a = 0, b = 0, c = 0, d = 0;  // as the text has it
        std::span<const Vertex<Given>> vertices;

        double depth(double x, double y) const { return x_slope * x + (y_slope * y + at_origin); }

        struct Exactly {
            Rational x_slope, y_slope, at_origin;
            bool operator==(const Exactly&) const = default;
        };
        const Exactly& exactly() const;

    private:
        mutable std::shared_ptr<const Exactly> exactly_;  // found out when first asked for
    };

    /// Of a plane, at a point that whoever compares knows.
    struct Depth {
        double value;
        const Plane* plane;

        explicit operator double() const { return value; }
    };

    /// Which plane each pixel shows, and about how far.
    class DepthBuffer;

    /// The depth of a plane at one pixel of a row after the other. It is not the sum of the steps, so does not drift.
    class Stepped {
    public:
        Stepped(const Plane& plane, const Point<Given>& first)
            : plane_(&plane),
              first_x_(first.x.value),
              y_(first.y.value),
              number_(plane.number),
              x_slope_(float(plane.x_slope)),
              first_(plane.fits_cells ? float(plane.depth(first_x_, y_)) : not_known),
              first_below_(first_ - cell_error),
              first_above_(first_ + cell_error) {}

        double value() const { return plane_->depth(first_x_ + steps_, y_); }
        const Plane& plane() const { return *plane_; }
        std::uint32_t number() const { return number_; }
        float about() const { return steps_ * x_slope_ + first_; }
        float surely_below() const { return steps_ * x_slope_ + first_below_; }
        float surely_above() const { return steps_ * x_slope_ + first_above_; }

        void operator+=(double /*step*/) { steps_ += 1; }
        explicit operator double() const { return value(); }

    private:
        const Plane* plane_;
        double first_x_, y_;
        std::uint32_t number_;
        float steps_ = 0, x_slope_, first_, first_below_, first_above_;
    };

    struct Cross {
        double value;
        Sign sign;

        explicit operator double() const { return value; }
    };

    /// A vertex of a clipped polygon: one of its vertices, where an edge meets a side of the window, or the window's corner.
    /// At least one of x and y is exact then, and the edge gives the other.
    struct ClippedVertex {
        Bounded x, y;
        double z;
        const Vertex<Given>* from;  // the edge that it is on, or that begins there
        const Vertex<Given>* to;
    };
    using Outline = std::vector<ClippedVertex>;

    /// (a - pivot) x (b - pivot) for the line along a side of a window.
    struct SideCross : Cross {
        bool vertical;
        double at;  // the x of a vertical side, the y of a level one
    };

protected:
    static constexpr double infinity = std::numeric_limits<double>::infinity();

    /// Two depths of planes that fit cells, farther apart than this as cells have them, differ alike. As a float, stepped by
    /// at most 4, a depth within [-2, 2] is off by 14 roundoffs of 2^-24, and by its plane's error, a 16th of this.
    static constexpr float cell_error = 0x1p-18F;
    /// Of other planes: it compares as neither more nor less.
    static constexpr float not_known = std::numeric_limits<float>::quiet_NaN();
};

class FilteredValues::DepthBuffer {
public:
    /// No more memory than a double: its speed is that of the inner loop.
    struct Shown {
        float about;
        std::uint32_t plane;
    };
    class Cell {
    public:
        Cell(Shown& shown, const Plane* planes, Pixel at) : shown_(shown), planes_(planes), at_(at) {}

        float about() const { return shown_.about; }
        const Plane& plane() const { return planes_[shown_.plane]; }
        operator Depth() const { return {plane().depth(at_.x + 0.5, at_.y + 0.5), &plane()}; }
        explicit operator double() const { return Depth(*this).value; }
        void operator=(const Stepped& z) { shown_ = {z.about(), z.number()}; }

    private:
        Shown& shown_;
        const Plane* planes_;
        Pixel at_;
    };
    struct Row {
        PixelRow<Shown> shown;
        const Plane* planes;
        int y;

        Cell operator[](int x) const { return {shown[x], planes, {x, y}}; }
    };

    void clear(const Area& area, const Depth& farthest) {
        shown_.clear(area, {float(farthest.value), farthest.plane->number});
        planes_ = farthest.plane - farthest.plane->number;
    }
    Cell at(int x, int y) { return row(y)[x]; }
    Row row(int y) { return {shown_.row(y), planes_, y}; }

private:
    vidno::DepthBuffer<Shown> shown_;
    const Plane* planes_ = nullptr;
};

/// The text's plane, in exact numbers.
inline const FilteredValues::Plane::Exactly& FilteredValues::Plane::exactly() const {
    struct Exactness {
        using Number = Rational;
        using Vertices = std::vector<Vertex<Rational>>;
    } numbers;
    if (!exactly_) {
        Exactness::Vertices corners;
        for (const auto& v : vertices) corners.push_back({v.x.value, v.y.value, v.z.value});
        const auto p = InitializePolygon::initialize_polygon(numbers, corners);
        exactly_ = std::make_shared<Exactly>(Exactly{-p.a / p.c, -p.b / p.c, -p.d / p.c});
    }
    return *exactly_;
}

}  // namespace vidno
