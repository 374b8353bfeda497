// The exact zeros that the list of decisions has for Weiler and Atherton's algorithm, against counts in rationals. The counts use the
// scene and the picture rule. From a run they take at most its questions, never an answer or a number.

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "run/run.h"
#include "support/checked.h"
#include "support/in_rationals.h"
#include "support/scenes.h"
#include "support/zeros.h"

using namespace vidno;
using namespace vidno::test;

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

/// A region by its outlines, holes included.
using Outlines = std::vector<Places>;

std::vector<EdgeOf> edges_of(const Outlines& region) {
    std::vector<EdgeOf> edges;
    for (const auto& outline : region) {
        for_each_edge_of(outline, [&](const Place& from, const Place& to) { edges.push_back({from, to}); });
    }
    return edges;
}

using PointOnLine = std::pair<Place, LineThrough>;

/// The coincidences of two overlaid regions: vertices of one on lines of the other, and common vertices.
struct Coincidences {
    std::set<PointOnLine> on_lines;
    std::set<Place> common;
    bool operator==(const Coincidences&) const = default;
};

/// A common edge counts as one edge, and vertices that are on it by construction are not tested. The line of an edge of the subject is
/// tested where it may meet an edge of the clip region, that is, where the line of that edge meets the subject's edge.
Coincidences coincidences(const Outlines& subject, const Outlines& clip) {
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
    for (const auto& ending : clip_edges) {
        const Place& vertex = ending.to;
        const auto has_vertex = [&](const EdgeOf& edge) { return edge.has(vertex); };
        if (std::none_of(subject_edges.begin(), subject_edges.end(), has_vertex)) continue;
        int shared = 0;
        for (const auto& edge : clip_edges) shared += edge.has(vertex) && is_shared(edge, subject_edges) ? 1 : 0;
        if (shared < 2) found.common.insert(vertex);
    }
    return found;
}

/// Whether two convex polygons share area: no line of an edge separates them.
bool overlap(const Places& p, const Places& q) {
    const auto separates = [](const EdgeOf& edge, const Places& own, const Places& other) {
        const auto all = [&](const Places& places, int side) {
            return std::all_of(places.begin(), places.end(),
                               [&](const Place& each) { return side * over(edge.line(), each) >= 0; });
        };
        return (all(own, 1) && all(other, -1)) || (all(own, -1) && all(other, 1));
    };
    for (const auto& edge : edges_of({p})) {
        if (separates(edge, p, q)) return false;
    }
    for (const auto& edge : edges_of({q})) {
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

PointOnLine point_on_line(const Finding& finding) {
    const Rational a = exact_operand(finding, "line.a"), b = exact_operand(finding, "line.b");
    const Rational c = a * exact_operand(finding, "line.x") + b * exact_operand(finding, "line.y");
    return {{exact_operand(finding, "p.x"), exact_operand(finding, "p.y")}, line(a, b, c)};
}

/// The coincidences among the zeros of RegionClip at the steps begin < step <= end.
Coincidences listed_in_clip(const std::vector<Finding>& zeros, std::uint64_t begin, std::uint64_t end) {
    Coincidences listed;
    for (const auto& each : zeros) {
        if (each.step <= begin || each.step > end || each.procedure != Procedure::region_clip) continue;
        if (has_operand(each, "line.a")) listed.on_lines.insert(point_on_line(each));
        if (each.gap->if_zero == Coincidence::shared_points) {
            listed.common.emplace(exact_operand(each, "p.x"), exact_operand(each, "p.y"));
        }
    }
    return listed;
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

/// Two triangles strictly inside the area, with corners on few whole numbers. One pair in eight is level.
AdmittedScene two_triangles(RandomScenes& random) {
    SceneBuilder builder({0, 0, 8, 8});
    const bool level = random.whole(0, 7) == 0;
    for (int i = 0; i < 2; ++i) {
        Corners corners;
        do {
            corners.clear();
            for (int k = 0; k < 3; ++k) {
                corners.emplace_back(random.whole(1, 7), random.whole(1, 7), level ? 0 : random.whole(0, 3) / 4.);
            }
        } while (cross(place_of(corners[0]), place_of(corners[1]), place_of(corners[2])) == 0);
        builder.polygon(corners);
    }
    return builder.build();
}

/// The line on which two planes have equal depths; none if they are parallel. Positive where the first is nearer.
std::optional<LineThrough> line_of_planes(const ScenePolygon& p, const ScenePolygon& q) {
    const auto over_other = [&](int x, int y) -> Rational { return depth_at(p, {x, y}) - depth_at(q, {x, y}); };
    const Rational at_origin = over_other(0, 0), a = over_other(1, 0) - at_origin, b = over_other(0, 1) - at_origin;
    if (a == 0 && b == 0) return std::nullopt;
    return line(a, b, -at_origin);
}

bool is_on_both_sides(const LineThrough& line, const Places& places) {
    const auto is_positive = [&](const Place& each) { return over(line, each) > 0; };
    const auto is_negative = [&](const Place& each) { return over(line, each) < 0; };
    return std::any_of(places.begin(), places.end(), is_positive) &&
           std::any_of(places.begin(), places.end(), is_negative);
}

/// The vertices of the part that two convex outlines have in common.
Places common_part(const Places& p, const Places& q) {
    Places inside = p;
    const Rational turn = cross(q[0], q[1], q[2]);
    for_each_edge_of(q, [&](const Place& from, const Place& to) {
        inside = cut_off(inside, [&](const Place& place) -> Rational { return -cross(from, to, place) * turn; });
    });
    return inside;
}

bool boxes_overlap(const Places& p, const Places& q) {
    const auto range = [](const Places& places, auto coordinate) {
        Rational least = coordinate(places[0]), greatest = least;
        for (const auto& each : places) {
            least = std::min<Rational>(least, coordinate(each));
            greatest = std::max<Rational>(greatest, coordinate(each));
        }
        return std::pair(least, greatest);
    };
    const auto overlap_in = [&](auto coordinate) {
        const auto [p_low, p_high] = range(p, coordinate);
        const auto [q_low, q_high] = range(q, coordinate);
        return p_low < q_high && q_low < p_high;
    };
    return overlap_in([](const Place& each) { return each.first; }) &&
           overlap_in([](const Place& each) { return each.second; });
}

Places outline_in(const Area& area, const ScenePolygon& polygon) {
    return clipped(whole_area(area), outline_of(polygon));
}

/// Adds the pixels of the area whose centres are an end of an outline on their row.
void add_centres_at_ends(const Area& area, const Places& outline, std::set<std::pair<int, int>>& pixels) {
    for (int y = area.y; y < area.bottom(); ++y) {
        const auto on_row = ends_on_row(outline, y);
        for (int x = area.x; on_row && x < area.right(); ++x) {
            const Rational centre = Rational(x) + half;
            if (centre == on_row->first || centre == on_row->second) pixels.emplace(x, y);
        }
    }
}

/// Whether a point is found on a convex outline. On a level lower side it is not: there a ray to the right, for which points on its row
/// count as below it, has found it inside.
bool is_found_on(const Places& outline, const Place& point) {
    const auto by_y = [](const Place& p, const Place& q) { return p.second < q.second; };
    const Rational top = std::min_element(outline.begin(), outline.end(), by_y)->second;
    bool found = false;
    for_each_edge_of(outline, [&](const Place& from, const Place& to) {
        const auto& [low, high] = std::minmax(from, to);
        if (cross(from, to, point) != 0 || point < low || high < point) return;
        found = found || std::min(from.second, to.second) < point.second || point.second == top;
    });
    return found;
}

/// Three level polygons, the farthest first, each strictly inside the one before it. Their corners are on half pixels.
AdmittedScene nested_polygons(RandomScenes& random) {
    const auto turn = [](const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& v) {
        return (q.x - p.x) * (v.y - p.y) - (q.y - p.y) * (v.x - p.x);  // exact for small halves
    };
    const auto holds_all = [&](const Corners& outer, const Corners& inner) {
        const double orientation = turn(outer[0], outer[1], outer[2]);
        return std::all_of(inner.begin(), inner.end(), [&](const auto& v) {
            for (std::size_t i = 0; i < outer.size(); ++i) {
                if (turn(outer[i], outer[(i + 1) % outer.size()], v) * orientation <= 0) return false;
            }
            return true;
        });
    };
    const auto triangle = [&](double z) {
        Corners corners;
        for (int k = 0; k < 3; ++k) corners.emplace_back(random.whole(3, 13) / 2., random.whole(3, 13) / 2., z);
        return corners;
    };
    while (true) {
        Corners quad{{1, 1, 0}, {7, 1, 0}, {7, 7, 0}, {1, 7, 0}};
        for (auto& corner : quad) {
            corner.x += random.whole(-1, 1) / 2.;
            corner.y += random.whole(-1, 1) / 2.;
        }
        const Corners middle = triangle(.25);
        for (int tries = 0; tries < 200; ++tries) {
            const Corners inner = triangle(.5);
            if (turn(inner[0], inner[1], inner[2]) == 0) continue;
            if (!holds_all(quad, middle) || !holds_all(middle, inner)) continue;
            return SceneBuilder({0, 0, 8, 8}).polygon(quad).polygon(middle).polygon(inner).build();
        }
    }
}

/// Four level rectangles whose sides run through pixel centres. They touch or overlap, and have one of two depths.
AdmittedScene touching_rectangles(RandomScenes& random) {
    SceneBuilder builder({0, 0, 8, 8});
    for (int i = 0; i < 4; ++i) {
        const double left = random.whole(0, 5) + .5, top = random.whole(0, 5) + .5;
        builder.quad(left, top, left + random.whole(1, 3), top + random.whole(1, 3), random.whole(0, 1) / 4.);
    }
    return builder.build();
}

/// Four rectangles side by side, so that none pierces another. Each is level or tilted; the depths at its sides are few quarters.
AdmittedScene rectangles_side_by_side(RandomScenes& random) {
    SceneBuilder builder({0, 0, 16, 16});
    for (int i = 0; i < 4; ++i) {
        const double left = 4 * i + 1, right = left + 2, top = random.whole(0, 7), bottom = top + random.whole(1, 8);
        const double at_left = random.whole(0, 3) / 4., at_right = random.whole(0, 3) / 4.;
        Corners corners{
            {left, top, at_left}, {right, top, at_right}, {right, bottom, at_right}, {left, bottom, at_left}};
        std::rotate(corners.begin(), corners.begin() + random.whole(0, 3), corners.end());
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
            begin == 0 ? Coincidences{} : coincidences({outlines[other]}, {outlines[std::size_t(clip->index)]});

        const auto zeros = of_kind(checked(scene, Method::weiler_atherton, "filtered", 0), FindingKind::zero);
        const Coincidences listed = begin == 0 ? Coincidences{} : listed_in_clip(zeros, begin, zeros.back().step);
        const auto depths = std::count_if(zeros.begin(), zeros.end(),
                                          [](const auto& each) { return each.procedure == Procedure::remove_behind; });
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
        std::set<std::pair<int, int>> expected, listed;
        if (!scene->polygons[0].edge_on) add_centres_at_ends(scene->area, outline_of(scene->polygons[0]), expected);
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

TEST_CASE(
    "On 1,000 scenes the zeros of DepthSort are the depths that equal the greatest so far, and equal greatest depths") {
    RandomScenes random(34);
    std::size_t zeros = 0;
    for (int i = 0; i < 1000 / thinning; ++i) {
        CAPTURE(i);
        const JudgedScene judged = judged_scene(rectangles_side_by_side(random), Method::weiler_atherton);
        std::size_t expected = 0, sorted = 0;
        std::optional<double> greatest;
        std::set<double> greatest_depths;
        hear_run(judged.scene, Method::weiler_atherton, [&](std::uint64_t, const EventView& event) {
            const auto* depth = event.get_if<event::Depth>();
            if (depth && depth->at == Line::DS1) {
                const auto& v = judged.scene->polygons[std::size_t(depth->polygon.index)].vertices;
                const auto vertex = std::find_if(v.begin(), v.end(), [&](const auto& each) {
                    return each.x == depth->point.x.number && each.y == depth->point.y.number;
                });
                REQUIRE(vertex != v.end());
                if (greatest && vertex->z == *greatest) ++expected;
                greatest = std::max(greatest.value_or(vertex->z), vertex->z);
            }
            if (event.get_if<event::GreatestDepth>()) {
                REQUIRE(greatest);
                greatest_depths.insert(*greatest);
                greatest.reset();
                ++sorted;
            }
        });
        CHECK(sorted == 4);
        // A stable insertion sort compares each piece that is not the first of its depth with an equal one, once.
        expected += sorted - greatest_depths.size();
        std::size_t listed = 0;
        for (const auto& zero : judged.zeros) {
            listed += zero.is(Procedure::depth_sort, Coincidence::equal_numbers) ? 1 : 0;
        }
        CHECK(listed == expected);
        zeros += expected;
    }
    CHECK(zeros > 1000 / thinning);
}

TEST_CASE(
    "On 1,000 scenes the zeros of SplitPiercing are parallel planes, and the vertices on the line in which two planes "
    "meet") {
    RandomScenes random(41);
    std::size_t on_lines = 0, parallel = 0;
    for (int i = 0; i < 1000 / thinning; ++i) {
        CAPTURE(i);
        const AdmittedScene scene = two_triangles(random);
        const auto& polygons = scene->polygons;
        const Places first = outline_of(polygons[0]), second = outline_of(polygons[1]);
        // Triangles whose boxes are apart are not compared. The vertices of the second are tested first, and those of the first and
        // of their common part only if the line divides what was tested before.
        std::set<PointOnLine> expected;
        const bool are_compared = boxes_overlap(first, second);
        const auto line = line_of_planes(polygons[1], polygons[0]);
        if (are_compared && line) {
            for (const Places& tested : {second, first, common_part(first, second)}) {
                for (const auto& place : tested) {
                    if (over(*line, place) == 0) expected.emplace(place, *line);
                }
                if (!is_on_both_sides(*line, tested)) break;
            }
        }
        std::set<PointOnLine> listed;
        int listed_parallel = 0;
        for (const auto& each : of_kind(checked(scene, Method::weiler_atherton, "filtered", 0), FindingKind::zero)) {
            if (each.procedure != Procedure::split_piercing) continue;
            if (each.gap->if_zero == Coincidence::point_on_line) listed.insert(point_on_line(each));
            if (each.gap->if_zero == Coincidence::parallel_lines) ++listed_parallel;
        }
        CHECK(listed == expected);
        CHECK(listed_parallel == (are_compared && !line ? 1 : 0));
        on_lines += expected.size();
        parallel += std::size_t(listed_parallel);
    }
    CHECK(on_lines > 200 / thinning);
    CHECK(parallel > 20 / thinning);
}

TEST_CASE(
    "On 1,000 scenes of nested polygons the zeros are vertices on lines of the other region, and pixel centres at the "
    "ends of a row") {
    RandomScenes random(43);
    std::size_t on_lines = 0, on_centres = 0;
    for (int i = 0; i < 1000 / thinning; ++i) {
        CAPTURE(i);
        const AdmittedScene scene = nested_polygons(random);
        const Places far = outline_of(scene->polygons[0]), middle = outline_of(scene->polygons[1]),
                     near = outline_of(scene->polygons[2]);
        const auto zeros = of_kind(checked(scene, Method::weiler_atherton, "filtered", 0), FindingKind::zero);

        // The nearest polygon clips the others. What lies outside it is the second list, in which the middle one clips the farthest.
        std::uint64_t begin = 0, end = 0;
        int lists = 0;
        hear_run(scene, Method::weiler_atherton, [&](std::uint64_t step, const EventView& event) {
            if (event.get_if<event::PopList>()) ++lists;
            const auto* call = event.get_if<event::Call>();
            if (lists == 2 && call && call->at == Line::WA5) begin = step;
            if (lists == 2 && event.get_if<event::Clipped>()) end = step;
        });
        REQUIRE(end > begin);
        const Coincidences expected = coincidences({far, near}, {middle, near});
        const Coincidences listed = listed_in_clip(zeros, begin, end);
        CHECK(listed.on_lines == expected.on_lines);
        CHECK(listed.common == expected.common);
        on_lines += expected.on_lines.size();

        std::set<std::pair<int, int>> centres, listed_centres;
        for (const Places& outline : {far, middle, near}) add_centres_at_ends(scene->area, outline, centres);
        for (const auto& each : zeros) {
            if (each.gap->if_zero == Coincidence::on_pixel_centre) listed_centres.emplace(each.pixels.x, each.pixels.y);
        }
        CHECK(listed_centres == centres);
        on_centres += centres.size();
    }
    CHECK(on_lines > 100 / thinning);
    CHECK(on_centres > 1000 / thinning);
}

TEST_CASE(
    "On 1,000 scenes RemoveBehind and PaintRegions find equal depths, and centres on outlines, exactly where they "
    "are") {
    RandomScenes random(45);
    std::size_t coplanar = 0, equal_depths = 0, on_outlines = 0;
    for (int i = 0; i < 1000 / thinning; ++i) {
        CAPTURE(i);
        const JudgedScene judged = judged_scene(
            i % 2 == 0 ? scene_with_copies(random, i / 2) : touching_rectangles(random), Method::weiler_atherton);
        const AdmittedScene& scene = judged.scene;
        if (!all_planar(scene)) continue;
        const auto polygon_at = [&](const PolygonPlace& place) -> const ScenePolygon& {
            return scene->polygons[std::size_t(place.index)];
        };
        std::set<std::uint64_t> in_one_plane, at_centres, at_outlines;
        bool pierces = false, is_on_outline = false;
        hear_run(scene, Method::weiler_atherton, [&](std::uint64_t step, const EventView& event) {
            pierces = pierces || event.get_if<event::Pierce>();
            if (const auto* behind = event.get_if<event::Behind>()) {
                const auto& clip = polygon_at(behind->clip);
                const auto is_in_plane = [&](const auto& v) { return depth_at(clip, place_of(v)) == Rational(v.z); };
                const auto& v = polygon_at(behind->polygon).vertices;
                if (std::all_of(v.begin(), v.end(), is_in_plane)) in_one_plane.insert(step);
            }
            // What is found after a comparison is listed at the next event.
            if (std::exchange(is_on_outline, false)) at_outlines.insert(step);
            if (const auto* order = event.get_if<event::Order>()) {
                const Place centre{order->point.x.number, order->point.y.number};
                const auto& polygon = polygon_at(order->polygon);
                if (depth_at(polygon, centre) != depth_at(polygon_at(order->other), centre)) return;
                at_centres.insert(step);
                // An equally near polygon may hold the centre, inside or on its outline.
                if (order->at == Line::PR2) is_on_outline = is_found_on(outline_in(scene->area, polygon), centre);
            }
        });
        CHECK(judged.steps(Procedure::remove_behind, Coincidence::equal_depths) == in_one_plane);
        CHECK(judged.steps(Procedure::paint_regions, Coincidence::equal_depths) == at_centres);
        coplanar += in_one_plane.size();
        equal_depths += at_centres.size();
        if (pierces) continue;  // then a piece of the polygon has other edges, too
        CHECK(judged.steps(Procedure::paint_regions, Coincidence::point_on_line) == at_outlines);
        on_outlines += at_outlines.size();
    }
    CHECK(coplanar > 100 / thinning);
    CHECK(equal_depths > 100 / thinning);
    CHECK(on_outlines > 100 / thinning);
}
