/// Marker: draws the subject of a step on the plane. It stands out by its colour and, without colours, by its shape:
/// full points mean yes, hollow ones no.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "notation.h"
#include "parts.h"
#include "weiler_atherton_parts.h"

namespace vidno::figures {

class Marker {
public:
    using Dashes = std::vector<double>;
    inline static const Dashes solid{}, dashed{2, 1.5};

    Marker(Drawing& to, const Plane& plane, const Style& style)
        : to_(to), plane_(plane), style_(style), color_(style.greyscale ? ink : mark_color) {}

    const Plane& plane() const { return plane_; }
    Point at(const Value& x, const Value& y) const { return plane_.at(number_of(x), number_of(y)); }

    /// None for a point that is not finite.
    void line(const Polyline& points, bool closed, const Stroke& stroke) {
        const auto nowhere = [](Point p) { return !std::isfinite(p.x) || !std::isfinite(p.y); };
        if (std::any_of(points.begin(), points.end(), nowhere)) return;
        add_rimmed(to_, Path{clipped(points, closed, plane_.shown), false, {}, stroke});
    }
    void line(const Polyline& points, bool closed, Dashes dashes = solid) {
        line(points, closed, Stroke{color_, 1, std::move(dashes)});
    }
    /// Does not hide anything that it crosses.
    void fine_line(const Polyline& points) {
        to_.add(Path{clipped(points, false, plane_.shown), false, {}, Stroke{color_, 0.5, {0.5, 1.5}}});
    }
    void box(const Box& box, Dashes dashes) { line(box.corners(), true, std::move(dashes)); }
    void pixels(const PixelRectangle& p, Dashes dashes = solid) {
        if (p.width > 0 && p.height > 0) box(plane_.box(p.x, p.y, p.width, p.height), std::move(dashes));
    }
    void region(const RegionLoops& region, const Dashes& dashes = solid) {
        for (const auto& loop : loops_of(region, plane_)) line(loop, true, dashes);
    }
    void edge(const ScenePolygon& polygon, int number) {
        const auto [a, b] = ends_of(polygon, number);
        line({plane_.at(a.x, a.y), plane_.at(b.x, b.y)}, false);
    }

    void point(const Value& x, const Value& y, bool yes) { point(at(x, y), yes, color_); }
    void point(const Point& center, bool yes, const Color& color) {
        constexpr double radius = 0.7;
        if (!is_shown(center)) return;
        const Polyline around = circle(center, radius);
        to_.add(Path{{around}, true, paper, Stroke{paper, 1.5}});
        to_.add(Path{{around}, true, yes ? color : paper, Stroke{color, 0.75}});
    }

    /// A number near a place, on a blank background.
    void note(const Point& center, const std::string& text) {
        constexpr double size = 7, around = 0.3;
        const double width = style_.letters * width_of(text, size, true) + 2 * around;
        const double height = 0.72 * size / points_per_millimetre + 2 * around;
        if (!is_shown(center)) return;
        const Box box{center.x - width / 2, center.y - height / 2, width, height};
        to_.add(rectangle(box, paper));
        to_.add(Label{text, {center.x, box.bottom() - around}, size, Anchor::middle, true, color_});
    }

    /// The ends of an edge of the scene.
    static std::pair<glm::dvec3, glm::dvec3> ends_of(const ScenePolygon& polygon, int edge) {
        const auto& vertices = polygon.vertices;
        return {vertices[std::size_t(edge) % vertices.size()], vertices[(std::size_t(edge) + 1) % vertices.size()]};
    }

private:
    static constexpr Color mark_color{0xc2, 0x00, 0x6b};

    bool is_shown(const Point& p) const {
        return std::isfinite(p.x) && std::isfinite(p.y) && plane_.shown.holds({p.x, p.y, 0, 0});
    }

    Drawing& to_;
    const Plane& plane_;
    const Style& style_;
    Color color_;
};

}  // namespace vidno::figures
