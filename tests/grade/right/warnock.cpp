// Warnock's algorithm, right: it reports every step. mutants.py makes mutants of this program.
#include "example.h"

using namespace vidno::student;

const double farthest = -2;  // behind all visible depths

struct Point {
    double x, y;
};

struct Plane {
    double a, b, c, d;
};

struct Box {
    double xmin, ymin, xmax, ymax;
};

struct Active {
    int polygon;
    bool surrounds;
};

/// A square window and the polygons that may show in it.
struct Window {
    double x, y, size;
    std::vector<Active> polygons;  // APL
};

/// The result of ProcessWindow.
struct Summary {
    int count = 0;
    bool has_surround = false, insider = false;
    Color color{0, 0, 0};
};

int sign(double value) { return (value > 0) - (value < 0); }

/// (a - o) x (b - o)
double cross(Point o, Point a, Point b) { return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x); }

/// Uses Newell's sum about the first vertex, because the first three vertices may lie on a line.
Plane plane_of(const std::vector<Vertex>& vertices) {
    const Vertex& o = vertices[0];
    Plane plane{0, 0, 0, 0};
    for (std::size_t i = 2; i < vertices.size(); ++i) {
        const Vertex &p = vertices[i - 1], &q = vertices[i];
        const Vertex u{p.x - o.x, p.y - o.y, p.z - o.z}, v{q.x - o.x, q.y - o.y, q.z - o.z};
        plane.a += u.y * v.z - u.z * v.y;
        plane.b += u.z * v.x - u.x * v.z;
        plane.c += u.x * v.y - u.y * v.x;
    }
    plane.d = -(plane.a * o.x + plane.b * o.y + plane.c * o.z);
    return plane;
}

Box box_of(const std::vector<Vertex>& vertices) {
    Box box{vertices[0].x, vertices[0].y, vertices[0].x, vertices[0].y};
    for (const Vertex& v : vertices) {
        box = {std::min(box.xmin, v.x), std::min(box.ymin, v.y), std::max(box.xmax, v.x), std::max(box.ymax, v.y)};
    }
    return box;
}

/// The first row or column whose centre is at v or greater.
int first_centre(double v) { return int(std::ceil(v - 0.5)); }

class Warnock {
public:
    Warnock(const Scene& scene, WarnockTrace& trace) : scene_(scene), trace_(trace) {
        Window whole{double(scene.area.x), double(scene.area.y), 1, {}};
        while (whole.size < scene.area.width || whole.size < scene.area.height) whole.size *= 2;
        for (int i = 0; i < int(scene.polygons.size()); ++i) {
            const Plane plane = plane_of(vertices_of(i));
            planes_.push_back(plane);
            trace.plane(i, plane.a, plane.b, plane.c, plane.d);
            const bool is_edge_on = plane.c == 0;
            if (!is_edge_on) whole.polygons.push_back({i, false});
        }
        push(whole);
        while (!windows_.empty()) {
            Window window = windows_.back();
            windows_.pop_back();
            trace.pop(window.x, window.y, window.size, window.size);
            show(window);
        }
    }

private:
    const std::vector<Vertex>& vertices_of(int polygon) const { return scene_.polygons[std::size_t(polygon)].vertices; }
    Color color_of(int polygon) const { return scene_.polygons[std::size_t(polygon)].color; }

    void push(const Window& window) {
        const Area& area = scene_.area;
        if (window.x >= area.x + area.width || window.y >= area.y + area.height) {
            trace_.skip(window.x, window.y, window.size, window.size);
            return;
        }
        windows_.push_back(window);
        trace_.push(window.x, window.y, window.size, window.size);
    }

    void show(Window& window) {
        const Summary found = process_window(window);
        if (found.count == 0) {
            trace_.decide(Case::empty);
            fill(window, scene_.background);
        } else if (found.has_surround) {
            trace_.decide(Case::surrounded);
            fill(window, found.color);
        } else if (window.size <= 1) {
            trace_.decide(Case::pixel);
            fill(window, point_color({window.x + window.size / 2, window.y + window.size / 2}, window.polygons));
        } else if (found.count == 1) {
            trace_.decide(Case::single);
            fill(window, scene_.background);
            const int polygon = window.polygons.front().polygon;
            fill_polygon(polygon, found.insider ? vertices_of(polygon) : polygon_clip(polygon, window));
        } else {
            trace_.decide(Case::split);
            const double half = window.size / 2;
            for (const double x : {window.x, window.x + half}) {
                for (const double y : {window.y, window.y + half}) push({x, y, half, window.polygons});
            }
        }
    }

    Summary process_window(Window& window) {
        const double right = window.x + window.size, bottom = window.y + window.size;
        const Point corners[4] = {{window.x, window.y}, {window.x, bottom}, {right, window.y}, {right, bottom}};
        double nearest[4] = {farthest, farthest, farthest, farthest};
        trace_.corners(farthest);
        Summary found;
        std::vector<Active> kept;
        for (Active active : window.polygons) {
            const int polygon = active.polygon;
            const Box box = box_of(vertices_of(polygon));
            const bool outside = box.xmax < window.x || box.xmin > right || box.ymax < window.y || box.ymin > bottom;
            trace_.box(polygon, box.xmin, box.ymin, box.xmax, box.ymax, outside);
            if (!active.surrounds && outside) {
                trace_.discard(polygon);
                continue;
            }
            trace_.count(polygon, ++found.count);

            double z[4];
            for (int i = 0; i < 4; ++i) z[i] = depth(polygon, corners[i]);
            int k = 0;
            for (int i = 0; i < 4; ++i) {
                const bool nearer = z[i] > nearest[i];
                trace_.compare(polygon, Corner(i), z[i], nearest[i], nearer);
                if (!nearer) continue;
                nearest[i] = z[i];
                ++k;
            }
            trace_.nearer(polygon);
            if (k > 0) {
                found.has_surround = false;
                trace_.uncover(polygon);
            }

            const auto holds = [&](Point corner) { return surround_test(polygon, corner); };
            if (!active.surrounds && std::all_of(corners, corners + 4, holds)) {
                active.surrounds = true;
                trace_.mark(polygon);
            }
            if (active.surrounds && k == 4) {
                found.has_surround = true;
                found.color = color_of(polygon);
                trace_.cover(polygon);
            } else if (found.count == 1) {
                found.insider = box.xmin > window.x && box.xmax < right && box.ymin > window.y && box.ymax < bottom;
                trace_.insider(polygon, found.insider);
            }
            kept.push_back(active);
        }
        window.polygons = kept;
        trace_.summary(found.count, found.has_surround, found.color, found.insider);
        return found;
    }

    Color point_color(Point point, const std::vector<Active>& polygons) {
        Color color = scene_.background;
        double nearest = farthest;
        for (const Active& active : polygons) {
            if (!surround_test(active.polygon, point)) continue;
            const double z = depth(active.polygon, point);
            trace_.compare(active.polygon, z, nearest, z > nearest);
            if (z <= nearest) continue;
            nearest = z;
            color = color_of(active.polygon);
            trace_.nearest(active.polygon, z);
        }
        trace_.color(point.x, point.y, color);
        return color;
    }

    double depth(int polygon, Point point) {
        const Plane& plane = planes_[std::size_t(polygon)];
        const double z = -(plane.a * point.x + plane.b * point.y + plane.d) / plane.c;
        trace_.depth(polygon, point.x, point.y, z);
        return z;
    }

    bool surround_test(int polygon, Point point) {
        const std::vector<Vertex>& vertices = vertices_of(polygon);
        int first_sign = 0;
        bool inside = true;
        for (std::size_t i = 0; i < vertices.size() && inside; ++i) {
            const Vertex &from = vertices[i], &to = vertices[(i + 1) % vertices.size()];
            const double value = cross({from.x, from.y}, {to.x, to.y}, point);
            trace_.orient(polygon, int(i), point.x, point.y, value, sign(value));
            if (first_sign == 0) first_sign = sign(value);
            inside = sign(value) == 0 || sign(value) == first_sign;
        }
        inside = inside && first_sign != 0;
        trace_.surround(polygon, point.x, point.y, inside);
        return inside;
    }

    std::vector<Vertex> polygon_clip(int polygon, const Window& window) {
        const double right = window.x + window.size, bottom = window.y + window.size;
        const Point corners[4] = {{window.x, window.y}, {window.x, bottom}, {right, bottom}, {right, window.y}};
        std::vector<Vertex> vertices = vertices_of(polygon);
        trace_.clip_begin(polygon);
        for (int side = 0; side < 4 && !vertices.empty(); ++side) {
            const Point corner = corners[side], before = corners[(side + 3) % 4];
            trace_.clip_side(side + 1, before.x, before.y, corner.x, corner.y);
            const auto outward = [&](const Vertex& v) {
                const double value = cross(corner, {v.x, v.y}, before);
                trace_.clip_sign(v, value, sign(value));
                return value;
            };
            std::vector<Vertex> clipped;
            Vertex p = vertices.back();
            double p_outward = outward(p);
            for (const Vertex& q : vertices) {
                const double q_outward = outward(q);
                if (sign(p_outward) * sign(q_outward) < 0) {
                    const double t = p_outward / (p_outward - q_outward);
                    clipped.push_back({p.x + (q.x - p.x) * t, p.y + (q.y - p.y) * t, p.z + (q.z - p.z) * t});
                    trace_.clip_cross(clipped.back());
                }
                if (q_outward <= 0) {
                    clipped.push_back(q);
                    trace_.clip_keep(q);
                } else {
                    trace_.clip_drop(q);
                }
                p = q;
                p_outward = q_outward;
            }
            vertices = clipped;
            trace_.clip_list();
        }
        trace_.clip_result(polygon, vertices);
        return vertices;
    }

    void fill_polygon(int polygon, const std::vector<Vertex>& vertices) {
        const Area& area = scene_.area;
        for (int row = area.y; row < area.y + area.height && !vertices.empty(); ++row) {
            const double y = row + 0.5;
            double left = INFINITY, right = -INFINITY;
            for (std::size_t i = 0; i < vertices.size(); ++i) {
                const Vertex &p = vertices[i], &q = vertices[(i + 1) % vertices.size()];
                if ((p.y <= y) == (q.y <= y)) continue;
                const double x = p.x + (y - p.y) * (q.x - p.x) / (q.y - p.y);
                left = std::min(left, x);
                right = std::max(right, x);
            }
            const int end = std::min(first_centre(right), area.x + area.width);
            if (left < right) trace_.row(row, left, right, first_centre(left), end);
        }
        trace_.draw(polygon);
    }

    void fill(const Window& window, Color color) {
        const Area& area = scene_.area;
        const int x = int(window.x), y = int(window.y), size = int(window.size);
        trace_.fill(x, y, std::min(size, area.x + area.width - x), std::min(size, area.y + area.height - y), color);
    }

    const Scene& scene_;
    WarnockTrace& trace_;
    std::vector<Plane> planes_;
    std::vector<Window> windows_;  // AW
};

int main(int count, char** words) {
    const Scene scene = scene_to_draw(example_scene());
    WarnockTrace trace("warnock.jsonl", scene, detail_from(count, words));
    Warnock(scene, trace);
}
