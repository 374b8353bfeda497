/// The decision that an event reports, if any, and what a check has added to it.
#pragma once

#include <optional>

#include "format/event_sink.h"

namespace vidno {

struct ReportedDecision {
    Decision of;
    Answer answer;
    const CheckedFields& checked;  // the event's
};

std::optional<ReportedDecision> decision_of(const EventView& event);

}  // namespace vidno
