/// DecisionCount: the verdicts on a run's decisions, procedure by procedure.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "format/event_sink.h"

namespace vidno {

/// Of one procedure, calls from it not included.
struct ProcedureVerdicts {
    Procedure procedure{};
    std::uint64_t decisions = 0;
    std::uint64_t wrong_for_operands = 0;      // the operation rounded
    std::uint64_t wrong_for_scene = 0;         // that, or its operands had drifted
    std::uint64_t undefined = 0;               // no truth: after a wrong turn
    std::optional<std::uint64_t> first_wrong;  // the step, from 1, of level `signs` that tells it or follows it
};

struct DecisionReport {
    std::vector<ProcedureVerdicts> procedures{};                        // those that decided, in the order of Procedure
    std::uint64_t intersections = 0;                                    // computed, under `float`, `double`, `bits`
    double farthest_off = 0;                                            // of them, from the exact one, in pixels
    std::array<std::uint64_t, filter_stage_names.size()> decided_by{};  // under `filtered`: how many at each stage

    bool any_wrong() const {
        return std::any_of(procedures.begin(), procedures.end(), [](const auto& each) { return each.first_wrong; });
    }
};

/// Hears every step of level `signs`, and before it the verdicts on its decisions.
class DecisionCount {
public:
    explicit DecisionCount(Procedure method) : running_{method} {}

    void judge(const Verdict& verdict) {
        auto& own = verdicts_[std::size_t(running_.back())];
        ++own.decisions;
        own.wrong_for_operands += verdict.right_for_operands ? 0 : 1;
        own.wrong_for_scene += verdict.wrong() ? 1 : 0;
        own.undefined += verdict.truth.answer ? 0 : 1;
        if ((verdict.wrong() || !verdict.right_for_operands) && !own.first_wrong) own.first_wrong = steps_ + 1;
    }
    void survey(double pixels) {
        ++report_.intersections;
        report_.farthest_off = std::max(report_.farthest_off, pixels);
    }
    void count(FilterStage stage) { ++report_.decided_by[std::size_t(stage)]; }
    void follow(const EventView& event);

    DecisionReport report() const;

private:
    std::vector<Procedure> running_;
    std::array<ProcedureVerdicts, procedure_names.size()> verdicts_;
    std::uint64_t steps_ = 0;
    DecisionReport report_;
};

}  // namespace vidno
