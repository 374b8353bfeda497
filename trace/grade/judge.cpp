#include "grade/judge.h"

#include <algorithm>
#include <cmath>

#include "choice/method.h"
#include "grade/floating_horizon_judge.h"
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

/// The false claim of the first step becomes `wrong`. Later events are judged too, because the set of all false claims
/// distinguishes one mistake from another, and because a claim may turn out to be false only later.
template <class Judge>
void judge_by(Judge& judge, const std::vector<Event>& events, bool complete, auto& state, const Words& say,
              Judgement& found) {
    std::vector<std::pair<Wrong, FalseClaim>> all;
    const auto add = [&](std::uint64_t step, const False& claim) {
        const std::uint64_t at = std::min<std::uint64_t>(claim.step.value_or(step), events.size());
        // A claim about an earlier step is about what was done there, not about the event, which may be one that the
        // program need not report.
        const bool is_about_event = at != 0 && !claim.step;
        all.push_back({{at, at == 0 ? "" : label_of(events[at - 1]), claim.claimed, claim.right, claim.symptom},
                       {claim.symptom, judge.place() + (is_about_event ? polygon_of(events[at - 1]) : "")}});
    };
    const auto look_at = [&](std::uint64_t step, auto&& what) {
        try {
            what();
        } catch (const False& claim) {
            add(step, claim);
        }
    };
    if constexpr (requires { judge.foresee(events); }) {
        if (complete) judge.foresee(events);
    }
    try {
        for (const auto& event : events) {
            look_at(state.step() + 1, [&] { judge.take(event, state.step() + 1); });
            state.apply(event);
        }
        if (complete) look_at(events.size(), [&] { judge.finish(); });
    } catch (const Impossible& impossible) {
        add(state.step() + 1, {Symptom::impossible, say({"this step", "этот шаг"}),
                               say({"{}", "такого состояния у процедуры быть не может"}, impossible.reason)});
    }
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first.step < b.first.step; });
    for (auto& [wrong, claim] : all) {
        if (!found.wrong) found.wrong = std::move(wrong);
        found.false_claims.push_back(std::move(claim));
    }
}

/// What the judgement says of the pixels.
void look_at_pixels(const SceneTruth& truth, const Picture& picture, Judgement& found) {
    const Area& area = truth.scene().area;
    found.is_plain = true;
    for (int row = area.y; row < area.bottom(); ++row) {
        for (int column = area.x; column < area.right(); ++column) {
            const SeenPixel& seen = truth.seen(column, row);
            found.open_places += int(seen.is_open);
            found.is_plain = found.is_plain && !seen.on_outline;
            const Color color = picture.at(column, row);
            if (truth.allows(column, row, color)) continue;
            found.wrong_places.push_back({column, row, color.red, color.green, color.blue});
        }
    }
}

/// Looks at the drawn parts of curves, at steps of a quarter of a column.
void look_at_curves(const CurveTruth& truth, const std::map<int, DrawnParts>& drawn, Judgement& found) {
    found.open_places = truth.open_columns();
    found.is_plain = !truth.touches_on_column();
    constexpr int steps = 4;
    for (int curve = 0; curve < int(truth.scene().curves.size()); ++curve) {
        const auto parts = drawn.find(curve);
        const auto& samples = truth.scene().curves[std::size_t(curve)].samples;
        for (int place = steps * samples.front().x; place <= steps * samples.back().x; ++place) {
            const double x = double(place) / steps;
            const auto holds = [x](const auto& part) { return part.first <= x && x <= part.second; };
            const bool is_drawn =
                parts != drawn.end() && std::any_of(parts->second.begin(), parts->second.end(), holds);
            const bool is_right = is_drawn ? truth.may_show(curve, x) : truth.may_be_left_out(curve, x);
            if (!is_right) found.wrong_places.push_back({curve, place, int(is_drawn)});
        }
    }
}

}  // namespace

Bilingual words_of(Difference difference) {
    switch (difference) {
        case Difference::order_of_parts:
            return {"the parts of a window in another order", "части окна в другом порядке"};
        case Difference::order_of_polygons: return {"the polygons in another order", "многоугольники в другом порядке"};
        case Difference::order_of_vertices:
            return {"outlines in the opposite direction", "контуры обходятся в обратную сторону"};
        case Difference::outline: return {"another rule for points of an outline", "другое правило для точек контура"};
        case Difference::equally_near:
            return {"another one of equally near polygons", "другой из одинаково близких многоугольников"};
        case Difference::hidden_leave:
            return {"hidden polygons leave the list", "закрытые многоугольники уходят из списка"};
        case Difference::single_precision: return {"numbers in float", "числа типа float"};
        case Difference::recursion: return {"recursion instead of the stack", "рекурсия вместо стека"};
        case Difference::breadth_first: return {"the windows breadth first", "окна рассматриваются в ширину"};
        case Difference::other_windows: return {"other windows", "другие окна"};
        case Difference::touching:
            return {"curves that touch a horizon are hidden", "кривые, касающиеся горизонта, не видны"};
    }
    return {};
}

bool in_floats(const std::vector<Event>& events) {
    bool all = true;
    const std::function<void(double)> look = [&](double value) { all = all && (std::isnan(value) || is_float(value)); };
    for (const auto& event : events) {
        event.visit([&]<class E>(const E& e) {
            E::fields(e, [&](std::string_view, const auto& field, const auto&...) { Numbers{look}(field); });
        });
    }
    return all;
}

Judgement judge(const TraceHeader& header, const std::vector<Event>& events, bool complete, Precision precision,
                const Words& words) {
    const SceneTruth truth(header.scene, precision);
    State state(header);
    Judgement found;
    if (precision == Precision::single) found.differences.insert(Difference::single_precision);
    const auto by = [&]<class Judge>() {
        Judge judge(truth, state, found.differences, words);
        judge_by(judge, events, complete, state, words, found);
    };
    if (header.method == Method::warnock) {
        by.operator()<grading::WarnockJudge>();
    } else if (header.method == Method::weiler_atherton) {
        by.operator()<grading::WeilerAthertonJudge>();
    } else {
        by.operator()<grading::ZBufferJudge>();
    }
    look_at_pixels(truth, state.picture(), found);
    found.shows_single = truth.shows_single();
    return found;
}

Judgement judge(const FloatingHorizonHeader& header, const std::vector<Event>& events, bool complete,
                Precision precision, const Words& words) {
    const CurveTruth truth(header.scene.curves, precision);
    FloatingHorizonState state(header);
    Judgement found;
    if (precision == Precision::single) found.differences.insert(Difference::single_precision);
    grading::FloatingHorizonJudge judge(truth, state, found.differences, words);
    judge_by(judge, events, complete, state, words, found);
    look_at_curves(truth, judge.drawn(), found);
    found.shows_single = truth.shows_single();
    return found;
}

Judgement judge(const AnyHeader& header, const std::vector<Event>& events, bool complete, Precision precision,
                const Words& words) {
    return std::visit([&](const auto& each) { return judge(each, events, complete, precision, words); }, header);
}

std::string_view method_of(const AnyHeader& header) {
    const auto* polygons = std::get_if<TraceHeader>(&header);
    return polygons ? method_names[std::size_t(polygons->method)] : floating_horizon_method;
}

const std::string& kernel_of(const AnyHeader& header) {
    return std::visit([](const auto& each) -> const std::string& { return each.kernel; }, header);
}

}  // namespace vidno
