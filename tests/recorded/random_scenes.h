/// Random scenes as text, the same ones forever. They are made with integers only and without the library. A change
/// here changes all of their recorded hashes.
#pragma once

#include <cstdint>
#include <string>

namespace vidno::recorded {

/// An admissible `vidno-scene/1`. Depending on the number, it has polygons on a coarse lattice, coplanar ones,
/// neighbours with a common edge, arbitrary triangles, slivers, edge-on or far ones, or a mixture. Every eighth scene
/// consists of closed convex bodies.
std::string random_scene(std::uint64_t number);

/// A `vidno-surface/1`. Depending on the number, it has few heights, peaks, arbitrary heights or tenths. Curves may
/// repeat.
std::string random_surface(std::uint64_t number);

}  // namespace vidno::recorded
