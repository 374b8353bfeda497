/// The numbers in the value of an option.
#pragma once

#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>

#include "refused.h"
#include "vidno/kernel.h"
#include "vidno/scene.h"

namespace vidno::cli {

/// A whole number that is all of the text; false if it is none.
bool is_read(std::string_view text, auto& number) {
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, number);
    return error == std::errc() && rest == end;
}

/// `option` says in the refusal what is read.
inline std::uint64_t whole_number(std::string_view text, const std::string& option) {
    std::uint64_t number = 0;
    if (!is_read(text, number)) throw Refused(option + ": " + std::string(text) + " is not a whole number");
    return number;
}

/// The value "X,Y" of --pixel, a pixel of the area.
inline Pixel pixel_in(std::string_view text, const Area& area) {
    const std::string option = "--pixel " + std::string(text);
    const auto comma = text.find(',');
    Pixel pixel{};
    if (comma == text.npos || !is_read(text.substr(0, comma), pixel.x) || !is_read(text.substr(comma + 1), pixel.y))
        throw Refused(option + ": not X,Y");
    if (!area.contains(pixel.x, pixel.y)) throw Refused(option + ": not a pixel of the area");
    return pixel;
}

}  // namespace vidno::cli
