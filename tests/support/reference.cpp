#include "reference.h"

#include <algorithm>

namespace vidno::test {

namespace {

using Traits = CGAL::Fraction_traits<CGAL::Exact_rational>;
using Integer = Traits::Numerator_type;

struct Fraction {
    Integer numerator, denominator;
};
struct Corner {
    Integer x, y, z;
};

Integer absolute(const Integer& value) { return value < 0 ? Integer(-value) : value; }

Fraction fraction_of(const CGAL::Exact_rational& value) {
    Fraction fraction;
    Traits::Decompose()(value, fraction.numerator, fraction.denominator);
    return fraction;
}

Integer whole(double value, const Integer& scale) {
    return fraction_of(CGAL::Exact_rational(value) * CGAL::Exact_rational(scale)).numerator;
}

}  // namespace

Integer Reference::Linear::at(const Integer& x, const Integer& y) const { return x_factor * x + y_factor * y + rest; }

bool Reference::Facet::holds(const Integer& x, const Integer& y) const {
    Integer around = 0;
    for (const auto& area : doubled_areas) around += absolute(area.at(x, y));
    return own_doubled_area != 0 && around == own_doubled_area;
}

Reference::Reference(const Scene& scene, double finest) : scene_(scene), xy_scale_(fraction_of(finest).denominator) {
    Integer z_scale = 1;
    for (const auto& polygon : scene.polygons) {
        for (const auto& v : polygon.vertices) {
            xy_scale_ = std::max({xy_scale_, fraction_of(v.x).denominator, fraction_of(v.y).denominator});
            z_scale = std::max(z_scale, fraction_of(v.z).denominator);
        }
    }
    for (const auto& polygon : scene.polygons) facets_.push_back(facet_of(polygon, z_scale));
}

Picture Reference::picture() const {
    Picture picture(scene_.area, scene_.background);
    for (int y = scene_.area.y; y < scene_.area.bottom(); ++y) {
        for (int x = scene_.area.x; x < scene_.area.right(); ++x) picture.paint(x, y, color_at(x + 0.5, y + 0.5));
    }
    return picture;
}

Color Reference::color_at(double x, double y) const {
    const Integer whole_x = whole(x, xy_scale_);
    const Integer whole_y = whole(y, xy_scale_);
    const Facet* nearest = nullptr;
    Integer depth;
    for (const auto& facet : facets_) {
        if (!facet.holds(whole_x, whole_y)) continue;
        const Integer z = facet.depth.at(whole_x, whole_y);
        if (nearest && z * nearest->divisor <= depth * facet.divisor) continue;
        nearest = &facet;
        depth = z;
    }
    return nearest ? nearest->color : scene_.background;
}

Reference::Facet Reference::facet_of(const ScenePolygon& polygon, const Integer& z_scale) const {
    std::vector<Corner> v;
    for (const auto& at : polygon.vertices) {
        v.push_back({whole(at.x, xy_scale_), whole(at.y, xy_scale_), whole(at.z, z_scale)});
    }
    Facet facet{polygon.color, {}, 0, {}, 0};

    // The normal of the plane through the first vertex: the sum of those of the fan about it. Its z is the doubled
    // area.
    Corner normal{0, 0, 0};
    for (std::size_t i = 0; i < v.size(); ++i) {
        const Corner& p = v[i];
        const Corner& q = v[(i + 1) % v.size()];
        facet.doubled_areas.push_back({p.y - q.y, q.x - p.x, p.x * q.y - p.y * q.x});
        const Corner to_p{p.x - v[0].x, p.y - v[0].y, p.z - v[0].z};
        const Corner to_q{q.x - v[0].x, q.y - v[0].y, q.z - v[0].z};
        normal.x += to_p.y * to_q.z - to_p.z * to_q.y;
        normal.y += to_p.z * to_q.x - to_p.x * to_q.z;
        normal.z += to_p.x * to_q.y - to_p.y * to_q.x;
    }
    if (normal.z < 0) normal = {-normal.x, -normal.y, -normal.z};
    facet.own_doubled_area = facet.divisor = normal.z;
    facet.depth = {-normal.x, -normal.y, v[0].z * normal.z + normal.x * v[0].x + normal.y * v[0].y};
    return facet;
}

}  // namespace vidno::test
