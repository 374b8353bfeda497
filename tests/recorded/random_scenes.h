/// Random scenes as text, the same ones for ever: whole numbers alone, and nothing of the library, make them. A change here
/// changes every hash that is recorded of them.
#pragma once

#include <cstdint>
#include <string>

namespace vidno::recorded {

/// `vidno-scene/1`, admitted. By the number: polygons on a coarse lattice, coplanar ones, neighbours with a common edge, any
/// triangles, slivers, edge-on and far ones; each eighth scene consists of closed convex bodies.
std::string random_scene(std::uint64_t number);

/// `vidno-surface/1`: few heights, equal curves, samples on other curves, peaks, all steps.
std::string random_surface(std::uint64_t number);

}  // namespace vidno::recorded
