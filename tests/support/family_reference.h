/// The expected results of the Warnock family, by brute force in exact rationals: relations by clipping, pictures with
/// the variations of the picture rule. Independent of kernels and procedures.
#pragma once

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "vidno/family/relation.h"
#include "vidno/picture.h"

namespace vidno::test {

using ExactNumber = CGAL::Exact_rational;

struct ExactPoint {
    ExactNumber x, y;
};

/// Twice the area of a triangle; positive one way round.
inline ExactNumber doubled_area(const ExactPoint& p, const ExactPoint& q, const ExactPoint& r) {
    return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
}

inline std::vector<ExactPoint> exact_outline(const ScenePolygon& polygon) {
    std::vector<ExactPoint> outline;
    for (const auto& v : polygon.vertices) outline.push_back({v.x, v.y});
    return outline;
}

/// Is a point in a closed convex polygon? If so, its triangles with the edges together have the polygon's area.
inline bool holds(const std::vector<ExactPoint>& outline, const ExactPoint& point) {
    ExactNumber own = 0, around = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const auto& p = outline[i];
        const auto& q = outline[(i + 1) % outline.size()];
        own += doubled_area(outline.front(), p, q);
        around += CGAL::abs(doubled_area(point, p, q));
    }
    return own != 0 && around == CGAL::abs(own);
}

/// The relation by its definition: the part of the polygon in the closed window decides whether it reaches into the
/// open window.
class RelationReference {
public:
    explicit RelationReference(const Window& window)
        : left_(window.x), right_(window.right()), top_(window.y), bottom_(window.bottom()) {}

    Relation of(const ScenePolygon& polygon) const {
        const auto outline = exact_outline(polygon);
        if (on_one_side(clipped(outline))) return Relation::outside;
        const auto inside = [&](const auto& p) { return left_ < p.x && p.x < right_ && top_ < p.y && p.y < bottom_; };
        if (std::all_of(outline.begin(), outline.end(), inside)) return Relation::inside;
        const std::vector<ExactPoint> corners{{left_, top_}, {right_, top_}, {right_, bottom_}, {left_, bottom_}};
        const auto held = [&](const auto& corner) { return holds(outline, corner); };
        return std::all_of(corners.begin(), corners.end(), held) ? Relation::surrounding : Relation::intersecting;
    }

private:
    /// Empty, or convex and on the line of one side: no part is strictly between the sides.
    bool on_one_side(const std::vector<ExactPoint>& part) const {
        const auto all = [&](auto&& on) { return std::all_of(part.begin(), part.end(), on); };
        return all([&](const auto& p) { return p.x == left_; }) || all([&](const auto& p) { return p.x == right_; }) ||
               all([&](const auto& p) { return p.y == top_; }) || all([&](const auto& p) { return p.y == bottom_; });
    }

    std::vector<ExactPoint> clipped(std::vector<ExactPoint> outline) const {
        outline = kept(outline, [&](const auto& p) { return ExactNumber(p.x - left_); });
        outline = kept(outline, [&](const auto& p) { return ExactNumber(right_ - p.x); });
        outline = kept(outline, [&](const auto& p) { return ExactNumber(p.y - top_); });
        return kept(outline, [&](const auto& p) { return ExactNumber(bottom_ - p.y); });
    }
    /// The part where a linear function is not negative.
    static std::vector<ExactPoint> kept(const std::vector<ExactPoint>& outline, auto&& function) {
        std::vector<ExactPoint> part;
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const auto& p = outline[i];
            const auto& q = outline[(i + 1) % outline.size()];
            const ExactNumber at_p = function(p), at_q = function(q);
            if (at_p >= 0) part.push_back(p);
            if ((at_p < 0 && at_q > 0) || (at_p > 0 && at_q < 0)) {
                const ExactNumber far = at_p / (at_p - at_q);
                part.push_back({p.x + (q.x - p.x) * far, p.y + (q.y - p.y) * far});
            }
        }
        return part;
    }

    ExactNumber left_, right_, top_, bottom_;
};

/// The depth of a polygon that is not edge-on at a point: that of the plane of Newell's sum about its first vertex.
/// None if the polygon does not hold the point.
inline std::optional<ExactNumber> plane_depth(const ScenePolygon& polygon, const ExactPoint& point) {
    if (!holds(exact_outline(polygon), point)) return std::nullopt;
    const auto& v = polygon.vertices;
    ExactNumber a = 0, b = 0, c = 0;
    for (std::size_t i = 1; i + 1 < v.size(); ++i) {
        const ExactNumber px = ExactNumber(v[i].x) - v[0].x, py = ExactNumber(v[i].y) - v[0].y;
        const ExactNumber qx = ExactNumber(v[i + 1].x) - v[0].x, qy = ExactNumber(v[i + 1].y) - v[0].y;
        const ExactNumber pz = ExactNumber(v[i].z) - v[0].z, qz = ExactNumber(v[i + 1].z) - v[0].z;
        a += py * qz - pz * qy;
        b += pz * qx - px * qz;
        c += px * qy - py * qx;
    }
    return v[0].z - (a * (point.x - v[0].x) + b * (point.y - v[0].y)) / c;
}

/// The nearest depth of an edge-on polygon where a line of sight meets it, perhaps along an edge. None if it misses the
/// polygon.
inline std::optional<ExactNumber> edge_on_depth(const ScenePolygon& polygon, const ExactPoint& point) {
    std::optional<ExactNumber> nearest;
    const auto take = [&](const ExactNumber& z) { nearest = nearest ? std::max(*nearest, z) : z; };
    for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
        const auto& from = polygon.vertices[i];
        const auto& to = polygon.vertices[(i + 1) % polygon.vertices.size()];
        const ExactNumber dx = ExactNumber(to.x) - from.x, dy = ExactNumber(to.y) - from.y;
        const ExactNumber px = point.x - from.x, py = point.y - from.y;
        if (dx == 0 && dy == 0) {
            if (px == 0 && py == 0) take(std::max(from.z, to.z));
            continue;
        }
        const ExactNumber far = (px * dx + py * dy) / (dx * dx + dy * dy);  // of the way along the edge
        if (px * dy != py * dx || far < 0 || far > 1) continue;
        take(from.z + far * (ExactNumber(to.z) - from.z));
    }
    return nearest;
}

/// The picture rule and its variations.
struct PictureVariation {
    bool shows_edge_on = false;      // as closed segments, at their nearest depth
    bool front_before_back = false;  // of equally near ones a face that looks towards the viewer wins, then the first

    Picture picture(const Scene& scene) const {
        Picture picture(scene.area, scene.background);
        for (int y = scene.area.y; y < scene.area.bottom(); ++y) {
            for (int x = scene.area.x; x < scene.area.right(); ++x) {
                picture.paint(x, y, color_at(scene, {x + 0.5, y + 0.5}));
            }
        }
        return picture;
    }

private:
    Color color_at(const Scene& scene, const ExactPoint& point) const {
        const ScenePolygon* nearest = nullptr;
        ExactNumber depth;
        for (const auto& polygon : scene.polygons) {
            if (polygon.edge_on && !shows_edge_on) continue;
            const auto z = polygon.edge_on ? edge_on_depth(polygon, point) : plane_depth(polygon, point);
            if (!z) continue;
            const bool wins = !nearest || *z > depth ||
                              (*z == depth && front_before_back && looks_here(polygon) && !looks_here(*nearest));
            if (!wins) continue;
            nearest = &polygon;
            depth = *z;
        }
        return nearest ? nearest->color : scene.background;
    }

    static bool looks_here(const ScenePolygon& polygon) {
        const auto outline = exact_outline(polygon);
        ExactNumber own = 0;
        for (std::size_t i = 2; i < outline.size(); ++i) own += doubled_area(outline[0], outline[i - 1], outline[i]);
        return own < 0;  // counter-clockwise, for y grows downward
    }
};

}  // namespace vidno::test
