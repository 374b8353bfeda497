#include "method.h"

#include "vidno/family/closed_bodies.h"

namespace vidno {

std::optional<std::string> refuses_bodies(const Scene& scene) { return not_closed_convex_bodies(scene); }

}  // namespace vidno
