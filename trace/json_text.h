/// JSON as text, written without a tree in between: numbers in their shortest form that reads back the same.
///
/// Each function appends to a std::string or to a Text.
#pragma once

#include <charconv>
#include <cmath>
#include <concepts>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>

#include "vidno/scene.h"

namespace vidno {

/// Text that grows. A trace is appended in pieces of a few bytes; here appending one is a copy and a comparison.
class Text {
public:
    Text& operator+=(char c) {
        if (size_ == room_.size()) grow(1);
        room_[size_++] = c;
        return *this;
    }
    Text& operator+=(std::string_view part) {
        if (room_.size() - size_ < part.size()) grow(part.size());
        std::memcpy(room_.data() + size_, part.data(), part.size());
        size_ += part.size();
        return *this;
    }

    std::string_view view() const { return {room_.data(), size_}; }
    std::size_t size() const { return size_; }
    void clear() { size_ = 0; }

private:
    // Apart from the appending, which stays small enough to be inlined.
    [[gnu::noinline]] void grow(std::size_t by) { room_.resize(2 * size_ + by + 1024); }

    std::string room_;
    std::size_t size_ = 0;
};

inline void append_digits(auto& out, auto value) {
    char digits[32];
    const char* end = std::to_chars(digits, digits + sizeof digits, value).ptr;
    out += std::string_view(digits, std::size_t(end - digits));
}

inline void append_integer(auto& out, std::integral auto value) { append_digits(out, value); }

/// -0 is written 0, what is not finite as a string.
inline void append_number(auto& out, double value) {
    // Most numbers of a trace are whole pixels and their centres. Below 100,000 no other form of them is shorter.
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
        append_digits(out, value);
    }
}

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

inline void append_color(auto& out, const Color& color) {
    constexpr std::string_view digits = "0123456789abcdef";
    out += std::string_view("\"#");
    for (const int part : {int(color.red), int(color.green), int(color.blue)}) {
        out += digits[std::size_t(part / 16)];
        out += digits[std::size_t(part % 16)];
    }
    out += '"';
}

}  // namespace vidno
