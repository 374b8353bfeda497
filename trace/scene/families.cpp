#include "scene/families.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "scene/exact_scene.h"

namespace vidno {

namespace {

using Group = std::vector<Corners>;

Group triangle(RandomPolygons& random, const Area& area) { return {random.triangle(area)}; }

Group neighbours(RandomPolygons& random, const Area& area) {
    const auto [first, second] = random.neighbours(area);
    return {first, second};
}

Group sliver(RandomPolygons& random, const Area& area) { return {random.sliver(area)}; }

Group coplanar(RandomPolygons& random, const Area& area) {
    const double level = random.whole(-4, 4) / 8.0;
    const double x_slope = random.whole(-1, 1) / 64.0;
    const double y_slope = random.whole(-1, 1) / 64.0;
    Group group{random.triangle(area), random.triangle(area)};
    for (auto& vertices : group) {
        for (auto& v : vertices) v.z = level + x_slope * (v.x - area.x) + y_slope * (v.y - area.y);
    }
    return group;
}

/// A tilted rectangle over most of the area, whose plane meets those of the others in it.
Group interpenetrating(RandomPolygons& random, const Area& area) {
    const double left = area.x + random.whole(-2, 4) / 2.0;
    const double top = area.y + random.whole(-2, 4) / 2.0;
    const double right = area.right() + random.whole(-4, 2) / 2.0;
    const double bottom = area.bottom() + random.whole(-4, 2) / 2.0;
    const double level = random.whole(-1, 1) / 16.0;
    const double x_slope = random.whole(-5, 5) / 64.0;
    const double y_slope = random.whole(-5, 5) / 64.0;
    const auto at = [&](double x, double y) {
        const double from_middle_x = x - area.x - area.width / 2.0;
        const double from_middle_y = y - area.y - area.height / 2.0;
        return glm::dvec3(x, y, level + x_slope * from_middle_x + y_slope * from_middle_y);
    };
    return {{at(left, top), at(right, top), at(right, bottom), at(left, bottom)}};
}

glm::dvec3 near_centre(RandomPolygons& random, const Area& area, int margin) {
    return {area.x + random.whole(-margin, area.width + margin - 1) + 0.5,
            area.y + random.whole(-margin, area.height + margin - 1) + 0.5, random.depth()};
}

Group edge_through_centres(RandomPolygons& random, const Area& area) {
    const glm::dvec3 centre = near_centre(random, area, 0);
    const glm::dvec3 step{double(random.whole(-3, 3)), double(random.whole(-3, 3)), 0};
    glm::dvec3 from = centre - double(random.whole(1, 2)) * step;
    glm::dvec3 to = centre + double(random.whole(1, 2)) * step;
    from.z = random.depth();
    to.z = random.depth();
    return {{from, to, random.vertex(area)}};
}

Group vertices_on_centres(RandomPolygons& random, const Area& area) {
    return {{near_centre(random, area, 2), near_centre(random, area, 2), near_centre(random, area, 2)}};
}

Group collinear(RandomPolygons& random, const Area& area) { return {random.box(area)}; }

Group nearly_edge_on(RandomPolygons& random, const Area& area) {
    const double off = std::ldexp(1.0, -random.whole(4, 50));
    return {random.sliver(area, off)};
}

/// The point of the edge from one vertex to the other at the given number of eighths.
glm::dvec3 on_edge(const glm::dvec3& from, const glm::dvec3& to, int eighths) {
    return from + (to - from) * (eighths / 8.0);
}

/// A triangle, and another one with a vertex exactly on an edge of the first, in whole numbers and eighths.
Group touching(RandomPolygons& random, const Area& area) {
    const auto corner = [&] {
        return glm::dvec3(area.x + random.whole(-2, area.width + 2), area.y + random.whole(-2, area.height + 2), 0);
    };
    Corners first{corner(), corner(), corner()};
    Corners second{on_edge(first[0], first[1], random.whole(0, 8)), corner(), corner()};
    const double behind = random.depth();
    const double before = random.depth();
    for (auto& vertex : first) vertex.z = behind;
    for (auto& vertex : second) vertex.z = before;
    return {first, second};
}

/// Two triangles, on either side of a line, that share a part of an edge but have different depths.
Group shared_edges(RandomPolygons& random, const Area& area) {
    const auto corner = [&] {
        return glm::dvec3(area.x + random.whole(-2, area.width + 2), area.y + random.whole(-2, area.height + 2), 0);
    };
    const glm::dvec3 from = corner();
    const glm::dvec3 to = corner();
    Corners first{from, to, corner()};
    Corners second{on_edge(from, to, random.whole(-4, 4)), on_edge(from, to, random.whole(4, 12)), corner()};
    const double behind = random.depth();
    const double before = random.depth();
    for (auto& vertex : first) vertex.z = behind;
    for (auto& vertex : second) vertex.z = before;
    return {first, second};
}

/// Vertices in line with the corners of windows, along their sides and diagonals, where octants meet and rays pass
/// through vertices.
Group octants(RandomPolygons& random, const Area& area) {
    const double corner_x = area.x + 2 * random.whole(0, area.width / 2);
    const double corner_y = area.y + 2 * random.whole(0, area.height / 2);
    const auto vertex = [&] {
        constexpr std::array<std::pair<int, int>, 8> ways{
            {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
        const auto way = ways[std::size_t(random.whole(0, 7))];
        const double far = random.whole(0, 12);
        return glm::dvec3(corner_x + far * way.first, corner_y + far * way.second, random.depth());
    };
    const glm::dvec3 a = vertex();
    const glm::dvec3 b = vertex();
    return {{a, b, vertex()}};
}

constexpr int curve_columns = 50;

/// Curves of a few samples over the same columns, with heights from `height`.
CurveScene curves_with(RandomPolygons& random, auto&& height) {
    CurveScene scene{{0, 0, curve_columns, 16}, {}};
    for (int count = random.whole(3, 6); count > 0; --count) {
        Curve curve;
        for (int x = 0; x < curve_columns; x += random.whole(5, curve_columns)) curve.samples.push_back({x, height()});
        curve.samples.push_back({curve_columns, height()});
        scene.curves.push_back(std::move(curve));
    }
    scene.area.width = curve_columns + 1;
    return scene;
}

/// Few heights, so that curves meet on columns between their samples, and run along each other.
CurveScene ties(RandomPolygons& random) {
    return curves_with(random, [&] { return double(random.whole(4, 8)); });
}

CurveScene crossing_curves(RandomPolygons& random) {
    return curves_with(random, [&] { return random.whole(0, 16 << 10) / 1024.0; });
}

double moved(double value, std::int64_t ulps) {
    // Read as whole numbers, doubles of one sign are in order; this puts the negative ones first.
    const auto flipped = [](std::int64_t bits) {
        return bits < 0 ? std::numeric_limits<std::int64_t>::min() - bits : bits;
    };
    return std::bit_cast<double>(flipped(flipped(std::bit_cast<std::int64_t>(value)) + ulps));
}

/// From -most to most.
std::int64_t ulps_up_to(std::int64_t most, RandomPolygons& random) {
    const std::uint64_t upper = random.generator();
    const std::uint64_t drawn = upper << 32 | random.generator();
    return std::int64_t(drawn % std::uint64_t(2 * most + 1)) - most;
}

}  // namespace

const std::array<Family, 12> families{{
    {"triangles", "anywhere", triangle},
    {"neighbours", "triangles that share an edge and its depths", neighbours},
    {"slivers", "triangles thinner than a pixel", sliver},
    {"coplanar", "triangles of one plane over each other", coplanar},
    {"interpenetrating", "tilted rectangles through each other", interpenetrating},
    {"edges", "triangles with an edge through pixel centres", edge_through_centres},
    {"vertices", "triangles with their vertices on pixel centres", vertices_on_centres},
    {"collinear", "boxes with collinear and repeated vertices", collinear},
    {"steep", "triangles that are nearly edge-on", nearly_edge_on},
    {"touching", "triangles with a vertex on another one's edge", touching},
    {"shared-edges", "triangles with a part of an edge in common", shared_edges},
    {"octants", "triangles with their vertices in line with the corners of windows", octants},
}};

const std::array<Family, 2> curve_families{{
    {"horizon-ties", "curves that meet the horizon between samples, or run along it", nullptr, ties},
    {"crossing-curves", "curves that cross anywhere", nullptr, crossing_curves},
}};

AdmittedScene random_scene(const Family& family, RandomPolygons& random) {
    Scene scene;
    scene.name = family.name;
    scene.area = {random.whole(-20, 20), random.whole(-20, 20), family_side, family_side};
    const auto add = [&](Corners vertices) {
        const std::size_t index = scene.polygons.size();
        scene.polygons.push_back({std::to_string(index), color_of(index), std::move(vertices), false});
    };
    if (random.whole(0, 1) == 1) {
        const double left = scene.area.x - 1, right = scene.area.right() + 1;
        const double top = scene.area.y - 1, bottom = scene.area.bottom() + 1;
        add({{left, top, -1}, {right, top, -1}, {right, bottom, -1}, {left, bottom, -1}});
    }
    for (int groups = random.whole(2, 4); groups > 0; --groups) {
        for (auto& vertices : family.group(random, scene.area)) add(std::move(vertices));
    }
    return admitted(std::move(scene));
}

AdmittedScene moved_by_ulps(Scene scene, std::int64_t most, RandomPolygons& random) {
    for (auto& polygon : scene.polygons) {
        for (auto& vertex : polygon.vertices) {
            for (int axis = 0; axis < 3; ++axis) vertex[axis] = moved(vertex[axis], ulps_up_to(most, random));
        }
    }
    return admitted(std::move(scene));
}

AdmittedCurves moved_by_ulps(CurveScene scene, std::int64_t most, RandomPolygons& random) {
    for (auto& curve : scene.curves) {
        for (auto& sample : curve.samples) sample.y = moved(sample.y, ulps_up_to(most, random));
    }
    return admit(std::move(scene));
}

AdmittedScene admitted(Scene scene) {
    for (ScenePolygon& polygon : std::exchange(scene.polygons, {})) {
        for (auto& vertex : polygon.vertices) vertex.z = std::clamp(vertex.z, -1.0, 1.0);
        if (exact_scene::admit_polygon(polygon).admission == Admission::admitted) {
            scene.polygons.push_back(std::move(polygon));
        } else {
            const auto parts = exact_scene::cut_into_triangles(polygon);
            scene.polygons.insert(scene.polygons.end(), parts.begin(), parts.end());
        }
    }
    return exact_scene::admit(std::move(scene));
}

}  // namespace vidno
