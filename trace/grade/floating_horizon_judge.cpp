#include "grade/floating_horizon_judge.h"

#include <algorithm>
#include <cmath>

#include "grade/claims.h"

namespace vidno {

namespace {

using grading::False;

class FloatingHorizonJudge {
public:
    FloatingHorizonJudge(const CurveTruth& truth, const FloatingHorizonState& state, const Words& words)
        : say(words), truth_(truth), state_(state) {}

    void take(const EventView& event) {
        event.visit([this](const auto& e) { judge(e); });
    }
    /// All that is visible was drawn.
    void finish() const {
        const auto& curves = truth_.scene().curves;
        for (int curve = 0; curve < int(curves.size()); ++curve) {
            const auto& samples = curves[std::size_t(curve)].samples;
            for (int x = samples.front().x; x < samples.back().x; ++x) {
                const auto here = truth_.sight(curve, x), next = truth_.sight(curve, x + 1);
                const bool goes_on = (here.must_above && next.must_above) || (here.must_below && next.must_below);
                const bool drawn =
                    goes_on ? steps_.contains({curve, x}) : !here.must() || columns_.contains({curve, x});
                if (drawn) continue;
                throw False{Symptom::visibility,
                            say({"the run is over, and curve {} is not drawn from column {} on",
                                 "работа закончена, а кривая {} не нарисована начиная со столбца {}"},
                                curve, x),
                            say({"it is visible there", "там она видна"})};
            }
        }
    }

    std::string about() const { return state_.curve() ? std::to_string(*state_.curve()) : ""; }

private:
    void judge(const auto&) const {}

    void judge(const event::Curve& e) const {
        const int expected = state_.curve() ? *state_.curve() + 1 : 0;
        if (e.curve == expected) return;
        throw False{Symptom::horizon, say({"curve {} comes next", "следующая кривая — {}"}, e.curve),
                    say({"the nearest come first: curve {}", "сначала ближние: кривая {}"}, expected)};
    }

    void judge_height(int x, double y, const std::string& told) const {
        const auto right = state_.curve() ? truth_.height(*state_.curve(), x) : std::nullopt;
        if (!right || truth_.same_height(y, *right)) return;
        throw False{Symptom::horizon, told, say({"its height there is {}", "её высота там {}"}, *right)};
    }

    void judge(const event::Height& e) const {
        judge_height(
            e.x, e.y.number,
            say({"over column {} the curve is at {}", "над столбцом {} кривая на высоте {}"}, e.x, e.y.number));
    }

    void judge(const event::Visibility& e) const {
        if (!state_.curve()) return;
        const auto sight = truth_.sight(*state_.curve(), e.x);
        const bool above = e.flag == VisibilityFlag::above || e.flag == VisibilityFlag::both;
        const bool below = e.flag == VisibilityFlag::below || e.flag == VisibilityFlag::both;
        const bool right = (above ? sight.may_above : e.flag == VisibilityFlag::below || !sight.must_above) &&
                           (below ? sight.may_below : e.flag == VisibilityFlag::above || !sight.must_below);
        if (right) return;
        const std::string is =
            sight.may_above && sight.may_below ? say({"it is on both", "она на обоих"})
            : sight.may_above ? say({"it is above the upper one, or on it", "она выше верхнего или на нём"})
            : sight.may_below ? say({"it is below the lower one, or on it", "она ниже нижнего или на нём"})
                              : say({"it is hidden between them", "она скрыта между ними"});
        throw False{Symptom::visibility,
                    say({"the flag of curve {} over column {} is {}", "флаг кривой {} над столбцом {} равен {}"},
                        *state_.curve(), e.x, int(e.flag)),
                    is};
    }

    void judge_end(int curve, const ValuePoint& point, const std::pair<int, int>& columns) const {
        const double x = point.x.number, y = point.y.number;
        const auto right = truth_.height(curve, x);
        const std::string told =
            say({"a visible part of curve {} ends at {}", "видимая часть кривой {} кончается в точке {}"}, curve,
                say.point(x, y));
        if (!right || x < columns.first || x > columns.second)
            throw False{Symptom::visibility, told, say({"the curve is not there", "кривой там нет"})};
        if (!truth_.same_height(y, *right))
            throw False{Symptom::visibility, told, say({"its height there is {}", "её высота там {}"}, *right)};
        if (columns.first == columns.second || truth_.is_on_horizon(curve, x, y)) return;
        throw False{Symptom::visibility, told,
                    say({"no horizon passes through that point", "через эту точку горизонт не проходит"})};
    }

    void judge(const event::DrawLine& e) {
        if (!state_.curve()) return;
        const int curve = *state_.curve();
        judge_end(curve, e.from, e.from_columns);
        judge_end(curve, e.to, e.to_columns);
        for (int x = e.from_columns.second; x <= e.to_columns.first; ++x) {
            if (!truth_.sight(curve, x).may()) {
                throw False{Symptom::visibility,
                            say({"curve {} is drawn over column {}", "кривая {} рисуется над столбцом {}"}, curve, x),
                            say({"it is hidden there", "там она скрыта"})};
            }
            columns_.insert({curve, x});
            if (x < e.to_columns.first) steps_.insert({curve, x});
        }
    }

    void judge(const event::Horizon& e) const {
        if (e.at == Line::SE2) return;
        for (const auto* changed : {&e.upper, &e.lower}) {
            for (const auto& [x, y] : *changed)
                judge_height(x, y.number,
                             say({"the horizon over column {} becomes {}", "горизонт над столбцом {} становится {}"}, x,
                                 y.number));
        }
    }

    const Words& say;
    const CurveTruth& truth_;
    const FloatingHorizonState& state_;
    std::set<std::pair<int, int>> columns_, steps_;  // that are drawn: a column of a curve, and from one to the next
};

}  // namespace

Judgement judge(const FloatingHorizonHeader& header, const std::vector<Event>& events, bool complete,
                Precision precision, const Words& words) {
    const CurveTruth truth(header.scene.curves, precision);
    FloatingHorizonState state(header);
    FloatingHorizonJudge judge(truth, state, words);
    Judgement found{std::nullopt, {}, {}, Picture({0, 0, 1, 1}, {})};
    if (precision == Precision::single) found.differences.insert(Difference::single_precision);
    const auto add = [&](std::uint64_t step, const False& claim) {
        found.false_claims.push_back({claim.symptom, judge.about()});
        if (found.wrong) return;
        const std::uint64_t at = std::min<std::uint64_t>(step, events.size());
        const auto label =
            at == 0 ? ""
                    : events[at - 1].visit([](const auto& e) { return std::string(line_names[std::size_t(e.at)]); });
        found.wrong = Wrong{at, label, claim.told, claim.right, claim.symptom};
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
            look_at(state.step() + 1, [&] { judge.take(event); });
            state.apply(event);
        }
        if (complete) look_at(events.size(), [&] { judge.finish(); });
    } catch (const Impossible& impossible) {
        add(state.step() + 1, {Symptom::impossible, words({"this step", "этот шаг"}),
                               words({"{}", "такого состояния у процедуры быть не может ({})"}, impossible.reason)});
    }
    return found;
}

}  // namespace vidno
