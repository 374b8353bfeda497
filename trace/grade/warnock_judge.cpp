#include "grade/warnock_judge.h"

#include <algorithm>
#include <cmath>

namespace vidno::grading {

namespace {

int sign_of(double value) { return (value > 0) - (value < 0); }

std::array<std::pair<double, double>, 4> corners_of(const Window& w) {
    return {{{w.x, w.y}, {w.x, w.bottom()}, {w.right(), w.y}, {w.right(), w.bottom()}}};
}

double twice_area(const auto& vertices, auto&& x, auto&& y) {
    double sum = 0;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const auto &p = vertices[i], &q = vertices[(i + 1) % vertices.size()];
        sum += x(p) * y(q) - x(q) * y(p);
    }
    return sum;
}

constexpr Bilingual not_looked_at{"; but {} was not examined in this window", "; но {} в этом окне не рассмотрен"};

}  // namespace

bool WarnockJudge::looked_at(int polygon) const {
    return std::find(counted_.begin(), counted_.end(), polygon) != counted_.end();
}

/// Whether the visible polygon at a pixel is missing among those that the program counted in this window.
bool WarnockJudge::overlooks(int column, int row) const {
    const int right = truth().seen(column, row).by_rule;
    return tells_counts_ && right != SeenPixel::background && !looked_at(right);
}

/// Whether only this polygon may show at the pixel.
bool WarnockJudge::needs(int column, int row, int polygon) const {
    const auto& allowed = truth().seen(column, row).allowed;
    return std::all_of(allowed.begin(), allowed.end(), [&](int q) { return q == polygon; });
}

void WarnockJudge::judge_shown(int column, int row, Color color) {
    if (!truth().allows(column, row, color) && overlooks(column, row)) {
        throw False{Symptom::overlooked,
                    say({"pixel {} shows {}", "в пикселе {} виден {}"}, pixel(column, row), owner_of(color)),
                    why_not(column, row, color) + say(not_looked_at, id(truth().seen(column, row).by_rule))};
    }
    judge_pixel(column, row, color);
}

void WarnockJudge::judge_in_window(int column, int row, const std::string& claimed) const {
    const bool is_in = scene().area.contains(column, row) && column >= std::floor(window_.x) &&
                       column < std::ceil(window_.right()) && row >= std::floor(window_.y) &&
                       row < std::ceil(window_.bottom());
    if (is_in) return;
    throw False{
        Symptom::off_window, claimed,
        say({"pixel {} is not in the window {}", "пиксель {} не лежит в окне {}"}, pixel(column, row), window_)};
}

void WarnockJudge::judge(const event::Push& e) {
    const bool is_root = tree_.empty();
    const bool is_part = tree_.push(e.window, step_);
    const Area& area = scene().area;
    if (is_root) {
        const bool covers = e.window.x <= area.x && e.window.y <= area.y && e.window.right() >= area.right() &&
                            e.window.bottom() >= area.bottom();
        if (!covers) {
            throw False{Symptom::stray_window, say({"the first window is {}", "первое окно — {}"}, e.window),
                        say({"the area is {}", "область — {}"}, whole_area(area))};
        }
        if (!(e.window == covering_square(area))) note(Difference::other_windows);
    }
    if (is_part) return;
    throw False{Symptom::stray_window, say({"the window {} goes on the stack", "окно {} помещается в стек"}, e.window),
                say({"it is not part of a window that was split", "оно не часть разделённого окна"})};
}

void WarnockJudge::judge_parts() {
    if (const auto missing = tree_.uncovered_now()) {
        throw False{Symptom::parts_missing,
                    say({"these are all parts of the window {}", "это все части окна {}"}, missing->window),
                    say({"pixel {} is in none of them", "пиксель {} не лежит ни в одной из них"},
                        pixel(missing->column, missing->row)),
                    missing->step};
    }
    if (decided_ != Case::split || tree_.empty() || tree_.parts().size() < 2) return;
    const WindowParts halves = parts_of(window_);
    std::vector<Window> usual(halves.begin(), halves.end()), claimed = tree_.parts();
    const auto off = [&](const Window& part) { return off_area(part, scene().area); };
    std::erase_if(usual, off);
    std::erase_if(claimed, off);
    if (claimed == usual) return;
    note(std::is_permutation(claimed.begin(), claimed.end(), usual.begin(), usual.end()) ? Difference::order_of_parts
                                                                                         : Difference::other_windows);
}

void WarnockJudge::judge(const event::Pop& e) {
    if (decided_) finish_window();
    tree_.pop(e.window);
    window_ = e.window;
    decided_.reset();
    summary_.reset();
    counted_.clear();
    depths_.clear();
    nearest_.fill(std::nullopt);
    compared_.fill(std::nullopt);
    has_surround_.reset();
    nearest_of_point_.reset();
    rows_.clear();
}

/// In the case `single` the polygon is painted over the background, so the pixels are judged only when the window is
/// done.
void WarnockJudge::finish_window() {
    judge_parts();
    if (decided_ != Case::single) return;
    for_pixels([&](int column, int row) {
        const Color color = state().screen().color(column, row);
        if (truth().allows(column, row, color)) return;
        throw False{Symptom::clipped_away,
                    say({"the window {} is done: pixel {} shows {}", "окно {} готово: в пикселе {} виден {}"}, window_,
                        pixel(column, row), owner_of(color)),
                    why_not(column, row, color), last_step_};
    });
}

void WarnockJudge::finish() {
    if (decided_) finish_window();
    if (const auto missing = tree_.uncovered()) {
        throw False{Symptom::parts_missing,
                    say({"these are all parts of the window {}", "это все части окна {}"}, missing->window),
                    say({"pixel {} is in none of them", "пиксель {} не лежит ни в одной из них"},
                        pixel(missing->column, missing->row)),
                    missing->step};
    }
    const Area& area = scene().area;
    for (int row = area.y; row < area.bottom(); ++row) {
        for (int column = area.x; column < area.right(); ++column) {
            const Color color = state().screen().color(column, row);
            if (!truth().allows(column, row, color) && !painted_.contains({column, row})) {
                throw False{Symptom::not_painted,
                            say({"the run is over, and nothing has painted pixel {}",
                                 "работа закончена, а пиксель {} не закрашен"},
                                pixel(column, row)),
                            why_not(column, row, color)};
            }
            judge_pixel(column, row, color);
        }
    }
    if (tree_.is_recursive()) note(Difference::recursion);
    if (tree_.is_breadth_first()) note(Difference::breadth_first);
}

void WarnockJudge::judge(const event::Corners& e) {
    judge_start(e.z.number, {"the depths at the corners start at {}", "глубины в углах начинаются с {}"});
    nearest_.fill(e.z.number);
    compared_.fill(std::nullopt);
}

void WarnockJudge::judge(const event::Box& e) const {
    const int p = e.polygon.index;
    const PlainBox box = truth().box(p);
    const std::array right{box.xmin, box.ymin, box.xmax, box.ymax};
    for (std::size_t i = 0; i < 4; ++i) {
        if (truth().same_coordinate(e.box[i].number, right[i])) continue;
        constexpr std::array names{"xmin", "ymin", "xmax", "ymax"};
        throw False{Symptom::box,
                    say({"{} of the box of {} is {}", "{} габарита {} равен {}"}, names[i], id(p), e.box[i].number),
                    say({"it is {}", "он равен {}"}, right[i])};
    }
    const double off =
        std::max({window_.x - box.xmax, box.xmin - window_.right(), window_.y - box.ymax, box.ymin - window_.bottom()});
    const bool may_be_outside = off >= 0 || truth().may_coincide(off, 0);
    const bool must_be_outside = off > 0 && !truth().may_coincide(off, 0);
    if (e.outside ? may_be_outside || !truth().meets(p, window_) : !must_be_outside) return;
    throw False{e.outside ? Symptom::left_list : Symptom::box,
                e.outside
                    ? say({"{} lies outside of the window {}", "{} лежит вне окна {}"}, id(p), window_)
                    : say({"the box of {} does not lie outside of the window {}", "габарит {} не лежит вне окна {}"},
                          id(p), window_),
                e.outside ? say({"it has a part in it", "часть его лежит в окне"})
                          : say({"it lies beside it", "он лежит рядом с окном"})};
}

void WarnockJudge::judge(const event::Discard& e) {
    const int p = e.polygon.index;
    if (!truth().meets(p, window_)) return;
    for_pixels([&](int column, int row) {
        if (!needs(column, row, p)) return;
        throw False{
            Symptom::left_list,
            say({"{} leaves the list of the window {}", "{} уходит из списка окна {}"}, id(p), window_),
            say({"it shows in that window, at pixel {}", "он виден в этом окне, в пикселе {}"}, pixel(column, row))};
    });
    note(Difference::hidden_leave);
}

void WarnockJudge::judge(const event::Count& e) {
    const int p = e.polygon.index;
    if (!counted_.empty() && counted_.back() > p) note(Difference::order_of_polygons);
    counted_.push_back(p);
    tells_counts_ = true;
    if (e.count == int(counted_.size())) return;
    throw False{Symptom::count, say({"with {} the count is {}", "вместе с {} насчитано {}"}, id(p), e.count),
                say({"so far the trace has counted {}", "в записи их пока {}"}, counted_.size())};
}

void WarnockJudge::judge(const event::Depth& e) {
    const int p = e.polygon.index;
    judge_depth(p, e.point.x.number, e.point.y.number, e.z.number);
    const auto corners = corners_of(window_);
    for (std::size_t i = 0; i < 4; ++i) {
        if (corners[i] == std::pair(e.point.x.number, e.point.y.number)) depths_[p][i] = e.z.number;
    }
}

void WarnockJudge::judge(const event::Compare& e) {
    const int p = e.polygon.index;
    if (!truth().has_inside(p)) return;
    const double z = e.z.number, against = e.against.number;
    if (e.corner) {
        const auto corner = std::size_t(*e.corner);
        const auto [x, y] = corners_of(window_)[corner];
        judge_depth(p, x, y, z);
        judge_nearest_so_far(against, compared_[corner] ? compared_[corner] : nearest_[corner]);
    } else {
        if (!nearest_of_point_)
            judge_start(against, {"the depth of PointColor starts at {}", "глубина в PointColor начинается с {}"});
        judge_nearest_so_far(against, nearest_of_point_);
    }
    judge_comparison(z, against, e.nearer);
    if (e.corner) {
        if (e.nearer) compared_[std::size_t(*e.corner)] = z;
    } else {
        nearest_of_point_ = e.nearer ? z : against;
    }
}

void WarnockJudge::judge(const event::Nearest& e) {
    const int p = e.polygon.index;
    if (!truth().has_inside(p)) return;
    if (is_pixel() && window_.width == 1 && window_.height == 1)
        judge_depth(p, window_.x + 0.5, window_.y + 0.5, e.z.number);
    nearest_of_point_ = e.z.number;
}

void WarnockJudge::judge(const event::Nearer& e) {
    const int p = e.polygon.index;
    for (std::size_t i = 0; i < 4; ++i) {
        const auto z = depths_[p][i];
        const bool listed = std::find(e.corners.begin(), e.corners.end(), Corner(i)) != e.corners.end();
        if (z && nearest_[i] && truth().has_inside(p)) judge_comparison(*z, *nearest_[i], listed);
        if (listed && z) nearest_[i] = z;
    }
    compared_.fill(std::nullopt);
}

void WarnockJudge::judge(const event::Surround& e) {
    const int p = e.polygon.index;
    if (!truth().has_inside(p)) return;
    const auto where = truth().place(p, e.point.x.number, e.point.y.number);
    if (where == SceneTruth::Place::outline) {
        if (!e.inside) note(Difference::outline);
        return;
    }
    if (e.inside == (where == SceneTruth::Place::inside)) return;
    const std::string point = say.point(e.point.x.number, e.point.y.number);
    throw False{Symptom::point_in_polygon,
                e.inside ? say({"{} is inside {}", "точка {} лежит внутри {}"}, point, id(p))
                         : say({"{} is outside {}", "точка {} лежит вне {}"}, point, id(p)),
                e.inside ? say({"it is outside", "она лежит вне его"}) : say({"it is inside", "она лежит внутри"})};
}

void WarnockJudge::judge(const event::Orient& e) {
    const int p = e.polygon.index, claimed = int(e.sign);
    judge_edge(p, e.edge);
    const int side = truth().side(p, e.edge, e.point.x.number, e.point.y.number);
    const std::string claim =
        say({"the sign for edge {} of {} and {} is {}", "знак для ребра {} многоугольника {} и точки {} равен {}"},
            e.edge, id(p), say.point(e.point.x.number, e.point.y.number), claimed);
    if (sign_of(e.value.number) != claimed) {
        throw False{Symptom::point_in_polygon, claim,
                    say({"its value is {}", "само значение равно {}"}, e.value.number)};
    }
    if (side == 0 || !truth().has_inside(p)) return;
    if (claimed == 0) {
        throw False{Symptom::point_in_polygon, claim,
                    say({"the point is not on that edge's line", "точка не лежит на прямой этого ребра"})};
    }
    const int convention = orientations_.try_emplace(p, claimed * side).first->second;
    if (convention == claimed * side) return;
    throw False{Symptom::point_in_polygon, claim,
                say({"by the signs before it would be {}", "судя по прежним знакам, он должен быть {}"}, -claimed)};
}

void WarnockJudge::judge(const event::Mark& e) const {
    const int p = e.polygon.index;
    if (truth().holds(p, truth().in_area(window_))) return;
    throw False{Symptom::point_in_polygon, say({"{} surrounds the window {}", "{} охватывает окно {}"}, id(p), window_),
                say({"not all of its corners are inside", "не все углы окна лежат внутри"})};
}

/// The polygon must surround the window, and no polygon counted so far may be nearer at a corner.
void WarnockJudge::judge(const event::Cover& e) {
    const int p = e.polygon.index;
    has_surround_ = true;
    if (!truth().has_inside(p)) return;
    const std::string claimed =
        say({"{} surrounds the window {} and is the nearest so far", "{} охватывает окно {} и ближе всех предыдущих"},
            id(p), window_);
    if (!truth().holds(p, truth().in_area(window_)))
        throw False{Symptom::surrounded, claimed, say({"it does not surround it", "он его не охватывает"})};
    for (const int q : counted_) {
        if (q == p || !truth().has_inside(q)) continue;
        for (const auto& [x, y] : corners_of(window_)) {
            if (truth().nearer(q, p, x, y) <= 0) continue;
            throw False{Symptom::surrounded, claimed,
                        say({"{} is nearer at the corner {}", "{} ближе в углу {}"}, id(q), say.point(x, y))};
        }
    }
}

/// Whether the polygon lies strictly inside. If it touches the window's sides, either answer is right.
void WarnockJudge::judge(const event::Insider& e) const {
    const int p = e.polygon.index;
    const PlainBox box = truth().box(p);
    const double room =
        std::min({box.xmin - window_.x, box.ymin - window_.y, window_.right() - box.xmax, window_.bottom() - box.ymax});
    if (truth().may_coincide(room, 0) || e.inside == (room > 0)) return;
    throw False{Symptom::insider,
                e.inside
                    ? say({"{} lies inside of the window {}", "{} лежит внутри окна {}"}, id(p), window_)
                    : say({"{} does not lie inside of the window {}", "{} не лежит внутри окна {}"}, id(p), window_),
                e.inside ? say({"it reaches beyond its sides", "он выходит за его стороны"})
                         : say({"it does not reach its sides", "он не доходит до его сторон"})};
}

void WarnockJudge::judge(const event::Summary& e) {
    summary_ = e;
    if (!counted_.empty() && e.count != int(counted_.size())) {
        throw False{Symptom::count, say({"{} polygons are in the window", "многоугольников в окне: {}"}, e.count),
                    say({"the trace has counted {}", "в записи их {}"}, counted_.size())};
    }
    if (has_surround_ && *has_surround_ != e.has_surround) {
        throw False{
            Symptom::contradiction,
            say({"hasSurround is {}", "hasSurround равен {}"}, e.has_surround ? "true" : "false"),
            say({"it was set to {} before", "раньше он получил значение {}"}, e.has_surround ? "false" : "true")};
    }
    if (e.has_surround && e.color) judge_surrounded(*e.color);
}

void WarnockJudge::judge_surrounded(Color color) {
    const std::string claimed =
        say({"{} hides everything else in the window {}", "{} закрывает всё остальное в окне {}"}, owner_of(color),
            window_);
    for_pixels([&](int column, int row) {
        if (truth().allows(column, row, color)) return;
        const bool overlooked = overlooks(column, row);
        const int right = truth().seen(column, row).by_rule;
        throw False{overlooked ? Symptom::overlooked : Symptom::surrounded, claimed,
                    why_not(column, row, color) + (overlooked ? say(not_looked_at, id(right)) : "")};
    });
    if (!is_pixel()) judge_surrounds(color);
}

/// Some polygon of the colour must surround the window and be nearer than all others everywhere in it, between the
/// pixel centres too.
void WarnockJudge::judge_surrounds(Color color) const {
    const Window window = truth().in_area(window_);
    std::optional<std::pair<int, int>> before;  // one that surrounds it, and one that is nearer
    for (int p = 0; p < int(scene().polygons.size()); ++p) {
        if (scene().polygons[std::size_t(p)].color != color || !truth().has_inside(p) || !truth().holds(p, window))
            continue;
        const auto nearer = truth().nearer_in(p, window);
        if (!nearer) return;
        before = {p, *nearer};
    }
    throw False{Symptom::surrounded,
                say({"{} surrounds the window {} and hides everything else in it",
                     "{} охватывает окно {} и закрывает всё остальное в нём"},
                    owner_of(color), window_),
                before ? say({"{} is nearer than {} in a part of it", "{} в части окна ближе, чем {}"},
                             id(before->second), id(before->first))
                       : say({"no polygon of that colour has all of its corners inside",
                              "ни в одном многоугольнике этого цвета не лежат все его углы"})};
}

void WarnockJudge::judge_empty() {
    const std::string claimed = say({"the window {} is empty", "окно {} пусто"}, window_);
    for_pixels([&](int column, int row) {
        if (truth().allows(column, row, scene().background)) return;
        const bool known = tells_counts_ && !overlooks(column, row);
        throw False{known ? Symptom::not_plain : Symptom::overlooked, claimed,
                    why_not(column, row, scene().background)};
    });
    if (is_pixel()) return;
    for (int p = 0; p < int(scene().polygons.size()); ++p) {
        if (!truth().meets(p, truth().in_area(window_))) continue;
        throw False{Symptom::not_plain, claimed, say({"{} has a part in it", "в нём лежит часть {}"}, id(p))};
    }
}

/// One polygon and the background must suffice for all pixels of the window.
void WarnockJudge::judge_single() {
    std::optional<std::pair<int, int>> first;  // the first pixel that cannot show the background
    std::set<Color, decltype([](const Color& a, const Color& b) {
                 return std::tie(a.red, a.green, a.blue) < std::tie(b.red, b.green, b.blue);
             })>
        enough;
    for_pixels([&](int column, int row) {
        if (truth().allows(column, row, scene().background)) return;
        if (!first) {
            first = {column, row};
            for (const int q : truth().seen(column, row).allowed) enough.insert(truth().color_of(q));
        }
        std::erase_if(enough, [&](const Color& color) { return !truth().allows(column, row, color); });
        if (!enough.empty()) return;
        const bool overlooked = overlooks(column, row) || overlooks(first->first, first->second);
        const auto shown = [&](int x, int y) {
            return say({"{} shows at pixel {}", "{} виден в пикселе {}"}, id(truth().seen(x, y).by_rule), pixel(x, y));
        };
        throw False{
            overlooked ? Symptom::overlooked : Symptom::not_plain,
            say({"no more than one polygon shows in the window {}", "в окне {} виден не более чем один многоугольник"},
                window_),
            shown(first->first, first->second) + ", " + shown(column, row)};
    });
}

/// The case must follow from what ProcessWindow found.
void WarnockJudge::judge_follows(Case which) const {
    if (!summary_) return;
    const auto& [at, count, has_surround, color, insider] = *summary_;
    const bool follows = which == Case::empty        ? count == 0
                         : which == Case::surrounded ? has_surround
                         : which == Case::single     ? count == 1
                         : which == Case::split      ? count > 0 && !has_surround
                                                     : true;
    if (follows) return;
    constexpr std::array<Bilingual, 5> names{{{"empty", "пусто"},
                                              {"surrounded", "охвачено"},
                                              {"a pixel", "пиксель"},
                                              {"of a single polygon", "с единственным многоугольником"},
                                              {"to be split", "подлежит делению"}}};
    throw False{Symptom::contradiction,
                say({"the window {} is {}", "окно {}: {}"}, window_, say(names[std::size_t(which)])),
                say({"what was found in it is: {} polygons, hasSurround {}",
                     "найдено в нём: многоугольников {}, hasSurround {}"},
                    count, has_surround ? "true" : "false")};
}

void WarnockJudge::judge(const event::Decide& e) {
    decided_ = e.which;
    if (e.which == Case::empty) judge_empty();
    if (e.which == Case::single) judge_single();
    if (e.which == Case::split) {
        tree_.split(step_);
        if (is_pixel()) {
            throw False{Symptom::too_small, say({"the window {} is split", "окно {} делится"}, window_),
                        say({"it is no larger than a pixel", "оно не больше пикселя"})};
        }
    }
    if (e.which == Case::pixel && pixels().width * pixels().height > 1) {
        throw False{Symptom::too_small,
                    say({"the window {} is no larger than a pixel", "окно {} не больше пикселя"}, window_),
                    say({"it has more than one pixel", "пикселей в нём больше"})};
    }
    judge_follows(e.which);
}

void WarnockJudge::judge(const event::Fill& e) {
    const auto& r = e.rect;
    const std::string claimed = say({"the pixels {} take {}", "пиксели {} получают цвет: {}"}, r, owner_of(e.color));
    for (int row = r.y; row < r.y + r.height; ++row) {
        for (int column = r.x; column < r.x + r.width; ++column) {
            judge_in_window(column, row, claimed);
            painted_.insert({column, row});
        }
    }
    if (decided_ == Case::single) return;
    if (decided_ == Case::surrounded) judge_surrounded(e.color);
    for (int row = r.y; row < r.y + r.height; ++row) {
        for (int column = r.x; column < r.x + r.width; ++column) judge_shown(column, row, e.color);
    }
}

void WarnockJudge::judge(const event::PointColor& e) {
    const double x = std::floor(e.point.x.number), y = std::floor(e.point.y.number);
    const bool in_area =
        scene().area.x <= x && x < scene().area.right() && scene().area.y <= y && y < scene().area.bottom();
    if (e.point.x.number != x + 0.5 || e.point.y.number != y + 0.5 || !in_area) {
        throw False{Symptom::colour,
                    say({"the colour at {} is that of a pixel", "цвет в точке {} — цвет пикселя"},
                        say.point(e.point.x.number, e.point.y.number)),
                    say({"no pixel of the area has its centre there", "ни у одного пикселя области нет там центра"})};
    }
    judge_shown(int(x), int(y), e.color);
}

void WarnockJudge::judge(const event::ClipBegin& e) {
    side_.reset();
    sides_ = 0;
    clipped_ = e.polygon.index;
}

void WarnockJudge::judge(const event::ClipSide& e) {
    side_ = {e.from, e.to};
    ++sides_;
    const auto corners = corners_of(window_);
    const auto is_corner = [&](const ValuePoint& p) {
        return std::any_of(corners.begin(), corners.end(), [&](const auto& corner) {
            return truth().same_coordinate(p.x.number, corner.first) &&
                   truth().same_coordinate(p.y.number, corner.second);
        });
    };
    if (is_corner(e.from) && is_corner(e.to) &&
        (e.from.x.number == e.to.x.number) != (e.from.y.number == e.to.y.number))
        return judge_side_number(e);
    throw False{Symptom::clip, side_in_words(e), say({"it has no such side", "такой стороны у него нет"})};
}

std::string WarnockJudge::side_in_words(const event::ClipSide& e) const {
    return say({"side {} of the window {} goes from {} to {}", "сторона {} окна {} идёт от {} до {}"}, e.side, window_,
               say.point(e.from.x.number, e.from.y.number), say.point(e.to.x.number, e.to.y.number));
}

/// The sides are numbered in the order in which they clip, or as in PolygonClip: upper, left, lower and right.
void WarnockJudge::judge_side_number(const event::ClipSide& e) const {
    const bool upright = e.from.x.number == e.to.x.number;
    const bool is_first =
        truth().same_coordinate(upright ? e.from.x.number : e.from.y.number, upright ? window_.x : window_.y);
    const int by_place = (is_first ? 1 : 3) + (upright ? 1 : 0);
    if (e.side == sides_ || e.side == by_place) return;
    throw False{Symptom::clip, side_in_words(e),
                say({"by its place this is side {}, but the polygon is now clipped by side number {}",
                     "по положению это сторона {}, а по порядку отсечения — {}"},
                    by_place, sides_)};
}

/// 1 if a vertex lies on the outer side of the current clipping line, -1 if on the inner side, 0 if on the line or if
/// there is no line.
int WarnockJudge::beyond_side(const ValueVertex& v) const {
    if (!side_) return 0;
    const auto& [from, to] = *side_;
    const bool upright = from.x == to.x;
    const double at = upright ? from.x.number : from.y.number;
    const double inside = upright ? window_.x + window_.width / 2 : window_.y + window_.height / 2;
    const double value = upright ? v.x.number : v.y.number;
    if ((!upright && !(from.y == to.y)) || truth().same_coordinate(value, at)) return 0;
    return (value > at) == (inside > at) ? -1 : 1;
}

void WarnockJudge::judge(const event::ClipSign& e) const {
    const int claimed = int(e.sign), right = beyond_side(e.vertex);
    const std::string vertex = say.point(e.vertex.x.number, e.vertex.y.number);
    const std::string claim = say({"the sign for {} is {}", "знак для {} равен {}"}, vertex, claimed);
    if (sign_of(e.value.number) != claimed)
        throw False{Symptom::clipped_inside, claim, say({"its value is {}", "само значение равно {}"}, e.value.number)};
    if (right == 0 || claimed == right) return;
    throw False{Symptom::clipped_inside, claim,
                right > 0
                    ? say({"it lies outside of the window {} by the current side, where signs are positive",
                           "она лежит вне окна {} по текущей стороне, а там знаки положительны"},
                          window_)
                    : say({"it lies on the inner side of the current side of the window {}, where signs are negative",
                           "она лежит с внутренней стороны окна {}, а там знаки отрицательны"},
                          window_)};
}

void WarnockJudge::judge(const event::ClipCross& e) const {
    const bool on_side = beyond_side(e.vertex) == 0;
    if (on_side &&
        (clipped_ < 0 || truth().has_vertex(clipped_, {e.vertex.x.number, e.vertex.y.number, e.vertex.z.number})))
        return;
    throw False{Symptom::clip,
                say({"{} is where the outline crosses the line of the current side",
                     "{} — точка пересечения с прямой текущей стороны"},
                    say.point(e.vertex.x.number, e.vertex.y.number, e.vertex.z.number)),
                on_side ? say({"it is not on the polygon", "она не лежит на многоугольнике"})
                        : say({"it is not on that line", "она не лежит на этой прямой"})};
}

void WarnockJudge::judge(const event::ClipKeep& e) const {
    if (beyond_side(e.vertex) <= 0) return;
    throw False{
        Symptom::clipped_inside,
        say({"{} is kept", "вершина {} остаётся"}, say.point(e.vertex.x.number, e.vertex.y.number)),
        say({"it lies outside of the window {} by the current side", "она лежит вне окна {} по текущей стороне"},
            window_)};
}

void WarnockJudge::judge(const event::ClipDrop& e) const {
    if (beyond_side(e.vertex) >= 0) return;
    throw False{Symptom::clipped_inside,
                say({"{} is dropped", "вершина {} отбрасывается"}, say.point(e.vertex.x.number, e.vertex.y.number)),
                say({"it lies on the inner side of the current side of the window {}",
                     "она лежит с внутренней стороны текущей стороны окна {}"},
                    window_)};
}

void WarnockJudge::judge(const event::ClipResult& e) {
    const int p = e.polygon.index;
    std::vector<glm::dvec3> vertices;
    for (const auto& v : e.vertices) vertices.push_back({v.x.number, v.y.number, v.z.number});
    if (const auto reason = truth().no_part(p, window_, vertices, say)) {
        throw False{
            vertices.empty() ? Symptom::clipped_away : Symptom::clip,
            say({"the part of {} in the window {} has {} vertices", "в части {}, лежащей в окне {}, вершин: {}"}, id(p),
                window_, vertices.size()),
            *reason};
    }
    const auto turn = [](const auto& list) {
        return twice_area(
            list, [](const auto& v) { return v.x; }, [](const auto& v) { return v.y; });
    };
    if (turn(vertices) * turn(scene().polygons[std::size_t(p)].vertices) < 0) note(Difference::order_of_vertices);
    sides_ = 0;
    clipped_ = p;
}

/// The ends of the rows before a `draw` must be those of the polygon or of its part in the window.
void WarnockJudge::judge_rows(int polygon) {
    if (!truth().has_inside(polygon)) return;
    for (const event::Row& e : rows_) {
        const auto whole = truth().ends(polygon, e.row + 0.5);
        const double left = e.left.number, right = e.right.number;
        if (!(left < right) || (whole && is_row(e.row + 0.5, left, right, *whole, window_))) continue;
        throw False{Symptom::edge,
                    say({"on row {} {} goes from x = {} to {}", "в строке {} {} занимает от x = {} до {}"}, e.row,
                        id(polygon), left, right),
                    whole ? say({"it goes from {} to {}", "он занимает от {} до {}"}, whole->first.x, whole->second.x)
                          : say({"it does not meet that row's line", "он не пересекает линию этой строки"})};
    }
    rows_.clear();
}

void WarnockJudge::judge(const event::Draw& e) {
    const int p = e.polygon.index;
    Picture after = state().picture();
    bool any = false;
    for (const auto& run : e.runs) {
        for (int column = run.first; column < run.end; ++column) {
            const std::string claimed =
                say({"{} is drawn at pixel {}", "{} рисуется в пикселе {}"}, id(p), pixel(column, run.row));
            judge_in_window(column, run.row, claimed);
            if (truth().place(p, column + 0.5, run.row + 0.5) == SceneTruth::Place::outside) {
                throw False{Symptom::off_polygon, claimed, why_not(column, run.row, e.color)};
            }
            painted_.insert({column, run.row});
            any = true;
        }
        after.paint(run, e.color);
    }
    judge_rows(p);
    if (decided_ != Case::single) return;
    for_pixels([&](int column, int row) {
        const Color color = after.at(column, row);
        if (!truth().allows(column, row, color)) {
            throw False{any ? Symptom::colour : Symptom::clipped_away,
                        say({"{} is drawn in the window {}, and pixel {} shows {}",
                             "{} нарисован в окне {}, и в пикселе {} виден {}"},
                            id(p), window_, pixel(column, row), owner_of(color)),
                        why_not(column, row, color)};
        }
        judge_pixel(column, row, color);
    });
}

}  // namespace vidno::grading
