#include "check/decision_of.h"

namespace vidno {

std::optional<ReportedDecision> decision_of(const EventView& event) {
    return event.visit([](const auto& e) -> std::optional<ReportedDecision> {
        if constexpr (requires { e.decides; }) {
            return ReportedDecision{e.decides, e.decision(), e.checked};
        } else {
            return std::nullopt;
        }
    });
}

}  // namespace vidno
