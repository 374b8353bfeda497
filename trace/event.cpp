#include "event.h"

#include <memory>

#include "event_sink.h"

namespace vidno {

Event::Event(const Event&) = default;
Event::Event(Event&&) noexcept = default;
Event& Event::operator=(const Event& other) { return *this = Event(other); }
Event& Event::operator=(Event&& other) noexcept {
    if (this != &other) {
        std::destroy_at(this);
        std::construct_at(this, std::move(other));
    }
    return *this;
}
Event::~Event() = default;

EventView::EventView(const Event& event)
    : EventView(std::visit([](const auto& e) { return EventView(e); }, static_cast<const AnyEvent&>(event))) {}

Event EventView::copy() const {
    return visit([](const auto& event) { return Event(event); });
}

}  // namespace vidno
