#include "scene/height_function.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "refused.h"

// In a page, the page evaluates the formula. It parses the formula, writes the reason if it does not accept it and returns the number
// of bytes (0 if it does), and from then on returns the values of the last formula.
[[clang::import_module("vidno"), clang::import_name("formula")]] extern "C" std::size_t vidno_formula(const char* text,
                                                                                                      std::size_t size,
                                                                                                      char* reason,
                                                                                                      std::size_t room);
[[clang::import_module("vidno"), clang::import_name("height")]] extern "C" double vidno_height(double x, double z);

namespace vidno {

HeightFunction height_function(const std::string& text) {
    std::array<char, 240> reason;
    const std::size_t said = vidno_formula(text.data(), text.size(), reason.data(), reason.size());
    if (said > 0) throw Refused(std::string(reason.data(), std::min(said, reason.size())));
    return vidno_height;
}

}  // namespace vidno
