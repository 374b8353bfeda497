/// The decision at which a failure goes wrong, as one to be mapped.
#pragma once

#include <string>

#include "scene/failure.h"
#include "sign_map/mapped_decision.h"

namespace vidno {

/// An orientation, with its point in the middle of the map, which has the steps of doubles there. Throws Refused, after the
/// name of the file, if something else fails.
MappedDecision failed_decision(const Failure& failure, const std::string& file);

}  // namespace vidno
