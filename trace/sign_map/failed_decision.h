/// The decision at which a failure goes wrong, for a map.
#pragma once

#include <string>

#include "scene/failure.h"
#include "sign_map/mapped_decision.h"

namespace vidno {

/// An orientation, with its point in the middle of the map, whose steps are those of doubles there. Throws Refused,
/// with the name of the file first, if anything else fails.
MappedDecision failed_decision(const Failure& failure, const std::string& file);

}  // namespace vidno
