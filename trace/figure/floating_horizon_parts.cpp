#include "floating_horizon_parts.h"

#include <cmath>

#include "notation.h"
#include "table.h"

namespace vidno::figures {

namespace {

constexpr double legend_base = 3;  // of a line of the legend, from its top
constexpr Color upper_color{0x00, 0x72, 0xb2}, lower_color{0xd5, 0x5e, 0x00};

Stroke upper_stroke(const Style& style, double width = 1) {
    return {deep(upper_color, style.greyscale), width, {4, 1.5}};
}
Stroke lower_stroke(const Style& style, double width = 1) {
    return {deep(lower_color, style.greyscale), width, {1.5, 1.5}};
}

Point place_of(const vidno::Point<Value>& point, const Plane& plane) {
    return plane.at(number_of(point.x), number_of(point.y));
}

/// The parts of lines that lie in the visible part of the plane.
void add_lines(Drawing& to, const std::vector<Polyline>& lines, const Stroke& stroke, const Plane& plane) {
    Path path{{}, false, {}, stroke};
    for (const auto& line : lines) {
        for (auto& piece : clipped(line, false, plane.shown)) path.lines.push_back(std::move(piece));
    }
    to.add(std::move(path));
}

/// Neighbours that meet become one line.
std::vector<Polyline> joined(const DrawnLines& lines, const Plane& plane) {
    std::vector<Polyline> found;
    int curve = -1;
    for (const auto& line : lines) {
        const Point from = place_of(line.from.point, plane), to = place_of(line.to.point, plane);
        if (line.segment.curve != curve || !(found.back().back() == from)) found.push_back({from});
        found.back().push_back(to);
        curve = line.segment.curve;
    }
    return found;
}

/// The horizon as a line from column to column; over a single column, a point.
std::vector<Polyline> horizon_lines(const FloatingHorizonState::Heights& heights, const Plane& plane) {
    std::vector<Polyline> lines;
    bool goes_on = false;
    for (std::size_t i = 0; i < heights.size(); ++i) {
        if (heights[i]) {
            if (!goes_on) lines.emplace_back();
            lines.back().push_back(plane.at(plane.area.x + int(i), number_of(*heights[i])));
        }
        goes_on = heights[i].has_value();
    }
    return lines;
}

void add_dot(Drawing& to, Point at, double reach, const Plane& plane, const Color& color) {
    const Box box{at.x - reach, at.y - reach, 2 * reach, 2 * reach};
    if (plane.shown.holds(box)) to.add(rectangle(box, color));
}

/// The subject of the step.
struct LineMarks {
    Drawing& to;
    const Plane& plane;

    void operator()(const event::Height& e) const { dot(e.x, e.y); }
    void operator()(const event::Raise& e) const { dot(e.x, e.y); }
    void operator()(const event::Lower& e) const { dot(e.x, e.y); }
    void operator()(const event::Intersection& e) const {
        add_dot(to, plane.at(number_of(e.point.x), number_of(e.point.y)), 0.7, plane, ink);
    }
    void operator()(const event::DrawLine& e) const {
        const Point from = plane.at(number_of(e.from.x), number_of(e.from.y));
        const Point end = plane.at(number_of(e.to.x), number_of(e.to.y));
        add_lines(to, {{from, end}}, {ink, 2.5}, plane);
    }
    void operator()(const auto&) const {}

    void dot(int x, const Value& y) const { add_dot(to, plane.at(x, number_of(y)), 0.7, plane, ink); }
};

std::string flag_text(const std::string& x, const std::string& flag,
                      const std::optional<FloatingHorizonState::Looked>& looked) {
    if (!looked) return "";
    return x + " = " + integer_text(looked->first) + ", " + flag + " = " + integer_text(int(looked->second));
}

}  // namespace

Drawing drawn_lines(const DrawnLines& lines, const Area& area) {
    const Plane plane = plane_without_frame(area);
    Drawing drawing{plane.shown.width, plane.shown.height};
    add_lines(drawing, joined(lines, plane), {ink, 0.5}, plane);
    return drawing;
}

std::vector<Loss> cut_curves(const DrawnLines& lines, const Plane& plane) {
    const auto is_shown = [&](const LineEnd<Value>& end) {
        const double y = place_of(end.point, plane).y;
        return !std::isfinite(y) || (plane.shown.y <= y && y <= plane.shown.bottom());
    };
    std::vector<Loss> losses;
    int last = -1;
    for (const auto& line : lines) {
        if (line.segment.curve == last || (is_shown(line.from) && is_shown(line.to))) continue;
        last = line.segment.curve;
        losses.push_back({"its part above or below the area is cut off", "curve " + std::to_string(last)});
    }
    return losses;
}

void draw_lines(Drawing& to, const FloatingHorizonMoment& moment, const Plane& plane, double width) {
    add_lines(to, joined(moment.state().values().lines, plane), {ink, width}, plane);
}

void draw_horizons(Drawing& to, const FloatingHorizonMoment& moment, const Plane& plane, const Style& style,
                   double width) {
    add_lines(to, horizon_lines(moment.state().values().horizons.upper, plane), upper_stroke(style, width), plane);
    add_lines(to, horizon_lines(moment.state().values().horizons.lower, plane), lower_stroke(style, width), plane);
}

void draw_curve_at_hand(Drawing& to, const FloatingHorizonMoment& moment, const Plane& plane, const Style& style) {
    constexpr double dots_from = 1.5;  // millimetres between samples
    const FloatingHorizonState& state = moment.state();
    if (!state.values().curve) return;
    const Curve& curve = moment.scene().curves[std::size_t(*state.values().curve)];
    std::vector<Polyline> pieces;
    Polyline segment;
    for (const Piece& piece : pieces_of(curve)) {
        pieces.emplace_back();
        for (const auto& [x, y] : piece) {
            pieces.back().push_back(plane.at(x, y));
            const bool at_hand = state.values().place.segment && (x == state.values().place.segment->first ||
                                                                  x == state.values().place.segment->second);
            if (at_hand) segment.push_back(plane.at(x, y));
        }
    }
    add_lines(to, pieces, {faint, 0.5}, plane);
    const double width = plane.at(curve.samples.back().x, 0).x - plane.at(curve.samples.front().x, 0).x;
    if (width >= dots_from * double(curve.samples.size() - 1)) {
        for (const Polyline& piece : pieces) {
            for (const Point& at : piece) add_dot(to, at, 0.35, plane, faint);
        }
    }
    if (!segment.empty()) add_lines(to, {segment}, {deep(faint, style.greyscale), 1.5}, plane);
    if (const auto& looked =
            state.values().place.current ? state.values().place.current : state.values().place.previous) {
        const Box area = plane.box(whole_area(plane.area));
        const double x = plane.at(looked->first, 0).x;
        add_lines(to, {{{x, area.y}, {x, area.bottom()}}}, {faint, 0.25, {2, 2}}, plane);
    }
    if (moment.event()) moment.event()->visit(LineMarks{to, plane});
}

double add_horizon_names(Drawing& to, std::string_view upper, std::string_view lower, const Style& style) {
    constexpr double sample = 7, gap = 1.2, middle = legend_base - 0.9;
    double x = 0;
    for (const auto& [text, stroke] : {std::pair(upper, upper_stroke(style)), std::pair(lower, lower_stroke(style))}) {
        to.add(Path{{{{x, middle}, {x + sample, middle}}}, false, {}, stroke});
        x += sample + gap;
        to.add(Label{std::string(text), {x, legend_base}, small_size, Anchor::start, false, ink});
        x += width_of(text, small_size) * style.letters + 2 * gap;
    }
    return x;
}

Drawing curve_legend(const FloatingHorizonMoment& moment, const Style& style, double width) {
    Drawing drawing{width, legend_height};
    const double x = add_horizon_names(drawing, "upper", "lower", style);
    const std::string before = flag_text("x", "Pflag", moment.state().values().place.previous);
    const std::string now = flag_text("x′", "Tflag", moment.state().values().place.current);
    const std::string text = before + (now.empty() ? "" : "; ") + now;
    if (x + width_of(text, small_size) * style.letters <= width) {
        drawing.add(Label{text, {width, legend_base}, small_size, Anchor::end, false, ink});
    }
    return drawing;
}

}  // namespace vidno::figures
