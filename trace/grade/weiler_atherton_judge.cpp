#include "grade/weiler_atherton_judge.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace vidno::grading {

/// Rounding gives the same vertex two places, so the pieces of an outline do not meet, and what they bound is lost.
/// That may be a sliver without area. So the run is wrong only if the visible regions are, and then this is the cause.
/// Arithmetic in `double` does not force such a loss: a program can keep the vertices that its pieces share.
void WeilerAthertonJudge::judge(const event::Fault& e) {
    if (lost_.empty())
        lost_ = say({"; at step {}, {}, {}", "; на шаге {}, {}, сбой"}, std::size_t(step_),
                    std::string(line_names[std::size_t(e.at)]), e.reason);
}

void WeilerAthertonJudge::judge(const event::Split& e) const {
    const int p = e.polygon.index;
    if (!truth().has_inside(p)) return;
    for (const RegionLoops& part : {e.region, e.other}) judge_region(p, part, say({"a part of {}", "часть {}"}, id(p)));
}

void WeilerAthertonJudge::judge(const event::Depth& e) const {
    judge_depth(e.polygon.index, e.point.x.number, e.point.y.number, e.z.number);
}

/// A region must lie in its polygon and in the area.
void WeilerAthertonJudge::judge_vertices(int polygon, const RegionLoops& region, const std::string& what) const {
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

/// Its loops must also run around it once, clockwise on the screen, and around its holes the other way.
void WeilerAthertonJudge::judge_region(int polygon, const RegionLoops& region, const std::string& what) const {
    judge_vertices(polygon, region, what);
    const auto [reversed, repeated] = SceneTruth::astray(region);
    const bool in_floats = SceneTruth::in_floats(region);
    if (!truth().same_area(reversed, 0, in_floats)) {
        throw False{
            Symptom::region,
            say({"{} runs counterclockwise around an area of {}", "{} обходит площадь {} против часовой стрелки"}, what,
                reversed),
            say({"on the screen outlines run clockwise, and holes counterclockwise",
                 "на экране контуры идут по часовой стрелке, а отверстия — против неё"})};
    }
    if (truth().same_area(repeated, 0, in_floats)) return;
    throw False{
        Symptom::region,
        say({"{} has an area of {} more than once", "{} содержит площадь {} более одного раза"}, what, repeated),
        say({"the loops of a region do not overlap", "контуры области не перекрываются"})};
}

void WeilerAthertonJudge::judge(const event::PushList& e) const {
    for (const PolygonPart& piece : e.pieces) {
        const int p = piece.polygon.index;
        if (truth().has_inside(p)) judge_region(p, piece.region, say({"a piece of {}", "часть {}"}, id(p)));
    }
}

void WeilerAthertonJudge::judge(const event::Beside& e) const {
    const auto& list = state().weiler_atherton().current_list();
    if (!list || std::size_t(list->seen) >= list->pieces.size()) return;
    const auto &piece = *list->pieces[std::size_t(list->seen)], &clip = *list->pieces.front();
    const double common = truth().common_area(piece.region, clip.region);
    if (truth().same_area(common, 0, SceneTruth::in_floats(piece.region))) return;
    throw False{Symptom::region,
                say({"the piece of {} lies outside of that of {}", "часть {} лежит вне части {}"}, id(e.polygon.index),
                    id(clip.polygon.index)),
                say({"an area of {} lies in both", "площадь {} лежит в обеих"}, common)};
}

void WeilerAthertonJudge::judge(const event::CutToArea& e) const {
    const int p = e.polygon.index;
    if (!truth().has_inside(p)) return;
    const std::string part = say({"the part of {} in the area", "часть {} в области"}, id(p));
    judge_region(p, e.region, part);
    const double claimed = SceneTruth::area_of(e.region), right = truth().area_in(p, whole_area(scene().area));
    if (truth().same_area(claimed, right, SceneTruth::in_floats(e.region))) return;
    throw False{Symptom::region, say({"{} has the area {}", "{}: площадь {}"}, part, claimed),
                say({"its area is {}", "её площадь {}"}, right)};
}

void WeilerAthertonJudge::judge(const event::Clipped& e) const {
    const int p = e.polygon.index, clip = e.clip.index;
    if (!truth().has_inside(p) || !truth().has_inside(clip)) return;
    const std::string inside = say({"the part of {} inside of {}", "часть {} внутри {}"}, id(p), id(clip));
    judge_vertices(clip, e.inside, inside);
    judge_region(p, e.inside, inside);
    judge_region(p, e.outside, say({"the part of {} outside of {}", "часть {} вне {}"}, id(p), id(clip)));
    if (e.at == Line::WA5) judge_parts(e);
}

/// The parts of the next piece of the current list must be all of it inside, and all of it outside, of the clip piece.
void WeilerAthertonJudge::judge_parts(const event::Clipped& e) const {
    const auto& list = state().weiler_atherton().current_list();
    if (!list || std::size_t(list->seen) >= list->pieces.size()) return;
    const auto &piece = *list->pieces[std::size_t(list->seen)], &clip = *list->pieces.front();
    if (piece.polygon != e.polygon || clip.polygon != e.clip) return;
    const auto astray = SceneTruth::parts_astray(piece.region, clip.region, e.inside, e.outside);
    const bool is_inside = !truth().same_area(astray.inside, 0, SceneTruth::in_floats(e.inside));
    if (!is_inside && truth().same_area(astray.outside, 0, SceneTruth::in_floats(e.outside))) return;
    const double common = truth().common_area(piece.region, clip.region);
    throw False{
        Symptom::region,
        say(is_inside ? Bilingual{"of the piece of {} an area of {} lies inside of that of {}",
                                  "из части {} площадь {} лежит внутри части {}"}
                      : Bilingual{"of the piece of {} an area of {} lies outside of that of {}",
                                  "из части {} площадь {} лежит вне части {}"},
            id(e.polygon.index), SceneTruth::area_of(is_inside ? e.inside : e.outside), id(e.clip.index)),
        say({"its area there is {}, and {} of the told area is wrong", "площадь там {}, и {} из сообщённого неверно"},
            is_inside ? common : SceneTruth::area_of(piece.region) - common,
            is_inside ? astray.inside : astray.outside) +
            lost_};
}

void WeilerAthertonJudge::judge_order(double z, double other, Sign order) {
    if (int(order) == (z > other) - (z < other) || truth().equally_near(z, other)) return;
    throw False{Symptom::comparison,
                say({"{} compares with {} as {}", "сравнение {} с {} даёт {}"}, z, other, int(order)),
                say({"the greater z is the nearer", "ближе тот, у кого z больше"})};
}

void WeilerAthertonJudge::judge(const event::Behind& e) {
    judge_depth(e.polygon.index, e.point.x.number, e.point.y.number, e.z.number);
    judge_depth(e.clip.index, e.point.x.number, e.point.y.number, e.clip_z.number);
    judge_order(e.z.number, e.clip_z.number, e.order);
    if (e.behind == (e.z.number < e.clip_z.number) || truth().equally_near(e.z.number, e.clip_z.number)) return;
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

/// No polygon may be nearer than the shown one anywhere in the region, and nothing of the region may have been shown
/// before.
void WeilerAthertonJudge::judge(const event::Show& e) {
    const int p = e.polygon.index;
    tells_regions_ = true;
    shown_ += SceneTruth::area_of(e.region);
    in_floats_ = in_floats_ && SceneTruth::in_floats(e.region);
    if (!truth().has_inside(p)) return;
    const std::string region = say({"the visible region of {}", "видимая область {}"}, id(p));
    judge_region(p, e.region, region);
    const std::string claimed = say({"{} is visible in a region of area {}", "{} виден в области площадью {}"}, id(p),
                                    SceneTruth::area_of(e.region));
    if (const auto hidden = truth().hidden_by(p, e.region)) {
        throw False{
            Symptom::region, claimed,
            say({"{} is nearer in {} of it", "{} ближе в части площадью {}"}, id(hidden->first), hidden->second) +
                lost_};
    }
    for (const auto& before : state().weiler_atherton().visible()) {
        const double common = truth().common_area(e.region, before->region);
        if (truth().same_area(common, 0, SceneTruth::in_floats(e.region))) continue;
        throw False{Symptom::region, claimed,
                    say({"{} of it is in a visible region of {} that was shown before",
                         "из неё площадь {} лежит в уже показанной видимой области {}"},
                        common, id(before->polygon.index))};
    }
}

namespace {

/// A point of an outline on a row's line, and how far it moves along the row if the row moves by 1.
struct RowCrossing {
    double x, slope;
};

/// Where the outlines of a region meet the line at y, from left to right. An end so near to it may lie on it.
std::vector<RowCrossing> crossings(const RegionLoops& region, double y, double near) {
    std::vector<RowCrossing> found;
    for (const auto& loop : region) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const ValuePoint &p = loop[i], &q = loop[(i + 1) % loop.size()];
            const double px = p.x.number, py = p.y.number, qx = q.x.number, qy = q.y.number;
            const auto slope = (qx - px) / (qy - py);
            if (std::min(py, qy) < y && y < std::max(py, qy)) found.push_back({px + (y - py) * slope, slope});
            if (std::abs(py - y) <= near) found.push_back({px, 0});
        }
    }
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
    return found;
}

}  // namespace

/// Whether a row from `left` to `right` reaches from one outline of the region to another, through it.
bool WeilerAthertonJudge::crosses(const RegionLoops& region, double y, double left, double right) const {
    const double near = truth().coincidence();
    const auto ends = crossings(region, y, near);
    const auto is_end = [&](double x) {
        return std::any_of(ends.begin(), ends.end(), [&](const RowCrossing& end) {
            return truth().same_coordinate(x, end.x, 1 / std::max(1.0, std::abs(end.slope)));
        });
    };
    if (!is_end(left) || !is_end(right)) return false;
    std::vector<double> stops{left};
    for (const RowCrossing& each : ends) {
        if (left < each.x && each.x < right) stops.push_back(each.x);
    }
    stops.push_back(right);
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
        if (truth().may_coincide(stops[i], stops[i + 1])) continue;
        // A row through a vertex may take the region just above it or just below it.
        const double middle = (stops[i] + stops[i + 1]) / 2;
        if (!SceneTruth::is_in(region, middle, y - near) && !SceneTruth::is_in(region, middle, y + near)) return false;
    }
    return true;
}

/// A row must be that of a region shown before. It does not say of which, and the pixels on its ends may be painted for
/// another polygon.
void WeilerAthertonJudge::judge(const event::Row& e) const {
    const double y = e.row + 0.5, left = e.left.number, right = e.right.number;
    const auto& visible = state().weiler_atherton().visible();
    const auto is_row_of = [&](const auto& each) { return crosses(each->region, y, left, right); };
    if (!tells_regions_ || !(left < right) || std::any_of(visible.begin(), visible.end(), is_row_of)) return;
    std::set<double> ends;
    for (const auto& each : visible) {
        for (const RowCrossing& end : crossings(each->region, y, 0)) ends.insert(end.x);
    }
    std::string list;
    for (const double x : ends) list.append(list.empty() ? "" : ", ").append(in_words(x));
    throw False{Symptom::edge,
                say({"on row {} a visible region goes from x = {} to {}",
                     "в строке {} видимая область занимает от x = {} до {}"},
                    e.row, left, right),
                ends.empty()
                    ? say({"no visible region meets that row's line", "ни одна видимая область её не пересекает"})
                    : say({"the outlines of the visible regions meet that row at x = {}",
                           "контуры видимых областей пересекают эту строку при x = {}"},
                          list)};
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

/// The first pixel whose centre is in none of the visible regions, though it should be, in words; empty if there is
/// none.
std::string WeilerAthertonJudge::not_shown() const {
    const Area& area = scene().area;
    for (int row = area.y; row < area.bottom(); ++row) {
        for (int column = area.x; column < area.right(); ++column) {
            const SeenPixel& seen = truth().seen(column, row);
            if (seen.on_outline || seen.by_rule == SeenPixel::background) continue;
            const auto& regions = state().weiler_atherton().visible();
            const auto holds = [&](const auto& each) {
                return SceneTruth::is_in(each->region, column + 0.5, row + 0.5);
            };
            if (std::any_of(regions.begin(), regions.end(), holds)) continue;
            return say({"; {} shows at pixel {}, and none of them has it",
                        "; в пикселе {1} виден {0}, но ни одна его не содержит"},
                       id(seen.by_rule), pixel(column, row));
        }
    }
    return "";
}

/// The visible regions are visible and apart from each other, so they are right if they add up to the area that the
/// polygons cover.
void WeilerAthertonJudge::finish() {
    const double right = truth().covered_area();
    if (tells_regions_ && !truth().same_area(shown_, right, in_floats_)) {
        throw False{Symptom::region,
                    say({"the visible regions have the area {}", "площадь видимых областей {}"}, shown_),
                    say({"the polygons cover {} of the area", "многоугольники покрывают площадь {}"}, right) +
                        not_shown() + lost_};
    }
    if (!paints_ && tells_regions_) return;
    const Area& area = scene().area;
    for (int row = area.y; row < area.bottom(); ++row) {
        for (int column = area.x; column < area.right(); ++column)
            judge_pixel(column, row, state().screen().color(column, row));
    }
}

}  // namespace vidno::grading
