#include "grade/warnock_judge.h"

#include <algorithm>
#include <cmath>

namespace vidno::grading {

using vidno::in_words;

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

}  // namespace

bool WarnockJudge::looked_at(int polygon) const {
    return std::find(counted_.begin(), counted_.end(), polygon) != counted_.end();
}

/// Whether what shows at a pixel has not been looked at in this window, as far as the program tells.
bool WarnockJudge::overlooks(int column, int row) const {
    const int right = truth().seen(column, row).by_rule;
    return tells_counts_ && right != SeenPixel::background && !looked_at(right);
}

/// Whether nothing but this polygon may show there.
bool WarnockJudge::needs(int column, int row, int polygon) const {
    const auto& allowed = truth().seen(column, row).allowed;
    return std::all_of(allowed.begin(), allowed.end(), [&](int q) { return q == polygon; });
}

void WarnockJudge::judge_shown(int column, int row, Color color) {
    if (!truth().allows(column, row, color) && overlooks(column, row)) {
        throw False{Symptom::overlooked, pixel_in_words(column, row) + " shows " + owner_of(color),
                    why_not(column, row, color) + "; but " + id(truth().seen(column, row).by_rule) +
                        " was not looked at in this window"};
    }
    judge_pixel(column, row, color);
}

void WarnockJudge::judge_in_window(int column, int row, const std::string& told) const {
    const bool is_in = scene().area.contains(column, row) && column >= std::floor(window_.x) &&
                       column < std::ceil(window_.right()) && row >= std::floor(window_.y) &&
                       row < std::ceil(window_.bottom());
    if (!is_in) throw False{Symptom::off_window, told, pixel_in_words(column, row) + " is not in " + in_words(window_)};
}

void WarnockJudge::judge(const event::Push& e) {
    const bool is_root = tree_.empty();
    const Area& area = scene().area;
    if (is_root) {
        const bool covers = e.window.x <= area.x && e.window.y <= area.y && e.window.right() >= area.right() &&
                            e.window.bottom() >= area.bottom();
        if (!covers) {
            throw False{Symptom::stray_window, "the first window is " + in_words(e.window),
                        "the area is " + in_words(whole_area(area))};
        }
        if (!(e.window == covering_square(area))) note(Difference::other_windows);
    }
    if (tree_.push(e.window, step_)) return;
    throw False{Symptom::stray_window, in_words(e.window) + " goes on the stack",
                "it is no part of a window that was split"};
}

void WarnockJudge::judge_parts() {
    if (const auto missing = tree_.uncovered_now()) {
        throw False{Symptom::parts_missing, "these are all parts of " + in_words(missing->window),
                    pixel_in_words(missing->column, missing->row) + " is in none of them", missing->step};
    }
    if (decided_ != Case::split || tree_.parts().size() < 2) return;
    std::vector<Window> usual = parts_of(window_), told = tree_.parts();
    const auto off = [&](const Window& part) { return off_area(part, scene().area); };
    std::erase_if(usual, off);
    std::erase_if(told, off);
    if (told == usual) return;
    note(std::is_permutation(told.begin(), told.end(), usual.begin(), usual.end()) ? Difference::order_of_parts
                                                                                   : Difference::other_windows);
}

void WarnockJudge::judge(const event::Pop& e) {
    if (decided_) finish_window();
    tree_.pop(e.window);
    window_ = e.window;
    decided_.reset();
    counted_.clear();
    depths_.clear();
    nearest_.fill(std::nullopt);
}

/// A single polygon is painted on the background: only then do the pixels have their colours.
void WarnockJudge::finish_window() {
    judge_parts();
    if (decided_ != Case::single) return;
    for_pixels([&](int column, int row) {
        const Color color = state().picture().at(column, row);
        if (truth().allows(column, row, color)) return;
        throw False{Symptom::clipped_away,
                    in_words(window_) + " is done: " + pixel_in_words(column, row) + " shows " + owner_of(color),
                    why_not(column, row, color), last_step_};
    });
}

void WarnockJudge::finish() {
    if (decided_) finish_window();
    if (const auto missing = tree_.uncovered()) {
        throw False{Symptom::parts_missing, "these are all parts of " + in_words(missing->window),
                    pixel_in_words(missing->column, missing->row) + " is in none of them", missing->step};
    }
    const Area& area = scene().area;
    for (int row = area.y; row < area.bottom(); ++row) {
        for (int column = area.x; column < area.right(); ++column) {
            const Color color = state().picture().at(column, row);
            if (!truth().allows(column, row, color) && !painted_.contains({column, row})) {
                throw False{Symptom::not_painted,
                            "the run is over, and nothing has painted " + pixel_in_words(column, row),
                            why_not(column, row, color)};
            }
            judge_pixel(column, row, color);
        }
    }
    if (tree_.is_recursive()) note(Difference::recursion);
}

void WarnockJudge::judge(const event::Corners& e) {
    judge_start(e.z.number, "the depths at the corners start");
    nearest_.fill(e.z.number);
}

void WarnockJudge::judge(const event::Box& e) const {
    const int p = e.polygon.index;
    const bool meets = e.outside && truth().meets(p, window_);
    if (meets) throw False{Symptom::left_list, id(p) + " lies outside of " + in_words(window_), "it has a part in it"};
}

void WarnockJudge::judge(const event::Discard& e) {
    const int p = e.polygon.index;
    if (!truth().meets(p, window_)) return;
    for_pixels([&](int column, int row) {
        if (!needs(column, row, p)) return;
        throw False{Symptom::left_list, id(p) + " leaves the list of " + in_words(window_),
                    "it shows in that window, at " + pixel_in_words(column, row)};
    });
    note(Difference::hidden_leave);
}

void WarnockJudge::judge(const event::Count& e) {
    const int p = e.polygon.index;
    if (!counted_.empty() && counted_.back() > p) note(Difference::order_of_polygons);
    counted_.push_back(p);
    tells_counts_ = true;
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
    if (!truth().has_inside(e.polygon.index)) return;
    judge_comparison(e.z.number, e.against.number, e.nearer);
}

void WarnockJudge::judge(const event::Nearer& e) {
    const int p = e.polygon.index;
    for (std::size_t i = 0; i < 4; ++i) {
        const auto z = depths_[p][i];
        const bool listed = std::find(e.corners.begin(), e.corners.end(), Corner(i)) != e.corners.end();
        if (z && nearest_[i] && truth().has_inside(p)) judge_comparison(*z, *nearest_[i], listed);
        if (listed && z) nearest_[i] = z;
    }
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
    throw False{
        Symptom::point_in_polygon,
        point_in_words(e.point.x.number, e.point.y.number) + " is " + (e.inside ? "inside " : "outside ") + id(p),
        std::string("it is ") + (e.inside ? "outside" : "inside")};
}

void WarnockJudge::judge(const event::Orient& e) {
    const int p = e.polygon.index, told = int(e.sign);
    const int side = truth().side(p, e.edge, e.point.x.number, e.point.y.number);
    const std::string claim = "the sign for edge " + std::to_string(e.edge) + " of " + id(p) + " and " +
                              point_in_words(e.point.x.number, e.point.y.number) + " is " + std::to_string(told);
    if (sign_of(e.value.number) != told) {
        throw False{Symptom::point_in_polygon, claim, "its value is " + in_words(e.value.number)};
    }
    if (side == 0 || !truth().has_inside(p)) return;
    if (told == 0) throw False{Symptom::point_in_polygon, claim, "the point is not on that edge's line"};
    const int convention = orientations_.try_emplace(p, told * side).first->second;
    if (convention == told * side) return;
    throw False{Symptom::point_in_polygon, claim, "by the signs before it would be " + std::to_string(-told)};
}

void WarnockJudge::judge(const event::Mark& e) const {
    const int p = e.polygon.index;
    if (truth().holds(p, window_)) return;
    throw False{Symptom::point_in_polygon, id(p) + " surrounds " + in_words(window_),
                "not all of its corners are inside"};
}

void WarnockJudge::judge(const event::Insider& e) const {
    if (!e.inside) return;
    const int p = e.polygon.index;
    for (const auto& v : scene().polygons[std::size_t(p)].vertices) {
        if (window_.x <= v.x && v.x <= window_.right() && window_.y <= v.y && v.y <= window_.bottom()) continue;
        throw False{Symptom::insider, id(p) + " lies inside of " + in_words(window_),
                    "its vertex " + point_in_words(v.x, v.y) + " does not"};
    }
}

void WarnockJudge::judge(const event::Summary& e) {
    if (e.has_surround && e.color) judge_surrounded(*e.color);
}

void WarnockJudge::judge_surrounded(Color color) {
    for_pixels([&](int column, int row) {
        if (truth().allows(column, row, color)) return;
        const bool overlooked = overlooks(column, row);
        throw False{
            overlooked ? Symptom::overlooked : Symptom::surrounded,
            owner_of(color) + " hides all else in " + in_words(window_),
            why_not(column, row, color) + (overlooked ? "; but that polygon was not looked at in this window" : "")};
    });
}

void WarnockJudge::judge_empty() {
    for_pixels([&](int column, int row) {
        if (truth().allows(column, row, scene().background)) return;
        const bool known = tells_counts_ && !overlooks(column, row);
        throw False{known ? Symptom::not_plain : Symptom::overlooked, in_words(window_) + " is empty",
                    why_not(column, row, scene().background)};
    });
}

/// Some polygon and the background must be enough for all pixels.
void WarnockJudge::judge_single() {
    std::optional<std::pair<int, int>> first;  // a pixel that needs a polygon
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
            return id(truth().seen(x, y).by_rule) + " shows at " + pixel_in_words(x, y);
        };
        throw False{overlooked ? Symptom::overlooked : Symptom::not_plain,
                    "no more than one polygon shows in " + in_words(window_),
                    shown(first->first, first->second) + ", " + shown(column, row)};
    });
}

void WarnockJudge::judge(const event::Decide& e) {
    decided_ = e.which;
    if (e.which == Case::empty) judge_empty();
    if (e.which == Case::single) judge_single();
    if (e.which == Case::split) {
        tree_.split(step_);
        if (window_.width <= 1 && window_.height <= 1) {
            throw False{Symptom::too_small, in_words(window_) + " is split", "it is no larger than a pixel"};
        }
    }
    if (e.which == Case::pixel && pixels().width * pixels().height > 1) {
        throw False{Symptom::too_small, in_words(window_) + " is no larger than a pixel", "it has more of them"};
    }
}

void WarnockJudge::judge(const event::Fill& e) {
    const auto& r = e.rect;
    const std::string told = "the pixels " + in_words(r) + " take " + owner_of(e.color);
    for (int row = r.y; row < r.y + r.height; ++row) {
        for (int column = r.x; column < r.x + r.width; ++column) {
            judge_in_window(column, row, told);
            painted_.insert({column, row});
        }
    }
    if (decided_ == Case::single) return;
    for (int row = r.y; row < r.y + r.height; ++row) {
        for (int column = r.x; column < r.x + r.width; ++column) {
            if (decided_ == Case::surrounded && !truth().allows(column, row, e.color)) judge_surrounded(e.color);
            judge_shown(column, row, e.color);
        }
    }
}

void WarnockJudge::judge(const event::PointColor& e) {
    const double x = std::floor(e.point.x.number), y = std::floor(e.point.y.number);
    const bool in_area =
        scene().area.x <= x && x < scene().area.right() && scene().area.y <= y && y < scene().area.bottom();
    if (e.point.x.number != x + 0.5 || e.point.y.number != y + 0.5 || !in_area) {
        throw False{Symptom::colour,
                    "the colour at " + point_in_words(e.point.x.number, e.point.y.number) + " is that of a pixel",
                    "no pixel of the area has its centre there"};
    }
    judge_shown(int(x), int(y), e.color);
}

/// 1 if a vertex is outside the window by the current side, -1 if inside, 0 if either is right.
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

void WarnockJudge::judge(const event::ClipKeep& e) const {
    if (beyond_side(e.vertex) <= 0) return;
    throw False{Symptom::clipped_inside, point_in_words(e.vertex.x.number, e.vertex.y.number) + " is kept",
                "it lies outside of " + in_words(window_) + " by the current side"};
}

void WarnockJudge::judge(const event::ClipDrop& e) const {
    if (beyond_side(e.vertex) >= 0) return;
    throw False{Symptom::clipped_inside, point_in_words(e.vertex.x.number, e.vertex.y.number) + " is dropped",
                "it lies on the inner side of the current side of " + in_words(window_)};
}

void WarnockJudge::judge(const event::ClipResult& e) {
    const int p = e.polygon.index;
    std::vector<glm::dvec3> vertices;
    for (const auto& v : e.vertices) vertices.push_back({v.x.number, v.y.number, v.z.number});
    if (const auto reason = truth().no_part(p, window_, vertices)) {
        throw False{vertices.empty() ? Symptom::clipped_away : Symptom::clip,
                    "the part of " + id(p) + " in " + in_words(window_) + " has " + std::to_string(vertices.size()) +
                        " vertices",
                    *reason};
    }
    const auto turn = [](const auto& list) {
        return twice_area(
            list, [](const auto& v) { return v.x; }, [](const auto& v) { return v.y; });
    };
    if (turn(vertices) * turn(scene().polygons[std::size_t(p)].vertices) < 0) note(Difference::order_of_vertices);
}

void WarnockJudge::judge(const event::Draw& e) {
    const int p = e.polygon.index;
    Picture after = state().picture();
    bool any = false;
    for (const auto& run : e.runs) {
        for (int column = run.first; column < run.end; ++column) {
            const std::string told = id(p) + " is drawn at " + pixel_in_words(column, run.row);
            judge_in_window(column, run.row, told);
            if (truth().place(p, column + 0.5, run.row + 0.5) == SceneTruth::Place::outside) {
                throw False{Symptom::off_polygon, told, why_not(column, run.row, e.color)};
            }
            painted_.insert({column, run.row});
            any = true;
        }
        after.paint(run, e.color);
    }
    if (decided_ != Case::single) return;
    for_pixels([&](int column, int row) {
        const Color color = after.at(column, row);
        if (!truth().allows(column, row, color)) {
            throw False{any ? Symptom::colour : Symptom::clipped_away,
                        id(p) + " is drawn in " + in_words(window_) + ", and " + pixel_in_words(column, row) +
                            " shows " + owner_of(color),
                        why_not(column, row, color)};
        }
        judge_pixel(column, row, color);
    });
}

}  // namespace vidno::grading
