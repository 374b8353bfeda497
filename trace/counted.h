/// counted: a number of things in English: `1 event`, `2 events`.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace vidno {

inline std::string counted(std::uint64_t count, std::string_view one, std::string_view several) {
    return std::to_string(count) + " " + std::string(count == 1 ? one : several);
}

}  // namespace vidno
