/// The tables of sentences. Each algorithm has one, which says in both languages what each of its events means; so have
/// the events that all algorithms share.
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

}  // namespace vidno::say
