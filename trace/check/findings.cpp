#include "check/findings.h"

#include <algorithm>
#include <concepts>

#include "check/decision_count.h"
#include "check/judged_run.h"

namespace vidno {

namespace {

/// Weiler and Atherton's algorithm compares the depths of two polygons as numbers.
Coincidence meaning(Coincidence coincidence, const EventView& event) {
    const bool of_depths = event.get_if<event::Behind>() || event.get_if<event::Order>();
    return of_depths && coincidence == Coincidence::equal_numbers ? Coincidence::equal_depths : coincidence;
}

}  // namespace

FindingList::FindingList(Procedure method, const Area& area, std::size_t narrowest, std::size_t most_zeros,
                         Detail level)
    : running_{method}, whereabouts_(area), most_narrow_(narrowest), most_zeros_(most_zeros), level_(level) {}

bool FindingList::is_narrow(const Gap& gap) const {
    return most_narrow_ > 0 && (narrow_.size() < most_narrow_ || gap.ulps < narrow_.rbegin()->first);
}

void FindingList::judge(const Verdict& verdict) {
    ++decisions_;
    const auto gap = verdict.calculator ? verdict.calculator->gap() : std::nullopt;
    const bool is_wrong = verdict.wrong() || !verdict.right_for_operands;
    FindingKind kind = FindingKind::wrong;
    if (!is_wrong) {
        if (!gap) return;
        kind = gap->sign == Sign::zero ? FindingKind::zero : FindingKind::narrow;
        if (kind == FindingKind::narrow && !is_narrow(*gap)) return;
    }
    pending_.add({verdict.of,
                  {.kind = kind, .procedure = running_.back(), .decision = JudgedDecision(verdict), .gap = gap},
                  decisions_});
}

void FindingList::survey(const Surveyed& point) {
    if (point.off <= most_pixels_off) return;
    Verdict of_point;
    of_point.calculator = point.calculator;
    pending_.add({{},
                  {.kind = FindingKind::point,
                   .procedure = running_.back(),
                   .decision = JudgedDecision(of_point),
                   .off = point.off}});
}

void FindingList::follow(const EventView& event) {
    event.visit([&]<class E>(const E& e) {
        at_ = e.at;
        is_shown_ = event::level_of(e) <= level_;
        if constexpr (std::same_as<E, event::Draw>) {
            for (std::size_t i = filling_; i < findings_.size(); ++i) {
                if (findings_[i].procedure == Procedure::fill_polygon) findings_[i].polygons = {e.polygon};
            }
            for (auto& [ulps, each] : narrow_) {
                const bool is_of_this = each.procedure == Procedure::fill_polygon && each.polygons.empty();
                if (is_of_this) each.polygons = {e.polygon};
            }
        }
    });
    for (auto& pending : pending_.reported_by(event)) place(std::move(pending), event);
    event.visit([&]<class E>(const E& e) {
        if constexpr (std::same_as<E, event::Call>) {
            running_.push_back(e.of);
            if (e.of == Procedure::fill_polygon) filling_ = findings_.size();
        }
        if constexpr (requires { E::result_of; }) running_.pop_back();
    });
    whereabouts_.follow(event);
    if (is_shown_) ++steps_;
}

void FindingList::place(PendingFinding pending, const EventView& event) {
    Finding& finding = pending.finding;
    finding.step = steps_ + 1;
    finding.is_shown = is_shown_;
    finding.at = at_;
    auto& gap = finding.gap;
    // An event that reports a decision reports the last one before it.
    if (gap && pending.number == decisions_) gap->if_zero = meaning(gap->if_zero, event);
    const bool draws = event.get_if<event::Draw>();
    if (finding.procedure != Procedure::fill_polygon || draws) finding.polygons = whereabouts_.polygons(event);
    finding.pixels = whereabouts_.pixels(event, finding.decision.of, gap ? gap->pixel : std::nullopt);
    if (finding.kind == FindingKind::narrow) return keep_narrow(std::move(finding));
    if (gap && gap->sign == Sign::zero) {
        Zeros& zeros = zeros_[std::size_t(gap->if_zero)];
        if (zeros.count++ == 0) zeros.first = finding.step;
    }
    if (finding.kind == FindingKind::zero) {
        if (most_zeros_ == 0) return;
        --most_zeros_;
    }
    findings_.push_back(std::move(finding));
}

void FindingList::keep_narrow(Finding finding) {
    if (!is_narrow(*finding.gap)) return;
    const double ulps = finding.gap->ulps;
    narrow_.emplace(ulps, std::move(finding));
    if (narrow_.size() > most_narrow_) narrow_.erase(std::prev(narrow_.end()));
}

std::vector<Finding> FindingList::findings() {
    for (auto& pending : pending_.rest()) {
        pending.finding.step = steps_;
        pending.finding.at = at_;
        if (pending.finding.kind == FindingKind::narrow) {
            const double ulps = pending.finding.gap->ulps;
            narrow_.emplace(ulps, std::move(pending.finding));
        } else {
            findings_.push_back(std::move(pending.finding));
        }
    }
    std::vector<Finding> all = std::move(findings_);
    for (auto& [ulps, finding] : narrow_) all.push_back(std::move(finding));
    // What follows the last event of the level belongs to its last step.
    for (Finding& finding : all) finding.step = std::min(finding.step, steps_);
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.step < b.step; });
    return all;
}

namespace {

/// `run(request, followers)` executes the run.
void find(auto& request, FindingList& findings, auto&& run) {
    const Judge judge = [&](const Verdict& verdict) { findings.judge(verdict); };
    const Surveyor survey = [&](const Surveyed& point) { findings.survey(point); };
    FunctionSink sink([&](const EventView& event) {
        request.progress();
        findings.follow(event);
    });
    request.detail = Detail::signs;
    request.sink = &sink;
    run(request, Followers{.judge = &judge, .survey = &survey});
}

}  // namespace

void find_in(RunRequest request, FindingList& findings) {
    find(request, findings, request.kernel.is_always_right() ? exactly_judged_run : judged_run);
}

void find_in(FloatingHorizonRequest request, FindingList& findings) {
    find(request, findings, traced_floating_horizon);
}

}  // namespace vidno
