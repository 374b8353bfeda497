/// Characters of a text in UTF-8, and the text as XML writes it.
#pragma once

#include <string>
#include <string_view>

namespace vidno {

std::u32string characters_of(std::string_view text);
std::string utf8(char32_t character);

/// Text for XML, without the characters that XML cannot represent.
std::string escaped_for_xml(std::string_view text);

/// The text as a terminal may show it. Control characters, those that change the direction of writing, and bytes that are no UTF-8 become
/// escapes such as \x1b and \u202e. The characters in `kept` stay.
std::string escaped_for_terminal(std::string_view text, std::string_view kept = "");

}  // namespace vidno
