// Many programs in one: its name says what it does, as words with hyphens between them. The first is the method;
// `styles.cmake` lists the others. A style is another way to be right; a lie or a mistake makes the program wrong.
#include <functional>

#include "course.h"

std::string words_of_name;

/// Whether the name has the word.
bool is(const std::string& word) { return ("-" + words_of_name + "-").find("-" + word + "-") != std::string::npos; }

Precision precision() {
    return is("float") || is("single") ? Precision::single_precision : Precision::double_precision;
}

using Outline = std::vector<Vertex>;

/// The depth at a point, computed in the type Number.
template <class Number>
Number depth_in(const Polygon& polygon, Number x, Number y) {
    const Vertex& o = polygon.vertices[0];
    Number a = 0, b = 0, c = 0;
    for (std::size_t i = 2; i < polygon.vertices.size(); ++i) {
        const Vertex &p = polygon.vertices[i - 1], &q = polygon.vertices[i];
        const Number u[] = {Number(p.x) - Number(o.x), Number(p.y) - Number(o.y), Number(p.z) - Number(o.z)};
        const Number v[] = {Number(q.x) - Number(o.x), Number(q.y) - Number(o.y), Number(q.z) - Number(o.z)};
        a += u[1] * v[2] - u[2] * v[1];
        b += u[2] * v[0] - u[0] * v[2];
        c += u[0] * v[1] - u[1] * v[0];
    }
    return Number(o.z) - (a * (x - Number(o.x)) + b * (y - Number(o.y))) / c;
}

double reported_depth(const Polygon& polygon, double x, double y) {
    if (is("float")) return double(depth_in<float>(polygon, float(x), float(y)));
    if (is("longdouble")) return double(depth_in<long double>(polygon, x, y));
    return depth_in<double>(polygon, x, y);
}

/// On which side of an edge a point lies: in whole numbers of 1/1024, or in doubles.
double side_of(const Vertex& p, const Vertex& q, double x, double y) {
    if (!is("integer")) return (q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x);
    const auto whole = [](double v) { return std::llround(v * 1024); };
    return double((whole(q.x) - whole(p.x)) * (whole(y) - whole(p.y)) -
                  (whole(q.y) - whole(p.y)) * (whole(x) - whole(p.x)));
}

/// Whether an outline contains a point: all of its points, those of its left and upper sides, or none on it.
bool contains(const Outline& outline, double x, double y) {
    double turn = 0;
    for (std::size_t i = 2; i < outline.size(); ++i)
        turn += side_of(outline[0], outline[i - 1], outline[i].x, outline[i].y);
    if (turn == 0) return false;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vertex &a = outline[i], &b = outline[(i + 1) % outline.size()];
        const Vertex &p = turn > 0 ? a : b, &q = turn > 0 ? b : a;
        if (p.x == q.x && p.y == q.y) continue;
        const double side = side_of(p, q, x, y);
        const bool keeps = is("halfopen") ? q.y < p.y || (q.y == p.y && q.x > p.x) : true;
        if (side < 0 || (side == 0 && !keeps)) return false;
    }
    return true;
}

/// The polygon as it is, as a fan of triangles, or cut in halves again and again.
std::vector<Outline> parts_of(const Outline& outline) {
    std::vector<Outline> parts;
    const std::size_t n = outline.size();
    if (is("fan") && n > 3) {
        for (std::size_t i = 2; i < n; ++i) parts.push_back({outline[0], outline[i - 1], outline[i]});
        if (is("triangle_lost")) parts.pop_back();
    } else if (is("halves") && n > 3) {
        const auto middle = std::ptrdiff_t(n / 2);
        Outline second(outline.begin() + middle, outline.end());
        second.push_back(outline[0]);
        for (const Outline& half : {Outline(outline.begin(), outline.begin() + middle + 1), second}) {
            for (const Outline& part : parts_of(half)) parts.push_back(part);
        }
    } else {
        parts.push_back(outline);
    }
    return parts;
}

class ZBuffer {
public:
    explicit ZBuffer(const Scene& scene)
        : scene_(scene), area_(scene.area), trace_("styles.jsonl", scene, Detail::signs, precision()) {
        const double start = is("starts_late") ? -0.5 : -1.5;
        depths_.assign(std::size_t(area_.width * area_.height), start);
        trace_.clear(start);
        const int count = int(scene.polygons.size());
        const auto for_polygons = [&](const std::function<void(int)>& draw) {
            for (int k = 0; k < count; ++k) {
                const int i = is("backwards") ? count - 1 - k : k;
                if (!is_edge_on(scene.polygons[std::size_t(i)])) draw(i);
            }
        };
        const auto for_rows = [&](const std::function<void(int)>& draw) {
            for (int k = 0; k < area_.height - int(is("row_lost")); ++k)
                draw(area_.y + (is("upward") ? area_.height - 1 - k : k));
        };
        if (is("rows")) {
            for_rows([&](int row) { for_polygons([&](int i) { draw_row(i, row); }); });
        } else {
            for_polygons([&](int i) {
                if (is("once_each")) trace_.polygon(i);
                for_rows([&](int row) { draw_row(i, row); });
            });
        }
    }

private:
    void draw_row(int i, int row) {
        const Polygon& polygon = scene_.polygons[std::size_t(i)];
        for (const Outline& part : parts_of(polygon.vertices)) {
            if (!is("once_each")) trace_.polygon(i);
            double left = 0, right = 0;
            const double y = row + 0.5;
            const bool meets = ends_on(part, y, left, right) && right > area_.x && left < area_.x + area_.width;
            if (meets && is("lines")) {
                trace_.scanline(y, row);
                if (is("cut")) {
                    left = std::max(left, double(area_.x));
                    right = std::min(right, double(area_.x + area_.width));
                }
                const double off = is("lie_line") ? 0.0625 : 0;
                trace_.line(row, left, reported_depth(polygon, left, y), right + off,
                            reported_depth(polygon, right + off, y));
            }
            for (int k = 0; k < area_.width - int(is("column_lost")); ++k)
                draw_pixel(i, part, area_.x + (is("leftward") ? area_.width - 1 - k : k), row);
            trace_.span();
        }
    }

    void draw_pixel(int i, const Outline& part, int x, int row) {
        const Polygon& polygon = scene_.polygons[std::size_t(i)];
        const double at = is("corners") ? 0 : 0.5;
        if (!contains(part, x + at, row + at)) return;
        double z = reported_depth(polygon, x + at, row + at);
        if (is("bias")) z += 4e-3 * i;
        if (is("bias") && is("float")) z = double(float(z));
        if (is("small_bias")) z += std::ldexp(1.0, -24);
        if (is("rounded")) z = std::round(z * 256) / 256;
        double& stored = depths_[std::size_t((row - area_.y) * area_.width + x - area_.x)];
        const bool shown = is("painter") ? true : is("farthest") ? z < stored : z > stored + (is("epsilon") ? 1e-3 : 0);
        if (is("lie_stored")) return tell(x, row, z, stored - 0.5, shown, stored);
        tell(x, row, z + (is("lie_depth") ? 1e-4 : 0), stored, shown, stored);
        if (shown) stored = z;
    }
    void tell(int x, int row, double z, double reported_stored, bool shown, double& stored) {
        trace_.pixel(x, row, z, reported_stored, shown);
        if (shown) stored = z;
    }

    const Scene& scene_;
    Area area_;
    ZBufferTrace trace_;
    std::vector<double> depths_;
};

struct Square {
    double x, y, size;
    std::vector<int> list;
};

class Warnock {
public:
    explicit Warnock(const Scene& scene)
        : scene_(scene), area_(scene.area), trace_("styles.jsonl", scene, Detail::signs, precision()) {
        Square whole{double(area_.x), double(area_.y), covering_side(area_), {}};
        for (int i = 0; i < int(scene.polygons.size()); ++i) {
            if (!is_edge_on(at(i))) whole.list.push_back(i);
        }
        trace_.push(whole.x, whole.y, whole.size, whole.size);
        show(whole);
    }

private:
    const Polygon& at(int i) const { return scene_.polygons[std::size_t(i)]; }

    void show(Square window) {
        trace_.pop(window.x, window.y, window.size, window.size);
        std::vector<int> kept;
        for (const int i : window.list) {
            const Box box = box_of(at(i));
            const bool outside = box.left >= window.x + window.size || box.right <= window.x ||
                                 box.top >= window.y + window.size || box.bottom <= window.y;
            if (is("boxes"))
                trace_.box(i, box.left, box.top, box.right + (is("lie_box") ? 0.25 : 0), box.bottom, outside);
            if (!outside) kept.push_back(i);
        }
        window.list = kept;
        if (kept.empty()) {
            trace_.decide(Case::empty);
            return fill(window, scene_.background);
        }
        if (window.size <= 1) {
            trace_.decide(Case::pixel);
            return fill(window, color_at(window.x + 0.5, window.y + 0.5, kept));
        }
        if (kept.size() == 1 && !is("never_single")) {
            trace_.decide(Case::single);
            fill(window, scene_.background);
            return draw(window, kept[0]);
        }
        trace_.decide(is("lie_case") ? Case::pixel : Case::split);
        const double half = window.size / 2;
        for (int k = 0; k < 4 - int(is("part_lost")); ++k) {
            const int part = is("backwards") ? 3 - k : k;
            const Square square{window.x + part % 2 * half, window.y + part / 2 * half, half, kept};
            if (square.x >= area_.x + area_.width || square.y >= area_.y + area_.height) continue;
            trace_.push(square.x, square.y, half, half);
            show(square);
        }
    }

    int right(const Square& w) const { return int(std::min(w.x + w.size, double(area_.x + area_.width))); }
    int bottom(const Square& w) const { return int(std::min(w.y + w.size, double(area_.y + area_.height))); }

    void fill(const Square& window, Color color) {
        const int x = int(window.x), y = int(window.y);
        if (!is("fill_by_pixels")) return trace_.fill(x, y, right(window) - x, bottom(window) - y, color);
        for (int row = y; row < bottom(window); ++row) {
            for (int column = x; column < right(window); ++column) trace_.fill(column, row, 1, 1, color);
        }
    }

    void draw(const Square& window, int i) {
        const Outline& outline = at(i).vertices;
        for (int row = int(window.y); row < bottom(window); ++row) {
            double left = 0, end = 0;
            if (is("by_rows")) {
                if (!ends_on(outline, row + 0.5, left, end) || end <= window.x || left >= right(window)) continue;
                if (is("cut")) {
                    left = std::max(left, window.x);
                    end = std::min(end, double(right(window)));
                }
                const auto centre = [&](double x) {
                    return std::min(right(window), std::max(int(window.x), int(std::ceil(x - 0.5))));
                };
                trace_.row(row + (is("between_rows") ? 0.5 : 0), left - (is("lie_row") ? 0.125 : 0), end, centre(left),
                           centre(end));
                continue;
            }
            for (int x = int(window.x); x < right(window) - int(is("column_lost")); ++x) {
                if (!contains(outline, x + 0.5, row + 0.5)) continue;
                is("fill_by_pixels") ? trace_.fill(x, row, 1, 1, at(i).color) : trace_.pixel(x, row);
            }
        }
        if (!is("fill_by_pixels") || is("by_rows")) trace_.draw(i);
    }

    Color color_at(double x, double y, const std::vector<int>& list) {
        Color color = scene_.background;
        double nearest = -1.5;
        for (const int i : list) {
            const bool inside = contains(at(i).vertices, x, y);
            if (is("tests")) trace_.surround(i, x, y, is("lie_inside") ? !inside : inside);
            if (!inside) continue;
            const double z = reported_depth(at(i), x, y) + (is("bias") ? 4e-3 * i : 0);
            trace_.depth(i, x, y, z + (is("lie_depth") ? 1e-4 : 0));
            const bool nearer = is("farthest") ? nearest == -1.5 || z < nearest : z > nearest;
            if (is("compares")) trace_.compare(i, z, nearest, is("lie_nearer") ? !nearer : nearer);
            if (!nearer) continue;
            nearest = z;
            color = at(i).color;
        }
        trace_.color(x, y, color);
        return color;
    }

    const Scene& scene_;
    Area area_;
    WarnockTrace trace_;
};

using Convex = std::vector<Point>;

double twice_area(const Convex& outline) {
    double sum = 0;
    for (std::size_t i = 2; i < outline.size(); ++i) sum += cross(outline[0], outline[i - 1], outline[i]);
    return sum;
}

/// The part of an outline where a linear function is not negative; empty if it has no area.
Convex half_of(const Convex& outline, const std::function<double(Point)>& value) {
    Convex kept;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Point p = outline[i], q = outline[(i + 1) % outline.size()];
        const double vp = value(p), vq = value(q);
        if (vp >= 0) kept.push_back(p);
        if ((vp < 0 && vq > 0) || (vp > 0 && vq < 0)) {
            const double t = vp / (vp - vq);
            kept.push_back({p.x + (q.x - p.x) * t, p.y + (q.y - p.y) * t});
        }
    }
    return std::abs(twice_area(kept)) < 1e-10 ? Convex{} : kept;
}

/// Visible regions without lists: from each polygon it takes away what each other one hides.
void show_regions(const Scene& scene) {
    WeilerAthertonTrace trace("styles.jsonl", scene, Detail::signs, precision());
    const Area& area = scene.area;
    std::vector<Convex> outlines;
    for (const Polygon& polygon : scene.polygons) {
        Convex outline;
        for (const Vertex& v : polygon.vertices) {
            if (outline.empty() || v.x != outline.back().x || v.y != outline.back().y) outline.push_back({v.x, v.y});
        }
        if (twice_area(outline) < 0) std::reverse(outline.begin(), outline.end());
        outline = half_of(outline, [&](Point p) { return p.x - area.x; });
        outline = half_of(outline, [&](Point p) { return area.x + area.width - p.x; });
        outline = half_of(outline, [&](Point p) { return p.y - area.y; });
        outlines.push_back(half_of(outline, [&](Point p) { return area.y + area.height - p.y; }));
    }
    std::vector<std::pair<int, Convex>> shown;
    const int count = int(scene.polygons.size());
    for (int i = 0; i < count; ++i) {
        std::vector<Convex> pieces{outlines[std::size_t(i)]};
        for (int j = 0; j < count; ++j) {
            const Convex& other = outlines[std::size_t(j)];
            if (j == i || other.empty() || pieces[0].empty() || is("hidden_too")) continue;
            const auto before = [&](Point p) {
                const double d = depth(scene.polygons[std::size_t(i)], p) - depth(scene.polygons[std::size_t(j)], p);
                return std::abs(d) < 1e-12 ? 0 : is("farthest") ? -d : d;
            };
            std::vector<Convex> left;
            for (Convex piece : pieces) {
                for (std::size_t k = 0; k < other.size() && !piece.empty(); ++k) {
                    const Point from = other[k], to = other[(k + 1) % other.size()];
                    const Convex out = half_of(piece, [&](Point p) { return -cross(from, to, p); });
                    if (!out.empty()) left.push_back(out);
                    piece = half_of(piece, [&](Point p) { return cross(from, to, p); });
                }
                if (piece.empty()) continue;
                const bool is_one_plane =
                    std::all_of(piece.begin(), piece.end(), [&](Point p) { return before(p) == 0; });
                if (is_one_plane ? i < j : true)
                    piece = is_one_plane ? piece : half_of(piece, before);
                else
                    piece.clear();
                if (!piece.empty()) left.push_back(piece);
            }
            pieces = left.empty() ? std::vector<Convex>{Convex{}} : left;
        }
        for (const Convex& piece : pieces) {
            if (!piece.empty()) shown.emplace_back(i, piece);
        }
    }
    if (is("backwards")) std::reverse(shown.begin(), shown.end());
    if (is("part_lost") && !shown.empty()) shown.pop_back();
    if (is("instead") && shown.size() > 1) shown.back() = shown.front();
    if (is("twice") && !shown.empty()) shown.push_back(shown.back());
    std::vector<Region> regions(scene.polygons.size());
    for (const auto& each : shown) {
        std::vector<ScreenPoint> loop;
        for (const Point& p : each.second) loop.push_back({p.x, p.y});
        if (is("reversed")) std::reverse(loop.begin(), loop.end());
        if (is("moved")) loop[0].x += 0.125;
        if (is("joined")) {
            regions[std::size_t(each.first)].push_back(loop);
        } else if (is("fan")) {
            for (std::size_t i = 2; i < loop.size(); ++i) trace.show(each.first, {{loop[0], loop[i - 1], loop[i]}});
        } else {
            trace.show(each.first, {loop});
        }
    }
    for (std::size_t i = 0; is("joined") && i < regions.size(); ++i) {
        if (!regions[i].empty()) trace.show(int(i), regions[i]);
    }
}

/// The floating horizon without horizons: over each column it looks at all nearer curves and edges.
template <class Number>
class Curves {
public:
    explicit Curves(const Surface& surface)
        : curves_(surface.curves), trace_("styles.jsonl", surface, Detail::signs, precision()) {
        const int count = int(curves_.size());
        const auto for_columns = [&](const std::function<void(int)>& draw) {
            for (int k = 0; k + 1 < surface.area.width; ++k)
                draw(surface.area.x + (is("leftward") ? surface.area.width - 2 - k : k));
        };
        const auto for_curves = [&](const std::function<void(int)>& draw) {
            for (int c = 0; c < count - int(is("curve_lost")); ++c) draw(is("backwards") ? count - 1 - c : c);
        };
        if (is("columns")) {
            for_columns([&](int x) { for_curves([&](int c) { step(c, x); }); });
        } else {
            for_curves([&](int c) {
                if (is("once_each")) trace_.curve(c);
                for_columns([&](int x) { step(c, x); });
            });
        }
    }

private:
    static Number on(const Sample& p, const Sample& q, Number x) {
        return Number(p.y) + (Number(q.y) - Number(p.y)) * (x - Number(p.x)) / Number(q.x - p.x);
    }
    const Sample* segment(int curve, int x) const {
        const std::vector<Sample>& samples = curves_[std::size_t(curve)];
        for (std::size_t i = 1; i < samples.size(); ++i) {
            if (samples[i - 1].x <= x && x < samples[i].x) return &samples[i - 1];
        }
        return nullptr;
    }
    /// Whether there is a horizon over the column before the curve, and its heights.
    bool horizon(int curve, int x, Number& upper, Number& lower) const {
        bool any = false;
        const auto include = [&](Number y) {
            upper = any ? std::min(upper, y) : y;
            lower = any ? std::max(lower, y) : y;
            any = true;
        };
        const auto edge = [&](const Sample& p, const Sample& q) {
            if (std::min(p.x, q.x) < x && x < std::max(p.x, q.x) && !is("edges_lost")) include(on(p, q, Number(x)));
        };
        for (int c = 0; c <= curve; ++c) {
            const std::vector<Sample>& samples = curves_[std::size_t(c)];
            if (c > 0) edge(curves_[std::size_t(c - 1)].front(), samples.front());
            if (c == curve) break;
            if (const Sample* p = segment(c, x)) include(on(p[0], p[1], Number(x)));
            if (samples.back().x == x) include(Number(samples.back().y));
            if (c > 0) edge(curves_[std::size_t(c - 1)].back(), samples.back());
        }
        return any;
    }

    void step(int curve, int x) {
        const Sample* p = segment(curve, x);
        if (!p) return;
        if (!is("once_each")) trace_.curve(curve);
        const Number y0 = on(p[0], p[1], Number(x)), y1 = on(p[0], p[1], Number(x + 1));
        if (is("heights")) trace_.visibility(x, flag(curve, x, y0));
        Number u0 = 0, u1 = 0, l0 = 0, l1 = 0;
        const bool first = horizon(curve, x, u0, l0), last = horizon(curve, x + 1, u1, l1);
        if (!first || !last || is("hidden_too")) return put(p, x, Number(0), Number(1));
        // The part between the horizons is hidden.
        Number from = 0, to = 1;
        limit(y0 - u0, y1 - u1, from, to);
        limit(l0 - y0, l1 - y1, from, to);
        if (is("upper_only")) from = y0 <= u0 && y1 <= u1 ? 1 : 0, to = 1;
        if (from >= to) return put(p, x, Number(0), Number(1));
        put(p, x, Number(0), from);
        if (!is("ends_lost")) put(p, x, to, Number(1));
    }
    int flag(int curve, int x, Number y) const {
        Number upper = 0, lower = 0;
        if (!horizon(curve, x, upper, lower)) return 1;
        const int right = y <= upper ? 1 : y >= lower ? -1 : 0;
        return is("lie_flag") ? -right : right;
    }
    static void limit(Number f0, Number f1, Number& from, Number& to) {
        if (f0 <= 0 && f1 <= 0) to = from;
        if (f0 < 0 && f1 > 0) from = std::max(from, f0 / (f0 - f1));
        if (f0 > 0 && f1 < 0) to = std::min(to, f0 / (f0 - f1));
    }
    void put(const Sample* p, int x, Number from, Number to) {
        if (from >= to) return;
        const Number left = Number(x) + from, right = Number(x) + to,
                     off = is("lie_height") ? Number(0.001) : Number(0);
        trace_.draw_line(double(left), double(on(p[0], p[1], left) + off), double(right),
                         double(on(p[0], p[1], right)));
    }

    const std::vector<std::vector<Sample>>& curves_;
    FloatingHorizonTrace trace_;
};

int main(int, char** words) {
    const std::string path = words[0];
    words_of_name = path.substr(path.find_last_of('/') + 1);
    if (is("horizon")) {
        const Surface surface = surface_to_draw(example_surface());
        if (is("float")) Curves<float>{surface};
        if (is("longdouble")) Curves<long double>{surface};
        if (!is("float") && !is("longdouble")) Curves<double>{surface};
        return 0;
    }
    const Scene scene = scene_to_draw(example_scene());
    if (is("zbuffer")) ZBuffer{scene};
    if (is("warnock")) Warnock{scene};
    if (is("weiler")) show_regions(scene);
}
