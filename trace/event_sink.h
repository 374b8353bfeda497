/// EventSink: whatever hears the events of a run: a writer, a judge, a test.
///
/// A recorder knows this one type, so that a run is compiled once for all who hear it.
#pragma once

#include <cstddef>
#include <functional>
#include <utility>

#include "event.h"

namespace vidno {

/// An event where it lies, for the time of a call.
class EventView {
public:
    template <EventType E>
    EventView(const E& event) : place_(event_place<E>), event_(&event) {}
    EventView(const Event& event);

    /// That of its type in AnyEvent.
    std::size_t place() const { return place_; }

    /// None if it is of another type.
    template <EventType E>
    const E* get_if() const {
        return place_ == event_place<E> ? static_cast<const E*>(event_) : nullptr;
    }

    Event copy() const;

    /// Calls `use(const event::Push&)` and so on, and gives what that gives.
    decltype(auto) visit(auto&& use) const { return visit_in(static_cast<const AnyEvent*>(nullptr), use); }

private:
    template <class Use, class... Events>
    decltype(auto) visit_in(const std::variant<Events...>*, Use& use) const {
        using Result = std::invoke_result_t<Use&, const event::Push&>;
        using Call = Result (*)(const void*, Use&);
        static constexpr Call calls[]{
            [](const void* event, Use& of) -> Result { return of(*static_cast<const Events*>(event)); }...};
        return calls[place_](event_, use);
    }

    std::size_t place_;
    const void* event_;
};

/// Hears each event of the level that was asked for. It may throw to end the run.
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
class HeardBy final : public EventSink {
public:
    explicit HeardBy(Use use) : use_(std::move(use)) {}
    void hear(const EventView& event) override { use_(event); }

private:
    Use use_;
};

}  // namespace vidno
