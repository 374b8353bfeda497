/// Bilingual: a text in English and Russian.
#pragma once

#include <string_view>

namespace vidno {

struct Bilingual {
    std::string_view english, russian;
};

}  // namespace vidno
