/// Curves: what the floating horizon draws, a surface cut by planes z = const, each seen as a line from sample to sample.
#pragma once

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "../admitted.h"
#include "../scene.h"

namespace vidno {

/// In screen space, on a whole column. y grows downward, so a higher point has the smaller y.
struct Sample {
    int x = 0;
    double y = 0;
    bool operator==(const Sample&) const = default;
};

/// At least two samples; x grows, within the area's columns. y is finite, and may leave the area.
struct Curve {
    std::vector<Sample> samples;
    bool operator==(const Curve&) const = default;
};

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
    const auto is_finite = [](const Sample& sample) { return std::isfinite(sample.y); };
    for (std::size_t i = 0; i < scene.curves.size(); ++i) {
        const Curve& curve = scene.curves[i];
        const auto refuse = [&](const char* reason) {
            throw std::invalid_argument("curve " + std::to_string(i) + ": " + reason);
        };
        if (!on_columns(curve, scene.area))
            refuse("fewer than two samples, or they do not grow within the area's columns");
        if (!std::all_of(curve.samples.begin(), curve.samples.end(), is_finite)) refuse("a height is not finite");
    }
}

}  // namespace vidno
