#include "characters.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "refused.h"

namespace vidno {

namespace {

/// The length of the character at the beginning of a text in UTF-8; 0 if there is none.
std::size_t length_of_first(std::string_view text) {
    const auto first = static_cast<unsigned char>(text.front());
    const std::size_t length = first < 0x80   ? 1
                               : first < 0xc0 ? 0
                               : first < 0xe0 ? 2
                               : first < 0xf0 ? 3
                               : first < 0xf8 ? 4
                                              : 0;
    if (length == 0 || length > text.size()) return 0;
    const std::u32string characters = characters_of(text.substr(0, length));
    // A longer form than necessary, or half of a pair of UTF-16, is not UTF-8.
    const bool is_one = characters.size() == 1 && utf8(characters.front()) == text.substr(0, length);
    const bool is_half = is_one && characters.front() >= 0xd800 && characters.front() < 0xe000;
    return is_one && !is_half && characters.front() < 0x110000 ? length : 0;
}

/// Whether a character does something to the text besides standing in it.
bool controls(char32_t c) {
    return c < 0x20 || (c >= 0x7f && c < 0xa0) || c == 0x61c || (c >= 0x200b && c <= 0x200f) ||
           (c >= 0x2028 && c <= 0x202e) || (c >= 0x2060 && c <= 0x206f) || c == 0xfeff || (c >= 0xe0000 && c < 0xe0080);
}

/// Whether the bytes, begin with ASCII text in units of this size: a character and zeros, or zeros and a character.
bool is_wide_text(std::string_view bytes, std::size_t unit, std::size_t character) {
    if (bytes.size() < 2 * unit) return false;
    for (std::size_t i = 0; i < 2 * unit; ++i) {
        const auto byte = static_cast<unsigned char>(bytes[i]);
        const bool is_character = byte == '\t' || byte == '\n' || byte == '\r' || (byte >= 0x20 && byte < 0x7f);
        if (i % unit == character ? !is_character : byte != 0) return false;
    }
    return true;
}

}  // namespace

std::string escaped_for_terminal(std::string_view text, std::string_view kept) {
    std::string shown;
    const auto escape = [&](const char* form, unsigned number) {
        std::array<char, 16> written{};
        shown.append(written.data(), std::size_t(std::snprintf(written.data(), written.size(), form, number)));
    };
    while (!text.empty()) {
        const std::size_t length = length_of_first(text);
        const char first = text.front();
        const char32_t character = length == 0 ? 0 : characters_of(text.substr(0, length)).front();
        if (length == 0) {
            escape("\\x%02x", static_cast<unsigned char>(first));
        } else if (first == '\n' && kept.find(first) == kept.npos) {
            shown += "\\n";
        } else if (!controls(character) || (length == 1 && kept.find(first) != kept.npos)) {
            shown += text.substr(0, length);
        } else {
            escape(character < 0x80 ? "\\x%02x" : "\\u%04x", unsigned(character));
        }
        text.remove_prefix(length == 0 ? 1 : length);
    }
    return shown;
}

std::string_view without_mark(std::string_view bytes) {
    using namespace std::string_view_literals;
    if (bytes.starts_with("\xef\xbb\xbf"sv)) return bytes.substr(3);
    for (const std::size_t unit : {4, 2}) {
        const std::string_view little = "\xff\xfe\0\0"sv.substr(0, unit), big = "\0\0\xfe\xff"sv.substr(4 - unit);
        const std::string_view text = bytes.substr(bytes.starts_with(little) || bytes.starts_with(big) ? unit : 0);
        if (is_wide_text(text, unit, 0) || is_wide_text(text, unit, unit - 1)) {
            throw Refused("text in UTF-" + std::to_string(8 * unit) + "; save it as UTF-8");
        }
    }
    return bytes;
}

std::u32string characters_of(std::string_view text) {
    std::u32string characters;
    for (const char byte : text) {
        const auto bits = static_cast<unsigned char>(byte);
        if ((bits & 0xc0) == 0x80 && !characters.empty()) {
            characters.back() = characters.back() << 6 | (bits & 0x3f);
        } else {
            const int prefix = bits < 0x80 ? 0 : bits < 0xe0 ? 3 : bits < 0xf0 ? 4 : 5;
            characters += char32_t(prefix == 0 ? bits : bits & (0xff >> prefix));
        }
    }
    return characters;
}

std::string utf8(char32_t c) {
    if (c < 0x80) return {char(c)};
    const auto rest = [&](int shift) { return char(0x80 | (c >> shift & 0x3f)); };
    if (c < 0x800) return {char(0xc0 | c >> 6), rest(0)};
    if (c < 0x10000) return {char(0xe0 | c >> 12), rest(6), rest(0)};
    return {char(0xf0 | c >> 18), rest(12), rest(6), rest(0)};
}

std::string escaped_for_xml(std::string_view text) {
    std::string written;
    for (const char32_t c : characters_of(text)) {
        const bool allowed = c == '\t' || c == '\n' || c == '\r' || (c >= 0x20 && c < 0xd800) ||
                             (c >= 0xe000 && c < 0xfffe) || (c >= 0x10000 && c < 0x110000);
        switch (c) {
            case '&': written += "&amp;"; break;
            case '<': written += "&lt;"; break;
            case '>': written += "&gt;"; break;
            case '"': written += "&quot;"; break;
            default: written += allowed ? utf8(c) : "\ufffd";
        }
    }
    return written;
}

}  // namespace vidno
