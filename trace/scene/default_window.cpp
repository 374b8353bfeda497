#include "scene/default_window.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vidno {

namespace {

/// The range from the least coordinate to the greatest, extended to whole pixels.
struct Extent {
    double least = std::numeric_limits<double>::infinity(), greatest = -least;

    void add(double coordinate) {
        least = std::min(least, coordinate);
        greatest = std::max(greatest, coordinate);
    }
    double first() const { return std::floor(least); }
    double size() const { return std::max(std::ceil(greatest) - first(), 1.0); }
    bool fits() const { return least <= greatest && std::abs(first()) <= farthest_offset && size() <= largest_side; }
};

std::optional<Area> window_of(const Extent& x, const Extent& y) {
    if (!x.fits() || !y.fits()) return std::nullopt;
    return Area{int(x.first()), int(y.first()), int(x.size()), int(y.size())};
}

}  // namespace

std::optional<Area> default_window(const std::vector<ScenePolygon>& polygons) {
    Extent x, y;
    for (const auto& polygon : polygons) {
        for (const auto& vertex : polygon.vertices) {
            x.add(vertex.x);
            y.add(vertex.y);
        }
    }
    return window_of(x, y);
}

std::optional<Area> default_window(const std::vector<Curve>& curves) {
    Extent x, y;
    for (const auto& [samples] : curves) {
        for (const auto& sample : samples) {
            x.add(sample.x);
            x.add(sample.x + 1.0);
            if (!sample.has_point()) continue;
            y.add(std::floor(sample.y));
            y.add(std::floor(sample.y) + 1);
        }
    }
    return window_of(x, y);
}

}  // namespace vidno
