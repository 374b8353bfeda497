/// The sentence of a step: what happens in it, in a language; and its note: what it found, in the notation of the
/// listing, beside the step's line. Figures, the page and the command line take them from here.
#pragma once

#include "choice/language.h"
#include "replay/floating_horizon_state.h"
#include "replay/state.h"
#include "say/exactly.h"

namespace vidno::say {

/// The sentence of an event, after which the run has this state.
Statement sentence(const EventView& event, const State& after, Language language);
Statement sentence(const EventView& event, const FloatingHorizonState& after, Language language);

/// The note of an event; empty if it has none. `run` is any state of its run.
std::string note(const EventView& event, const State& run, Language language);
std::string note(const EventView& event, const FloatingHorizonState& run, Language language);

/// Whether events of a type have notes, by its place in AllEvents.
bool has_note(std::size_t event);

}  // namespace vidno::say
