/// The values of the kernel `filtered`: each holds a double and what it approximates.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "../warnock/initialize_polygon.h"
#include "bounded.h"
#include "exact.h"
#include "plane_depths.h"

namespace vidno {

/// A polygon's plane; the polygon outlives it.
struct FilteredPlane : ApproximatePlane {
    double a = 0, b = 0, c = 0, d = 0;  // as the text has it
    std::span<const Vertex<Given>> vertices;

    bool exactly_nearer(const FilteredPlane& than, double x, double y) const {
        const auto& p = exactly();
        const auto& q = than.exactly();
        if (&p == &q) return false;
        if (p == q) {  // shared from now on: where polygons of one plane overlap, each pixel compares them
            than.exactly_ = exactly_;
            return false;
        }
        return (p.x_slope - q.x_slope) * Rational(x) + (p.y_slope - q.y_slope) * Rational(y) >
               q.at_origin - p.at_origin;
    }

private:
    struct Exactly {
        Rational x_slope, y_slope, at_origin;
        bool operator==(const Exactly&) const = default;
    };

    /// The text's plane, in exact numbers.
    const Exactly& exactly() const {
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

    mutable std::shared_ptr<const Exactly> exactly_;  // computed when first needed
};

struct FilteredCross {
    double value;
    Sign sign;

    explicit operator double() const { return value; }
};

/// (a - pivot) x (b - pivot) for the line along a side of a window.
struct SideCross : FilteredCross {
    bool vertical;
    double at;  // the x of a vertical side, the y of a level one
};

/// A vertex of a clipped polygon: one of its vertices, where an edge meets a side of the window, or the window's
/// corner. At least one of x and y is exact then, and the edge gives the other.
struct ClippedVertex {
    Bounded x, y;
    double z;
    const Vertex<Given>* from;  // the edge that it is on, or that begins there
    const Vertex<Given>* to;
};

}  // namespace vidno
