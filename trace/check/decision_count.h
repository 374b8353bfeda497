/// DecisionCount: the verdicts on a run's decisions, procedure by procedure.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "check/pending.h"
#include "run/followers.h"

namespace vidno {

/// The counts of one procedure, without the calls that it makes.
struct ProcedureVerdicts {
    Procedure procedure{};
    std::uint64_t decisions = 0;
    std::uint64_t wrong_for_operands = 0;  // the operation rounded
    std::uint64_t wrong_for_scene = 0;     // that, or its operands had drifted
    std::uint64_t undefined = 0;           // no truth: after a wrong turn
    // The steps of level `signs`, from 1, that report the first of these or follow it. At the first a checked trace has
    // a `disagree`.
    std::optional<std::uint64_t> first_wrong{};
    std::optional<std::uint64_t> first_wrong_for_operands{};

    /// The first that is wrong for the scene; if there is none, the first that is wrong only for its numbers.
    std::optional<std::uint64_t> first() const { return first_wrong ? first_wrong : first_wrong_for_operands; }
};

/// A constructed point farther than this from the exact one, in pixels, is an error.
inline constexpr double most_pixels_off = 0.5;

struct DecisionReport {
    std::vector<ProcedureVerdicts> procedures{};                        // those that decided, in the order of Procedure
    std::uint64_t intersections = 0;                                    // computed, under `float`, `double`, `bits`
    double farthest_off = 0;                                            // the greatest error of one, in pixels
    std::uint64_t farthest_step = 0;                                    // the step that reports it
    std::uint64_t points_off = 0;                                       // errors of more than most_pixels_off
    std::array<std::uint64_t, filter_stage_names.size()> decided_by{};  // under `filtered`: how many at each stage

    bool any_wrong() const {
        return points_off > 0 || std::any_of(procedures.begin(), procedures.end(),
                                             [](const auto& each) { return each.first().has_value(); });
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
        if (!verdict.wrong() && verdict.right_for_operands) return;
        auto& first = verdict.wrong() ? own.first_wrong : own.first_wrong_for_operands;
        if (!first) wrong_.add({verdict.of, &first});
    }
    void survey(const Surveyed& point) {
        ++report_.intersections;
        report_.points_off += point.off > most_pixels_off ? 1 : 0;
        if (point.off <= report_.farthest_off) return;
        report_.farthest_off = point.off;
        report_.farthest_step = steps_ + 1;
    }
    void count(FilterStage stage) { ++report_.decided_by[std::size_t(stage)]; }
    void follow(const EventView& event);

    /// Call it once the run has ended.
    DecisionReport report();

private:
    /// Where the step of a wrong decision is stored, if it is the first.
    struct Wrong {
        Decision of;
        std::optional<std::uint64_t>* first;
    };

    void keep_step(const std::vector<Wrong>& wrong) {
        for (const auto& [of, first] : wrong) {
            if (!*first) *first = steps_;
        }
    }

    std::vector<Procedure> running_;
    std::array<ProcedureVerdicts, procedure_names.size()> verdicts_;
    std::uint64_t steps_ = 0;
    Pending<Wrong> wrong_;
    DecisionReport report_;
};

}  // namespace vidno
