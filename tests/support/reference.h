/// The picture rule by brute force in exact integers: independent of kernels and procedures.
#pragma once

#include <CGAL/Exact_rational.h>
#include <CGAL/Fraction_traits.h>

#include <vector>

#include "vidno/picture.h"

namespace vidno::test {

/// All x and y of a scene, and its pixel centres, become whole numbers when multiplied by the largest of their
/// denominators, which are powers of two; its z likewise with another factor. Unlike rationals, whole numbers need no
/// common divisors.
class Reference {
public:
    /// Queried points are multiples of `finest`, a power of two, or of the coordinates' own last digits.
    explicit Reference(const Scene& scene, double finest = 0.5);

    Picture picture() const;
    Color color_at(double x, double y) const;

private:
    using Integer = CGAL::Fraction_traits<CGAL::Exact_rational>::Numerator_type;

    /// x_factor x + y_factor y + rest.
    struct Linear {
        Integer x_factor, y_factor, rest;

        Integer at(const Integer& x, const Integer& y) const;
    };

    struct Facet {
        Color color;
        std::vector<Linear> doubled_areas;  // of the triangle that a point spans with each edge
        Integer own_doubled_area;           // 0 if edge-on
        Linear depth;                       // times the divisor, which is positive
        Integer divisor;

        /// The triangles' areas add up to the polygon's; holds for the closed polygon in either orientation.
        bool holds(const Integer& x, const Integer& y) const;
    };

    Facet facet_of(const ScenePolygon& polygon, const Integer& z_scale) const;

    const Scene& scene_;
    Integer xy_scale_;
    std::vector<Facet> facets_;
};

}  // namespace vidno::test
