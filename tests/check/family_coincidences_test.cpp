// The exact zeros of the Warnock family and of DepthSort, against counts in rationals. From a run the counts take its questions (which
// window, polygon, edge or point), never an answer or a number.

#include <doctest/doctest.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>

#include "support/scenes.h"
#include "support/zeros.h"
#include "vidno/kernels/exact.h"

using namespace vidno;
using namespace vidno::test;

namespace {

const ScenePolygon& polygon_at(const AdmittedScene& scene, const PolygonPlace& place) {
    return scene->polygons[std::size_t(place.index)];
}

/// Whether a point lies on the line through an edge.
bool is_on_line(const ScenePolygon& polygon, int edge, const ValuePoint& point) {
    const auto& v = polygon.vertices;
    const auto& p = v[std::size_t(edge)];
    const auto& q = v[(std::size_t(edge) + 1) % v.size()];
    const Rational dx = Rational(point.x.number) - Rational(p.x), dy = Rational(point.y.number) - Rational(p.y);
    return (Rational(q.x) - Rational(p.x)) * dy == (Rational(q.y) - Rational(p.y)) * dx;
}

/// A call of a containment test: its steps, its window and its polygon.
struct ContainmentCall {
    std::uint64_t begin = 0, end = 0;
    Window window;
    PolygonPlace polygon;
};

/// The calls of a procedure, each of which ends with an event `Result`.
template <class Result>
std::vector<ContainmentCall> calls_of(Procedure procedure, const AdmittedScene& scene, Method method) {
    std::vector<ContainmentCall> calls;
    Window window;
    hear_run(scene, method, [&](std::uint64_t step, const EventView& event) {
        if (const auto* pop = event.get_if<event::Pop>()) window = pop->window;
        const auto* call = event.get_if<event::Call>();
        if (call && call->of == procedure) calls.push_back({step, 0, window, {}});
        if (const auto* result = event.get_if<Result>()) {
            calls.back().end = step;
            calls.back().polygon = result->polygon;
        }
    });
    return calls;
}

struct JudgedByMethod {
    Method method;
    JudgedScene judged;
};

/// 1,000 scenes, judged once: half of them with RayCrossings, half with OctantAngles.
const std::vector<JudgedByMethod>& scenes_of_family() {
    static const std::vector<JudgedByMethod> scenes = [] {
        RandomScenes random(31);
        std::vector<JudgedByMethod> all;
        for (int i = 0; i < 1000 / thinning; ++i) {
            const Method method = i % 4 < 2 ? Method::warnock_full : Method::warnock_angles;
            all.push_back({method, judged_scene(scene_with_copies(random, i), method)});
        }
        return all;
    }();
    return scenes;
}

/// Compares the calls with zeros in the list to those with a vertex for which `coincides(vertex, window)`.
template <class Result>
void check_calls(Procedure procedure, Method method, auto&& coincides) {
    std::size_t calls_with_zeros = 0, all_calls = 0;
    for (const auto& [own_method, judged] : scenes_of_family()) {
        if (own_method != method) continue;
        const auto zeros = judged.steps(procedure, Coincidence::equal_numbers);
        std::set<std::uint64_t> expected, listed;
        std::size_t listed_in_calls = 0;
        for (const auto& call : calls_of<Result>(procedure, judged.scene, method)) {
            const auto& vertices = polygon_at(judged.scene, call.polygon).vertices;
            const auto coincides_here = [&](const auto& vertex) { return coincides(vertex, call.window); };
            if (std::any_of(vertices.begin(), vertices.end(), coincides_here)) expected.insert(call.begin);
            const auto inside = std::distance(zeros.upper_bound(call.begin), zeros.upper_bound(call.end));
            if (inside > 0) listed.insert(call.begin);
            listed_in_calls += std::size_t(inside);
            ++all_calls;
        }
        CHECK(listed == expected);
        CHECK(listed_in_calls == zeros.size());
        calls_with_zeros += expected.size();
    }
    CHECK(calls_with_zeros > 100 / thinning);
    CHECK(calls_with_zeros < all_calls);
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

// One test, because judging the scenes takes longest.
TEST_CASE("On 1,000 scenes the zeros of the family's procedures are those of the scene") {
    SUBCASE("of TrialFunction: the corners that lie on the line of the edge in question") {
        std::size_t zeros = 0;
        for (const auto& [method, judged] : scenes_of_family()) {
            const AdmittedScene& scene = judged.scene;
            std::map<Line, std::set<std::uint64_t>> expected;
            hear_run(scene, method, [&](std::uint64_t step, const EventView& event) {
                const auto* orient = event.get_if<event::Orient>();
                if (!orient || !is_on_line(polygon_at(scene, orient->polygon), orient->edge, orient->point)) return;
                expected[orient->at].insert(step);
            });
            const auto on_line = Coincidence::point_on_line;
            CHECK(judged.steps(Procedure::trial_function, on_line) == expected[Line::TF2]);
            CHECK(judged.steps(Procedure::ray_crossings, on_line) == expected[Line::CR4]);
            CHECK(judged.steps(Procedure::octant_angles, on_line) == expected[Line::OA4]);
            zeros += expected[Line::TF2].size();
        }
        CHECK(zeros > 1000 / thinning);
    }

    SUBCASE("of RayCrossings: in the calls in which a vertex is on the row of the window's centre") {
        const auto is_on_row = [](const glm::dvec3& vertex, const Window& window) {
            return Rational(vertex.y) == Rational(window.y) + Rational(window.height) / 2;
        };
        check_calls<event::Crossings>(Procedure::ray_crossings, Method::warnock_full, is_on_row);
    }

    SUBCASE("of OctantAngles: in the calls in which a vertex is on the line of a side of the window") {
        const auto is_on_side = [](const glm::dvec3& vertex, const Window& window) {
            return vertex.x == window.x || vertex.x == window.right() || vertex.y == window.y ||
                   vertex.y == window.bottom();
        };
        check_calls<event::Angle>(Procedure::octant_angles, Method::warnock_angles, is_on_side);
    }
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
                const auto& v = polygon_at(judged.scene, depth->polygon).vertices;
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
