/// Plane: the place of the scene's plane in a drawing, and the styles of the scene.
#pragma once

#include <algorithm>

#include "drawing.h"
#include "vidno/window.h"

namespace vidno::figures {

/// The colour itself, or a grey of the same lightness.
Color printed(const Color& color, bool greyscale);
/// A pale tint on which lines and letters stand out; grey on request.
Color tinted(const Color& color, bool greyscale);
/// For lines on tinted areas.
Color deep(const Color& color, bool greyscale);

inline constexpr Color ink{0x10, 0x13, 0x1c}, faint{0x8a, 0x90, 0x9c}, paper{0xff, 0xff, 0xff};

struct Plane {
    Area area;
    double scale;  // millimetres a pixel
    Point origin;  // where the plane's (0, 0) would lie
    Box shown;     // the area and a margin around it, to which everything is cut

    Point at(double x, double y) const {
        return {within_reach(origin.x + x * scale), within_reach(origin.y + y * scale)};
    }
    Box box(double x, double y, double width, double height) const {
        const Point corner = at(x, y);
        return {corner.x, corner.y, width * scale, height * scale};
    }
    Box box(const Window& window) const { return box(window.x, window.y, window.width, window.height); }
    Polyline outline(const ScenePolygon& polygon) const {
        Polyline line;
        for (const auto& vertex : polygon.vertices) line.push_back(at(vertex.x, vertex.y));
        return line;
    }

private:
    /// Coordinates are clamped to this, so that differences stay finite.
    static double within_reach(double millimetres) { return std::clamp(millimetres, -1e300, 1e300); }
};

/// The size of the numbers at the corners, in points.
inline constexpr double tick_size = 7;
/// With a real minus sign.
std::string integer_text(int value);

/// The plane of an area alone, without ticks or margin, as wide as a column of a journal.
Plane plane_without_frame(const Area& area);
/// The plane of an area in the given room, ticks included.
Plane plane_in(const Area& area, double width, double most_height);
/// The height of the drawing of a plane with its ticks.
double height_of(const Plane& plane);

/// Lines with a light rim, which stand out on any background.
void add_rimmed(Drawing& to, const Path& path);

}  // namespace vidno::figures
