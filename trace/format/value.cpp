#include "format/value.h"

#include <cmath>
#include <cstdlib>
#include <string_view>

namespace vidno {

namespace {

/// An integer of any length as leading * 10^tens.
struct Scaled {
    double leading;
    int tens;
};

Scaled scaled(std::string_view digits) {
    constexpr std::size_t enough = 18;
    const std::string leading(digits.substr(0, enough));
    return {std::strtod(leading.c_str(), nullptr), int(digits.size() - leading.size())};
}

}  // namespace

double number_of(const Value& value) {
    if (!value.fraction) return value.number;
    std::string_view text = *value.fraction;
    const bool negative = text.starts_with('-');
    if (negative) text.remove_prefix(1);
    const auto slash = text.find('/');
    const Scaled above = scaled(text.substr(0, slash)), below = scaled(text.substr(slash + 1));
    if (below.leading == 0) return std::numeric_limits<double>::quiet_NaN();
    return (negative ? -1 : 1) * above.leading / below.leading * std::pow(10, above.tens - below.tens);
}

}  // namespace vidno
