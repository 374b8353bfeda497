#include <cmath>

#include "containment_part.h"
#include "marker.h"

namespace vidno::figures {

namespace {

/// The subject of the step.
class Marks : Marker {
public:
    Marks(Drawing& to, const Moment& moment, const Plane& plane, const Style& style)
        : Marker(to, plane, style), moment_(moment) {}

    void state() {
        if (const auto& clip = moment_.state().warnock().clip()) {
            outline(clip->vertices, true, Stroke{ink, 0.8, {3, 1.5}});
            outline(clip->next, false);
            for (const auto& vertex : clip->next) point(vertex.x, vertex.y, true);
        }
        const auto& y = moment_.state().z_buffer().last().y;
        for (const auto& entry : moment_.state().z_buffer().active_edges()) {
            if (y) point(at(entry.x, *y), true, ink);
        }
    }

    void lists() {
        for (const auto& [x, y] : moment_.entering()) point(x, y, true);
        for (const auto& [x, y] : moment_.leaving()) point(x, y, false);
    }

    void operator()(const event::Push& e) { box(plane().box(e.window), {2, 1.5}); }
    void operator()(const event::Skip& e) { box(plane().box(e.window), {0.5, 1.5}); }
    void operator()(const event::Fill& e) { pixels(e.rect); }
    void operator()(const event::Draw& e) {
        for (const auto& [row, first, end] : e.runs) pixels({first, row, end - first, 1});
    }
    void operator()(const event::Span& e) {
        for (const auto& [first, end] : e.runs) pixels({first, e.row, end - first, 1});
    }
    void operator()(const event::Pixel& e) { pixels({e.x, e.y, 1, 1}, e.shown ? solid : dashed); }
    void operator()(const event::Depth& e) { point(e.point.x, e.point.y, true); }
    void operator()(const event::PointColor& e) { point(e.point.x, e.point.y, true); }
    void operator()(const event::Surround& e) { point(e.point.x, e.point.y, e.inside); }
    void operator()(const event::Orient& e) {
        edge(moment_.scene().polygons[std::size_t(e.polygon.index)], e.edge);
        point(e.point.x, e.point.y, true);
    }
    void operator()(const event::Compare& e) {
        if (e.corner) corner(*e.corner, e.nearer);
    }
    void operator()(const event::Nearer& e) {
        for (const Corner each : e.corners) corner(each, true);
    }
    void operator()(const event::ClipSide& e) { line({at(e.from.x, e.from.y), at(e.to.x, e.to.y)}, false); }
    void operator()(const event::ClipSign& e) { point(e.vertex.x, e.vertex.y, e.sign != Sign::positive); }
    void operator()(const event::ClipCross& e) { point(e.vertex.x, e.vertex.y, true); }
    void operator()(const event::ClipKeep& e) { point(e.vertex.x, e.vertex.y, true); }
    void operator()(const event::ClipDrop& e) { point(e.vertex.x, e.vertex.y, false); }
    void operator()(const event::ClipResult& e) { outline(e.vertices, true); }
    void operator()(const event::Row& e) {
        on_row(e.row, e.left, e.right);
        pixels({e.first, e.row, e.end - e.first, 1}, dashed);
    }
    void operator()(const event::ShownLine& e) { on_row(e.row, e.from.x, e.to.x); }
    void operator()(const event::Columns& e) {
        pixels({e.first, moment_.state().z_buffer().last().row.value_or(0), e.end - e.first, 1}, dashed);
    }
    void operator()(const event::Edge& e) { line({at(e.from.x, e.from.y), at(e.to.x, e.to.y)}, false); }
    void operator()(const event::Horizontal& e) { current_edge(e.edge); }
    void operator()(const event::AelAdd& e) { current_edge(e.edge); }
    void operator()(const event::AelStep& e) { current_edge(e.edge); }
    void operator()(const event::CutToArea& e) { region(e.region); }
    void operator()(const event::PushList& e) {
        for (const auto& piece : e.pieces) region(piece.region, dashed);
    }
    void operator()(const event::Clipped& e) {
        region(e.outside, dashed);
        region(e.inside);
    }
    void operator()(const event::Show& e) { region(e.region); }
    void operator()(const event::Pierce& e) { through(e.point, e.normal); }
    void operator()(const event::Split& e) {
        region(e.region);
        region(e.other);
    }
    void operator()(const event::EdgePiece& e) {
        const bool inside = e.lies == Lies::inside || e.lies == Lies::same_side;
        line({at(e.from.x, e.from.y), at(e.to.x, e.to.y)}, false, inside ? solid : dashed);
    }
    void operator()(const event::Behind& e) { point(e.point.x, e.point.y, !e.behind); }
    void operator()(const event::Order& e) { point(e.point.x, e.point.y, true); }
    void operator()(const event::Paint& e) {
        for (const auto& [row, first, end] : e.runs) pixels({first, row, end - first, 1});
    }
    void operator()(const auto&) {}

private:
    void outline(const std::vector<ValueVertex>& vertices, bool closed, const auto&... stroke) {
        Polyline points;
        for (const auto& vertex : vertices) points.push_back(at(vertex.x, vertex.y));
        line(points, closed, stroke...);
    }
    /// Draws the line through a place, cut to the visible part of the plane.
    void through(const ValuePoint& place, const ValuePoint& normal) {
        const double a = number_of(normal.x), b = number_of(normal.y), length = std::hypot(a, b);
        const Point on = at(place.x, place.y);
        const double far = 2 * (std::hypot(on.x, on.y) + plane().shown.right() + plane().shown.bottom());
        const Point along{far * b / length, -far * a / length};
        line({on + Point{-along.x, -along.y}, on + along}, false);
    }
    void on_row(int row, const Value& left, const Value& right) {
        line({at(left, row + 0.5), at(right, row + 0.5)}, false);
    }
    void current_edge(int number) {
        const auto polygon = moment_.state().z_buffer().polygon();
        if (polygon) edge(moment_.scene().polygons[std::size_t(polygon->index)], number);
    }
    void corner(Corner corner, bool yes) {
        const auto& current = moment_.state().warnock().current();
        if (!current) return;
        const Window& window = current->window;
        const bool right = corner == Corner::right_bottom || corner == Corner::right_top;
        const bool lower = corner == Corner::left_top || corner == Corner::right_top;
        point(right ? window.right() : window.x, lower ? window.bottom() : window.y, yes);
    }

    const Moment& moment_;
};

}  // namespace

void draw_marks(Drawing& to, const Moment& moment, const Plane& plane, const Style& style) {
    Marks marks(to, moment, plane, style);
    marks.state();
    draw_containment(to, moment, plane, style);
    if (moment.event()) moment.event()->visit(marks);
    marks.lists();
}

}  // namespace vidno::figures
