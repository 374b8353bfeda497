#include "grade/z_buffer_judge.h"

#include <algorithm>
#include <cmath>

namespace vidno::grading {

using vidno::in_words;

void ZBufferJudge::judge(const event::Clear& e) {
    judge_start(e.z.number, "the depths of the Z-buffer start");
    cells_.clear();
    cleared_ = e.z.number;
}

void ZBufferJudge::judge(const event::Polygon& e) {
    finish_polygon();
    if (polygon_ && *polygon_ > e.polygon.index) note(Difference::order_of_polygons);
    polygon_ = e.polygon.index;
}

/// What is nearer than all before it must show where it is.
void ZBufferJudge::finish_polygon() {
    if (!polygon_ || !truth().has_inside(*polygon_)) return;
    const Area& area = scene().area;
    for (int row = area.y; row < area.bottom(); ++row) {
        for (int column = area.x; column < area.right(); ++column) {
            const double x = column + 0.5, y = row + 0.5;
            const auto found = cells_.find({column, row});
            const int shown = found == cells_.end() ? SeenPixel::background : found->second.polygon;
            if (shown == *polygon_ || truth().place(*polygon_, x, y) != SceneTruth::Place::inside) continue;
            if (shown != SeenPixel::background && truth().nearer(*polygon_, shown, x, y) <= 0) continue;
            const std::string there = shown == SeenPixel::background ? "nothing" : id(shown);
            throw False{Symptom::not_painted,
                        id(*polygon_) + " is done, and " + pixel_in_words(column, row) + " shows " + there +
                            " of what came so far",
                        "its centre is inside " + id(*polygon_) +
                            (shown == SeenPixel::background ? "" : ", which is nearer there than " + id(shown)),
                        last_step_};
        }
    }
}

void ZBufferJudge::finish() {
    finish_polygon();
    const Area& area = scene().area;
    for (int row = area.y; row < area.bottom(); ++row) {
        for (int column = area.x; column < area.right(); ++column) {
            judge_pixel(column, row, state().picture().at(column, row));
        }
    }
}

void ZBufferJudge::judge(const event::Depth& e) const {
    judge_depth(e.polygon.index, e.point.x.number, e.point.y.number, e.z.number);
}

void ZBufferJudge::judge(const event::Edge& e) const {
    if (!polygon_) return;
    const auto& vertices = scene().polygons[std::size_t(*polygon_)].vertices;
    const auto is = [&](const ValueVertex& told, std::size_t i) {
        const auto& v = vertices[i % vertices.size()];
        return truth().same_coordinate(told.x.number, v.x) && truth().same_coordinate(told.y.number, v.y);
    };
    const auto i = std::size_t(e.edge);
    if (i < vertices.size() && ((is(e.from, i) && is(e.to, i + 1)) || (is(e.from, i + 1) && is(e.to, i)))) return;
    throw False{Symptom::edge,
                "edge " + std::to_string(e.edge) + " of " + id(*polygon_) + " goes from " +
                    point_in_words(e.from.x.number, e.from.y.number) + " to " +
                    point_in_words(e.to.x.number, e.to.y.number),
                "that is not from its vertex " + std::to_string(e.edge) + " to the next"};
}

void ZBufferJudge::judge_entry(int edge, double y, double x, double z) const {
    if (!polygon_ || !truth().has_inside(*polygon_)) return;
    const auto right = truth().crossing(*polygon_, edge, y);
    if (!right || (truth().same_coordinate(x, right->x) && truth().nearly_equal(z, right->z))) return;
    throw False{
        Symptom::edge,
        "edge " + std::to_string(edge) + " of " + id(*polygon_) + " is at x = " + in_words(x) + ", z = " + in_words(z),
        "at y = " + in_words(y) + " it is at x = " + in_words(right->x) + ", z = " + in_words(right->z)};
}

void ZBufferJudge::judge(const event::AelAdd& e) const {
    if (state().y()) judge_entry(e.edge, height(), e.x.number, e.z.number);
}

void ZBufferJudge::judge(const event::AelStep& e) const {
    if (state().y()) judge_entry(e.edge, height() + 1, e.x.number, e.z.number);
}

void ZBufferJudge::judge(const event::AelSort& e) const {
    double last = -std::numeric_limits<double>::infinity();
    for (const int edge : e.edges) {
        const auto& ael = state().ael();
        const auto entry = std::find_if(ael.begin(), ael.end(), [&](const auto& each) { return each.edge == edge; });
        if (entry == ael.end()) continue;
        const double x = entry->x.number;
        if (x < last && !truth().same_coordinate(x, last)) {
            throw False{Symptom::edge, "AEL is in order",
                        "edge " + std::to_string(edge) + " is at x = " + in_words(x) +
                            ", to the left of the one before, at " + in_words(last)};
        }
        last = x;
    }
}

/// An edge may go when its last row is done, and not before.
void ZBufferJudge::judge(const event::AelDrop& e) const {
    if (!polygon_ || !state().row() || *state().row() + 1 >= scene().area.bottom()) return;
    const auto& vertices = scene().polygons[std::size_t(*polygon_)].vertices;
    for (const int edge : e.edges) {
        const double lower =
            std::max(vertices[std::size_t(edge)].y, vertices[std::size_t(edge + 1) % vertices.size()].y);
        const double next = *state().row() + 1.5;
        if (lower <= next || truth().same_coordinate(lower, next)) continue;
        throw False{Symptom::edge,
                    "edge " + std::to_string(edge) + " of " + id(*polygon_) + " leaves AEL after row " +
                        std::to_string(*state().row()),
                    "it goes down to y = " + in_words(lower) + ", beyond the centre of the next row"};
    }
}

void ZBufferJudge::judge(const event::ShownLine& e) const {
    if (!polygon_ || !truth().has_inside(*polygon_)) return;
    const double y = state().y() && state().row() == e.row ? height() : e.row + 0.5;
    const auto right = truth().ends(*polygon_, y);
    const std::string told = "on row " + std::to_string(e.row) + " " + id(*polygon_) +
                             " goes from x = " + in_words(e.from.x.number) + " to " + in_words(e.to.x.number);
    if (!right) throw False{Symptom::edge, told, "it does not meet that row's line, y = " + in_words(y)};
    const auto& [left, end] = std::minmax(e.from.x.number, e.to.x.number);
    if (truth().same_coordinate(left, right->first.x) && truth().same_coordinate(end, right->second.x)) return;
    throw False{Symptom::edge, told, "it goes from " + in_words(right->first.x) + " to " + in_words(right->second.x)};
}

void ZBufferJudge::judge_covered(int column, int row) const {
    const bool in_area = scene().area.contains(column, row);
    if (!polygon_ || (in_area && truth().place(*polygon_, column + 0.5, row + 0.5) != SceneTruth::Place::outside))
        return;
    throw False{Symptom::off_polygon, id(*polygon_) + " is drawn at " + pixel_in_words(column, row),
                in_area ? "its centre lies outside of " + id(*polygon_) : "that is not in the area"};
}

/// The current polygon takes a pixel: nothing nearer may be there.
void ZBufferJudge::judge_shown(int column, int row) {
    judge_covered(column, row);
    Cell& own = cell(column, row);
    const double x = column + 0.5, y = row + 0.5;
    if (own.polygon != SeenPixel::background && own.polygon != *polygon_ &&
        truth().nearer(own.polygon, *polygon_, x, y) > 0) {
        throw False{Symptom::comparison, id(*polygon_) + " takes " + pixel_in_words(column, row),
                    "the depth of " + id(own.polygon) + ", which is there, is " +
                        in_words(truth().depth(own.polygon, x, y)) + ", and that of " + id(*polygon_) + " is " +
                        in_words(truth().depth(*polygon_, x, y))};
    }
    own.polygon = *polygon_;
}

void ZBufferJudge::judge(const event::Pixel& e) {
    if (!polygon_ || !truth().has_inside(*polygon_)) return;
    judge_covered(e.x, e.y);
    judge_depth(*polygon_, e.x + 0.5, e.y + 0.5, e.z.number);
    Cell& own = cell(e.x, e.y);
    const auto before = own.z ? own.z : cleared_;
    if (!before) judge_start(e.stored.number, "the depths of the Z-buffer, never cleared, are");
    if (before && *before != e.stored.number && !truth().nearly_equal(*before, e.stored.number)) {
        throw False{Symptom::start,
                    "the depth stored for " + pixel_in_words(e.x, e.y) + " is " + in_words(e.stored.number),
                    "it was " + in_words(*before) + " when it was written last"};
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
