/// Scene: convex planar polygons in screen space, and the area of pixels that shows them.
///
/// x grows to the right, y downward, z towards the viewer: the greater z is nearer. Pixel (i, j) is the square from (i,
/// j) to (i + 1, j + 1); its centre decides its colour.
#pragma once

#include <cassert>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace vidno {

struct Color {
    std::uint8_t red = 0, green = 0, blue = 0;
    bool operator==(const Color&) const = default;
};

/// The drawing area in whole pixels: columns x <= i < x + width, rows y <= j < y + height.
struct Area {
    int x = 0, y = 0, width = 0, height = 0;

    int right() const { return x + width; }
    int bottom() const { return y + height; }
    bool contains(int column, int row) const { return x <= column && column < right() && y <= row && row < bottom(); }
    bool operator==(const Area&) const = default;
};

/// The values of one row of an area's pixels, by x: a row of a picture or of depths.
template <class T>
struct PixelRow {
    T* first;
    int first_x;

    T& operator[](int x) const { return first[x - first_x]; }
};

template <class T>
PixelRow<T> row_of(std::vector<T>& pixels, const Area& area, int y) {
    assert(area.y <= y && y < area.bottom());
    return {pixels.data() + std::size_t(y - area.y) * std::size_t(area.width), area.x};
}

/// The limits that `admit` (admitted.h) checks.
inline constexpr int largest_side = 16384;
inline constexpr int farthest_offset = 1 << 30;
inline constexpr std::size_t most_polygons = std::size_t{1} << 20;

struct ScenePolygon {
    std::string id;
    Color color;
    std::vector<glm::dvec3> vertices;  // at least 3, in order; the last joins the first
    bool edge_on = false;              // seen from the viewer it has no inside; decided exactly
    std::string face{};                // the name that all parts of one flat face share; empty: it is no part of one
    bool operator==(const ScenePolygon&) const = default;
};

/// Whether two polygons are parts of one face, so that nothing is seen where they meet.
inline bool are_of_one_face(const ScenePolygon& one, const ScenePolygon& other) {
    return !one.face.empty() && one.face == other.face;
}

/// The name of the face for the parts into which a polygon is cut.
inline const std::string& face_of_parts(const ScenePolygon& polygon) {
    return polygon.face.empty() ? polygon.id : polygon.face;
}

struct Scene {
    std::string name;
    Area area;
    Color background{255, 255, 255};
    std::vector<ScenePolygon> polygons;  // among equal depths the first wins
    bool operator==(const Scene&) const = default;
};

}  // namespace vidno
