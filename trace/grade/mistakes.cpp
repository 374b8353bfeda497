#include "grade/mistakes.h"

#include <algorithm>
#include <array>
#include <memory>
#include <set>

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

Judgement judgement_of(Deviation deviation, const TraceHeader& of, const Kinds& kinds, Precision precision) {
    // The mistakes run in `double` alone.
    const NamedKernel single = *kernel_named("float");
    const bool in_single = precision == Precision::single && single.choice->runs(of.method, deviation);
    const NamedKernel kernel = in_single ? single : *kernel_named("double");
    Filter filter(kinds);
    const AdmittedScene scene = exact_scene::admit(of.scene);
    run({of.method, kernel, deviation, scene, Detail::signs, &filter});
    // Level `windows` has no call stack, so the state accepts events without their calls.
    const TraceHeader header{of.method, Edition(deviation), kernel.name(), Detail::windows, of.scene};
    return judge(header, filter.events, true, precision);
}

/// The wrong pixels of a picture: column, row, red, green, blue.
std::vector<std::array<int, 5>> wrong_pixels(const SceneTruth& truth, const Picture& picture) {
    std::vector<std::array<int, 5>> wrong;
    const Area& area = truth.scene().area;
    for (int row = area.y; row < area.bottom(); ++row) {
        for (int column = area.x; column < area.right(); ++column) {
            const Color color = picture.at(column, row);
            if (!truth.allows(column, row, color)) wrong.push_back({column, row, color.red, color.green, color.blue});
        }
    }
    return wrong;
}

bool has_outline_on_centre(const SceneTruth& truth) {
    const Area& area = truth.scene().area;
    for (int row = area.y; row < area.bottom(); ++row) {
        for (int column = area.x; column < area.right(); ++column) {
            if (truth.seen(column, row).on_outline) return true;
        }
    }
    return false;
}

/// An observation with what a comparison needs.
struct Compared {
    const Observation* observed;
    std::unique_ptr<SceneTruth> truth;
    std::vector<std::array<int, 5>> wrong;
    bool is_plain;  // no pixel centre lies on an outline

    bool is_wrong() const { return observed->judgement->wrong.has_value(); }
};

bool does_the_same(Deviation deviation, const Compared& on, const Kinds& kinds, Precision precision) {
    const auto made = judgement_of(deviation, *on.observed->header, kinds, precision);
    if (wrong_pixels(*on.truth, made.picture) != on.wrong) return false;
    if (!on.is_wrong()) return !made.wrong;
    const auto& claims = made.false_claims;
    return std::find(claims.begin(), claims.end(), on.observed->judgement->false_claims.front()) != claims.end();
}

}  // namespace

std::optional<Deviation> deviation_of(const std::vector<Observation>& observed, Precision precision) {
    std::vector<Compared> cases;
    Kinds kinds;
    for (const auto& each : observed) {
        for (const auto& event : *each.events) kinds.insert(event.place());
        if (!each.complete) continue;
        auto truth = std::make_unique<SceneTruth>(each.header->scene, precision);
        auto wrong = wrong_pixels(*truth, each.judgement->picture);
        const bool is_plain = !has_outline_on_centre(*truth);
        cases.push_back({&each, std::move(truth), std::move(wrong), is_plain});
    }
    kinds.erase(event_place<event::Call>);
    const bool any_plain =
        std::any_of(cases.begin(), cases.end(), [](const Compared& each) { return each.is_plain && each.is_wrong(); });
    std::erase_if(cases, [&](const Compared& each) { return any_plain ? !each.is_plain : !each.is_wrong(); });
    // Wrong runs first: most deviations differ there, so the search rejects them early.
    std::stable_partition(cases.begin(), cases.end(), [](const Compared& each) { return each.is_wrong(); });
    if (cases.empty() || !cases.front().is_wrong() || kinds.empty()) return std::nullopt;

    const Method method = cases.front().observed->header->method;
    std::vector<Deviation> candidates;
    for (std::size_t i = 0; i < deviations.size(); ++i) {
        if (has_text(Edition(Deviation(i)), method)) candidates.push_back(Deviation(i));
    }
    // A student makes a usual mistake more often than a mistake of the printed text.
    std::stable_partition(candidates.begin(), candidates.end(),
                          [](Deviation deviation) { return !choice_of(deviation).mistake.empty(); });
    for (const Deviation deviation : candidates) {
        const std::size_t needed = any_plain ? cases.size() : (2 * cases.size() + 2) / 3;
        std::size_t agree = 0, left = cases.size();
        for (const Compared& each : cases) {
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
    return say({"It behaves like a usual mistake, {}: {}.", "Она ведёт себя как при обычной ошибке {}: {}."},
               std::string(choice.mistake),
               choice.advice.english.empty() ? say.of(choice.says) : say.of(choice.advice));
}

}  // namespace vidno
