/// Numbers and the texts of events, in the notation of the listings: short, and the same in any language.
#pragma once

#include <string>

#include "format/event.h"

namespace vidno::figures {

/// With all its digits, and a real minus sign.
std::string in_full(double value);

inline constexpr std::size_t short_enough = 7;  // characters of a number that is read at a glance

/// A number in at most `most` characters (more with a power of ten), with a real minus sign, and with `≈` where a fraction was cut.
std::string readable(const Value& value, std::size_t most = short_enough);

/// For example `(8, 0) 8 × 8`.
std::string readable(const Window& window);

/// The text of an event beside its line, perhaps empty.
std::string note_of(const EventView& event, const Scene& scene);

}  // namespace vidno::figures
