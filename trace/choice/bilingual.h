/// Bilingual: a text in the languages of program and page.
#pragma once

#include <string_view>

namespace vidno {

struct Bilingual {
    std::string_view english, russian;
};

}  // namespace vidno
