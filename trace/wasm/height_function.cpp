#include "scene/height_function.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "refused.h"
#include "scene/elementary.h"

// In a page, the page evaluates the formula. It parses the formula, writes the reason if it does not accept it and returns the number
// of bytes (0 if it does), and from then on returns the values of the last formula.
[[clang::import_module("vidno"), clang::import_name("formula")]] extern "C" std::size_t vidno_formula(const char* text,
                                                                                                      std::size_t size,
                                                                                                      char* reason,
                                                                                                      std::size_t room);
[[clang::import_module("vidno"), clang::import_name("height")]] extern "C" double vidno_height(double x, double z);

// It computes sines and powers by these.
#define VIDNO_EXPORTED(name) \
    extern "C" [[clang::export_name(#name)]] double vidno_##name(double x) { return vidno::elementary::name(x); }
VIDNO_ELEMENTARY(VIDNO_EXPORTED)
extern "C" [[clang::export_name("atan2")]] double vidno_atan2(double y, double x) {
    return vidno::elementary::atan2(y, x);
}
extern "C" [[clang::export_name("pow")]] double vidno_pow(double base, double exponent) {
    return vidno::elementary::pow(base, exponent);
}

namespace vidno {

HeightFunction height_function(const std::string& text) {
    std::array<char, 240> reason;
    const std::size_t said = vidno_formula(text.data(), text.size(), reason.data(), reason.size());
    if (said > 0) throw Refused(std::string(reason.data(), std::min(said, reason.size())));
    return vidno_height;
}

}  // namespace vidno
