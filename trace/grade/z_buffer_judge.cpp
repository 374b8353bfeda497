#include "grade/z_buffer_judge.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vidno::grading {

void ZBufferJudge::judge(const event::Clear& e) {
    judge_start(e.z.number, {"the depths of the Z-buffer start at {}", "глубины Z-буфера начинаются с {}"});
    cells_.clear();
    cleared_ = e.z.number;
}

void ZBufferJudge::judge(const event::Polygon& e) {
    const std::optional<int> before = std::exchange(polygon_, e.polygon.index);
    const std::uint64_t begun = std::exchange(begun_, step_);
    line_.reset();
    if (!before) return;
    if (*before > e.polygon.index) note(Difference::order_of_polygons);
    leave_polygon(*before, begun);
}

/// If the program never returns to the polygon, it must show wherever it is nearer than all that came so far.
void ZBufferJudge::leave_polygon(int polygon, std::uint64_t begun) const {
    const auto last = last_steps_.find(polygon);
    if (last == last_steps_.end() || last->second != begun || !truth().has_inside(polygon)) return;
    const Area& area = scene().area;
    for (int row = area.y; row < area.bottom(); ++row) {
        for (int column = area.x; column < area.right(); ++column) {
            const double x = column + 0.5, y = row + 0.5;
            const auto found = cells_.find({column, row});
            const int shown = found == cells_.end() ? SeenPixel::background : found->second.polygon;
            if (shown == polygon || truth().place(polygon, x, y) != SceneTruth::Place::inside) continue;
            if (shown != SeenPixel::background && truth().nearer(polygon, shown, x, y) <= 0) continue;
            const std::string there = shown == SeenPixel::background ? say({"nothing", "ничего"}) : id(shown);
            throw False{Symptom::not_painted,
                        say({"{} is done, and pixel {} shows {} of what came so far",
                             "{} готов, а в пикселе {} из уже рассмотренного видно: {}"},
                            id(polygon), pixel(column, row), there),
                        shown == SeenPixel::background
                            ? say({"its centre is inside {}", "его центр лежит внутри {}"}, id(polygon))
                            : say({"its centre is inside {0}, which is nearer there than {1}",
                                   "его центр лежит внутри {0}, который там ближе, чем {1}"},
                                  id(polygon), id(shown)),
                        last_step_};
        }
    }
}

void ZBufferJudge::finish() {
    if (polygon_) leave_polygon(*polygon_, begun_);
    const Area& area = scene().area;
    for (int row = area.y; row < area.bottom(); ++row) {
        for (int column = area.x; column < area.right(); ++column) {
            judge_pixel(column, row, state().screen().color(column, row));
        }
    }
}

void ZBufferJudge::judge(const event::Depth& e) const {
    judge_depth(e.polygon.index, e.point.x.number, e.point.y.number, e.z.number);
}

void ZBufferJudge::judge(const event::Edge& e) const {
    if (!polygon_) return;
    const auto& vertices = scene().polygons[std::size_t(*polygon_)].vertices;
    const auto is = [&](const ValueVertex& claimed, std::size_t i) {
        const auto& v = vertices[i % vertices.size()];
        return truth().same_coordinate(claimed.x.number, v.x) && truth().same_coordinate(claimed.y.number, v.y);
    };
    const auto i = std::size_t(e.edge);
    if (i < vertices.size() && ((is(e.from, i) && is(e.to, i + 1)) || (is(e.from, i + 1) && is(e.to, i)))) return;
    throw False{
        Symptom::edge,
        say({"edge {} of {} goes from {} to {}", "ребро {} многоугольника {} идёт от {} до {}"}, e.edge, id(*polygon_),
            say.point(e.from.x.number, e.from.y.number), say.point(e.to.x.number, e.to.y.number)),
        say({"that is not from its vertex {} to the next", "это не от его вершины {} к следующей"}, e.edge)};
}

void ZBufferJudge::judge(const event::Extent& e) const {
    if (!polygon_) return;
    const PlainBox box = truth().box(*polygon_);
    if (truth().same_coordinate(e.ymin.number, box.ymin) && truth().same_coordinate(e.ymax.number, box.ymax)) return;
    throw False{Symptom::box,
                say({"{} reaches from y = {} to {}", "{} занимает от y = {} до {}"}, id(*polygon_), e.ymin.number,
                    e.ymax.number),
                say({"it reaches from {} to {}", "он занимает от {} до {}"}, box.ymin, box.ymax)};
}

void ZBufferJudge::judge(const event::Scanline& e) const {
    if (e.row <= e.y.number && e.y.number <= e.row + 1) return;
    throw False{Symptom::edge,
                say({"the scanline y = {} is that of row {}", "строке {1} соответствует y = {0}"}, e.y.number, e.row),
                say({"that row reaches from {} to {}", "эта строка занимает от {} до {}"}, e.row, e.row + 1)};
}

void ZBufferJudge::judge_entry(int edge, double y, double x, double z) const {
    if (!polygon_ || !truth().has_inside(*polygon_)) return;
    judge_edge(*polygon_, edge);
    const auto right = truth().crossing(*polygon_, edge, y);
    if (!right || (truth().same_coordinate(x, right->x) && truth().same_depth(z, right->z))) return;
    throw False{Symptom::edge,
                say({"edge {} of {} is at x = {}, z = {}", "ребро {} многоугольника {}: x = {}, z = {}"}, edge,
                    id(*polygon_), x, z),
                say({"at y = {} it is at x = {}, z = {}", "при y = {} у него x = {}, z = {}"}, y, right->x, right->z)};
}

/// Judges the edge's x and z on the row, their changes from row to row, and its last row.
void ZBufferJudge::judge(const event::AelAdd& e) const {
    if (!polygon_ || !truth().has_inside(*polygon_)) return;
    judge_edge(*polygon_, e.edge);
    if (state().z_buffer().last().y) judge_entry(e.edge, height(), e.x.number, e.z.number);
    const auto& vertices = scene().polygons[std::size_t(*polygon_)].vertices;
    const auto &p = vertices[std::size_t(e.edge)], &q = vertices[std::size_t(e.edge + 1) % vertices.size()];
    const auto above = truth().crossing(*polygon_, e.edge, std::min(p.y, q.y)),
               below = truth().crossing(*polygon_, e.edge, std::max(p.y, q.y));
    if (!above) return;
    const double rows = std::abs(q.y - p.y), dx = (below->x - above->x) / rows, dz = (below->z - above->z) / rows;
    // Over all rows of the edge the error may be as large as at one end, so the error of a change is multiplied by the
    // number of rows.
    if (!truth().same_coordinate(e.dx.number, dx, rows) || !truth().same_depth(e.dz.number, dz, rows)) {
        throw False{Symptom::edge,
                    say({"from row to row edge {} of {} changes by dx = {}, dz = {}",
                         "от строки к строке у ребра {} многоугольника {} dx = {}, dz = {}"},
                        e.edge, id(*polygon_), e.dx.number, e.dz.number),
                    say({"it changes by dx = {}, dz = {}", "у него dx = {}, dz = {}"}, dx, dz)};
    }
    const double lower = std::max(p.y, q.y), last = e.until.number + 0.5;
    const bool is_last = (last <= lower || truth().may_coincide(last, lower)) &&
                         (lower <= last + 1 || truth().may_coincide(lower, last + 1));
    const bool is_last_of_area = e.until.number >= scene().area.bottom() - 1 && last <= lower;
    if (is_last || is_last_of_area) return;
    throw False{Symptom::edge,
                say({"the last row of edge {} of {} is {}", "последняя строка ребра {} многоугольника {} — {}"}, e.edge,
                    id(*polygon_), e.until.number),
                say({"it goes down to y = {}", "оно доходит до y = {}"}, lower)};
}

void ZBufferJudge::judge(const event::AelStep& e) const {
    if (state().z_buffer().last().y) judge_entry(e.edge, height() + 1, e.x.number, e.z.number);
}

void ZBufferJudge::judge(const event::AelSort& e) const {
    double last = -std::numeric_limits<double>::infinity();
    for (const int edge : e.edges) {
        const auto& ael = state().z_buffer().active_edges();
        const auto entry = std::find_if(ael.begin(), ael.end(), [&](const auto& each) { return each.edge == edge; });
        if (entry == ael.end()) continue;
        const double x = entry->x.number;
        if (x < last && !truth().same_coordinate(x, last)) {
            throw False{Symptom::edge, say({"AEL is in order", "AEL упорядочен"}),
                        say({"edge {} is at x = {}, to the left of the one before, at {}",
                             "ребро {} стоит при x = {}, левее предыдущего, при {}"},
                            edge, x, last)};
        }
        last = x;
    }
    judge_next_end(e.next.number, e.edges);
}

/// An edge may leave AEL only after its last row.
void ZBufferJudge::judge(const event::AelDrop& e) const {
    if (!polygon_ || !state().z_buffer().last().row || *state().z_buffer().last().row + 1 >= scene().area.bottom())
        return;
    const auto& vertices = scene().polygons[std::size_t(*polygon_)].vertices;
    for (const int edge : e.edges) {
        judge_edge(*polygon_, edge);
        const double lower =
            std::max(vertices[std::size_t(edge)].y, vertices[std::size_t(edge + 1) % vertices.size()].y);
        const double next = *state().z_buffer().last().row + 1.5;
        if (lower <= next || truth().may_coincide(lower, next)) continue;
        throw False{
            Symptom::edge,
            say({"edge {} of {} leaves AEL after row {}", "ребро {} многоугольника {} уходит из AEL после строки {}"},
                edge, id(*polygon_), *state().z_buffer().last().row),
            say({"it goes down to y = {}, beyond the centre of the next row",
                 "оно доходит до y = {}, дальше центра следующей строки"},
                lower)};
    }
    std::vector<int> active;
    for (const auto& entry : state().z_buffer().active_edges()) {
        if (std::find(e.edges.begin(), e.edges.end(), entry.edge) == e.edges.end()) active.push_back(entry.edge);
    }
    judge_next_end(e.next.number, active);
}

/// Whether it is the first row whose centre lies at that height or below it. If the height is that of a centre, it may
/// be the row after. Without a height it is a row beyond the area. The rows of a program may also end at the sides of
/// the area.
bool ZBufferJudge::is_next(double row, const std::optional<double>& height) const {
    const Area& area = scene().area;
    if (!height) return row >= area.bottom();
    const double above = row - 0.5, below = row + 0.5;
    const bool is_row = (above <= *height || truth().may_coincide(above, *height)) &&
                        (*height <= below || truth().may_coincide(*height, below));
    return is_row || (row == area.y && *height < below) || (row >= area.bottom() && *height > area.bottom() - 0.5);
}

/// y_Snext: the row at which the next edges of S begin.
void ZBufferJudge::judge(const event::Leave& e) const {
    if (!polygon_ || state().z_buffer().edges().empty()) return;
    const auto& vertices = scene().polygons[std::size_t(*polygon_)].vertices;
    std::optional<double> upper;
    for (const int edge : state().z_buffer().edges()) {
        judge_edge(*polygon_, edge);
        if (std::find(e.edges.begin(), e.edges.end(), edge) != e.edges.end()) continue;
        const double y = std::min(vertices[std::size_t(edge)].y, vertices[std::size_t(edge + 1) % vertices.size()].y);
        upper = std::min(y, upper.value_or(y));
    }
    if (is_next(e.next.number, upper)) return;
    throw False{
        Symptom::edge,
        say({"the next edges of S begin at row {}", "следующие рёбра из S начинаются в строке {}"}, e.next.number),
        upper ? say({"the highest of them begins at y = {}", "верхнее из них начинается при y = {}"}, *upper)
              : say({"S is empty", "S пуст"})};
}

/// y_AELnext: the row at which the first edge of AEL has ended.
void ZBufferJudge::judge_next_end(double next, const std::vector<int>& active) const {
    if (!polygon_) return;
    const auto& vertices = scene().polygons[std::size_t(*polygon_)].vertices;
    std::optional<double> lower;
    for (const int edge : active) {
        judge_edge(*polygon_, edge);
        const double y = std::max(vertices[std::size_t(edge)].y, vertices[std::size_t(edge + 1) % vertices.size()].y);
        lower = std::min(y, lower.value_or(y));
    }
    if (is_next(next, lower)) return;
    throw False{Symptom::edge,
                say({"the first edge of AEL has ended at row {}", "первое ребро из AEL кончается к строке {}"}, next),
                lower ? say({"that edge goes down to y = {}", "оно доходит до y = {}"}, *lower)
                      : say({"AEL is empty", "AEL пуст"})};
}

/// Whether a row at height y is that of a part into which lines through two of the polygon's vertices cut it, such as a
/// triangle of a fan.
bool ZBufferJudge::is_part_of_row(double left, double right, double y) const {
    const auto& vertices = scene().polygons[std::size_t(*polygon_)].vertices;
    const auto is_end = [&](double x) {
        for (const auto& p : vertices) {
            for (const auto& q : vertices) {
                if (p.y <= y && y <= q.y && p.y < q.y &&
                    truth().same_coordinate(x, p.x + (y - p.y) * (q.x - p.x) / (q.y - p.y)))
                    return true;
            }
        }
        return truth().same_coordinate(x, scene().area.x) || truth().same_coordinate(x, scene().area.right());
    };
    return is_end(left) && is_end(right);
}

void ZBufferJudge::judge(const event::ShownLine& e) {
    line_ = e;
    ends_.reset();
    if (!polygon_ || !truth().has_inside(*polygon_)) return;
    const double y = state().z_buffer().last().y && state().z_buffer().last().row == e.row ? height() : e.row + 0.5;
    const auto right = truth().ends(*polygon_, y);
    const std::string claimed = say({"on row {} {} goes from x = {} to {}", "в строке {} {} занимает от x = {} до {}"},
                                    e.row, id(*polygon_), e.from.x.number, e.to.x.number);
    if (!right) {
        throw False{Symptom::edge, claimed,
                    say({"it does not meet that row's line, y = {}", "он не пересекает линию этой строки, y = {}"}, y)};
    }
    const auto& [from, to] = e.from.x.number <= e.to.x.number ? std::pair(e.from, e.to) : std::pair(e.to, e.from);
    const bool is_whole = is_row(y, from.x.number, to.x.number, *right, whole_area(scene().area));
    ends_ = is_whole ? *right : SceneTruth::Ends{{from.x.number, from.y.number}, {to.x.number, to.y.number}};
    if (!is_whole && !is_part_of_row(from.x.number, to.x.number, y)) {
        throw False{Symptom::edge, claimed,
                    say({"it goes from {} to {}", "он занимает от {} до {}"}, right->first.x, right->second.x)};
    }
    // The second coordinate of such a point is its z.
    for (const ValuePoint& end : {from, to}) {
        if (std::isfinite(end.x.number) && truth().same_depth(end.y.number, truth().depth(*polygon_, end.x.number, y)))
            continue;
        judge_depth(*polygon_, end.x.number, y, end.y.number);
    }
}

void ZBufferJudge::judge(const event::Slope& e) const {
    if (!polygon_ || !truth().has_inside(*polygon_) || !line_ || !std::isfinite(e.dz.number)) return;
    const double columns = std::abs(line_->to.x.number - line_->from.x.number);
    const double right = truth().depth_slope(*polygon_);
    if (columns == 0 || truth().same_depth(e.dz.number, right, columns)) return;
    throw False{
        Symptom::depth,
        say({"from pixel to pixel the depth of {} changes by {}", "от пикселя к пикселю глубина {} меняется на {}"},
            id(*polygon_), e.dz.number),
        say({"it changes by {}", "она меняется на {}"}, right)};
}

void ZBufferJudge::judge(const event::Columns& e) const {
    if (!polygon_ || !truth().has_inside(*polygon_) || !line_) return;
    const double y = line_->row + 0.5;
    if (ends_) judge_columns(*polygon_, line_->row, e.first, e.end, ends_->first, ends_->second);
    if (e.first < e.end) judge_depth(*polygon_, e.first + 0.5, y, e.z.number);
}

void ZBufferJudge::judge_covered(int column, int row) const {
    const bool in_area = scene().area.contains(column, row);
    if (!polygon_ || (in_area && truth().place(*polygon_, column + 0.5, row + 0.5) != SceneTruth::Place::outside))
        return;
    throw False{Symptom::off_polygon,
                say({"{} is drawn at pixel {}", "{} рисуется в пикселе {}"}, id(*polygon_), pixel(column, row)),
                in_area ? say({"its centre lies outside of {}", "его центр лежит вне {}"}, id(*polygon_))
                        : say({"that is not in the area", "он не лежит в области"})};
}

/// The current polygon takes a pixel: the pixel must not show a nearer one.
void ZBufferJudge::judge_shown(int column, int row) {
    judge_covered(column, row);
    Cell& own = cell(column, row);
    const double x = column + 0.5, y = row + 0.5;
    if (own.polygon != SeenPixel::background && own.polygon != *polygon_ &&
        truth().nearer(own.polygon, *polygon_, x, y) > 0) {
        throw False{
            Symptom::comparison,
            say({"{} takes pixel {}", "{} занимает пиксель {}"}, id(*polygon_), pixel(column, row)),
            say({"the depth of {}, which is there, is {}, and that of {} is {}",
                 "глубина {}, который уже там, равна {}, а глубина {} равна {}"},
                id(own.polygon), truth().depth(own.polygon, x, y), id(*polygon_), truth().depth(*polygon_, x, y))};
    }
    own.polygon = *polygon_;
}

void ZBufferJudge::judge(const event::Pixel& e) {
    if (!polygon_ || !truth().has_inside(*polygon_)) return;
    judge_covered(e.x, e.y);
    judge_depth(*polygon_, e.x + 0.5, e.y + 0.5, e.z.number);
    Cell& own = cell(e.x, e.y);
    const auto before = own.z ? own.z : cleared_;
    if (!before) {
        judge_start(e.stored.number,
                    {"the depths of the Z-buffer, never cleared, are {}", "глубины Z-буфера, не очищенного, равны {}"});
    }
    if (before && *before != e.stored.number && !truth().nearly_equal(*before, e.stored.number)) {
        throw False{Symptom::start,
                    say({"the depth stored for pixel {} is {}", "для пикселя {} хранится глубина {}"}, pixel(e.x, e.y),
                        e.stored.number),
                    say({"it was {} when last written", "при последней записи она была {}"}, *before)};
    }
    judge_comparison(e.z.number, e.stored.number, e.shown);
    if (!e.shown) return;
    judge_shown(e.x, e.y);
    own.z = e.z.number;
}

void ZBufferJudge::judge(const event::Span& e) {
    if (!polygon_ || !truth().has_inside(*polygon_)) return;
    for (const auto& [first, end] : e.runs) {
        for (int column = first; column < end; ++column) judge_shown(column, e.row);
    }
}

}  // namespace vidno::grading
