/// Random triangles, the same ones on every machine.
#pragma once

#include <vidno/admission.h>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>
#include <utility>

namespace vidno {

/// `count` equilateral triangles on a square of `side` pixels, slightly tilted, each at its own depth. Together they
/// have `overdraw` times the square's area.
inline AdmittedScene random_triangles(int count, int side, double overdraw) {
    std::uint64_t state = 1;
    const auto random = [&] {  // 0 <= r < 1; Knuth's MMIX generator, whose high bits are good
        state = state * 6364136223846793005u + 1442695040888963407u;
        return double(state >> 11) * 0x1p-53;
    };
    const double area = overdraw * side * side / count;
    const double radius = std::sqrt(area * 4 / (3 * std::numbers::sqrt3));

    Scene scene{.name = "random triangles", .area = {0, 0, side, side}, .background = {}, .polygons = {}};
    for (int i = 0; i < count; ++i) {
        const glm::dvec3 centre(random() * side, random() * side, random() * 1.8 - 0.9);
        const double turn = random() * 2 * std::numbers::pi;
        ScenePolygon polygon{.id = std::to_string(i), .color = {}, .vertices = {}};
        polygon.color = {std::uint8_t(random() * 256), std::uint8_t(random() * 256), std::uint8_t(random() * 256)};
        for (int corner = 0; corner < 3; ++corner) {
            const double angle = turn + corner * 2 * std::numbers::pi / 3;
            polygon.vertices.push_back(
                centre + glm::dvec3(radius * std::cos(angle), radius * std::sin(angle), random() * 0.2 - 0.1));
        }
        scene.polygons.push_back(polygon);
    }
    return admit(std::move(scene));
}

/// `count` triangles in 64 x 64 pixels, each with random corners in a box of 10 x 10 and at random depths: many pierce
/// each other.
inline AdmittedScene small_triangles(int count) {
    std::mt19937 random(1);
    std::uniform_real_distribution<> place(0, 54), within(0, 10), depth(-1, 1);
    Scene scene{.name = "small triangles", .area = {0, 0, 64, 64}, .background = {}, .polygons = {}};
    for (int i = 0; i < count; ++i) {
        ScenePolygon polygon{.id = std::to_string(i), .color = {}, .vertices = {}};
        const double x = place(random), y = place(random);
        for (int corner = 0; corner < 3; ++corner) {
            const double dx = within(random), dy = within(random);
            polygon.vertices.emplace_back(x + dx, y + dy, depth(random));
        }
        scene.polygons.push_back(polygon);
    }
    return admit(std::move(scene));
}

}  // namespace vidno
