/// Reads an edition or a kernel by its name from a JSON file. Refuses an unknown name.
#pragma once

#include "choice/edition.h"
#include "choice/kernel_choice.h"
#include "json/json_node.h"

namespace vidno {

inline Edition read_edition(const JsonNode& node) {
    const auto edition = node.is_text() ? edition_named(node.text()) : std::nullopt;
    if (!edition) node.refuse("no such edition");
    return *edition;
}

inline NamedKernel read_kernel(const JsonNode& node) {
    const auto kernel = node.is_text() ? kernel_named(node.text()) : std::nullopt;
    if (!kernel) node.refuse("not one of " + kernel_names());
    return *kernel;
}

}  // namespace vidno
