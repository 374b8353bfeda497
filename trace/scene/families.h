/// Families: random scenes, each of one kind, the same on every machine.
///
/// A sub-pixel grid makes coincidences common: vertices on centres, on outlines and on each other. Moving by ulps turns
/// coincidences into near coincidences.
#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <string_view>
#include <utility>
#include <vector>

#include "vidno/floating_horizon/curves.h"
#include "vidno/scene.h"

namespace vidno {

using Corners = std::vector<glm::dvec3>;

/// Each polygon gets its own colour, so that the picture shows which one is visible.
inline Color color_of(std::size_t index) {
    return {std::uint8_t(index + 1), std::uint8_t(40 * (index % 6)), std::uint8_t(200 - index % 7 * 20)};
}

/// Write draws in braces, never in parentheses: only braces evaluate them in the order of the text.
struct RandomPolygons {
    std::mt19937 generator;  // no distributions, which differ between standard libraries

    explicit RandomPolygons(std::mt19937 seeded) : generator(seeded) {}

    int whole(int low, int high) { return low + int(generator() % unsigned(high - low + 1)); }

    /// A coordinate near the area, in steps of 1/2 or of 1/8, or anything.
    double coordinate(int low, int size) {
        const int steps = std::array{2, 8, 1 << 20}[std::size_t(whole(0, 2))];
        return low + double(whole(-3 * steps, (size + 3) * steps)) / steps;
    }

    double depth() { return whole(-8, 8) / 8.0; }

    glm::dvec3 vertex(const Area& area) {
        return {coordinate(area.x, area.width), coordinate(area.y, area.height), depth()};
    }

    Corners triangle(const Area& area) { return {vertex(area), vertex(area), vertex(area)}; }

    /// A level or tilted box with collinear vertices on its outline and perhaps a repeated one.
    Corners box(const Area& area) {
        const double left = area.x + whole(-4, 2 * area.width) / 2.0;
        const double top = area.y + whole(-4, 2 * area.height) / 2.0;
        const double right = left + whole(0, 2 * area.width) / 2.0;
        const double bottom = top + whole(0, 2 * area.height) / 2.0;
        const double z = depth() / 2;
        const double slope = whole(-1, 1) / 128.0;
        const auto at = [&](double x, double y) { return glm::dvec3(x, y, z + slope * (x - left)); };
        Corners vertices{at(left, top), at((left + right) / 2, top), at(right, top), at(right, bottom),
                         at(left, bottom)};
        if (whole(0, 1) == 1) vertices.insert(vertices.begin() + 3, vertices[2]);
        return vertices;
    }

    /// A triangle thinner than a pixel, or without area: its third vertex is this far to the right of the middle of the
    /// others.
    Corners sliver(const Area& area, double off) {
        const glm::dvec3 a = vertex(area);
        const glm::dvec3 b = vertex(area);
        return {a, b, {(a.x + b.x) / 2 + off, (a.y + b.y) / 2, depth()}};
    }
    Corners sliver(const Area& area) { return sliver(area, whole(0, 2) / 16.0); }

    /// Two triangles that share an edge and its depths.
    std::pair<Corners, Corners> neighbours(const Area& area) {
        const Corners first = triangle(area);
        return {first, {first[1], first[0], triangle(area)[0]}};
    }
};

struct Family {
    std::string_view name;
    std::string_view shows;
    std::vector<Corners> (*group)(RandomPolygons&, const Area&);  // polygons that belong together
    CurveScene (*curves)(RandomPolygons&) = nullptr;              // or a whole scene of curves
};

extern const std::array<Family, 12> families;
/// The families of curves.
extern const std::array<Family, 2> curve_families;

/// A campaign that names no family has the first ones, as always, so that its old files can be continued.
inline constexpr std::size_t first_families = 9;

inline constexpr int family_side = 8;

/// Two to four groups in an area of family_side pixels each way, somewhere; half of the time in front of a backdrop.
AdmittedScene random_scene(const Family& family, RandomPolygons& random);

/// Each coordinate is moved by at most `most` ulps.
AdmittedScene moved_by_ulps(Scene scene, std::int64_t most, RandomPolygons& random);
/// Each height is moved by at most `most` ulps.
AdmittedCurves moved_by_ulps(CurveScene scene, std::int64_t most, RandomPolygons& random);

/// Makes a scene valid after its vertices were changed: z between -1 and 1, and polygons that are no longer planar or
/// convex cut into triangles.
AdmittedScene admitted(Scene scene);

}  // namespace vidno
