/// Exactly: what is so where a sentence states what a run computed and that is wrong.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "choice/kernel_choice.h"
#include "format/trace_header.h"
#include "say/words.h"

namespace vidno::say {

/// Whether a run's words can be wrong: its kernel rounds, or its text is not the corrected one.
bool can_be_wrong(const TraceHeader& header);
bool can_be_wrong(const FloatingHorizonHeader& header);

/// What is so instead, after "Exactly: ", in exact arithmetic and by the picture rule; and the pixel that shows it, if
/// it is about one.
struct Exact {
    std::string text;
    std::optional<std::pair<int, int>> pixel;
};

/// None if what the event's sentence states is so.
std::optional<Exact> exactly(const EventView& event, const PolygonWords& words);
std::optional<Exact> exactly(const EventView& event, const CurveWords& words);

/// What is so of the colour that a pixel has.
std::optional<Exact> exactly_at(int x, int y, const PolygonWords& words);

/// What a run computed; and what is so, if that is something else.
struct Statement {
    std::string text, exactly{};
    std::optional<std::pair<int, int>> pixel{};

    std::string whole() const { return exactly.empty() ? text : text + " " + exactly; }
};

/// Marks a text as computed if something else is so.
Statement stated(std::string text, const std::optional<Exact>& exact, const Words& words);

}  // namespace vidno::say
