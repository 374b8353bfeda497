/// Margin: where a vertex of the scene may be moved to so that no sign of a step changes.
///
/// The signs of a step are those of the test or of the clip, SurroundTest or PolygonClip, to which it belongs. Each is the sign of a
/// number that is linear in the coordinates of any one vertex: a cross product is, and where an edge is cut at a side of the window and
/// the cut lies to another side is the side of the edge on which their corner lies. So the region is an intersection of half-planes.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "run/run.h"

namespace vidno {

/// A sign of the step, and what it says: of an edge and a point; of a vertex and a side of the window; or of the cut of an edge at one
/// side and another side.
struct StepSign {
    std::uint64_t step = 0;
    Line at{};
    PolygonPlace polygon{};
    std::optional<int> vertex{}, edge{};
    std::optional<ValuePoint> point{};
    std::optional<int> cut{}, side{};  // 1 to 4, as PolygonClip goes round
    Sign sign{};                       // in exact arithmetic
    Sign told{};                       // as the run has it
};

/// The signs stay as they are where a x + b y + c has this sign: beyond, those of `flips` change. The first of a and b that is not 0 is 1.
struct MarginSide {
    std::array<Fraction, 3> line;  // a, b, c
    Sign sign{};
    bool bounds = false;  // the region is smaller than it would be without
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

/// Of a step of level `signs`; vertices are numbered from 0. Throws Refused where the step has no such sign.
Margin margin_of(const RunRequest& request, std::uint64_t step, PolygonPlace polygon, int vertex);

std::string margin_text(const Margin& margin, const Scene& scene);
std::string margin_json(const Margin& margin, const Scene& scene);

}  // namespace vidno
