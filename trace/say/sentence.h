/// The sentence of a step: what happens in it, in a language. Figures, the page and the command line take it from here.
#pragma once

#include "choice/language.h"
#include "replay/floating_horizon_state.h"
#include "replay/state.h"
#include "say/exactly.h"

namespace vidno::say {

/// The sentence of an event, after which the run has this state.
Statement sentence(const EventView& event, const State& after, Language language);
Statement sentence(const EventView& event, const FloatingHorizonState& after, Language language);

}  // namespace vidno::say
