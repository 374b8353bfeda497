#include "containment_part.h"

#include "marker.h"

namespace vidno::figures {

namespace {

constexpr double beside = 2.2, around = 4.5;  // millimetres: from a point, and from a window, to the numbers there

class Containment : Marker {
public:
    Containment(Drawing& to, const Moment& moment, const Window& window, const Plane& plane, const Style& style)
        : Marker(to, plane, style), moment_(moment), window_(window) {}

    void rays() {
        const auto& rays = moment_.rays();
        if (rays.empty()) return;
        const Point start = plane().at(window_.x + window_.width / 2, window_.y + window_.height / 2);
        line({start, {plane().shown.right(), start.y}}, false);
        edge(polygon_of(rays.back()), rays.back().edge);
        point(start, true, ink);
        for (const auto& ray : rays) crossing(ray, start.y);
    }

    void octants() {
        const auto& turns = moment_.octants();
        if (turns.empty()) return;
        sides();
        edge(polygon_of(turns.back()), turns.back().edge);
        for (const auto& turn : turns) {
            const auto [a, b] = ends_of(polygon_of(turn), turn.edge);
            const std::string sign = turn.difference > 0 ? "+" : "";
            note(plane().at((a.x + b.x) / 2, (a.y + b.y) / 2), sign + integer_text(turn.difference));
        }
    }

private:
    const ScenePolygon& polygon_of(const auto& event) const {
        return moment_.scene().polygons[std::size_t(event.polygon.index)];
    }

    /// The place where an edge, or at CR3 its first vertex, meets the line of the ray. If that is off the drawing, its
    /// number stands at the side.
    void crossing(const event::Ray& ray, double row) {
        const auto [a, b] = ends_of(polygon_of(ray), ray.edge);
        const Point from = plane().at(a.x, a.y), to = plane().at(b.x, b.y);
        const double way = ray.at == Line::CR3 ? 0 : (row - from.y) / (to.y - from.y);
        const double x = from.x + way * (to.x - from.x);
        const Box& shown = plane().shown;
        point(Point{x, row}, ray.counts > 0, ink);
        note({std::clamp(x, shown.x + beside, shown.right() - beside), row - beside}, integer_text(ray.counts));
    }

    /// The lines of the window's sides divide the plane into octants, clockwise from 0 at the upper left.
    void sides() {
        const Box& shown = plane().shown;
        const Box box = plane().box(window_);
        for (const double x : {box.x, box.right()}) fine_line({{x, shown.y}, {x, shown.bottom()}});
        for (const double y : {box.y, box.bottom()}) fine_line({{shown.x, y}, {shown.right(), y}});
        const double left = box.x - around, middle = box.x + box.width / 2, right = box.right() + around;
        const double above = box.y - around, level = box.y + box.height / 2, below = box.bottom() + around;
        const Polyline places{{left, above},  {middle, above}, {right, above}, {right, level},
                              {right, below}, {middle, below}, {left, below},  {left, level}};
        for (std::size_t octant = 0; octant < places.size(); ++octant) note(places[octant], integer_text(int(octant)));
    }

    const Moment& moment_;
    const Window& window_;
};

}  // namespace

void draw_containment(Drawing& to, const Moment& moment, const Plane& plane, const Style& style) {
    const auto& current = moment.state().warnock().current();
    if (!current) return;
    Containment containment(to, moment, current->window, plane, style);
    containment.rays();
    containment.octants();
}

}  // namespace vidno::figures
