#include "json/json_text.h"

namespace vidno {

[[gnu::flatten]] char* write_integer(char* to, std::int64_t value) {
    return std::to_chars(to, to + longest_number, value).ptr;
}

}  // namespace vidno
