/// The numbers of a trace as a sentence writes them: short, in the format of a language, with a real minus sign, and
/// with `≈` where digits are missing.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "choice/language.h"
#include "format/value.h"
#include "vidno/kernel.h"

namespace vidno::say {

/// A number's digits with a real minus sign, and with the decimal sign of the language.
std::string in_format(std::string text, Language language);

/// At most seven characters, or a few more with a power of ten.
std::string short_number(const Value& value, Language language);

/// With all digits. Fractions may be too long for a sentence; they are then short.
std::string in_full(const Value& value, Language language);

/// With all digits, however many.
std::string all_digits(const Value& value, Language language);

/// Two numbers to compare: short, or in full if they differ but their short forms do not.
std::pair<std::string, std::string> apart(const Value& one, const Value& other, Language language);

/// A whole number as a summand, `+2`.
std::string signed_number(int value);

/// The order of two numbers: less, equal or greater. None if one of them is no number.
std::optional<Sign> order_of(const Value& one, const Value& other);

/// "<", "=" or ">".
constexpr std::string_view relation_of(Sign order) {
    return order == Sign::negative ? "<" : order == Sign::zero ? "=" : ">";
}

/// Whether an answer to "is z nearer than the other depth?" agrees with the depths as written. It need not: some
/// kernels compare more than they write, and a trace may be wrong.
bool agrees(bool nearer, const Value& z, const Value& other);

}  // namespace vidno::say
