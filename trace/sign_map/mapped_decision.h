/// MappedDecision: a decision of the procedures, taken at each place of a point p that moves by small steps.
///
/// Source  The places are those of L. Kettner, K. Mehlhorn, S. Pion, S. Schirra and C. Yap, Classroom examples of
///         robustness problems in geometric computations, Computational Geometry 40(1), 2008.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <string>
#include <string_view>
#include <variant>

#include "vidno/kernel.h"

namespace vidno {

/// The names of a decision's answers, each a sign: negative, zero, positive. An answer that it never gives has no name.
using AnswerNames = std::array<std::string_view, 3>;
inline constexpr AnswerNames three_signs{"negative", "zero", "positive"};

/// On which side of the line from q to r does p lie? The differences are taken from the pivot, always in the same order
/// around the triangle. In exact arithmetic the pivot makes no difference.
struct MappedOrientation {
    static constexpr std::string_view decision = "orientation";
    static constexpr AnswerNames answers = three_signs;

    glm::dvec2 q, r;
    int pivot;  // 0, 1, 2: p, q, r
};

/// Does the polygon hold p?
struct MappedSurround {
    static constexpr std::string_view decision = "surround";
    static constexpr AnswerNames answers{"outside", "", "inside"};

    ScenePolygon polygon;
};

/// PolygonClip cuts the edge from p to q at one side of the window. On which side of a later one does the cut lie?
/// (A vertex that is not cut has given coordinates, so a double decides its side correctly.)
struct MappedClip {
    static constexpr std::string_view decision = "clip";
    static constexpr AnswerNames answers = three_signs;  // positive lies outside

    glm::dvec2 q;
    Area window;
    int cut, side;  // 1 to 4 in PolygonClip's order: top, left, bottom, right
};

/// Is the first polygon nearer at p than the second?
struct MappedDepth {
    static constexpr std::string_view decision = "depth";
    static constexpr AnswerNames answers{"not nearer", "", "nearer"};

    std::array<ScenePolygon, 2> polygons;
};

struct MappedDecision {
    static constexpr int side = 256;

    std::string name;
    glm::dvec2 p;
    double step;
    std::variant<MappedOrientation, MappedSurround, MappedClip, MappedDepth> asked;

    /// The coordinates of a place, doubles without rounding for 0 <= i, j < side.
    glm::dvec2 place(int i, int j) const { return {p.x + i * step, p.y + j * step}; }
};

}  // namespace vidno
