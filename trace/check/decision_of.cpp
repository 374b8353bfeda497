#include "check/decision_of.h"

namespace vidno {

std::optional<ToldDecision> decision_of(const EventView& event) {
    return event.visit([](const auto& e) -> std::optional<ToldDecision> {
        if constexpr (requires { e.decides; }) {
            return ToldDecision{e.decides, e.decision()};
        } else {
            return std::nullopt;
        }
    });
}

}  // namespace vidno
