/// The format of a JSON document, by its contents.
#pragma once

#include <string>
#include <string_view>

namespace vidno {

/// The member "format" of the outermost object or, if a key that only one format has comes first, that format. Empty if
/// there is neither. Reads no further than that, and does not report errors.
std::string document_format(std::string_view text);

/// Whether two formats differ in their versions at most.
bool are_of_one_kind(std::string_view format, std::string_view other);

/// Why a file is not accepted where another format is read, or another version of it: in place of the first {} stands
/// the format that is read, in place of the second the one found. The page has these words, too.
struct FormatWords {
    std::string_view other, newer, older;
};
inline constexpr FormatWords english_format_words{R"(not "{}")", R"(not "{}" but "{}": a newer vidno reads this file)",
                                                  R"(not "{}" but "{}": an older vidno reads this file)"};
inline constexpr FormatWords russian_format_words{R"(не "{}")",
                                                  R"(не "{}", а "{}": этот файл читает более новая версия vidno)",
                                                  R"(не "{}", а "{}": этот файл читает более старая версия vidno)"};

/// What is said of a file of another format, by the format that was found.
std::string other_format(std::string_view format, std::string_view read);

/// Throws Refused if the text has a format, and another one than is read.
void expect_format_in(std::string_view text, std::string_view read, const std::string& file);

}  // namespace vidno
