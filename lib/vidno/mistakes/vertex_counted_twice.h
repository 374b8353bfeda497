/// VertexCountedTwice: a ray that leaves a polygon through a vertex crosses its outline twice.
///
/// Believed   that the edges which the ray meets are counted; two of them end at a vertex.
/// Goes wrong a vertex that the ray pierces counts as much as one that it touches, and an odd number becomes even.
/// Seen       where a polygon surrounds a window and has a vertex to the right of its centre, at the same height: it is
///            taken to be outside, and does not show there.
#pragma once

#include "../family/family.h"

namespace vidno::mistakes {

struct VertexCountedTwice : family::Full {
    static constexpr std::string_view name = "vertex-counted-twice";

    /// CR3
    static int crossings_at_vertex(bool /*touches*/) { return 2; }
};

}  // namespace vidno::mistakes
