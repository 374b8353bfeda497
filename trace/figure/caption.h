/// The caption of a step: a sentence that says what happens.
#pragma once

#include "floating_horizon_moment.h"
#include "moment.h"

namespace vidno::figures {

std::string caption_of(const Moment& moment, Language language);
std::string caption_of(const FloatingHorizonMoment& moment, Language language);

/// "(a)" for 0, "(z)" for 25, "(aa)" for 26.
std::string letter_of(std::size_t place);

}  // namespace vidno::figures
