/// Numbers and the texts of events: short, in the format of a language.
#pragma once

#include <string>

#include "choice/language.h"
#include "format/event.h"

namespace vidno::figures {

/// With all its digits, and a real minus sign. In Russian numbers have a decimal comma.
std::string in_full(double value, Language language);

inline constexpr std::size_t short_enough = 7;  // characters of a number that is read at a glance

/// A number in at most `most` characters (more with a power of ten), with a real minus sign, and with `≈` where a
/// fraction was cut.
std::string readable(const Value& value, Language language, std::size_t most = short_enough);

/// `(x, y)`. Where numbers have a comma, a semicolon stands between them.
std::string pair_of(const std::string& x, const std::string& y, Language language);

/// For example `(8, 0) 8 × 8`.
std::string readable(const Window& window, Language language);

}  // namespace vidno::figures
