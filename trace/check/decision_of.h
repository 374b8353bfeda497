/// The decision that an event reports, if any.
#pragma once

#include <optional>

#include "format/event_sink.h"

namespace vidno {

struct ReportedDecision {
    Decision of;
    Answer answer;
};

std::optional<ReportedDecision> decision_of(const EventView& event);

}  // namespace vidno
