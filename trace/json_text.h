/// JSON as text, written without a tree in between: numbers in their shortest form that reads back the same.
#pragma once

#include <charconv>
#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>

#include "vidno/scene.h"

namespace vidno {

inline void append_integer(std::string& out, auto value) {
    char digits[24];
    out.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

/// -0 is written 0, what is not finite as a string.
inline void append_number(std::string& out, double value) {
    if (std::isnan(value)) {
        out += "\"nan\"";
    } else if (std::isinf(value)) {
        out += value < 0 ? "\"-inf\"" : "\"inf\"";
    } else {
        char digits[32];
        out.append(digits, std::to_chars(digits, digits + sizeof digits, value == 0 ? 0.0 : value).ptr);
    }
}

/// Quotes, backslashes and control characters are escaped; the text is UTF-8 already.
inline void append_string(std::string& out, std::string_view text) {
    out += '"';
    for (const char c : text) {
        if (c == '"' || c == '\\') {
            out += '\\';
            out += c;
        } else if (static_cast<unsigned char>(c) < 0x20) {
            char escape[8];
            std::snprintf(escape, sizeof escape, "\\u%04x", unsigned(c));
            out += escape;
        } else {
            out += c;
        }
    }
    out += '"';
}

inline void append_color(std::string& out, const Color& color) {
    constexpr std::string_view digits = "0123456789abcdef";
    out += "\"#";
    for (const int part : {int(color.red), int(color.green), int(color.blue)}) {
        out += digits[std::size_t(part / 16)];
        out += digits[std::size_t(part % 16)];
    }
    out += '"';
}

}  // namespace vidno
