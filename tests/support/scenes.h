/// Scenes for tests: builders for small polygons, and random and degenerate families from a seed.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "vidno/admission.h"
#include "vidno/scene.h"

namespace vidno::test {

inline constexpr Color red{255, 0, 0}, green{0, 128, 0}, blue{0, 0, 255}, white{255, 255, 255};

using Corners = std::vector<glm::dvec3>;

/// Each polygon gets a colour of its own, so that the picture says which one shows.
inline Color color_of(std::size_t index) {
    return {std::uint8_t(index + 1), std::uint8_t(40 * (index % 6)), std::uint8_t(200 - index % 7 * 20)};
}

class SceneBuilder {
public:
    explicit SceneBuilder(Area area) { scene_.area = area; }

    SceneBuilder& polygon(Corners vertices) {
        const std::size_t index = scene_.polygons.size();
        return polygon(std::string(1, char('A' + index % 26)) + (index < 26 ? "" : std::to_string(index / 26)),
                       color_of(index), std::move(vertices));
    }
    SceneBuilder& polygon(std::string id, Color color, Corners vertices) {
        scene_.polygons.push_back({std::move(id), color, std::move(vertices), false});
        return *this;
    }
    SceneBuilder& quad(double left, double top, double right, double bottom, double z) {
        return polygon({{left, top, z}, {right, top, z}, {right, bottom, z}, {left, bottom, z}});
    }

    /// Throws if a polygon is not admitted: a test's scene is in the domain.
    Scene build() const {
        Scene scene = scene_;
        for (auto& polygon : scene.polygons) admitted(polygon);
        return scene;
    }

    static void admitted(ScenePolygon& polygon) {
        const Admitted result = admit(polygon);
        if (result.admission != Admission::admitted)
            throw std::invalid_argument(std::string(reason_of(result.admission)));
    }

private:
    Scene scene_;
};

/// The quad Q over the whole 16 x 16 area and the square N in its middle, before it.
inline const Corners far_quad{{-1, -1, .125}, {17, -1, .125}, {17, 17, .125}, {-1, 17, .125}};
inline const Corners near_square{{4, 4, .5}, {12, 4, .5}, {12, 12, .5}, {4, 12, .5}};
inline constexpr Area area_16{0, 0, 16, 16};

/// A sub-pixel grid makes coincidences common: vertices on centres, on outlines and on each other.
struct RandomScenes {
    std::mt19937 generator;

    explicit RandomScenes(unsigned seed) : generator(seed) {}

    int whole(int low, int high) { return low + int(generator() % unsigned(high - low + 1)); }

    Area area() {
        static constexpr int sides[]{1, 3, 7, 8, 10, 13, 16};
        return {whole(-20, 20), whole(-20, 20), sides[whole(0, 6)], sides[whole(0, 6)]};
    }

    /// A coordinate near the area, in steps of 1/2 or of 1/8, or anything.
    double coordinate(int low, int size) {
        const int steps = std::vector{2, 8, 1 << 20}[std::size_t(whole(0, 2))];
        return low + double(whole(-3 * steps, (size + 3) * steps)) / steps;
    }

    double depth() { return whole(-8, 8) / 8.0; }

    Corners triangle(const Area& area) {
        Corners vertices;
        for (int i = 0; i < 3; ++i) {
            vertices.push_back({coordinate(area.x, area.width), coordinate(area.y, area.height), depth()});
        }
        return vertices;
    }

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

    /// A triangle thinner than a pixel, or without area.
    Corners sliver(const Area& area) {
        const glm::dvec3 a(coordinate(area.x, area.width), coordinate(area.y, area.height), depth());
        const glm::dvec3 b(coordinate(area.x, area.width), coordinate(area.y, area.height), depth());
        const double off = whole(0, 2) / 16.0;
        return {a, b, {(a.x + b.x) / 2 + off, (a.y + b.y) / 2, depth()}};
    }

    /// Two triangles that share an edge and its depths.
    std::pair<Corners, Corners> neighbours(const Area& area) {
        const Corners first = triangle(area);
        return {first, {first[1], first[0], triangle(area)[0]}};
    }

    Scene scene() {
        const Area drawing = area();
        SceneBuilder builder(drawing);
        for (int i = whole(1, 5); i > 0; --i) {
            switch (whole(0, 3)) {
                case 0: builder.polygon(triangle(drawing)); break;
                case 1: builder.polygon(box(drawing)); break;
                case 2: builder.polygon(sliver(drawing)); break;
                default: const auto [a, b] = neighbours(drawing); builder.polygon(a).polygon(b);
            }
        }
        return builder.build();
    }
};

/// Each coordinate moved by up to two ulps: what was a coincidence becomes nearly one. Is the scene still admitted?
inline bool moved_by_ulps(Scene& scene, RandomScenes& random) {
    for (auto& polygon : scene.polygons) {
        for (auto& vertex : polygon.vertices) {
            for (int axis = 0; axis < 3; ++axis) {
                const int ulps = random.whole(-2, 2);
                for (int i = 0; i < std::abs(ulps); ++i) vertex[axis] = std::nextafter(vertex[axis], ulps * 1e9);
            }
            vertex.z = std::clamp(vertex.z, -1., 1.);
        }
        if (admit(polygon).admission != Admission::admitted) return false;
    }
    return true;
}

}  // namespace vidno::test
