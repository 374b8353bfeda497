#include "grade/judge.h"

#include <cmath>

#include "grade/warnock_judge.h"
#include "grade/z_buffer_judge.h"

namespace vidno {

namespace {

using grading::False;

/// Calls `take` with every number of an event.
struct Numbers {
    const std::function<void(double)>& take;

    void operator()(const Value& value) const { take(value.number); }
    void operator()(const ValuePoint& point) const {
        (*this)(point.x);
        (*this)(point.y);
    }
    void operator()(const ValueVertex& vertex) const {
        (*this)(vertex.x);
        (*this)(vertex.y);
        (*this)(vertex.z);
    }
    template <class T>
    void operator()(const std::optional<T>& value) const {
        if (value) (*this)(*value);
    }
    template <class T>
    void operator()(const std::vector<T>& values) const {
        for (const T& value : values) (*this)(value);
    }
    template <std::size_t count>
    void operator()(const std::array<Value, count>& values) const {
        for (const Value& value : values) (*this)(value);
    }
    void operator()(const auto&) const {}  // no number of the kernel
};

/// A program in `float` may not have said so: its numbers tell it.
bool all_single(const std::vector<Event>& events) {
    bool all = true;
    const std::function<void(double)> look = [&](double value) {
        all = all && (std::isnan(value) || double(float(value)) == value);
    };
    for (const auto& event : events) {
        event.visit([&]<class E>(const E& e) {
            E::fields(e, [&](std::string_view, const auto& field, const auto&...) { Numbers{look}(field); });
        });
    }
    return all;
}

std::string label_of(const EventView& event) {
    return event.visit([](const auto& e) { return std::string(line_names[std::size_t(e.at)]); });
}

/// The rest of a run that is not judged any more: for its picture.
void replay_rest(const std::vector<Event>& events, State& state) {
    try {
        while (state.step() < events.size()) state.apply(events[state.step()]);
    } catch (const Impossible&) {
        return;
    }
}

template <class Judge>
void judge_by(const SceneTruth& truth, const std::vector<Event>& events, bool complete, State& state,
              Judgement& found) {
    Judge judge(truth, state, found.differences);
    const auto wrong_at = [&](std::uint64_t step, const False& claim) {
        const std::uint64_t at = claim.step.value_or(step);
        found.wrong = Wrong{at, at == 0 ? "" : label_of(events[at - 1]), claim.told, claim.right, claim.symptom};
    };
    try {
        for (const auto& event : events) {
            judge.take(event, state.step() + 1);
            state.apply(event);
        }
        if (complete) judge.finish();
    } catch (const False& claim) {
        wrong_at(std::min<std::uint64_t>(state.step() + 1, events.size()), claim);
    } catch (const Impossible& impossible) {
        wrong_at(state.step() + 1, {Symptom::impossible, "this step", impossible.reason});
    }
}

}  // namespace

std::string_view words_of(Difference difference) {
    switch (difference) {
        case Difference::order_of_parts: return "the parts of a window in another order";
        case Difference::order_of_polygons: return "the polygons in another order";
        case Difference::order_of_vertices: return "outlines in the opposite direction";
        case Difference::outline: return "another rule for points of an outline";
        case Difference::equally_near: return "another one of equally near polygons";
        case Difference::hidden_leave: return "hidden polygons leave the list";
        case Difference::single_precision: return "numbers in float";
        case Difference::recursion: return "recursion instead of the stack";
        case Difference::other_windows: return "other windows";
    }
    return "";
}

Judgement judge(const TraceHeader& header, const std::vector<Event>& events, bool complete) {
    const bool single = header.kernel == "float" || all_single(events);
    const SceneTruth truth(header.scene, single ? Precision::single : Precision::twice);
    State state(header);
    Judgement found{std::nullopt, {}, state.picture()};
    if (header.kernel == "float") found.differences.insert(Difference::single_precision);
    if (header.method == Method::warnock) {
        judge_by<grading::WarnockJudge>(truth, events, complete, state, found);
    } else {
        judge_by<grading::ZBufferJudge>(truth, events, complete, state, found);
    }
    replay_rest(events, state);
    found.picture = state.picture();
    return found;
}

}  // namespace vidno
