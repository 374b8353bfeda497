#include "grade/floating_horizon_judge.h"

#include <algorithm>
#include <utility>

namespace vidno::grading {

std::string FloatingHorizonJudge::horizon_in_words(Side side, int x, const std::optional<double>& y) const {
    const Bilingual name = side == Side::upper ? Bilingual{"upper", "верхнего"} : Bilingual{"lower", "нижнего"};
    if (!y) return say({"there is no {} horizon over column {}", "{} горизонта над столбцом {} нет"}, name, x);
    return say({"the {} horizon over column {} is at y = {}", "высота {} горизонта над столбцом {} равна {}"}, name, x,
               *y);
}

/// A start value counts as no horizon if it is beyond every curve.
void FloatingHorizonJudge::judge_start(Side side, const std::optional<Value>& start) const {
    if (!start || truth_.is_beyond_all(side, start->number)) return;
    throw False{Symptom::start,
                side == Side::upper
                    ? say({"the upper horizon starts at y = {}", "верхний горизонт начинается с y = {}"}, start->number)
                    : say({"the lower horizon starts at y = {}", "нижний горизонт начинается с y = {}"}, start->number),
                say({"a curve goes beyond it, and nothing hides the curve there",
                     "кривая заходит дальше, и там её ничто не закрывает"})};
}

void FloatingHorizonJudge::judge(const event::Horizons& e) const {
    judge_start(Side::upper, e.upper);
    judge_start(Side::lower, e.lower);
}

void FloatingHorizonJudge::judge(const event::Curve& e) {
    const std::uint64_t begun = std::exchange(begun_, step_);
    const bool is_farthest = !state_.values().curve || curve() == farthest_;
    farthest_ = std::max(farthest_, e.curve);
    if (state_.values().curve) leave_curve(curve(), begun, is_farthest);
}

/// If the program never returns to the curve, all that is visible of it must be drawn. Its horizons are those of the
/// state unless a farther curve has come.
void FloatingHorizonJudge::leave_curve(int curve, std::uint64_t begun, bool is_farthest) const {
    const auto last = last_steps_.find(curve);
    if (last == last_steps_.end() || last->second != begun) return;
    judge_drawn(curve);
    if (tells_horizons_ && is_farthest) judge_claimed_horizons(curve);
}

void FloatingHorizonJudge::judge_drawn(int curve) const {
    const auto found = drawn_.find(curve);
    const DrawnParts parts = found == drawn_.end() ? DrawnParts{} : found->second;
    if (const auto x = truth_.left_out(curve, parts)) {
        throw False{
            Symptom::visibility,
            say({"curve {} is done, and it is not drawn at x = {}", "кривая {} готова, а при x = {} она не нарисована"},
                curve, *x),
            say({"it is visible there, at y = {}", "там она видна, y = {}"}, truth_.height(curve, *x).value_or(0)),
            last_step_};
    }
    if (truth_.leaves_out_touching(curve, parts)) differences_.insert(Difference::touching);
}

void FloatingHorizonJudge::judge_claimed_horizons(int curve) const {
    const Area& area = truth_.scene().area;
    const auto number = [](const std::optional<Value>& value) {
        return value ? std::optional(value->number) : std::nullopt;
    };
    for (int x = area.x; x < area.right(); ++x) {
        const auto column = std::size_t(x - area.x);
        for (const Side side : {Side::upper, Side::lower}) {
            const auto claimed =
                number((side == Side::upper ? state_.values().horizons.upper : state_.values().horizons.lower)[column]);
            if (truth_.is_horizon(curve, When::after, side, x, claimed)) continue;
            throw False{
                Symptom::horizon,
                say({"curve {} is done, and {}", "кривая {} готова, {}"}, curve, horizon_in_words(side, x, claimed)),
                horizon_in_words(side, x, truth_.horizon(curve, When::after, side, x)), last_step_};
        }
    }
}

void FloatingHorizonJudge::finish() {
    if (state_.values().curve) leave_curve(curve(), begun_, curve() == farthest_);
    if (tells_horizons_ && state_.values().curve && curve() != farthest_) judge_claimed_horizons(farthest_);
    for (int c = 0; c < int(truth_.scene().curves.size()); ++c) judge_drawn(c);
}

void FloatingHorizonJudge::judge(const event::SideEdge& e) const {
    if (!state_.values().curve) return;
    const bool is_left = e.at == Line::FH3;
    const auto& [x, y] = e.sample;
    const auto ends = truth_.ends(curve());
    if (ends) {
        const Sample& end = is_left ? ends->first : ends->second;
        if (x == end.x && truth_.same_height(y, end.y)) return;
    }
    throw False{Symptom::edge,
                is_left ? say({"the left edge comes to {}", "левое ребро доходит до {}"}, say.point(x, y))
                        : say({"the right edge comes to {}", "правое ребро доходит до {}"}, say.point(x, y)),
                end_in_words(ends, is_left)};
}

std::string FloatingHorizonJudge::end_in_words(const std::optional<std::pair<Sample, Sample>>& ends,
                                               bool is_left) const {
    if (!ends)
        return say({"curve {} has no two neighbouring samples", "у кривой {} нет двух соседних отсчётов"}, curve());
    const Sample& end = is_left ? ends->first : ends->second;
    return say({"the end of curve {} there is {}", "конец кривой {} там — {}"}, curve(), say.point(end.x, end.y));
}

/// Throws False unless the current curve reaches the column.
void FloatingHorizonJudge::judge_column(int x) const {
    if (truth_.height(curve(), x)) return;
    throw False{Symptom::height,
                say({"curve {} is examined over column {}", "кривая {} рассматривается над столбцом {}"}, curve(), x),
                reach_in_words(x)};
}

std::string FloatingHorizonJudge::reach_in_words(double x) const {
    const auto ends = truth_.ends(curve());
    if (ends && (x < ends->first.x || x > ends->second.x)) {
        return say({"it reaches from column {} to {}", "она занимает столбцы от {} до {}"}, ends->first.x,
                   ends->second.x);
    }
    return say({"it has a gap there", "там она прерывается"});
}

void FloatingHorizonJudge::judge_height(double x, double y) const {
    if (truth_.is_on_curve(curve(), x, y)) return;
    const auto right = truth_.height(curve(), x);
    throw False{Symptom::height,
                say({"at x = {} curve {} is at y = {}", "при x = {} кривая {} на высоте y = {}"}, x, curve(), y),
                right ? say({"it is at y = {}", "она на высоте y = {}"}, *right) : reach_in_words(x)};
}

void FloatingHorizonJudge::judge(const event::Height& e) const {
    if (!state_.values().curve) return;
    judge_column(e.x);
    judge_height(e.x, e.y.number);
    for (const auto& [side, value] : {std::pair(Side::upper, e.upper), std::pair(Side::lower, e.lower)}) {
        const auto claimed = value ? std::optional(value->number) : std::nullopt;
        if (truth_.is_horizon(curve(), When::before, side, e.x, claimed)) continue;
        throw False{Symptom::horizon, horizon_in_words(side, e.x, claimed),
                    say({"by the curves and edges before it {}", "по предыдущим кривым и рёбрам {}"},
                        horizon_in_words(side, e.x, truth_.horizon(curve(), When::before, side, e.x)))};
    }
}

void FloatingHorizonJudge::judge(const event::Visibility& e) const {
    if (!state_.values().curve) return;
    judge_column(e.x);
    if (truth_.may_be(curve(), e.x, e.flag)) return;
    const auto upper = truth_.horizon(curve(), When::before, Side::upper, e.x),
               lower = truth_.horizon(curve(), When::before, Side::lower, e.x);
    const double y = truth_.height(curve(), e.x).value_or(0);
    throw False{Symptom::visibility,
                say({"the flag of curve {} over column {} is {}", "флаг кривой {} над столбцом {} равен {}"}, curve(),
                    e.x, int(e.flag)),
                upper
                    ? say({"it is at y = {} there, and the horizons are at {} and {}",
                           "там она на высоте y = {}, а горизонты — на {} и {}"},
                          y, *upper, *lower)
                    : say({"there is no horizon there yet, so it is visible", "горизонтов там ещё нет, и она видна"})};
}

void FloatingHorizonJudge::judge(const event::Intersection& e) const {
    if (!state_.values().curve) return;
    const double x = e.point.x.number, y = e.point.y.number;
    judge_height(x, y);
    if (truth_.meets_horizon(curve(), x)) return;
    throw False{
        Symptom::visibility,
        say({"curve {} meets a horizon at {}", "кривая {} встречает горизонт в точке {}"}, curve(), say.point(x, y)),
        say({"no horizon passes there", "там горизонта нет"})};
}

std::string FloatingHorizonJudge::why_not_seen(double x) const {
    const auto y = truth_.height(curve(), x);
    if (!y) return say({"at x = {} it has a gap", "при x = {} она прерывается"}, x);
    return say({"at x = {} it is hidden: there it is at y = {}, between the horizons",
                "при x = {} она закрыта: там она на высоте y = {}, между горизонтами"},
               x, *y);
}

void FloatingHorizonJudge::judge(const event::DrawLine& e) {
    if (!state_.values().curve) return;
    const double from = std::min(e.from.x.number, e.to.x.number), to = std::max(e.from.x.number, e.to.x.number);
    judge_height(e.from.x.number, e.from.y.number);
    judge_height(e.to.x.number, e.to.y.number);
    drawn_[curve()].emplace_back(from, to);
    const auto hidden = truth_.hidden_between(curve(), from, to);
    if (!hidden) return;
    throw False{Symptom::visibility,
                say({"curve {} is visible from x = {} to {}", "кривая {} видна от x = {} до {}"}, curve(), from, to),
                why_not_seen(*hidden)};
}

/// A new height of a horizon must be that of the curve or of a side edge.
void FloatingHorizonJudge::judge_raised(Side side, int x, double y, bool is_edge) {
    tells_horizons_ = true;
    if (!state_.values().curve) return;
    if (!is_edge && truth_.is_on_curve(curve(), x, y)) return;
    if (truth_.is_on_edge(curve(), x, y)) return;
    const auto right = truth_.height(curve(), x);
    throw False{Symptom::horizon, horizon_in_words(side, x, y),
                right && !is_edge
                    ? say({"curve {} is at y = {} there", "кривая {} там на высоте y = {}"}, curve(), *right)
                    : say({"no edge that leads to curve {} passes there", "через это место не идёт ребро к кривой {}"},
                          curve())};
}

void FloatingHorizonJudge::judge(const event::Horizon& e) {
    tells_horizons_ = true;
    for (const auto& [x, y] : e.upper) judge_raised(Side::upper, x, y.number, e.at == Line::SE2);
    for (const auto& [x, y] : e.lower) judge_raised(Side::lower, x, y.number, e.at == Line::SE2);
}

}  // namespace vidno::grading
