/// The published maps of the orientation test: p takes 256 x 256 positions in steps of 2^-53 near the line through q
/// and r.
///
/// Source  L. Kettner, K. Mehlhorn, S. Pion, S. Schirra and C. Yap, Classroom examples of robustness problems in
///         geometric computations, Computational Geometry 40(1), 2008, figure 2.
#pragma once

#include <array>
#include <glm/vec3.hpp>

namespace vidno::test {

struct KettnerMap {
    glm::dvec3 p, q, r;

    void for_each_place(auto&& visit) const {
        for (int i = 0; i < 256; ++i) {
            for (int j = 0; j < 256; ++j) visit(glm::dvec3(p.x + i * 0x1p-53, p.y + j * 0x1p-53, 0));
        }
    }
};

inline const std::array<KettnerMap, 3> kettner_maps{
    {{{.5, .5, 0}, {12, 12, 0}, {24, 24, 0}},
     {{0x1.00000000000e4p-1, 0x1.000000000009ap-1, 0},
      {0x1.14ccccccccccdp+4, 0x1.14ccccccccccdp+4, 0},
      {0x1.800000000000ep+4, 0x1.800000000000fp+4, 0}},
     {{.5, .5, 0}, {0x1.199999999999ap+3, 0x1.199999999999ap+3, 0}, {0x1.8333333333333p+3, 0x1.8333333333333p+3, 0}}}};

}  // namespace vidno::test
