/// The values in play at a step: what the listing has beside its lines.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "choice/language.h"
#include "vidno/line.h"

namespace vidno {

class Replay;

namespace say {

/// The last note of each line in the running procedures since the start of their current loop iterations; notes of
/// later lines from an earlier iteration are outdated. The search goes back to the start of the current window,
/// polygon, curve or list, and at most 400 steps, so that a long list of polygons does not slow it down.
std::vector<std::pair<Line, std::string>> notes_in_play(Replay& run, std::uint64_t step, Language language);

}  // namespace say
}  // namespace vidno
