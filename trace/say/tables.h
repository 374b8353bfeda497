/// The tables of sentences and of notes. Each algorithm has one, which says in both languages what each of its events
/// means, and in the notation of a listing what it found; so have the events that all algorithms share.
#pragma once

#include "say/words.h"

namespace vidno::say {

std::string warnock_sentence(const EventView& event, const PolygonWords& words);
std::string z_buffer_sentence(const EventView& event, const PolygonWords& words);
std::string weiler_atherton_sentence(const EventView& event, const PolygonWords& words);
std::string floating_horizon_sentence(const EventView& event, const CurveWords& words);

// The events of all algorithms.
std::string common_sentence(const event::Call& event, const Words& words);
std::string common_sentence(const event::Disagree& event, const Words& words);
std::string common_sentence(const event::Fault& event, const Words& words);
std::string common_sentence(const event::Plane& event, const PolygonWords& words);
std::string common_sentence(const event::Depth& event, const PolygonWords& words);

// The notes of all algorithms' events.
std::string common_note(const event::Disagree& event, const Words& words);
std::string common_note(const event::Fault& event, const Words& words);
std::string common_note(const event::Plane& event, const PolygonWords& words);
std::string common_note(const event::Depth& event, const PolygonWords& words);

/// The notes of an algorithm; of some events there is none.
std::string warnock_note(const EventView& event, const PolygonWords& words);
std::string z_buffer_note(const EventView& event, const PolygonWords& words);
std::string weiler_atherton_note(const EventView& event, const PolygonWords& words);
std::string floating_horizon_note(const EventView& event, const CurveWords& words);

/// Whether an event has a note, by its place in AllEvents.
using Noted = std::array<bool, AllEvents::count>;
extern const Noted noted_by_warnock, noted_by_z_buffer, noted_by_weiler_atherton, noted_by_floating_horizon;

/// The sentence of one of these events: that of the table, or the common one.
template <class Events>
std::string sentence_in(const auto& table, const EventView& event) {
    return event.visit([&](const auto& e) -> std::string {
        if constexpr (!Events::template has<std::decay_t<decltype(e)>>()) {
            return {};
        } else if constexpr (requires { table(e); }) {
            return table(e);
        } else {
            return common_sentence(e, table);
        }
    });
}

/// The note of one of these events: that of the table, or the common one; otherwise nothing.
template <class Events>
std::string note_in(const auto& table, const EventView& event) {
    return event.visit([&](const auto& e) -> std::string {
        if constexpr (!Events::template has<std::decay_t<decltype(e)>>()) {
            return {};
        } else if constexpr (requires { table.note(e); }) {
            return table.note(e);
        } else if constexpr (requires { common_note(e, table); }) {
            return common_note(e, table);
        } else {
            return {};
        }
    });
}

template <class Events, class Table, class E>
constexpr bool has_note() {
    if constexpr (!Events::template has<E>()) {
        return false;
    } else {
        return requires(const Table& table, const E& e) { table.note(e); }
        || requires(const Table& table, const E& e) { common_note(e, table); };
    }
}
/// The events of which `note_in` makes something.
template <class Events, class Table, class... All>
constexpr Noted noted_in(EventTypes<All...>) {
    return {has_note<Events, Table, All>()...};
}

}  // namespace vidno::say
