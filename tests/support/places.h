/// Messages without the places in a text, for tables of what is refused.
#pragma once

#include <regex>
#include <string>

namespace vidno::test {

/// Removes "line 2, column 13: ", except where a text is not JSON and the message has only that place.
inline std::string without_places(const std::string& message) {
    return std::regex_replace(message, std::regex("line [0-9]+, column [0-9]+: (?!not valid JSON)"), "");
}

}  // namespace vidno::test
