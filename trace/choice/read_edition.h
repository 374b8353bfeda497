/// Reads an edition by its name from a JSON file. Refuses an unknown name.
#pragma once

#include "choice/edition.h"
#include "json/json_node.h"

namespace vidno {

inline Edition read_edition(const JsonNode& node) {
    const auto edition = node.is_text() ? edition_named(node.text()) : std::nullopt;
    if (!edition) node.refuse("no such edition");
    return *edition;
}

}  // namespace vidno
