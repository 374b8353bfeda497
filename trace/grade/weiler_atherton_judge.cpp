#include "grade/weiler_atherton_judge.h"

#include <algorithm>
#include <cmath>

namespace vidno::grading {

/// Rounding gives the same vertex two places, so the pieces of an outline do not meet, and what they bound is lost. That may be a sliver
/// without area. So the run is wrong only if the visible regions are, and then this is the cause. Arithmetic in `double` does not force
/// such a loss: a program can keep the vertices that its pieces share.
void WeilerAthertonJudge::judge(const event::Fault& e) {
    if (lost_.empty())
        lost_ = say({"; at step {}, {}, {}", "; на шаге {}, {}, {}"}, std::size_t(step_),
                    std::string(line_names[std::size_t(e.at)]), e.reason);
}

void WeilerAthertonJudge::judge(const event::Split& e) const {
    const int p = e.polygon.index;
    if (!truth().has_inside(p)) return;
    for (const RegionLoops& part : {e.region, e.other}) judge_inside(p, part, say({"a part of {}", "часть {}"}, id(p)));
}

void WeilerAthertonJudge::judge(const event::Depth& e) const {
    judge_depth(e.polygon.index, e.point.x.number, e.point.y.number, e.z.number);
}

/// A region must lie in its polygon and in the area.
void WeilerAthertonJudge::judge_inside(int polygon, const RegionLoops& region, const std::string& what) const {
    const Area& area = scene().area;
    for (const auto& loop : region) {
        for (const ValuePoint& point : loop) {
            const double x = point.x.number, y = point.y.number;
            const auto beyond = [&](double low, double value, double high) {
                return (value < low && !truth().same_coordinate(value, low)) ||
                       (value > high && !truth().same_coordinate(value, high));
            };
            const bool off =
                !std::isfinite(x + y) || beyond(area.x, x, area.right()) || beyond(area.y, y, area.bottom());
            if (!off && truth().has_point(polygon, x, y)) continue;
            throw False{Symptom::region, say({"{} has a vertex at {}", "у {} есть вершина {}"}, what, say.point(x, y)),
                        off ? say({"that is not in the area", "она лежит вне области"})
                            : say({"that lies outside of {}", "она лежит вне {}"}, id(polygon))};
        }
    }
}

void WeilerAthertonJudge::judge(const event::CutToArea& e) const {
    const int p = e.polygon.index;
    if (!truth().has_inside(p)) return;
    const std::string part = say({"the part of {} in the area", "часть {} в области"}, id(p));
    judge_inside(p, e.region, part);
    const double told = SceneTruth::area_of(e.region), right = truth().area_in(p, whole_area(scene().area));
    if (truth().same_area(told, right)) return;
    throw False{Symptom::region, say({"{} has the area {}", "{}: площадь {}"}, part, told),
                say({"its area is {}", "её площадь {}"}, right)};
}

void WeilerAthertonJudge::judge(const event::Clipped& e) const {
    const int p = e.polygon.index, clip = e.clip.index;
    if (!truth().has_inside(p) || !truth().has_inside(clip)) return;
    const std::string inside = say({"the part of {} inside of {}", "часть {} внутри {}"}, id(p), id(clip));
    judge_inside(p, e.inside, inside);
    judge_inside(clip, e.inside, inside);
    judge_inside(p, e.outside, say({"the part of {} outside of {}", "часть {} вне {}"}, id(p), id(clip)));
}

void WeilerAthertonJudge::judge_order(double z, double other, Sign order) {
    if (int(order) == (z > other) - (z < other) || truth().nearly_equal(z, other)) return;
    throw False{Symptom::comparison,
                say({"{} compares with {} as {}", "сравнение {} с {} даёт {}"}, z, other, int(order)),
                say({"the greater z is the nearer", "ближе тот, у кого z больше"})};
}

void WeilerAthertonJudge::judge(const event::Behind& e) {
    judge_depth(e.polygon.index, e.point.x.number, e.point.y.number, e.z.number);
    judge_depth(e.clip.index, e.point.x.number, e.point.y.number, e.clip_z.number);
    judge_order(e.z.number, e.clip_z.number, e.order);
    if (e.behind == (e.z.number < e.clip_z.number) || truth().nearly_equal(e.z.number, e.clip_z.number)) return;
    throw False{
        Symptom::comparison,
        e.behind ? say({"{} is hidden by {}", "{} закрыт {}"}, id(e.polygon.index), id(e.clip.index))
                 : say({"{} is not hidden by {}", "{} не закрыт {}"}, id(e.polygon.index), id(e.clip.index)),
        say({"its depth is {}, the other's {}", "его глубина {}, а другого — {}"}, e.z.number, e.clip_z.number)};
}

void WeilerAthertonJudge::judge(const event::Order& e) {
    judge_depth(e.polygon.index, e.point.x.number, e.point.y.number, e.z.number);
    judge_depth(e.other.index, e.point.x.number, e.point.y.number, e.other_z.number);
    judge_order(e.z.number, e.other_z.number, e.order);
}

/// No polygon may be nearer than the shown one anywhere in the region.
void WeilerAthertonJudge::judge(const event::Show& e) {
    const int p = e.polygon.index;
    tells_regions_ = true;
    shown_ += SceneTruth::area_of(e.region);
    if (!truth().has_inside(p)) return;
    const std::string region = say({"the visible region of {}", "видимая область {}"}, id(p));
    judge_inside(p, e.region, region);
    if (const auto hidden = truth().hidden_by(p, e.region)) {
        throw False{
            Symptom::region,
            say({"{} is visible in a region of area {}", "{} виден в области площадью {}"}, id(p),
                SceneTruth::area_of(e.region)),
            say({"{} is nearer in {} of it", "{} ближе в части площадью {}"}, id(hidden->first), hidden->second) +
                lost_};
    }
}

void WeilerAthertonJudge::judge(const event::Paint& e) {
    const int p = e.polygon.index;
    paints_ = true;
    for (const auto& run : e.runs) {
        for (int column = run.first; column < run.end; ++column) {
            const bool in_area = scene().area.contains(column, run.row);
            if (!in_area || truth().place(p, column + 0.5, run.row + 0.5) == SceneTruth::Place::outside) {
                throw False{Symptom::off_polygon,
                            say({"{} is drawn at pixel {}", "{} рисуется в пикселе {}"}, id(p), pixel(column, run.row)),
                            in_area ? say({"its centre lies outside of {}", "его центр лежит вне {}"}, id(p))
                                    : say({"that is not in the area", "он не лежит в области"})};
            }
            judge_pixel(column, run.row, e.color);
        }
    }
}

/// The visible regions must add up to the area that the polygons cover.
void WeilerAthertonJudge::finish() {
    const double right = truth().covered_area();
    if (tells_regions_ && !truth().same_area(shown_, right)) {
        throw False{Symptom::region,
                    say({"the visible regions have the area {}", "площадь видимых областей {}"}, shown_),
                    say({"the polygons cover {} of the area", "многоугольники покрывают площадь {}"}, right) + lost_};
    }
    if (!paints_ && tells_regions_) return;
    const Area& area = scene().area;
    for (int row = area.y; row < area.bottom(); ++row) {
        for (int column = area.x; column < area.right(); ++column)
            judge_pixel(column, row, state().screen().color(column, row));
    }
}

}  // namespace vidno::grading
