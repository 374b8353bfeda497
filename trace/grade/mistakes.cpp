#include "grade/mistakes.h"

#include <algorithm>
#include <set>

#include "run/floating_horizon_run.h"
#include "run/run.h"
#include "scene/exact_scene.h"

namespace vidno {

namespace {

/// The kinds of events that a program reports. Events that make the picture are always kept.
using Kinds = std::set<std::size_t>;

bool makes_picture(const EventView& event) {
    return event.visit(
        []<class E>(const E&) { return E::kind.from == Detail::windows && !std::is_same_v<E, event::Clear>; });
}

/// Keeps the events of a run whose kinds the program reports too.
class Filter final : public EventSink {
public:
    explicit Filter(const Kinds& kinds) : kinds_(kinds) {}
    void hear(const EventView& event) override {
        if (makes_picture(event) || kinds_.contains(event.place())) events.push_back(event.copy());
    }

    std::vector<Event> events;

private:
    const Kinds& kinds_;
};

Judgement judgement_of(Deviation deviation, const AnyHeader& of, const Kinds& kinds, Precision precision) {
    Filter filter(kinds);
    const auto* curves = std::get_if<FloatingHorizonHeader>(&of);
    const auto* polygons = std::get_if<TraceHeader>(&of);
    // The mistakes run in `double` alone.
    const NamedKernel single = kernel_of(KernelKind::binary32);
    const bool in_single =
        precision == Precision::single &&
        (curves ? single.choice->runs_floating_horizon(deviation) : single.choice->runs(polygons->method, deviation));
    const NamedKernel kernel = in_single ? single : kernel_of(KernelKind::binary64);
    // Level `windows` has no call stack, so the state accepts events without their calls.
    if (curves) {
        run(FloatingHorizonRequest{kernel, deviation, curves->scene.curves, Detail::signs, &filter});
        const FloatingHorizonHeader header{Edition(deviation), kernel.name(), Detail::windows, curves->scene};
        return judge(header, filter.events, true, precision);
    }
    const AdmittedScene scene = exact_scene::admit(polygons->scene);
    run(RunRequest{polygons->method, kernel, deviation, scene, Detail::signs, &filter});
    const TraceHeader header{polygons->method, Edition(deviation), kernel.name(), Detail::windows, polygons->scene};
    return judge(header, filter.events, true, precision);
}

/// The deviations of the method that made the trace.
std::vector<Deviation> candidates_for(const AnyHeader& header) {
    std::vector<Deviation> candidates;
    for (std::size_t i = 0; i < deviations.size(); ++i) {
        const Edition edition{Deviation(i)};
        const auto* polygons = std::get_if<TraceHeader>(&header);
        if (polygons ? has_text(edition, polygons->method) : has_text_of_curves(edition))
            candidates.push_back(Deviation(i));
    }
    // A student makes a usual mistake more often than a mistake of the printed text.
    std::stable_partition(candidates.begin(), candidates.end(),
                          [](Deviation deviation) { return !choice_of(deviation).mistake.empty(); });
    return candidates;
}

bool does_the_same(Deviation deviation, const Observation& observed, const Kinds& kinds, Precision precision) {
    const Judgement& own = *observed.judgement;
    const Judgement made = judgement_of(deviation, *observed.header, kinds, precision);
    if (made.wrong_places != own.wrong_places) return false;
    if (!own.wrong) return !made.wrong;
    const auto& claims = made.false_claims;
    return std::find(claims.begin(), claims.end(), own.false_claims.front()) != claims.end();
}

}  // namespace

std::optional<Deviation> deviation_of(const std::vector<Observation>& observed, Precision precision) {
    std::vector<Observation> cases;
    Kinds kinds;
    for (const auto& each : observed) {
        for (const auto& event : *each.events) kinds.insert(event.place());
        if (each.complete) cases.push_back(each);
    }
    kinds.erase(event_place<event::Call>);
    const auto is_wrong = [](const Observation& each) { return each.judgement->wrong.has_value(); };
    const bool any_plain = std::any_of(cases.begin(), cases.end(), [&](const Observation& each) {
        return each.judgement->is_plain && is_wrong(each);
    });
    std::erase_if(cases,
                  [&](const Observation& each) { return any_plain ? !each.judgement->is_plain : !is_wrong(each); });
    // Wrong runs first: most deviations differ there, so the search rejects them early.
    std::stable_partition(cases.begin(), cases.end(), is_wrong);
    if (cases.empty() || !is_wrong(cases.front()) || kinds.empty()) return std::nullopt;

    for (const Deviation deviation : candidates_for(*cases.front().header)) {
        const std::size_t needed = any_plain ? cases.size() : (2 * cases.size() + 2) / 3;
        std::size_t agree = 0, left = cases.size();
        for (const Observation& each : cases) {
            if (agree + left < needed) break;
            agree += std::size_t(does_the_same(deviation, each, kinds, precision));
            --left;
        }
        if (agree >= needed) return deviation;
    }
    return std::nullopt;
}

std::string in_words(Deviation deviation, const Words& say) {
    const DeviationChoice& choice = choice_of(deviation);
    if (choice.mistake.empty()) {
        return say({"It behaves like the defect {} of the printed text: {}.",
                    "Она ведёт себя как дефект {} печатного текста: {}."},
                   std::string(choice.title.english), say.of(choice.says));
    }
    return say({"It behaves like a usual mistake, {}: {}.", "Она ведёт себя как при типичной ошибке {}: {}."},
               std::string(choice.mistake),
               choice.advice.english.empty() ? say.of(choice.says) : say.of(choice.advice));
}

}  // namespace vidno
