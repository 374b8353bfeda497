// The exact zeros that the list of decisions has for the Z-buffer and the floating horizon, against counts in
// rationals. The counts use the scene and the picture rule. From a run they take at most its questions, never an answer
// or a number.

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "run/run.h"
#include "support/checked.h"
#include "support/curves.h"
#include "support/in_rationals.h"
#include "support/outlines.h"
#include "support/random_curves.h"
#include "support/scenes.h"
#include "support/zeros.h"

using namespace vidno;
using namespace vidno::test;

namespace {

using PolygonAtPixel = std::tuple<int, int, int>;  // a polygon, x, y
using PolygonOnRow = std::pair<int, int>;          // a polygon, y

Rational lowest_of(const Places& outline) {
    const auto by_y = [](const Place& p, const Place& q) { return p.second < q.second; };
    return std::max_element(outline.begin(), outline.end(), by_y)->second;
}

/// How many equal heights the Z-buffer finds as it lists the edges of a polygon: two for a level edge, and one more if
/// it is a point; one for a lower end that is the lowest; and, in a stable insertion sort, one for each edge that is
/// not the first of its height.
int equal_heights(const Places& outline) {
    const Rational lowest = lowest_of(outline);
    std::set<Rational> heights;
    int found = int(outline.size());
    for_each_edge_of(outline, [&](const Place& from, const Place& to) {
        if (from.second == to.second) found += from == to ? 3 : 2;
        if (std::max(from.second, to.second) == lowest) ++found;
        heights.insert(std::min(from.second, to.second));
    });
    return found - int(heights.size());
}

/// The level edges at the foot of a polygon, if a centre line of the area runs through them.
int level_edges_at_foot(const Area& area, const Places& outline) {
    const Rational lowest = lowest_of(outline);
    if (!is_centre_of_row(area, lowest)) return 0;
    int found = 0;
    for_each_edge_of(outline, [&](const Place& from, const Place& to) {
        found += from.second == lowest && to.second == lowest ? 1 : 0;
    });
    return found;
}

}  // namespace

TEST_CASE("On 1,000 scenes the Z-buffer's zeros are pixel centres on outlines, vertices on rows, and equal depths") {
    RandomScenes random(22);
    std::size_t on_outlines = 0, on_rows = 0, equal_depths = 0;
    for (int i = 0; i < 1000 / thinning; ++i) {
        CAPTURE(i);
        const AdmittedScene scene = scene_with_copies(random, i);
        const Area& area = scene->area;

        // The centres at an end of a polygon on a row; the rows on whose centre line a vertex lies; and where a polygon
        // is exactly as near as the nearest before it.
        std::set<PolygonAtPixel> ends;
        std::set<PolygonOnRow> vertices;
        std::set<PolygonsAtPixel> ties;
        const bool planar = all_planar(scene);
        for (int y = area.y; y < area.bottom(); ++y) {
            for (int p = 0; p < int(scene->polygons.size()); ++p) {
                const auto& polygon = scene->polygons[std::size_t(p)];
                if (polygon.edge_on) continue;
                const auto on_row = ends_on_row(outline_of(polygon), y);
                if (!on_row) continue;
                for (const auto& [vertex_x, vertex_y] : outline_of(polygon)) {
                    if (vertex_y == Rational(y) + half) vertices.emplace(p, y);
                }
                for (int x = area.x; x < area.right(); ++x) {
                    const Rational centre = Rational(x) + half;
                    if (centre == on_row->first || centre == on_row->second) ends.emplace(p, x, y);
                }
            }
            for (int x = area.x; planar && x < area.right(); ++x) add_ties(scene, x, y, ties);
        }

        for (const std::string_view kernel : {"exact", "filtered"}) {
            std::set<PolygonAtPixel> listed_ends;
            std::set<PolygonOnRow> listed_vertices;
            std::set<PolygonsAtPixel> listed_ties;
            for (const auto& each : of_kind(checked(scene, Method::zbuffer, kernel, 0), FindingKind::zero)) {
                const auto& [x, y, width, height] = each.pixels;
                const auto is = [&](Coincidence of) { return each.gap->if_zero == of; };
                if (each.procedure == Procedure::show_line && is(Coincidence::on_pixel_centre)) {
                    REQUIRE(width * height == 1);
                    listed_ends.emplace(each.polygons.at(0).index, x, y);
                }
                if (each.procedure == Procedure::z_buffer && is(Coincidence::on_pixel_centre)) {
                    REQUIRE(height == 1);
                    listed_vertices.emplace(each.polygons.at(0).index, y);
                }
                // A row with a level edge is shown twice, so a polygon is compared with itself there.
                if (is(Coincidence::equal_depths) && each.polygons.size() == 2) {
                    listed_ties.emplace(each.polygons[0].index, each.polygons[1].index, x, y);
                }
            }
            CHECK(listed_ends == ends);
            CHECK(listed_vertices == vertices);
            if (planar) CHECK(listed_ties == ties);
        }
        on_outlines += ends.size();
        on_rows += vertices.size();
        equal_depths += ties.size();
    }
    CHECK(on_outlines > 1000 / thinning);
    CHECK(on_rows > 300 / thinning);
    CHECK(equal_depths > 100 / thinning);
}

TEST_CASE(
    "On 1,000 scenes the Z-buffer's equal numbers are level edges, lowest vertices, and edges that meet on a row") {
    RandomScenes random(51);
    std::size_t heights = 0, level = 0, meetings = 0;
    for (int i = 0; i < 1000 / thinning; ++i) {
        CAPTURE(i);
        const JudgedScene judged = judged_scene(scene_with_copies(random, i), Method::zbuffer);
        const AdmittedScene& scene = judged.scene;
        std::map<int, int> at_edges, at_foot;  // by polygon
        for (int p = 0; p < int(scene->polygons.size()); ++p) {
            const auto& polygon = scene->polygons[std::size_t(p)];
            if (polygon.edge_on) continue;
            const Places outline = outline_of(polygon);
            at_edges[p] = equal_heights(outline);
            if (const int found = level_edges_at_foot(scene->area, outline)) at_foot[p] = found;
            level += std::size_t(at_foot.contains(p));
            heights += std::size_t(at_edges[p]);
        }
        // Two edges of a polygon are at one point of a row exactly where the row holds one point of the polygon.
        std::set<std::uint64_t> sorted, shown;
        int polygon = 0, row = 0;
        hear_run(scene, Method::zbuffer, [&](std::uint64_t step, const EventView& event) {
            if (const auto* begun = event.get_if<event::Polygon>()) polygon = begun->polygon.index;
            if (const auto* scanline = event.get_if<event::Scanline>()) row = scanline->row;
            const auto* sort = event.get_if<event::AelSort>();
            const bool sorts = sort && sort->edges.size() == 2;
            if (!sorts && !event.get_if<event::Slope>()) return;
            const auto ends = ends_on_row(outline_of(scene->polygons[std::size_t(polygon)]), row);
            REQUIRE(ends);
            if (ends->first == ends->second) (sorts ? sorted : shown).insert(step);
        });

        std::map<int, int> listed_at_edges, listed_at_foot;
        std::set<std::uint64_t> listed_sorted, listed_shown;
        for (const auto& zero : judged.zeros) {
            if (zero.coincidence != Coincidence::equal_numbers) continue;
            switch (zero.at) {
                case Line::Z3: ++listed_at_edges[zero.polygons.at(0).index]; break;
                case Line::Z9: ++listed_at_foot[zero.polygons.at(0).index]; break;
                case Line::Z12: listed_sorted.insert(zero.step); break;
                case Line::L3: listed_shown.insert(zero.step); break;
                default: FAIL("equal numbers in another line: " << zero.step);
            }
        }
        CHECK(listed_at_edges == at_edges);
        CHECK(listed_at_foot == at_foot);
        CHECK(listed_sorted == sorted);
        CHECK(listed_shown == shown);
        meetings += sorted.size() + shown.size();
    }
    CHECK(heights > 1000 / thinning);
    CHECK(level > 30 / thinning);
    CHECK(meetings > 100 / thinning);
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
            FunctionSink sink([&](const EventView& event) {
                if (const auto* begun = event.get_if<event::Curve>()) curve = begun->curve;
                const auto* seen = event.get_if<event::Visibility>();
                seen_at.push_back(seen ? std::optional(CurveAtColumn{curve, seen->x}) : std::nullopt);
            });
            FloatingHorizonRequest request{*kernel_named(kernel), Edition::corrected, scene, Detail::signs, &sink};
            traced_floating_horizon(request);
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
