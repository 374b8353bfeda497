#include "characters.h"

namespace vidno {

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
