/// The verdict on a run at its end, in one sentence.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "choice/language.h"
#include "format/trace_header.h"

namespace vidno::say {

/// How a run compares with exact arithmetic.
struct Comparison {
    /// Awaited: it is being compared.
    enum class Is : unsigned char { unknown, awaited, known };
    Is is = Is::unknown;
    /// The pixels that differ from the exact picture; in a run of curves, the steps with wrong decisions.
    std::uint64_t wrong = 0;
};

/// The number of a run's events of each type, by its place in AllEvents.
using Tally = std::array<std::uint64_t, AllEvents::count>;

/// The size of the picture, how it compares, and how often the run did what its method does. It claims exactness only
/// if the comparison is known.
std::string verdict(const AnyHeader& header, const Tally& tally, const Comparison& comparison, Language language);

}  // namespace vidno::say
