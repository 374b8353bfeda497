/// The format of a JSON document, by its contents.
#pragma once

#include <string>
#include <string_view>

namespace vidno {

/// The member "format" of the outermost object or, if a key that only one format has comes first, that format. Empty if there is neither.
/// Reads no further than that, and does not report errors.
std::string document_format(std::string_view text);

/// Why a file of one format is not accepted where another is read. A file of another version gets advice.
std::string other_format(std::string_view format, std::string_view read);

}  // namespace vidno
