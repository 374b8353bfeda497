// The exact zeros that the list of decisions has for Warnock's algorithm and its variants, against counts in rationals.
// From a run the counts take its questions (which window, polygon, edge or point), never an answer or a number.

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "support/bodies.h"
#include "support/in_rationals.h"
#include "support/scenes.h"
#include "support/zeros.h"

using namespace vidno;
using namespace vidno::test;

namespace {

using Steps = std::set<std::uint64_t>;

/// Hears a run, and finds out at which of its steps the scene has a coincidence.
class ExpectedZeros {
public:
    ExpectedZeros(const AdmittedScene& scene, Method method) : scene_(scene), method_(method) {}

    std::map<Coincidence, Steps> steps;
    std::set<PolygonsAtPixel> ties;                  // at the points of PointColor, by the picture rule
    std::map<std::uint64_t, int> equal_coordinates;  // at each step of RayCrossings and OctantAngles: how many

    void hear(std::uint64_t step, const EventView& event) {
        step_ = step;
        if (pending_) {
            add(*pending_);
            pending_.reset();
        }
        event.visit([&](const auto& reported) { hear(reported); });
    }

private:
    void hear(const auto&) {}

    void add(Coincidence coincidence, bool holds = true) {
        if (holds) steps[coincidence].insert(step_);
    }

    const ScenePolygon& at(const PolygonPlace& place) const { return scene_->polygons[std::size_t(place.index)]; }

    std::pair<Place, Place> edge_of(const PolygonPlace& polygon, int edge) const {
        const auto& v = at(polygon).vertices;
        return {place_of(v[std::size_t(edge)]), place_of(v[(std::size_t(edge) + 1) % v.size()])};
    }

    std::array<Place, 4> corners() const {  // lb, lt, rb, rt: "b" is the least y of the window
        const auto& w = window_;
        return {Place{w.x, w.y}, {w.x, w.bottom()}, {w.right(), w.y}, {w.right(), w.bottom()}};
    }

    void hear(const event::Pop& pop) {
        window_ = pop.window;
        in_window_.clear();
    }

    // A box next to a window

    void hear(const event::Box& box) {
        in_window_.insert(box.polygon.index);
        const auto [left, top, right, bottom] = box_of(at(box.polygon));
        add(Coincidence::box_on_window,
            right == window_.x || bottom == window_.y || left == window_.right() || top == window_.bottom());
    }
    void hear(const event::Insider& insider) {
        const auto [left, top, right, bottom] = box_of(at(insider.polygon));
        add(Coincidence::box_on_window,
            left == window_.x || top == window_.y || right == window_.right() || bottom == window_.bottom());
    }

    static std::array<double, 4> box_of(const ScenePolygon& polygon) {
        const auto& v = polygon.vertices;
        const auto of_axis = [&](int axis) {
            return std::minmax_element(v.begin(), v.end(),
                                       [&](const auto& p, const auto& q) { return p[axis] < q[axis]; });
        };
        const auto [left, right] = of_axis(0);
        const auto [top, bottom] = of_axis(1);
        return {left->x, top->y, right->x, bottom->y};
    }

    // A window that is split at a vertex. The vertices are tried in the order of the scene, up to one strictly inside
    // the window that is rounded to a point strictly inside it. Only vertices strictly inside have events.

    void hear(const event::Join& join) { in_window_.erase(join.polygon.index); }

    void hear(const event::Decide& decide) {
        if (method_ == Method::warnock_vertex && decide.which == Case::split) await_split_vertex(0, 0);
    }
    void hear(const event::SplitVertex& split) {
        const glm::dvec3 vertex = at(split.polygon).vertices[std::size_t(split.vertex)];
        const auto is_centre = [](double v) { return v - std::floor(v) == 0.5; };
        add(Coincidence::on_pixel_centre, is_centre(vertex.x) || is_centre(vertex.y));
        const double column = std::ceil(vertex.x - 0.5), row = std::ceil(vertex.y - 0.5);
        const bool splits =
            (window_.x < column && column < window_.right()) || (window_.y < row && row < window_.bottom());
        if (!splits) await_split_vertex(split.polygon.index, split.vertex + 1);
    }

    /// From this vertex on, to the next one that is strictly inside.
    void await_split_vertex(int polygon, int vertex) {
        for (int p = polygon; p < int(scene_->polygons.size()); ++p) {
            if (!in_window_.contains(p)) continue;
            const auto& vertices = scene_->polygons[std::size_t(p)].vertices;
            for (int v = p == polygon ? vertex : 0; v < int(vertices.size()); ++v) {
                const double x = vertices[std::size_t(v)].x, y = vertices[std::size_t(v)].y;
                if (x == window_.x || x == window_.right() || y == window_.y || y == window_.bottom()) {
                    pending_ = Coincidence::box_on_window;
                }
                if (x > window_.x && x < window_.right() && y > window_.y && y < window_.bottom()) return;
            }
        }
    }

    // A point on the line of an edge

    void hear(const event::Orient& orient) {
        test_box(orient.polygon, orient.point);
        if (orient.at == Line::CR4) hear_ray(orient.polygon, orient.edge);
        if (orient.at == Line::OA4) hear_octants(orient.polygon, orient.edge);
        const auto [from, to] = edge_of(orient.polygon, orient.edge);
        const Place point{orient.point.x.number, orient.point.y.number};
        add(Coincidence::point_on_line, cross(from, to, point) == 0);
    }

    // The ends of an edge that crosses the window's lines, next to the sides in turn: the second end only if the first
    // is not within

    void hear(const event::Trial& trial) {
        const auto [from, to] = edge_of(trial.polygon, trial.edge);
        bool negative = false, positive = false;
        for (const auto& corner : corners()) {
            const Rational side = cross(from, to, corner);
            negative = negative || side < 0;
            positive = positive || side > 0;
        }
        if (!negative || !positive) return;
        for (const int side : {1, 3, 0, 2}) {  // left, right, top, bottom
            const Rational of_from = beyond(side, window_, from);
            add(Coincidence::equal_numbers, of_from == 0);
            if (of_from < 0) continue;
            const Rational of_to = beyond(side, window_, to);
            add(Coincidence::equal_numbers, of_to == 0);
            if (of_to >= 0) return;
        }
    }

    // Vertices next to the lines of the window's sides: both ends of each edge, in turn

    void hear(const event::Call& call) {
        if (call.of == Procedure::ray_crossings || call.of == Procedure::octant_angles) next_edge_ = 0;
        is_at_first_ray_ = call.of == Procedure::ray_crossings;
        if (call.of == Procedure::fill_polygon) rows_.assign(1, step_);
        if (call.of == Procedure::surround_test) begins_surround_test_ = true;
    }
    void hear_octants(const PolygonPlace& polygon, int edge) {
        if (edge < next_edge_) return;  // reported before its orientation
        next_edge_ = edge + 1;
        const auto [from, to] = edge_of(polygon, edge);
        for (const auto& [x, y] : {from, to}) {
            add_equal_coordinates((x == window_.x || x == window_.right() ? 1 : 0) +
                                  (y == window_.y || y == window_.bottom() ? 1 : 0));
        }
    }
    void hear(const event::Octants& octants) { hear_octants(octants.polygon, octants.edge); }

    // Vertices next to the ray from the window's centre. RayCrossings first compares all of them, and then the second
    // end of each edge, and the first end if the second is not on the ray's line. It tells the edges that end off that
    // line and either begin on it or cross it. A vertex is compared twice, as less and as greater.

    void hear_rays_to(const PolygonPlace& polygon, int end) {
        const Rational row = Rational(window_.y) + Rational(window_.height) / 2;
        const Places outline = outline_of(at(polygon));
        const auto is_on_row = [&](std::size_t vertex) { return outline[vertex % outline.size()].second == row; };
        if (std::exchange(is_at_first_ray_, false)) {
            for (std::size_t i = 0; i < outline.size(); ++i) add_equal_coordinates(is_on_row(i) ? 2 : 0);
        }
        // The edge from the last vertex to the first one comes first, so edges are numbered by their second ends here.
        for (; next_edge_ < end; ++next_edge_) {
            const auto to = std::size_t(next_edge_);
            add_equal_coordinates(is_on_row(to) || is_on_row(to + outline.size() - 1) ? 2 : 0);
        }
    }
    void hear_ray(const PolygonPlace& polygon, int edge) {
        hear_rays_to(polygon, (edge + 1) % int(at(polygon).vertices.size()) + 1);
    }
    void hear(const event::Ray& ray) { hear_ray(ray.polygon, ray.edge); }
    void hear(const event::Crossings& crossings) {
        hear_rays_to(crossings.polygon, int(at(crossings.polygon).vertices.size()));
    }

    void add_equal_coordinates(int count) {
        if (count > 0) equal_coordinates[step_] += count;
    }

    // Depths at the corners of a window, and at the points of PointColor

    void hear(const event::Corners&) { at_corners_.fill(std::nullopt); }

    void hear(const event::Compare& compare) {
        if (!compare.corner) return;
        const auto corner = std::size_t(*compare.corner);
        const Rational z = depth_at(at(compare.polygon), corners()[corner]);
        auto& nearest = at_corners_[corner];
        add(Coincidence::equal_depths, nearest && z == *nearest);
        if (!nearest || z > *nearest) nearest = z;
    }

    void hear(const event::PointColor& color) {
        const auto pixel = [](const Value& centre) { return int(std::floor(centre.number)); };
        add_ties(scene_, pixel(color.point.x), pixel(color.point.y), ties,
                 [&](const ScenePolygon& polygon, int x, int y) { return depth_shown(polygon, x, y); });
    }

    /// By the rule of the method.
    std::optional<Rational> depth_shown(const ScenePolygon& polygon, int x, int y) const {
        if (method_ == Method::warnock_bodies && looks_away(polygon)) return std::nullopt;
        if (method_ != Method::warnock_edges || !polygon.edge_on) return depth_at_pixel(polygon, x, y);
        std::optional<Rational> nearest;
        for (int edge = 0; edge < int(polygon.vertices.size()); ++edge) {
            const auto z = depth_on_edge(polygon, edge, centre_of_pixel(x, y));
            if (z && (!nearest || *z > *nearest)) nearest = z;
        }
        return nearest;
    }

    // The planes through the edges of edge-on polygons, which come before the first window: an edge is compared with
    // the axes, and its first end with the sides of the area

    void hear(const event::Push& push) {
        if (push.at != Line::WF1 || method_ != Method::warnock_edges) return;
        for (const auto& polygon : scene_->polygons) {
            if (!polygon.edge_on) continue;
            for_each_edge_of(outline_of(polygon), [&](const Place& from, const Place& to) {
                const bool is_upright = from.first == to.first;
                add(Coincidence::equal_numbers, is_upright || from.second == scene_->area.y);
            });
        }
    }

    // The box of an edge-on polygon at a point, up to the first side that the point is beyond

    void hear(const event::Surround& surround) {
        test_box(surround.polygon, surround.point);
        point_ = {surround.point.x.number, surround.point.y.number};
        next_edge_ = 0;
    }
    void test_box(const PolygonPlace& polygon, const ValuePoint& point) {
        const bool is_first = std::exchange(begins_surround_test_, false);
        if (!is_first || method_ != Method::warnock_edges || !at(polygon).edge_on) return;
        const double x = point.x.number, y = point.y.number;
        const auto [left, top, right, bottom] = box_of(at(polygon));
        for (const auto& [low, high] :
             std::array{std::pair(left, x), std::pair(x, right), std::pair(top, y), std::pair(y, bottom)}) {
            add(Coincidence::equal_numbers, low == high);
            if (low > high) break;
        }
    }

    // The ends of the edges of an edge-on polygon next to a point of it

    void hear_edges_to(const PolygonPlace& polygon, int end) {
        for (; next_edge_ < end; ++next_edge_) {
            const auto [from, to] = edge_of(polygon, next_edge_);
            if (is_between(from.first, point_.first, to.first)) is_between(from.second, point_.second, to.second);
        }
    }
    bool is_between(const Rational& a, const Rational& value, const Rational& b) {
        const auto in_order = [&](const Rational& low, const Rational& high) {
            add(Coincidence::equal_numbers, low == high);
            return low <= high;
        };
        return (in_order(a, value) && in_order(value, b)) || (in_order(b, value) && in_order(value, a));
    }

    // The depths of the edges of an edge-on polygon at the centre of the window, in turn. The next event follows their
    // comparison.

    void hear(const event::EdgeDepth& reported) {
        hear_edges_to(reported.polygon, reported.edge + 1);
        const Place centre{Rational(window_.x) + Rational(window_.width) / 2,
                           Rational(window_.y) + Rational(window_.height) / 2};
        const auto z = depth_on_edge(at(reported.polygon), reported.edge, centre);
        REQUIRE(z);
        if (nearest_edge_ && *z == *nearest_edge_) pending_ = Coincidence::equal_depths;
        if (!nearest_edge_ || *z > *nearest_edge_) nearest_edge_ = z;
    }
    void hear(const event::Depth& depth) {
        if (at(depth.polygon).edge_on) hear_edges_to(depth.polygon, int(at(depth.polygon).vertices.size()));
        nearest_edge_.reset();
    }

    /// The greatest depth of an edge at a point; none if the point is not on it.
    static std::optional<Rational> depth_on_edge(const ScenePolygon& polygon, int edge, const Place& point) {
        const auto& v = polygon.vertices;
        const auto& from = v[std::size_t(edge)];
        const auto& to = v[(std::size_t(edge) + 1) % v.size()];
        const Place p = place_of(from), q = place_of(to);
        const Place low = std::min(p, q), high = std::max(p, q);
        if (cross(p, q, point) != 0 || point < low || high < point) return std::nullopt;
        if (p == q) return Rational(std::max(from.z, to.z));
        const Rational part = p.first != q.first ? (point.first - p.first) / (q.first - p.first)
                                                 : (point.second - p.second) / (q.second - p.second);
        return Rational(from.z) + part * (Rational(to.z) - Rational(from.z));
    }

    /// Faces are counter-clockwise as seen from outside, so one that looks away is clockwise on the screen, where y
    /// grows downward.
    static bool looks_away(const ScenePolygon& face) {
        const Places outline = outline_of(face);
        Rational doubled = 0;
        for_each_edge_of(outline, [&](const Place& p, const Place& q) { doubled += cross(outline[0], p, q); });
        return doubled > 0;
    }

    // The part of a polygon in a window

    void hear(const event::ClipBegin& begin) {
        clipped_ = outline_of(at(begin.polygon));
        side_ = -1;
    }
    void hear(const event::ClipSide&) {
        if (side_ >= 0) clipped_ = clipped(side_, window_, clipped_);
        ++side_;
        next_ = clipped_.size() - 1;  // the last vertex comes first, and again at the end
    }
    void hear(const event::ClipSign&) {
        const Place& vertex = clipped_.at(next_);
        next_ = (next_ + 1) % clipped_.size();
        add(Coincidence::point_on_line, beyond(side_, window_, vertex) == 0);
    }

    void hear(const event::Row&) { rows_.push_back(step_); }

    /// The first event of FillPolygon follows the search for the rows, and each `row` that for its columns.
    void hear(const event::Draw& draw) {
        const Places outline = clipped(window_, outline_of(at(draw.polygon)));
        if (outline.empty()) return;
        rows_.push_back(step_);
        const Area& area = scene_->area;
        const auto is_centre = [](const Rational& v, int first, int end) {
            for (int i = first; i < end; ++i) {
                if (v == Rational(i) + half) return true;
            }
            return false;
        };
        const auto by_y = [](const Place& p, const Place& q) { return p.second < q.second; };
        const auto [top, bottom] = std::minmax_element(outline.begin(), outline.end(), by_y);
        const auto is_row = [&](const Rational& y) { return is_centre(y, area.y, area.bottom()); };
        if (is_row(top->second) || is_row(bottom->second)) steps[Coincidence::on_pixel_centre].insert(rows_[1]);
        std::size_t reported = 1;
        for (int row = area.y; row < area.bottom(); ++row) {
            const auto ends = ends_on_row(outline, row);
            if (!ends) continue;
            const auto is_column = [&](const Rational& x) { return is_centre(x, area.x, area.right()); };
            if (is_column(ends->first) || is_column(ends->second)) {
                steps[Coincidence::on_pixel_centre].insert(rows_.at(reported));
            }
            ++reported;
        }
    }

    const AdmittedScene& scene_;
    Method method_;
    std::uint64_t step_ = 0;
    std::optional<Coincidence> pending_;  // at the next event
    Window window_;
    std::set<int> in_window_;  // the polygons that neither surround the window nor lie outside, of ThreeListsWarnock
    std::vector<std::uint64_t> rows_;  // the steps of FillPolygon: its call, its rows, its end
    std::array<std::optional<Rational>, 4> at_corners_;
    bool begins_surround_test_ = false;
    Place point_;        // of the last surround test
    int next_edge_ = 0;  // of an edge-on polygon there, or of the polygon next to the window
    bool is_at_first_ray_ = false;
    std::optional<Rational> nearest_edge_;
    Places clipped_;
    int side_ = -1;
    std::size_t next_ = 0;
};

/// The zeros in the list, in the form of those expected.
struct ListedZeros {
    std::map<Coincidence, Steps> steps;
    std::set<PolygonsAtPixel> ties;
    std::map<std::uint64_t, int> equal_coordinates;

    explicit ListedZeros(const std::vector<Zero>& zeros) {
        using enum Procedure;
        for (const auto& zero : zeros) {
            if (zero.at == Line::PC4) {
                REQUIRE(zero.polygons.size() == 2);
                ties.emplace(zero.polygons[0].index, zero.polygons[1].index, zero.pixels.x, zero.pixels.y);
            } else if (zero.is(ray_crossings, Coincidence::equal_numbers) ||
                       zero.is(octant_angles, Coincidence::equal_numbers)) {
                ++equal_coordinates[zero.step];
            } else {
                steps[zero.coincidence].insert(zero.step);
            }
        }
    }
};

using Counts = std::map<Coincidence, std::size_t>;

/// Judges a run, and compares the zeros of its list with those expected. Adds how many there are.
void check_zeros(const AdmittedScene& scene, Method method, Counts& counts) {
    const JudgedScene judged = judged_scene(scene, method);
    ExpectedZeros expected(judged.scene, method);
    hear_run(judged.scene, method, [&](std::uint64_t step, const EventView& event) { expected.hear(step, event); });
    ListedZeros listed(judged.zeros);

    const bool planar = all_planar(scene);  // otherwise the scene does not determine the depths
    for (std::size_t i = 0; i < coincidence_names.size(); ++i) {
        const auto coincidence = Coincidence(i);
        if (coincidence == Coincidence::equal_depths && !planar) continue;
        CAPTURE(coincidence_names[i]);
        CHECK(listed.steps[coincidence] == expected.steps[coincidence]);
        counts[coincidence] += expected.steps[coincidence].size();
    }
    if (planar) CHECK(listed.ties == expected.ties);
    CHECK(listed.equal_coordinates == expected.equal_coordinates);
    for (const auto& each : expected.equal_coordinates) counts[Coincidence::equal_numbers] += std::size_t(each.second);
}

}  // namespace

TEST_CASE("On 1,000 scenes the zeros of Warnock's algorithm are those of the scene") {
    RandomScenes random(23);
    Counts counts;
    for (int i = 0; i < 1000 / thinning; ++i) {
        CAPTURE(i);
        check_zeros(scene_with_copies(random, i), Method::warnock, counts);
    }
    CHECK(counts[Coincidence::point_on_line] > 1500 / thinning);
    CHECK(counts[Coincidence::equal_depths] > 1000 / thinning);
    CHECK(counts[Coincidence::box_on_window] > 1000 / thinning);
    CHECK(counts[Coincidence::on_pixel_centre] > 100 / thinning);
}

TEST_CASE("On 1,000 scenes the zeros of Warnock's variants are those of the scene") {
    using enum Method;
    const std::array methods{warnock_simplest, warnock_full,  warnock_angles,
                             warnock_vertex,   warnock_edges, warnock_bodies};
    RandomScenes random(31);
    RandomBodies bodies(32);
    Counts counts;
    for (int i = 0; i < 1000 / thinning; ++i) {
        CAPTURE(i);
        const Method method = methods[std::size_t(i) % methods.size()];
        check_zeros(method == warnock_bodies ? bodies.scene() : scene_with_copies(random, i), method, counts);
    }
    CHECK(counts[Coincidence::point_on_line] > 1500 / thinning);
    CHECK(counts[Coincidence::equal_depths] > 1000 / thinning);
    CHECK(counts[Coincidence::box_on_window] > 1000 / thinning);
    CHECK(counts[Coincidence::equal_numbers] > 1000 / thinning);
    CHECK(counts[Coincidence::on_pixel_centre] > 100 / thinning);
}
