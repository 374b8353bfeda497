#include "json/json_text.h"

// Header-only programs, which link no library, define this as `inline`.
#ifndef VIDNO_INLINE
#define VIDNO_INLINE
#endif

namespace vidno {

[[gnu::flatten]] VIDNO_INLINE char* write_integer(char* to, std::int64_t value) {
    return std::to_chars(to, to + longest_number, value).ptr;
}

}  // namespace vidno
