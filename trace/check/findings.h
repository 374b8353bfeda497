/// Findings: the decisions of a judged run that are worth examining: wrong ones, those that rest on an exact
/// coincidence, and the narrowest of the others; and constructed points that are an error. FORMAT.md describes their
/// file.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "check/judged_decision.h"
#include "check/pending.h"
#include "check/whereabouts.h"
#include "run/floating_horizon_run.h"
#include "run/run.h"

namespace vidno {

/// Why a decision is listed.
enum class FindingKind : unsigned char { wrong, zero, narrow, point };
inline constexpr std::array<std::string_view, 4> finding_kind_names{"wrong", "zero", "narrow", "point"};

struct Finding {
    FindingKind kind{};
    std::uint64_t step = 0;  // from 1: the event that reports it or is the first after it
    bool is_shown = true;    // false if the level has no such event: the step then contains it
    Line at{};
    Procedure procedure{};
    std::vector<PolygonPlace> polygons{};
    PixelRectangle pixels{};  // the pixels whose colour it may change
    JudgedDecision decision;  // for a point, the operands are its coordinates
    std::optional<Gap> gap{};
    double off = 0;  // of a point
};

/// Collects findings during a run. It hears each event of level `signs`, and before it what followers hear.
class FindingList {
public:
    /// `narrowest` is the number of narrow decisions that are listed. All zeros are counted, and the first `most_zeros`
    /// are listed. Steps are those of a trace of the level.
    FindingList(Procedure method, const Area& area, std::size_t narrowest = 20,
                std::size_t most_zeros = std::size_t(-1), Detail level = Detail::signs);

    void judge(const Verdict& verdict);
    void survey(const Surveyed& point);
    void follow(const EventView& event);

    /// The findings in the order of the steps. Call it once the run has ended.
    std::vector<Finding> findings();

    /// The number of decisions that rest on each kind of coincidence, and the step of the first.
    struct Zeros {
        std::uint64_t count = 0, first = 0;
    };
    const std::array<Zeros, coincidence_names.size()>& zeros() const { return zeros_; }

private:
    /// Findings whose event has not come yet.
    struct PendingFinding {
        Decision of;
        Finding finding;
        std::uint64_t number = 0;  // among all decisions; none for a point
    };

    bool is_narrow(const Gap& gap) const;
    void place(PendingFinding pending, const EventView& event);
    void keep_narrow(Finding finding);

    std::vector<Procedure> running_;
    Whereabouts whereabouts_;
    std::size_t most_narrow_, most_zeros_;
    Detail level_;
    std::uint64_t steps_ = 0;  // before the current event
    bool is_shown_ = true;     // the current event
    std::uint64_t decisions_ = 0;
    Line at_{};
    Pending<PendingFinding> pending_;
    std::vector<Finding> findings_;          // all but the narrow ones
    std::multimap<double, Finding> narrow_;  // by ulps; of equals the first is the narrower, on every system
    std::size_t filling_ = 0;                // where the findings of the FillPolygon that is running begin
    std::array<Zeros, coincidence_names.size()> zeros_{};
};

/// Executes a run for its findings. For a kernel that is always right it runs `exact`, whose decisions and events are
/// the same.
void find_in(RunRequest request, FindingList& findings);
void find_in(FloatingHorizonRequest request, FindingList& findings);

}  // namespace vidno
