/// The files of decisions to be mapped, `vidno-question/1`: reading with every rule checked. lessons/maps/README.md
/// describes them.
#pragma once

#include <string>
#include <string_view>

#include "sign_map/mapped_decision.h"

namespace vidno {

/// `text` is the JSON, `file` is its name in messages. Throws Refused.
MappedDecision read_mapped_decision(std::string_view text, const std::string& file);

}  // namespace vidno
