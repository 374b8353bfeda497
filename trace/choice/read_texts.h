/// Reads a text in each language from a JSON file: an object with a member for each language.
#pragma once

#include "choice/language.h"
#include "json/json_node.h"

namespace vidno {

inline InEachLanguage<std::string> read_texts(const JsonNode& node) {
    node.require_keys(language_codes);
    return in_each_language([&](Language language) { return node.at(code_of(language)).text(); });
}

}  // namespace vidno
