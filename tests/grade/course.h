// Functions that the students of this test took from the course's web page: geometry, and the rows of a convex outline.
#ifndef COURSE_H
#define COURSE_H

#include "example.h"

using namespace vidno::student;

const double farthest = -2;  // behind all visible depths

struct Point {
    double x, y;
};

struct Plane {
    double a, b, c, d;
};

struct Box {
    double left, top, right, bottom;
};

/// (a - o) x (b - o)
inline double cross(Point o, Point a, Point b) { return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x); }

/// Uses Newell's sum about the first vertex, because the first three vertices may lie on a line.
inline Plane plane_of(const Polygon& polygon) {
    const Vertex& o = polygon.vertices[0];
    Plane plane{0, 0, 0, 0};
    for (std::size_t i = 2; i < polygon.vertices.size(); ++i) {
        const Vertex &p = polygon.vertices[i - 1], &q = polygon.vertices[i];
        const Vertex u{p.x - o.x, p.y - o.y, p.z - o.z}, v{q.x - o.x, q.y - o.y, q.z - o.z};
        plane.a += u.y * v.z - u.z * v.y;
        plane.b += u.z * v.x - u.x * v.z;
        plane.c += u.x * v.y - u.y * v.x;
    }
    plane.d = -(plane.a * o.x + plane.b * o.y + plane.c * o.z);
    return plane;
}

inline double depth(const Polygon& polygon, Point at) {
    const Plane plane = plane_of(polygon);
    return -(plane.a * at.x + plane.b * at.y + plane.d) / plane.c;
}

inline bool is_edge_on(const Polygon& polygon) { return plane_of(polygon).c == 0; }

inline Box box_of(const Polygon& polygon) {
    const Vertex& first = polygon.vertices[0];
    Box box{first.x, first.y, first.x, first.y};
    for (const Vertex& v : polygon.vertices) {
        box = {std::min(box.left, v.x), std::min(box.top, v.y), std::max(box.right, v.x), std::max(box.bottom, v.y)};
    }
    return box;
}

/// Whether the polygon contains the point. Its outline belongs to it.
inline bool holds(const Polygon& polygon, Point point) {
    bool left = false, right = false;
    for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
        const Vertex &p = polygon.vertices[i], &q = polygon.vertices[(i + 1) % polygon.vertices.size()];
        const double side = cross({p.x, p.y}, {q.x, q.y}, point);
        left = left || side > 0;
        right = right || side < 0;
    }
    return left != right;
}

/// Finds the left and the right end of the outline on the line y. Returns false if the outline misses the line.
inline bool ends_on(const std::vector<Vertex>& vertices, double y, double& left, double& right) {
    bool any = false;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const Vertex &p = vertices[i], &q = vertices[(i + 1) % vertices.size()];
        if ((p.y <= y) == (q.y <= y)) continue;
        const double x = p.x + (y - p.y) * (q.x - p.x) / (q.y - p.y);
        left = any ? std::min(left, x) : x;
        right = any ? std::max(right, x) : x;
        any = true;
    }
    return any;
}

/// The first column of the area whose centre lies at x or to the right of it; the column after the last if there is
/// none.
inline int first_centre(double x, const Area& area) {
    return int(std::max<double>(area.x, std::min<double>(area.x + area.width, std::ceil(x - 0.5))));
}

/// Reports the events of FillPolygon.
inline void fill_polygon(WarnockTrace& trace, const Scene& scene, int polygon, const std::vector<Vertex>& vertices) {
    const Area& area = scene.area;
    for (int row = area.y; row < area.y + area.height; ++row) {
        double left = 0, right = 0;
        if (!ends_on(vertices, row + 0.5, left, right)) continue;
        trace.row(row, left, right, first_centre(left, area), first_centre(right, area));
    }
    trace.draw(polygon);
}

/// The side of the smallest square that covers the area: a power of two, in pixels.
inline double covering_side(const Area& area) {
    double side = 1;
    while (side < area.width || side < area.height) side *= 2;
    return side;
}

/// Paints the pixels of a square window that lie in the area.
inline void fill_square(WarnockTrace& trace, const Scene& scene, double x, double y, double side, Color color) {
    const Area& area = scene.area;
    const int left = int(x), top = int(y), size = int(side);
    trace.fill(left, top, std::min(size, area.x + area.width - left), std::min(size, area.y + area.height - top),
               color);
}

/// The part of a polygon on the inner side of from -> to, where `cross` is not positive.
inline std::vector<Vertex> clipped_by(const std::vector<Vertex>& vertices, Point from, Point to) {
    std::vector<Vertex> kept;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const Vertex &p = vertices[i], &q = vertices[(i + 1) % vertices.size()];
        const double cp = cross(from, to, {p.x, p.y}), cq = cross(from, to, {q.x, q.y});
        if (cp <= 0) kept.push_back(p);
        if ((cp < 0 && cq > 0) || (cp > 0 && cq < 0)) {
            const double t = cp / (cp - cq);
            kept.push_back({p.x + (q.x - p.x) * t, p.y + (q.y - p.y) * t, p.z + (q.z - p.z) * t});
        }
    }
    return kept;
}

#endif
