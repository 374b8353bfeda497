/// Curves: what the floating horizon draws, a surface cut by planes z = const, each seen as a line from sample to
/// sample.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "../admitted.h"
#include "../scene.h"

namespace vidno {

/// In screen space, on a whole column. y grows downward, so a higher point has the smaller y. It may leave the area.
/// Where the surface has no point, it is not finite.
struct Sample {
    int x = 0;
    double y = 0;
    bool has_point() const { return std::isfinite(y); }
    bool operator==(const Sample& other) const {
        return x == other.x && (y == other.y || (!has_point() && !other.has_point()));
    }
};

/// At least two samples; x grows, within the area's columns.
struct Curve {
    std::vector<Sample> samples;
    bool operator==(const Curve&) const = default;
};

/// Neighbouring samples that have points, at least two: the curve goes from each to the next.
using Piece = std::span<const Sample>;

/// From left to right: more than one if the curve has gaps. A point between two gaps belongs to none.
inline std::vector<Piece> pieces_of(const Curve& curve) {
    const auto has_point = [](const Sample& sample) { return sample.has_point(); };
    const Sample* const end = curve.samples.data() + curve.samples.size();
    std::vector<Piece> pieces;
    for (const Sample* from = curve.samples.data(); from != end;) {
        from = std::find_if(from, end, has_point);
        const Sample* const gap = std::find_if_not(from, end, has_point);
        if (gap - from >= 2) pieces.emplace_back(from, std::size_t(gap - from));
        from = gap;
    }
    return pieces;
}

/// The curves from the nearest to the farthest, and the area whose columns the horizons have.
struct CurveScene {
    Area area;
    std::vector<Curve> curves;
    bool operator==(const CurveScene&) const = default;
};

/// The part of a curve from one sample to the next, or a side edge from the end of one curve to that of the next.
struct Segment {
    int curve = 0;  // its index in the scene; for a side edge, that of the farther curve
    Sample from, to;
    bool operator==(const Segment&) const = default;
};

inline bool on_columns(const Curve& curve, const Area& area) {
    const auto& samples = curve.samples;
    const auto not_growing = [](const Sample& a, const Sample& b) { return a.x >= b.x; };
    return samples.size() >= 2 && samples.front().x >= area.x && samples.back().x < area.right() &&
           std::adjacent_find(samples.begin(), samples.end(), not_growing) == samples.end();
}

using AdmittedCurves = Admitted<CurveScene>;

/// For `admit`: checks the area and each curve.
inline void make_admissible(const CurveScene& scene) {
    expect_admissible(scene.area);
    for (std::size_t i = 0; i < scene.curves.size(); ++i) {
        if (on_columns(scene.curves[i], scene.area)) continue;
        throw std::invalid_argument("curve " + std::to_string(i) +
                                    ": fewer than two samples, or they do not grow within the area's columns");
    }
}

}  // namespace vidno
