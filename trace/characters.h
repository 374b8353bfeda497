/// Characters of a text in UTF-8, and the text as XML writes it.
#pragma once

#include <string>
#include <string_view>

namespace vidno {

std::u32string characters_of(std::string_view text);
std::string utf8(char32_t character);

/// Text for XML, without the characters that XML cannot represent.
std::string escaped_for_xml(std::string_view text);

}  // namespace vidno
