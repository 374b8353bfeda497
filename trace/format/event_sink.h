/// EventSink: hears the events of a run: a writer, a judge, a test.
///
/// A recorder knows only this type, so that a run is compiled once for all sinks.
#pragma once

#include <functional>
#include <utility>

#include "format/event.h"

namespace vidno {

/// Hears each event of the requested level. It may throw to end the run.
class EventSink {
public:
    virtual void hear(const EventView& event) = 0;

protected:
    EventSink() = default;
    EventSink(const EventSink&) = default;
    EventSink& operator=(const EventSink&) = default;
    ~EventSink() = default;
};

using HearEvent = std::function<void(const EventView&)>;

/// The sink that calls a function with each event, `use(const EventView&)`.
template <class Use>
class FunctionSink final : public EventSink {
public:
    explicit FunctionSink(Use use) : use_(std::move(use)) {}
    void hear(const EventView& event) override { use_(event); }

private:
    Use use_;
};

}  // namespace vidno
