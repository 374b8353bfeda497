/// SHA-256, from the available library.
#pragma once

#include <array>
#include <string_view>

namespace vidno {

std::array<unsigned char, 32> sha256(std::string_view bytes);

}  // namespace vidno
