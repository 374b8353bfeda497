/// Characters of a text in UTF-8, and the text as XML writes it.
#pragma once

#include <string>
#include <string_view>

namespace vidno {

std::u32string characters_of(std::string_view text);
std::string utf8(char32_t character);

/// The contents of a file without the byte order mark of UTF-8. Bytes that are no text are left as they are. Throws
/// Refused for text in UTF-16 or UTF-32, with or without a mark.
std::string_view without_mark(std::string_view bytes);

/// Text for XML, without the characters that XML cannot represent.
std::string escaped_for_xml(std::string_view text);

/// The text as a terminal may show it. Control characters, those that change the direction of writing, and bytes that
/// are no UTF-8 become escapes such as \x1b and \u202e. The characters in `kept` stay.
std::string escaped_for_terminal(std::string_view text, std::string_view kept = "");

}  // namespace vidno
