/// The decision that an event reports, if any.
#pragma once

#include <optional>

#include "format/event_sink.h"

namespace vidno {

struct ToldDecision {
    Decision of;
    Answer answer;
};

std::optional<ToldDecision> decision_of(const EventView& event);

}  // namespace vidno
