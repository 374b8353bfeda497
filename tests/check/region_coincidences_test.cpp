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
#include "support/outlines.h"
#include "support/scenes.h"
#include "support/zeros.h"

using namespace vidno;
using namespace vidno::test;

namespace {

/// The coincidences among the zeros of RegionClip at the steps begin < step <= end.
Coincidences listed_in_clip(const std::vector<Finding>& zeros, std::uint64_t begin, std::uint64_t end) {
    Coincidences listed;
    for (const auto& each : zeros) {
        if (each.step <= begin || each.step > end || each.procedure != Procedure::region_clip) continue;
        if (has_operand(each, "line.a")) listed.on_lines.insert(point_on_line_of(each));
        if (each.gap->if_zero == Coincidence::shared_points) {
            listed.common.emplace(exact_operand(each, "p.x"), exact_operand(each, "p.y"));
        }
    }
    return listed;
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
            if (each.gap->if_zero == Coincidence::point_on_line) listed.insert(point_on_line_of(each));
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
