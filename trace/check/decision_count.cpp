#include "check/decision_count.h"

#include <concepts>

namespace vidno {

void DecisionCount::follow(const EventView& event) {
    ++steps_;
    keep_step(wrong_.reported_by(event));
    event.visit([&]<class E>(const E& e) {
        if constexpr (std::same_as<E, event::Call>) running_.push_back(e.of);
        if constexpr (requires { E::result_of; }) running_.pop_back();
    });
}

DecisionReport DecisionCount::report() {
    keep_step(wrong_.rest());
    DecisionReport report = report_;
    for (std::size_t i = 0; i < verdicts_.size(); ++i) {
        if (verdicts_[i].decisions == 0) continue;
        report.procedures.push_back(verdicts_[i]);
        report.procedures.back().procedure = Procedure(i);
    }
    return report;
}

}  // namespace vidno
