/// Which format a document of JSON has, by what is in it.
#pragma once

#include <string>
#include <string_view>

namespace vidno {

/// The member "format" of the outermost object; of one that does not say it before a key that only one format has, that format.
/// Empty if neither is there. Reads no further than that, and does not say what is wrong.
std::string document_format(std::string_view text);

}  // namespace vidno
