/// JSON as text, written without a tree: numbers in their shortest form that reads back the same.
///
/// Each function appends to a Text or a Pen.
#pragma once

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>

#include "vidno/scene.h"

namespace vidno {

/// Text that grows.
class Text {
public:
    Text& operator+=(char c) {
        return put(1, [c](char* to) { return *to = c, to + 1; });
    }
    Text& operator+=(std::string_view part) {
        return put(part.size(), [part](char* to) { return std::copy(part.begin(), part.end(), to); });
    }
    /// Appends at most `most` bytes, which `write` writes to the given place; it returns their end.
    Text& put(std::size_t most, auto&& write) {
        if (room_.size() - size_ < most) grow(most);
        char* const start = room_.data() + size_;
        const auto written = std::size_t(write(start) - start);
        assert(written <= most);
        size_ += written;
        return *this;
    }

    std::string_view view() const { return {room_.data(), size_}; }
    std::string string() const { return std::string(view()); }
    std::size_t size() const { return size_; }
    void clear() { size_ = 0; }

private:
    // Separate from the appending, which stays small enough to be inlined.
    [[gnu::noinline]] void grow(std::size_t by) { room_.resize(2 * size_ + by + 1024); }

    std::string room_;
    std::size_t size_ = 0;
};

/// Writes text to a place with room for all of it. A line of a trace is written in pieces of a few bytes, so each piece
/// is just a copy.
struct Pen {
    char* at;

    Pen& operator+=(char c) {
        *at++ = c;
        return *this;
    }
    Pen& operator+=(std::string_view part) {
        at = std::copy(part.begin(), part.end(), at);
        return *this;
    }
    Pen& put(std::size_t, auto&& write) {
        at = write(at);
        return *this;
    }
};

/// No number takes more bytes.
inline constexpr std::size_t longest_number = 24;  // -2.2250738585072014e-308

/// Writes the shortest form of a number that reads back the same; gives its end.
struct Shortest {
    char* operator()(char* to, double value) const { return std::to_chars(to, to + longest_number, value).ptr; }
};

/// Writes a whole number; gives its end. Not a template: the linker would keep the code of any unit that has it, and
/// most are hardly optimized.
char* write_integer(char* to, std::int64_t value);

void append_integer(auto& out, std::integral auto value) {
    out.put(longest_number, [&](char* to) { return write_integer(to, std::int64_t(value)); });
}

/// -0 is written as 0, numbers that are not finite as strings.
inline void append_number(auto& out, double value, auto&& shortest) {
    // Below 100,000 no other form of such numbers is shorter.
    if (std::abs(value) < 1e5 && 2 * value == int(2 * value)) {
        const int twice = int(2 * value);
        if (twice < 0) out += '-';
        append_integer(out, std::abs(twice) / 2);
        if (twice % 2 != 0) out += std::string_view(".5");
    } else if (std::isnan(value)) {
        out += std::string_view("\"nan\"");
    } else if (std::isinf(value)) {
        out += std::string_view(value < 0 ? "\"-inf\"" : "\"inf\"");
    } else {
        out.put(longest_number, [&](char* to) { return shortest(to, value); });
    }
}
inline void append_number(auto& out, double value) { append_number(out, value, Shortest{}); }

/// Quotes, backslashes and control characters are escaped; the text is UTF-8 already.
inline void append_string(auto& out, std::string_view text) {
    out += '"';
    for (const char c : text) {
        if (c == '"' || c == '\\') {
            out += '\\';
            out += c;
        } else if (static_cast<unsigned char>(c) < 0x20) {
            char escape[8];
            std::snprintf(escape, sizeof escape, "\\u%04x", unsigned(c));
            out += std::string_view(escape);
        } else {
            out += c;
        }
    }
    out += '"';
}

/// "#rrggbb" without quotes.
inline void append_hex(auto& out, const Color& color) {
    constexpr std::string_view digits = "0123456789abcdef";
    out += '#';
    for (const int part : {int(color.red), int(color.green), int(color.blue)}) {
        out += digits[std::size_t(part / 16)];
        out += digits[std::size_t(part % 16)];
    }
}

inline std::string hex_of(const Color& color) {
    Text text;
    append_hex(text, color);
    return text.string();
}

inline void append_area(auto& out, const Area& area) {
    out += std::string_view("{\"x\":");
    append_integer(out, area.x);
    out += std::string_view(",\"y\":");
    append_integer(out, area.y);
    out += std::string_view(",\"width\":");
    append_integer(out, area.width);
    out += std::string_view(",\"height\":");
    append_integer(out, area.height);
    out += '}';
}

inline void append_color(auto& out, const Color& color) {
    out += '"';
    append_hex(out, color);
    out += '"';
}

/// The colour "#rrggbb"; none for another text.
constexpr std::optional<Color> color_of_hex(std::string_view text) {
    if (text.size() != 7 || text[0] != '#') return std::nullopt;
    unsigned rgb = 0;
    for (const char c : text.substr(1)) {
        const auto digit = std::string_view("0123456789abcdefABCDEF").find(c);
        if (digit == std::string_view::npos) return std::nullopt;
        rgb = rgb * 16 + unsigned(digit < 16 ? digit : digit - 6);
    }
    return Color{std::uint8_t(rgb >> 16), std::uint8_t(rgb >> 8), std::uint8_t(rgb)};
}

}  // namespace vidno
