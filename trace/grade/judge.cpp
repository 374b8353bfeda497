#include "grade/judge.h"

#include <cmath>

#include "grade/warnock_judge.h"
#include "grade/weiler_atherton_judge.h"
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
    void operator()(const auto&) const {}  // not a number of the kernel
};

/// How many numbers the events have, and whether a float holds each of them.
struct Counted {
    std::size_t numbers = 0;
    bool all_single = true;
};

Counted counted(const std::vector<Event>& events) {
    Counted found;
    const std::function<void(double)> look = [&](double value) {
        ++found.numbers;
        found.all_single = found.all_single && (std::isnan(value) || double(float(value)) == value);
    };
    for (const auto& event : events) {
        event.visit([&]<class E>(const E& e) {
            E::fields(e, [&](std::string_view, const auto& field, const auto&...) { Numbers{look}(field); });
        });
    }
    return found;
}

std::string label_of(const EventView& event) {
    return event.visit([](const auto& e) { return std::string(line_names[std::size_t(e.at)]); });
}

/// A space and the index of the event's polygon; empty if it has none.
std::string polygon_of(const EventView& event) {
    return event.visit([](const auto& e) -> std::string {
        if constexpr (requires { e.polygon.index; }) return " " + std::to_string(e.polygon.index);
        return "";
    });
}

/// The first false claim becomes `wrong`. Later events are judged too, because the set of all false claims distinguishes one mistake from
/// another.
template <class Judge>
void judge_by(const SceneTruth& truth, const std::vector<Event>& events, bool complete, State& state, const Words& say,
              Judgement& found) {
    Judge judge(truth, state, found.differences, say);
    const auto add = [&](std::uint64_t step, const False& claim) {
        const std::uint64_t at = std::min<std::uint64_t>(claim.step.value_or(step), events.size());
        const std::string about = judge.place() + (at == 0 ? "" : polygon_of(events[at - 1]));
        found.false_claims.push_back({claim.symptom, about});
        if (found.wrong) return;
        found.wrong = Wrong{at, at == 0 ? "" : label_of(events[at - 1]), claim.told, claim.right, claim.symptom};
    };
    const auto look_at = [&](std::uint64_t step, auto&& what) {
        try {
            what();
        } catch (const False& claim) {
            add(step, claim);
        }
    };
    try {
        for (const auto& event : events) {
            look_at(state.step() + 1, [&] { judge.take(event, state.step() + 1); });
            state.apply(event);
        }
        if (complete) look_at(events.size(), [&] { judge.finish(); });
    } catch (const Impossible& impossible) {
        add(state.step() + 1, {Symptom::impossible, say({"this step", "этот шаг"}),
                               say({"{}", "такого состояния у процедуры быть не может ({})"}, impossible.reason)});
    }
}

int open_pixels(const SceneTruth& truth) {
    const Area& area = truth.scene().area;
    int open = 0;
    for (int row = area.y; row < area.bottom(); ++row) {
        for (int column = area.x; column < area.right(); ++column) open += int(truth.seen(column, row).is_open);
    }
    return open;
}

}  // namespace

Bilingual words_of(Difference difference) {
    switch (difference) {
        case Difference::order_of_parts:
            return {"the parts of a window in another order", "части окна в другом порядке"};
        case Difference::order_of_polygons: return {"the polygons in another order", "многоугольники в другом порядке"};
        case Difference::order_of_vertices:
            return {"outlines in the opposite direction", "границы обходятся в обратную сторону"};
        case Difference::outline: return {"another rule for points of an outline", "другое правило для точек границы"};
        case Difference::equally_near:
            return {"another one of equally near polygons", "другой из одинаково близких многоугольников"};
        case Difference::hidden_leave:
            return {"hidden polygons leave the list", "закрытые многоугольники уходят из списка"};
        case Difference::single_precision: return {"numbers in float", "числа типа float"};
        case Difference::recursion: return {"recursion instead of the stack", "рекурсия вместо стека"};
        case Difference::breadth_first: return {"the windows breadth first", "окна рассматриваются в ширину"};
        case Difference::other_windows: return {"other windows", "другие окна"};
    }
    return {};
}

Precision precision_of(const std::vector<const std::vector<Event>*>& traces, bool says_single) {
    constexpr std::size_t enough = 100;  // numbers: if a float holds all of them, the program computes in float
    Counted all;
    for (const auto* events : traces) {
        const Counted each = counted(*events);
        all.numbers += each.numbers;
        all.all_single = all.all_single && each.all_single;
    }
    return says_single || (all.numbers >= enough && all.all_single) ? Precision::single : Precision::twice;
}

Judgement judge(const TraceHeader& header, const std::vector<Event>& events, bool complete, Precision precision,
                const Words& words) {
    const SceneTruth truth(header.scene, precision);
    State state(header);
    Judgement found{std::nullopt, {}, {}, state.picture(), open_pixels(truth)};
    if (precision == Precision::single) found.differences.insert(Difference::single_precision);
    if (header.method == Method::warnock) {
        judge_by<grading::WarnockJudge>(truth, events, complete, state, words, found);
    } else if (header.method == Method::weiler_atherton) {
        judge_by<grading::WeilerAthertonJudge>(truth, events, complete, state, words, found);
    } else {
        judge_by<grading::ZBufferJudge>(truth, events, complete, state, words, found);
    }
    found.picture = state.picture();
    return found;
}

}  // namespace vidno
