// The exact zeros of the list of decisions, against counts in rationals. The counts use the scene and the picture rule. From a run they
// take at most its questions, never an answer or a number.

#include <doctest/doctest.h>

#include <array>
#include <functional>
#include <set>
#include <tuple>

#include "run/run.h"
#include "support/checked.h"
#include "support/curves.h"
#include "support/random_curves.h"
#include "support/scenes.h"
#include "support/zeros.h"
#include "vidno/kernels/exact.h"

using namespace vidno;
using namespace vidno::test;

namespace {

/// Polygons and pixels by the picture rule, in rationals.
class InRationals {
public:
    /// The ends of the closed polygon on a row's centre line; none if it does not reach it. As in the rule, a polygon without width does
    /// not count.
    std::optional<std::pair<Rational, Rational>> ends(const ScenePolygon& polygon, int row) const {
        if (polygon.edge_on) return std::nullopt;
        const Rational y = Rational(row) + half;
        std::optional<std::pair<Rational, Rational>> found;
        const auto& v = polygon.vertices;
        for (std::size_t i = 0; i < v.size(); ++i) {
            const auto& p = v[i];
            const auto& q = v[(i + 1) % v.size()];
            const Rational py(p.y), qy(q.y), px(p.x), qx(q.x);
            if ((y < py && y < qy) || (y > py && y > qy)) continue;
            const auto include = [&](const Rational& x) {
                if (!found) found.emplace(x, x);
                found->first = std::min(found->first, x);
                found->second = std::max(found->second, x);
            };
            if (py == qy) {
                include(px);
                include(qx);
            } else {
                include(px + (y - py) * (qx - px) / (qy - py));
            }
        }
        return found;
    }

    bool holds(const ScenePolygon& polygon, int x, int y) const {
        const auto on_row = ends(polygon, y);
        const Rational centre = Rational(x) + half;
        return on_row && on_row->first <= centre && centre <= on_row->second;
    }

    /// The depth of the polygon's plane at a point, by three of its vertices.
    static Rational depth(const ScenePolygon& polygon, const Rational& x, const Rational& y) {
        const auto& v = polygon.vertices;
        for (std::size_t i = 1; i + 1 < v.size(); ++i) {
            const Rational ux = Rational(v[i].x) - Rational(v[0].x), uy = Rational(v[i].y) - Rational(v[0].y);
            const Rational wx = Rational(v[i + 1].x) - Rational(v[0].x), wy = Rational(v[i + 1].y) - Rational(v[0].y);
            const Rational area = ux * wy - uy * wx;
            if (area == 0) continue;
            const Rational dx = x - Rational(v[0].x), dy = y - Rational(v[0].y);
            const Rational s = (dx * wy - dy * wx) / area, t = (ux * dy - uy * dx) / area;
            return Rational(v[0].z) + s * (Rational(v[i].z) - Rational(v[0].z)) +
                   t * (Rational(v[i + 1].z) - Rational(v[0].z));
        }
        FAIL("a polygon without area has no plane");
        return 0;
    }

    /// Whether all vertices lie in one plane exactly, so that any three of them give the same plane.
    static bool is_planar(const ScenePolygon& polygon) {
        return polygon.edge_on || std::all_of(polygon.vertices.begin(), polygon.vertices.end(), [&](const auto& v) {
                   return depth(polygon, Rational(v.x), Rational(v.y)) == Rational(v.z);
               });
    }

private:
    const Rational half = Rational(1) / 2;
};

using PolygonAtPixel = std::tuple<int, int, int>;        // a polygon, x, y
using PolygonsAtPixel = std::tuple<int, int, int, int>;  // two polygons, the nearer one so far last, x, y

using Place = std::pair<Rational, Rational>;

std::vector<Place> outline_of(const ScenePolygon& polygon) {
    std::vector<Place> outline;
    for (const auto& v : polygon.vertices) outline.emplace_back(v.x, v.y);
    return outline;
}

/// A polygon that is clipped by the sides of a window in turn: top, left, bottom, right.
class Clipped {
public:
    Clipped(const ScenePolygon& polygon, const Window& window) : outline_(outline_of(polygon)), window_(window) {}

    void begin_side() {
        if (side_ >= 0) clip();
        ++side_;
        next_ = outline_.size() - 1;  // the last vertex comes first, and again at the end
    }
    bool next_is_on_side() {
        const Place& vertex = outline_.at(next_);
        next_ = (next_ + 1) % outline_.size();
        return beyond(vertex) == 0;
    }

private:
    /// Positive outside.
    Rational beyond(const Place& p) const {
        switch (side_) {
            case 0: return Rational(window_.y) - p.second;
            case 1: return Rational(window_.x) - p.first;
            case 2: return p.second - Rational(window_.bottom());
            default: return p.first - Rational(window_.right());
        }
    }

    void clip() {
        std::vector<Place> inside;
        Place from = outline_.back();
        for (const Place& to : outline_) {
            const Rational f = beyond(from), t = beyond(to);
            if ((f < 0 && t > 0) || (f > 0 && t < 0)) {
                const Rational part = f / (f - t);
                inside.emplace_back(from.first + (to.first - from.first) * part,
                                    from.second + (to.second - from.second) * part);
            }
            if (t <= 0) inside.push_back(to);
            from = to;
        }
        outline_ = inside;
    }

    std::vector<Place> outline_;
    Window window_;
    int side_ = -1;
    std::size_t next_ = 0;
};

/// Adds the polygons that are exactly as near as the nearest before them in the scene.
void add_ties(const AdmittedScene& scene, int x, int y, std::set<PolygonsAtPixel>& ties) {
    const InRationals exact;
    const Rational half = Rational(1) / 2;
    int nearest = -1;
    Rational depth;
    for (int p = 0; p < int(scene->polygons.size()); ++p) {
        const auto& polygon = scene->polygons[std::size_t(p)];
        if (!exact.holds(polygon, x, y)) continue;
        const Rational z = InRationals::depth(polygon, Rational(x) + half, Rational(y) + half);
        if (nearest >= 0 && z == depth) ties.emplace(p, nearest, x, y);
        if (nearest >= 0 && z <= depth) continue;
        nearest = p;
        depth = z;
    }
}

bool all_planar(const AdmittedScene& scene) {
    return std::all_of(scene->polygons.begin(), scene->polygons.end(), InRationals::is_planar);
}

/// 1,000 scenes and their zeros under Warnock's algorithm, judged once.
const std::vector<JudgedScene>& scenes_of_warnock() {
    static const std::vector<JudgedScene> scenes = [] {
        RandomScenes random(23);
        std::vector<JudgedScene> all;
        for (int i = 0; i < 1000 / thinning; ++i) {
            all.push_back(judged_scene(scene_with_copies(random, i), Method::warnock));
        }
        return all;
    }();
    return scenes;
}

}  // namespace

TEST_CASE(
    "On 1,000 scenes the Z-buffer's zeros are the pixel centres on outlines and the equal depths that the picture rule "
    "has") {
    RandomScenes random(22);
    std::size_t on_outlines = 0, equal_depths = 0;
    for (int i = 0; i < 1000 / thinning; ++i) {
        CAPTURE(i);
        const AdmittedScene scene = scene_with_copies(random, i);
        const InRationals exact;
        const Area& area = scene->area;

        const Rational half = Rational(1) / 2;
        // The centres at an end of a polygon on a row; and where a polygon is exactly as near as the nearest before it.
        std::set<PolygonAtPixel> ends;
        std::set<PolygonsAtPixel> ties;
        const bool planar = all_planar(scene);
        for (int y = area.y; y < area.bottom(); ++y) {
            for (int p = 0; p < int(scene->polygons.size()); ++p) {
                const auto on_row = exact.ends(scene->polygons[std::size_t(p)], y);
                if (!on_row) continue;
                for (int x = area.x; x < area.right(); ++x) {
                    const Rational centre = Rational(x) + half;
                    if (centre == on_row->first || centre == on_row->second) ends.emplace(p, x, y);
                }
            }
            for (int x = area.x; planar && x < area.right(); ++x) add_ties(scene, x, y, ties);
        }

        for (const std::string_view kernel : {"exact", "filtered"}) {
            std::set<PolygonAtPixel> listed_ends;
            std::set<PolygonsAtPixel> listed_ties;
            for (const auto& each : of_kind(checked(scene, Method::zbuffer, kernel, 0), FindingKind::zero)) {
                const auto& [x, y, width, height] = each.pixels;
                const auto is = [&](Coincidence of) { return each.gap->if_zero == of; };
                if (each.procedure == Procedure::show_line && is(Coincidence::on_pixel_centre)) {
                    REQUIRE(width * height == 1);
                    listed_ends.emplace(each.polygons.at(0).index, x, y);
                }
                // A row with a level edge is shown twice, so a polygon is compared with itself there.
                if (is(Coincidence::equal_depths) && each.polygons.size() == 2) {
                    listed_ties.emplace(each.polygons[0].index, each.polygons[1].index, x, y);
                }
            }
            CHECK(listed_ends == ends);
            if (planar) CHECK(listed_ties == ties);
        }
        on_outlines += ends.size();
        equal_depths += ties.size();
    }
    CHECK(on_outlines > 1000 / thinning);
    CHECK(equal_depths > 100 / thinning);
}

// One test, because judging the scenes takes longest.
TEST_CASE("On 1,000 scenes the zeros of Warnock's algorithm are those of the scene") {
    SUBCASE("of SurroundTest: the points that lie on the line of the edge in question") {
        std::size_t zeros = 0;
        for (const auto& judged : scenes_of_warnock()) {
            const AdmittedScene& scene = judged.scene;
            std::set<std::uint64_t> expected;
            hear_run(scene, Method::warnock, [&](std::uint64_t step, const EventView& event) {
                const auto* orient = event.get_if<event::Orient>();
                if (!orient) return;
                const auto& v = scene->polygons[std::size_t(orient->polygon.index)].vertices;
                const auto& p = v[std::size_t(orient->edge)];
                const auto& q = v[(std::size_t(orient->edge) + 1) % v.size()];
                const Rational x(orient->point.x.number), y(orient->point.y.number);
                const Rational twice_area = (Rational(q.x) - Rational(p.x)) * (y - Rational(p.y)) -
                                            (Rational(q.y) - Rational(p.y)) * (x - Rational(p.x));
                if (twice_area == 0) expected.insert(step);
            });
            CHECK(judged.steps(Procedure::surround_test, Coincidence::point_on_line) == expected);
            zeros += expected.size();
        }
        CHECK(zeros > 1000 / thinning);
    }

    SUBCASE("of PolygonClip: the vertices that lie on the side at which they are clipped") {
        std::size_t zeros = 0;
        for (const auto& judged : scenes_of_warnock()) {
            const AdmittedScene& scene = judged.scene;
            std::set<std::uint64_t> expected;
            std::optional<Clipped> clipped;
            hear_run(scene, Method::warnock, [&](std::uint64_t step, const EventView& event) {
                if (const auto* begin = event.get_if<event::ClipBegin>()) {
                    clipped.emplace(scene->polygons[std::size_t(begin->polygon.index)], begin->window);
                }
                if (event.get_if<event::ClipSide>()) clipped->begin_side();
                if (event.get_if<event::ClipSign>() && clipped->next_is_on_side()) expected.insert(step);
            });
            CHECK(judged.steps(Procedure::polygon_clip, Coincidence::point_on_line) == expected);
            zeros += expected.size();
        }
        CHECK(zeros > 500 / thinning);
    }

    SUBCASE("of ProcessWindow: the equal depths of the polygons' planes at a window's corners") {
        std::size_t zeros = 0;
        for (const auto& judged : scenes_of_warnock()) {
            const AdmittedScene& scene = judged.scene;
            if (!all_planar(scene)) continue;
            std::set<std::uint64_t> expected;
            Window window;
            std::array<std::optional<Rational>, 4> nearest;
            hear_run(scene, Method::warnock, [&](std::uint64_t step, const EventView& event) {
                if (const auto* pop = event.get_if<event::Pop>()) window = pop->window;
                if (event.get_if<event::Corners>()) nearest.fill(std::nullopt);
                const auto* compare = event.get_if<event::Compare>();
                if (!compare || !compare->corner) return;
                // lb, lt, rb, rt: "b" is the least y of the window.
                const auto corner = std::size_t(*compare->corner);
                const Rational x(corner < 2 ? window.x : window.right());
                const Rational y(corner % 2 == 0 ? window.y : window.bottom());
                const Rational z = InRationals::depth(scene->polygons[std::size_t(compare->polygon.index)], x, y);
                auto& there = nearest[corner];
                if (there && z == *there) expected.insert(step);
                if (!there || z > *there) there = z;
            });
            CHECK(judged.steps(Procedure::process_window, Coincidence::equal_depths) == expected);
            zeros += expected.size();
        }
        CHECK(zeros > 1000 / thinning);
    }

    SUBCASE("of PointColor: the equal depths that the picture rule has at its pixels") {
        std::size_t zeros = 0;
        for (const auto& judged : scenes_of_warnock()) {
            const AdmittedScene& scene = judged.scene;
            if (!all_planar(scene)) continue;
            std::set<PolygonsAtPixel> expected, listed;
            hear_run(scene, Method::warnock, [&](std::uint64_t, const EventView& event) {
                const auto* color = event.get_if<event::PointColor>();
                if (!color) return;
                const auto pixel = [](const Value& centre) { return int(std::floor(centre.number)); };
                add_ties(scene, pixel(color->point.x), pixel(color->point.y), expected);
            });
            for (const auto& zero : judged.zeros) {
                if (!zero.is(Procedure::point_color, Coincidence::equal_depths)) continue;
                REQUIRE(zero.polygons.size() == 2);
                listed.emplace(zero.polygons[0].index, zero.polygons[1].index, zero.pixels.x, zero.pixels.y);
            }
            CHECK(listed == expected);
            zeros += expected.size();
        }
        CHECK(zeros > 1000 / thinning);
    }
}

TEST_CASE(
    "On 1,000 surfaces the zeros of Visibility are the columns at which a curve meets a horizon of those before it") {
    RandomCurves random(28);
    using CurveAtColumn = std::pair<int, int>;
    std::size_t zeros = 0;
    for (int i = 0; i < 1000 / thinning; ++i) {
        CAPTURE(i);
        const AdmittedCurves scene = random.scene();
        std::set<CurveAtColumn> expected;
        const FloatingHorizonReference reference(scene);
        for (std::size_t curve = 0; curve < scene->curves.size(); ++curve) {
            const auto& on_horizon = reference.curves()[curve].on_horizon;
            for (std::size_t column = 0; column < on_horizon.size(); ++column) {
                const int x = scene->curves[curve].samples.front().x + int(column);
                if (on_horizon[column]) expected.emplace(int(curve), x);
            }
        }
        for (const std::string_view kernel : {"exact", "filtered"}) {
            std::vector<std::optional<CurveAtColumn>> seen_at;  // by the step
            int curve = 0;
            HeardBy sink([&](const EventView& event) {
                if (const auto* begun = event.get_if<event::Curve>()) curve = begun->curve;
                const auto* seen = event.get_if<event::Visibility>();
                seen_at.push_back(seen ? std::optional(CurveAtColumn{curve, seen->x}) : std::nullopt);
            });
            FloatingHorizonRequest request{*kernel_named(kernel), Edition::corrected, scene, Detail::signs, &sink};
            told_floating_horizon(request);
            FindingList list(Procedure::floating_horizon, scene->area, 0);
            find_in(request, list);
            std::set<CurveAtColumn> listed;
            for (const auto& each : list.findings()) {
                if (each.kind != FindingKind::zero || each.gap->if_zero != Coincidence::curve_on_horizon) continue;
                const auto& at = seen_at.at(each.step - 1);
                REQUIRE(at);
                listed.insert(*at);
            }
            CHECK(listed == expected);
        }
        zeros += expected.size();
    }
    CHECK(zeros > 1000 / thinning);
}

namespace {

/// a x + b y = c, the first of a and b that is not 0 is 1.
using LineThrough = std::tuple<Rational, Rational, Rational>;

LineThrough line(Rational a, Rational b, Rational c) {
    const Rational scale = a != 0 ? a : b;
    return {a / scale, b / scale, c / scale};
}
LineThrough line_through(const Place& p, const Place& q) {
    const Rational a = p.second - q.second, b = q.first - p.first;
    return line(a, b, a * p.first + b * p.second);
}
Rational over(const LineThrough& line, const Place& p) {
    const auto& [a, b, c] = line;
    return a * p.first + b * p.second - c;
}

struct EdgeOf {
    Place from, to;

    LineThrough line() const { return line_through(from, to); }
    bool has(const Place& p) const { return p == from || p == to; }
    bool is_same_as(const EdgeOf& other) const { return has(other.from) && has(other.to); }
};

std::vector<EdgeOf> edges_of(const std::vector<Place>& outline) {
    std::vector<EdgeOf> edges;
    for (std::size_t i = 0; i < outline.size(); ++i) edges.push_back({outline[i], outline[(i + 1) % outline.size()]});
    return edges;
}

using PointOnLine = std::pair<Place, LineThrough>;

/// The coincidences of two overlaid outlines: vertices of one on lines of the other, and common vertices.
struct Coincidences {
    std::set<PointOnLine> on_lines;
    std::set<Place> common;
    bool operator==(const Coincidences&) const = default;
};

/// A common edge counts as one edge, and vertices that are on it by construction are not tested. The line of an edge of the subject is
/// tested where it may meet an edge of the clip polygon, that is, where the line of that edge meets the subject's edge.
Coincidences coincidences(const std::vector<Place>& subject, const std::vector<Place>& clip) {
    Coincidences found;
    const auto is_shared = [](const EdgeOf& edge, const std::vector<EdgeOf>& others) {
        return std::any_of(others.begin(), others.end(), [&](const EdgeOf& other) { return edge.is_same_as(other); });
    };
    const auto subject_edges = edges_of(subject), clip_edges = edges_of(clip);
    const auto on_own_edge = [](const Place& vertex, const EdgeOf& edge, const std::vector<EdgeOf>& own) {
        return std::any_of(own.begin(), own.end(),
                           [&](const EdgeOf& each) { return each.has(vertex) && each.is_same_as(edge); });
    };
    for (const auto& e : subject_edges) {
        for (const auto& f : clip_edges) {
            const Rational from = over(f.line(), e.from), to = over(f.line(), e.to);
            for (const auto& end : {e.from, e.to}) {
                if (over(f.line(), end) == 0 && !on_own_edge(end, f, subject_edges)) {
                    found.on_lines.emplace(end, f.line());
                }
            }
            if ((from < 0 && to < 0) || (from > 0 && to > 0)) continue;
            for (const auto& end : {f.from, f.to}) {
                if (over(e.line(), end) == 0 && !on_own_edge(end, e, clip_edges)) {
                    found.on_lines.emplace(end, e.line());
                }
            }
        }
    }
    for (const auto& vertex : clip) {
        if (std::find(subject.begin(), subject.end(), vertex) == subject.end()) continue;
        int shared = 0;
        for (const auto& edge : clip_edges) shared += edge.has(vertex) && is_shared(edge, subject_edges) ? 1 : 0;
        if (shared < 2) found.common.insert(vertex);
    }
    return found;
}

/// Whether two convex polygons share area: no line of an edge separates them.
bool overlap(const std::vector<Place>& p, const std::vector<Place>& q) {
    const auto separates = [](const EdgeOf& edge, const std::vector<Place>& own, const std::vector<Place>& other) {
        const auto all = [&](const std::vector<Place>& places, int side) {
            return std::all_of(places.begin(), places.end(),
                               [&](const Place& each) { return side * over(edge.line(), each) >= 0; });
        };
        return (all(own, 1) && all(other, -1)) || (all(own, -1) && all(other, 1));
    };
    for (const auto& edge : edges_of(p)) {
        if (separates(edge, p, q)) return false;
    }
    for (const auto& edge : edges_of(q)) {
        if (separates(edge, q, p)) return false;
    }
    return true;
}

Rational exact_operand(const Finding& finding, const std::string& name) {
    for (const auto& operand : finding.decision.operands) {
        if (operand.name != name) continue;
        const auto& text = operand.exact.text;
        const auto slash = text.find('/');
        return Rational(text.substr(0, slash)) / Rational(text.substr(slash + 1));
    }
    FAIL("no operand " << name);
    return 0;
}

bool has_operand(const Finding& finding, const std::string& name) {
    const auto& operands = finding.decision.operands;
    return std::any_of(operands.begin(), operands.end(), [&](const Operand& each) { return each.name == name; });
}

/// Two level polygons strictly inside the area, with corners on few whole numbers.
AdmittedScene two_level_polygons(RandomScenes& random) {
    SceneBuilder builder({0, 0, 8, 8});
    for (int i = 0; i < 2; ++i) {
        const double z = random.whole(0, 1) / 4.;
        const auto at = [&] { return double(random.whole(1, 7)); };
        if (random.whole(0, 2) == 0) {
            const double left = random.whole(1, 5), top = random.whole(1, 5);
            builder.quad(left, top, left + random.whole(1, 7 - int(left)), top + random.whole(1, 7 - int(top)), z);
            continue;
        }
        Corners corners;
        do {
            corners = {{at(), at(), z}, {at(), at(), z}, {at(), at(), z}};
        } while ((corners[1].x - corners[0].x) * (corners[2].y - corners[0].y) ==
                 (corners[1].y - corners[0].y) * (corners[2].x - corners[0].x));
        builder.polygon(corners);
    }
    return builder.build();
}

}  // namespace

TEST_CASE(
    "On 1,000 scenes the zeros of RegionClip are the vertices on the other polygon's lines, and those in common") {
    RandomScenes random(29);
    std::size_t on_lines = 0, common = 0, equal_depths = 0;
    for (int i = 0; i < 1000 / thinning; ++i) {
        CAPTURE(i);
        const AdmittedScene scene = two_level_polygons(random);
        // Which polygon clips the other, and at which step; none if their boxes are apart.
        std::optional<PolygonPlace> clip;
        std::uint64_t begin = 0;
        hear_run(scene, Method::weiler_atherton, [&](std::uint64_t step, const EventView& event) {
            if (const auto* list = event.get_if<event::PopList>(); list && list->count == 2) clip = list->clip;
            const auto* call = event.get_if<event::Call>();
            if (call && call->at == Line::WA5) begin = step;
        });
        REQUIRE(clip);
        const auto outlines = std::array{outline_of(scene->polygons[0]), outline_of(scene->polygons[1])};
        const auto other = std::size_t(1 - clip->index);
        const Coincidences expected =
            begin == 0 ? Coincidences{} : coincidences(outlines[other], outlines[std::size_t(clip->index)]);

        Coincidences listed;
        int depths = 0;
        for (const auto& each : of_kind(checked(scene, Method::weiler_atherton, "filtered", 0), FindingKind::zero)) {
            if (each.procedure == Procedure::remove_behind) ++depths;
            if (begin == 0 || each.step <= begin || each.procedure != Procedure::region_clip) continue;
            if (each.decision.of == Decision::orientation && has_operand(each, "line.a")) {
                const Rational a = exact_operand(each, "line.a"), b = exact_operand(each, "line.b");
                const Rational c = a * exact_operand(each, "line.x") + b * exact_operand(each, "line.y");
                listed.on_lines.emplace(Place{exact_operand(each, "p.x"), exact_operand(each, "p.y")}, line(a, b, c));
            }
            if (each.gap->if_zero == Coincidence::shared_points) {
                listed.common.emplace(exact_operand(each, "p.x"), exact_operand(each, "p.y"));
            }
        }
        CHECK(listed.on_lines == expected.on_lines);
        CHECK(listed.common == expected.common);
        // Where they overlap, level polygons are equally near if their depths are equal.
        const bool is_level = scene->polygons[0].vertices[0].z == scene->polygons[1].vertices[0].z;
        CHECK(depths == (is_level && overlap(outlines[0], outlines[1]) ? 1 : 0));
        on_lines += expected.on_lines.size();
        common += expected.common.size();
        equal_depths += std::size_t(depths);
    }
    CHECK(on_lines > 1000 / thinning);
    CHECK(common > 100 / thinning);
    CHECK(equal_depths > 100 / thinning);
}

TEST_CASE("On 1,000 scenes of a polygon alone PaintRegions has its zeros at the pixel centres at its ends") {
    RandomScenes random(30);
    std::size_t zeros = 0;
    for (int i = 0; i < 1000 / thinning; ++i) {
        CAPTURE(i);
        Scene drawn = random.scene();
        drawn.polygons.resize(1);
        const AdmittedScene scene = admit(std::move(drawn));
        const InRationals exact;
        const Area& area = scene->area;
        std::set<std::pair<int, int>> expected, listed;
        for (int y = area.y; y < area.bottom(); ++y) {
            const auto on_row = exact.ends(scene->polygons[0], y);
            if (!on_row) continue;
            for (int x = area.x; x < area.right(); ++x) {
                const Rational centre = Rational(x) + Rational(1) / 2;
                if (centre == on_row->first || centre == on_row->second) expected.emplace(x, y);
            }
        }
        for (const auto& each : of_kind(checked(scene, Method::weiler_atherton, "filtered", 0), FindingKind::zero)) {
            if (each.procedure != Procedure::paint_regions || each.gap->if_zero != Coincidence::on_pixel_centre)
                continue;
            listed.emplace(each.pixels.x, each.pixels.y);
        }
        CHECK(listed == expected);
        zeros += expected.size();
    }
    CHECK(zeros > 300 / thinning);
}
