/// Margin: where a vertex of the scene may be moved without changing a sign of a step.
///
/// The signs of a step are those of the call to which it belongs: SurroundTest, PolygonClip, TrialFunction,
/// RayCrossings or OctantAngles. Each is the sign of a number that is linear in the coordinates of any one vertex. A
/// cross product is linear. If an edge is cut at one side of the window, the cut lies beyond another side if the corner
/// of the two sides lies on a certain side of the edge, which again is the sign of a cross product. So the region is an
/// intersection of half-planes.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "run/run.h"

namespace vidno {

/// A sign of the step: on which side of an edge a point lies, or whether a vertex, or the cut of an edge at one side of
/// the window, lies beyond another side.
struct StepSign {
    std::uint64_t step = 0;
    Line at{};
    PolygonPlace polygon{};
    std::optional<int> vertex{}, edge{};
    std::optional<ValuePoint> point{};
    std::optional<int> cut{}, side{};  // 1 to 4: top, left, bottom, right, in the order of PolygonClip
    Sign sign{};                       // in exact arithmetic
    Sign in_run{};                     // in the run
};

/// The signs do not change where a x + b y + c has this sign; beyond, those of `flips` change. The first of a and b
/// that is not 0 is 1.
struct MarginSide {
    std::array<Fraction, 3> line;  // a, b, c
    Sign sign{};
    bool bounds = false;  // without this side the region would be larger
    std::vector<StepSign> flips;
};

struct Margin {
    std::uint64_t step = 0;
    Procedure procedure{};
    PolygonPlace polygon{};
    int vertex = 0;
    glm::dvec3 at{};
    std::vector<MarginSide> sides;  // none, if no sign depends on the vertex
};

/// The margin of a vertex at a step of level `signs`; vertices are numbered from 0. Throws Refused if the step has no
/// sign.
Margin margin_of(const RunRequest& request, std::uint64_t step, PolygonPlace polygon, int vertex);

std::string margin_text(const Margin& margin, const Scene& scene);
std::string margin_json(const Margin& margin, const Scene& scene);

}  // namespace vidno
