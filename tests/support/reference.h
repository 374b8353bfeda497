/// The picture rule by brute force in exact rationals: independent of kernels and procedures.
#pragma once

#include <CGAL/Exact_rational.h>

#include "vidno/picture.h"

namespace vidno::test {

class Reference {
public:
    using Rational = CGAL::Exact_rational;

    explicit Reference(const Scene& scene) : scene_(scene) {}

    Picture picture() const {
        Picture picture(scene_.area, scene_.background);
        for (int y = scene_.area.y; y < scene_.area.bottom(); ++y) {
            for (int x = scene_.area.x; x < scene_.area.right(); ++x) picture.paint(x, y, color_at(x + 0.5, y + 0.5));
        }
        return picture;
    }

    Color color_at(double x, double y) const {
        const ScenePolygon* nearest = nullptr;
        Rational depth;
        for (const auto& polygon : scene_.polygons) {
            if (!holds(polygon, x, y)) continue;
            const Rational z = depth_at(polygon, x, y);
            if (nearest && z <= depth) continue;
            nearest = &polygon;
            depth = z;
        }
        return nearest ? nearest->color : scene_.background;
    }

private:
    /// The sum of the triangles' areas that the point spans with the edges equals the polygon's own: closed, any way round.
    static bool holds(const ScenePolygon& polygon, double x, double y) {
        const auto& v = polygon.vertices;
        Rational around = 0, own = 0;
        for (std::size_t i = 0; i < v.size(); ++i) {
            const auto& p = v[i];
            const auto& q = v[(i + 1) % v.size()];
            const Rational part = doubled_area(p.x, p.y, q.x, q.y, x, y);
            around += part < 0 ? Rational(-part) : part;
            own += doubled_area(v[0].x, v[0].y, p.x, p.y, q.x, q.y);
        }
        return own != 0 && around == (own < 0 ? Rational(-own) : own);
    }

    static Rational doubled_area(double ax, double ay, double bx, double by, double cx, double cy) {
        const Rational ux = Rational(bx) - Rational(ax), uy = Rational(by) - Rational(ay);
        const Rational vx = Rational(cx) - Rational(ax), vy = Rational(cy) - Rational(ay);
        return ux * vy - uy * vx;
    }

    /// On the plane through the first vertex whose normal is the sum of the normals of the fan about it.
    static Rational depth_at(const ScenePolygon& polygon, double x, double y) {
        const auto& v = polygon.vertices;
        Rational nx = 0, ny = 0, nz = 0;
        for (std::size_t i = 1; i + 1 < v.size(); ++i) {
            const Rational ux = Rational(v[i].x) - Rational(v[0].x), wx = Rational(v[i + 1].x) - Rational(v[0].x);
            const Rational uy = Rational(v[i].y) - Rational(v[0].y), wy = Rational(v[i + 1].y) - Rational(v[0].y);
            const Rational uz = Rational(v[i].z) - Rational(v[0].z), wz = Rational(v[i + 1].z) - Rational(v[0].z);
            nx += uy * wz - uz * wy;
            ny += uz * wx - ux * wz;
            nz += ux * wy - uy * wx;
        }
        return Rational(v[0].z) - (nx * (Rational(x) - Rational(v[0].x)) + ny * (Rational(y) - Rational(v[0].y))) / nz;
    }

    const Scene& scene_;
};

}  // namespace vidno::test
