// Charts of cost against error: counts and measurements on scenes small enough to be counted by hand.

#include "chart/chart.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>
#include <sstream>
#include <utility>

#include "chart/chart_pictures.h"
#include "check/visible_areas.h"
#include "output.h"
#include "scene/scene_json.h"
#include "scene/snapped_scene.h"
#include "support/scenes.h"
#include "vidno/admission.h"

using namespace vidno;
using namespace vidno::test;
using nlohmann::json;

namespace {

/// Over the whole area, its outline a pixel outside.
AdmittedScene whole_quad() { return SceneBuilder(area_16).quad(-1, -1, 17, 17, 0).build(); }

/// Its right side goes through the centres of column 8.
AdmittedScene half_quad() { return SceneBuilder(area_16).quad(-1, -1, 8.5, 17, 0).build(); }

Findings examined(const AdmittedScene& scene, Method method, const std::string& kernel, int smallest_window = 1) {
    RunRequest request{method, *kernel_named(kernel), Edition::corrected, scene};
    request.smallest_window = smallest_window;
    std::vector<std::size_t> sources(scene->polygons.size());
    std::iota(sources.begin(), sources.end(), std::size_t{0});
    return Examiner(scene).examine(request, sources);
}

OperationCounts counted(std::initializer_list<std::pair<Operation, std::uint64_t>> counts) {
    OperationCounts all{};
    for (const auto& [operation, count] : counts) all[std::size_t(operation)] = count;
    return all;
}

SceneChart charted(const AdmittedScene& scene) {
    return chart_of(scene, [] {});
}

std::size_t number_of(const std::vector<Way>& ways, std::optional<Knob> knob, Method method) {
    return std::size_t(std::count_if(ways.begin(), ways.end(),
                                     [&](const Way& way) { return way.knob == knob && way.method == method; }));
}

}  // namespace

TEST_CASE("Chart: each kernel in each edition that it runs, and each knob at each place") {
    const auto ways = ways_to_draw(whole_quad());
    for (const Method method : {Method::warnock, Method::zbuffer}) {
        CHECK_MESSAGE(number_of(ways, std::nullopt, method) == 4 + 3, "filtered has no printed edition");
        CHECK_MESSAGE(number_of(ways, Knob::bits, method) == 21, "4 to 24");
        // The scene and the square over the area are 18 wide: 18 * 2^19 + 1 < 2^24 <= 18 * 2^20.
        CHECK_MESSAGE(number_of(ways, Knob::grid, method) == 19, "1 to 19");
    }
    CHECK_MESSAGE(number_of(ways, Knob::depth, Method::zbuffer) == 31, "2 to 32");
    CHECK(number_of(ways, Knob::depth, Method::warnock) == 0);
    CHECK_MESSAGE(number_of(ways, Knob::window, Method::warnock) == 4, "2, 4, 8, 16");
    CHECK(number_of(ways, Knob::window, Method::zbuffer) == 0);
}

TEST_CASE("Chart: other methods that take the scene, under each kernel") {
    const auto ways = ways_to_draw(whole_quad());
    for (const Method method : {Method::warnock_simplest, Method::warnock_full, Method::warnock_angles,
                                Method::warnock_vertex, Method::warnock_edges}) {
        CHECK_MESSAGE(number_of(ways, std::nullopt, method) == 6, "float, double, bits:12, filtered, grid:8, exact");
    }
    CHECK_MESSAGE(number_of(ways, std::nullopt, Method::warnock_bodies) == 0, "a quad is no body");
    CHECK_MESSAGE(number_of(ways, std::nullopt, Method::weiler_atherton) == 5,
                  "float, double, bits:12, filtered, exact");
}

TEST_CASE("Operations: the Warnock family finds a window surrounded by its own tests") {
    using enum Operation;
    // The box test, twice; four corners against each edge. To the right of the centre (8, 8) one edge crosses the ray,
    // the one from (17, -1) to (17, 17): only this edge and the left one pass from one side of the ray's line to the
    // other.
    CHECK(examined(whole_quad(), Method::warnock_full, "double").operations ==
          counted({{windows, 1}, {boxes, 2}, {orientations, 4 * 4 + 2}}));
    // The quad's corners are in the octants 0, 2, 4 and 6: nothing is split.
    CHECK(examined(whole_quad(), Method::warnock_angles, "filtered").operations ==
          counted({{windows, 1}, {boxes, 2}, {orientations, 4 * 4}}));
    // 16 x 16 pixels and 1 + 4 + 16 + 64 windows around them; at each pixel four edges and a depth, compared with none.
    CHECK(examined(whole_quad(), Method::warnock_simplest, "double").operations ==
          counted({{windows, 341}, {boxes, 341}, {orientations, 4 * 256}, {depths, 256}, {comparisons, 256}}));
}

TEST_CASE("Wrong pixels of a method with its own rule are those that differ from this rule") {
    const AdmittedScene edge_on = SceneBuilder(area_16).polygon({{2.5, 2.5, 0}, {2.5, 9.5, 0}, {2.5, 6, 1}}).build();
    CHECK(examined(edge_on, Method::warnock_edges, "double").wrong_pixels == 0);
    CHECK(examined(edge_on, Method::warnock_full, "double").wrong_pixels == 0);
    CHECK(right_picture(edge_on, Method::warnock_edges).at(2, 5) == color_of(0));
    CHECK(right_picture(edge_on).at(2, 5) == edge_on->background);
}

TEST_CASE("Operations: a window that a quad surrounds") {
    // One window; the depths of its four corners, each compared; each corner on the inner side of four edges.
    using enum Operation;
    const auto expected = counted({{windows, 1}, {boxes, 1}, {depths, 4}, {comparisons, 4}, {orientations, 16}});
    for (const auto* kernel : {"float", "bits:12", "filtered", "grid:4", "exact"}) {
        CAPTURE(kernel);
        CHECK(examined(whole_quad(), Method::warnock, kernel).operations == expected);
    }
}

TEST_CASE("Operations: a quad scanned row by row") {
    // The depths of four vertices; 16 rows of 16 pixels; two edges that enter, and are stepped from row to row 15
    // times.
    using enum Operation;
    const auto expected = counted({{depths, 4}, {comparisons, 256}, {rows, 16}, {edges, 2 + 2 * 15}});
    for (const auto* kernel : {"float", "bits:12", "depth:8", "filtered", "grid:4", "exact"}) {
        CAPTURE(kernel);
        CHECK(examined(whole_quad(), Method::zbuffer, kernel).operations == expected);
    }
}

TEST_CASE("Area: half of a half-covered pixel is wrong") {
    // The centres of column 8 lie on the outline, which belongs to the quad; half of each is beyond it.
    CHECK(Examiner(half_quad()).area_of_pixels() == 16 * 0.5);
    CHECK(Examiner(whole_quad()).area_of_pixels() == 0);
    const Findings right = examined(half_quad(), Method::zbuffer, "double");
    CHECK(right.wrong_pixels == 0);
    CHECK(right.area == 16 * 0.5);
}

TEST_CASE("Area: what of each pixel shows the colour that it has not, where an outline is slanted") {
    // The slanted edge goes from (0, 1) to (3, 0) and covers 5/6, 3/6 and 1/6 of the three pixels. The centre of the
    // second lies on it, so the first two are painted and the third is not: 1/6 + 3/6 + 1/6 have a wrong colour.
    const AdmittedScene scene = SceneBuilder({0, 0, 3, 1}).polygon({{0, 0, 0}, {3, 0, 0}, {0, 1, 0}}).build();
    CHECK(Examiner(scene).area_of_pixels() == doctest::Approx(5 / 6.).epsilon(1e-15));
    // All white: 5/6 + 3/6 + 1/6.
    CHECK(VisibleAreas(scene).wrong_in(Picture(scene->area, scene->background)) == doctest::Approx(1.5).epsilon(1e-15));
}

TEST_CASE("Area: polygons of one colour are one, a hidden one shows nothing, and a hole is its own") {
    // A quad of 2 x 2, a nearer one of 1/2 x 1/2 in the middle of a pixel in front of it, and one of 1 x 1 behind.
    const AdmittedScene scene =
        SceneBuilder({0, 0, 2, 2}).quad(0, 0, 2, 2, 0).quad(.25, .25, .75, .75, .5).quad(1, 1, 2, 2, -.5).build();
    Picture picture(scene->area, color_of(0));
    CHECK(VisibleAreas(scene).wrong_in(picture) == .25);
    picture.paint(0, 0, color_of(1));
    CHECK(VisibleAreas(scene).wrong_in(picture) == .75);
    picture.paint(1, 1, color_of(2));
    CHECK(VisibleAreas(scene).wrong_in(picture) == 1.75);
    Scene one_color = scene;
    for (auto& polygon : one_color.polygons) polygon.color = color_of(0);
    CHECK(VisibleAreas(admit(one_color)).wrong_in(Picture(scene->area, color_of(0))) == 0);
}

TEST_CASE("Operations: Weiler and Atherton's algorithm on one quad") {
    using enum Operation;
    // Cut to the area: its four edges lie outside, and those of the area inside it (which are not reported). Its
    // greatest depth is found at four vertices; a list of one; 16 rows, each examined above and below its centres.
    CHECK(examined(whole_quad(), Method::weiler_atherton, "double").operations ==
          counted({{windows, 1}, {depths, 4}, {orientations, 4}, {rows, 32}}));
}

TEST_CASE("Smallest window: one colour for the whole area, that of its centre") {
    // (8, 8) lies in the quad: seven columns and half of an eighth are wrong.
    const Findings found = examined(half_quad(), Method::warnock, "double", 16);
    CHECK(found.operations[std::size_t(Operation::windows)] == 1);
    CHECK(found.wrong_pixels == 16 * 7);
    CHECK(found.area == 16 * 7.5);
}

TEST_CASE("Depth error: depth 0 in a Z-buffer of two bits") {
    // 1/3 (depth_bits_test.cpp), in ulps of 2^-52.
    const Findings found = examined(whole_quad(), Method::zbuffer, "depth:2");
    CHECK(found.depth_ulps == doctest::Approx(std::ldexp(1 / 3., 52)));
    CHECK(examined(whole_quad(), Method::zbuffer, "exact").depth_ulps == 0);
    CHECK(examined(whole_quad(), Method::zbuffer, "double").depth_ulps == 0);
}

TEST_CASE("Depth error: a wall that is snapped to another place is as far off as its slope says") {
    // z = x / 64 - 1/256 at x = 0.25: on a grid of 1/2 pixel, 0.25 and 31.75 go up to 0.5 and 32, z stays. So the
    // snapped plane is lower by 0.25 / 64 everywhere, which is exact in doubles.
    const auto z = [](double x) { return x / 64 - 1 / 256.; };
    const AdmittedScene scene =
        SceneBuilder({0, 0, 32, 32}).polygon({{0.25, -1, z(0.25)}, {31.75, -1, z(31.75)}, {0.25, 33, z(0.25)}}).build();
    const SnappedScene snapped = snapped_scene(scene, 1);
    const Findings found = Examiner(scene).examine(
        {Method::zbuffer, *kernel_named("grid:1"), Edition::corrected, snapped.scene}, snapped.sources);
    CHECK(found.depth_ulps == doctest::Approx(std::ldexp(0.25 / 64, 52)).epsilon(1e-6));
}

TEST_CASE("Unsteady pixels are those that an ulp can change") {
    CHECK(Examiner(whole_quad()).unsteady_pixels() == 0);
    CHECK_MESSAGE(Examiner(half_quad()).unsteady_pixels() == 16, "the column of centres on the outline");
    const AdmittedScene tie = SceneBuilder(area_16).quad(-1, -1, 4.2, 17, 0).quad(-1, -1, 4.2, 17, 0).build();
    CHECK_MESSAGE(Examiner(tie).unsteady_pixels() == 4 * 16, "two polygons at one depth");
}

TEST_CASE("Cost in bits: operations times the bits of their numbers") {
    const SceneChart chart = charted(whole_quad());
    // 4 depths, 256 comparisons, 16 rows, 32 edges; and 26 operations of Warnock's algorithm.
    const auto cost_of = [&](Method method, const std::string& kernel) {
        for (const auto& run : chart.runs) {
            const auto& way = run.way;
            if (way.method == method && way.kernel.name() == kernel && way.edition == Edition::corrected &&
                way.knob != Knob::window) {
                return run.cost;
            }
        }
        FAIL("no such run");
        return Cost{};
    };
    CHECK(cost_of(Method::warnock, "double").operations == 26);
    CHECK(cost_of(Method::warnock, "double").bits == 26 * 53);
    CHECK(cost_of(Method::zbuffer, "float").bits == 308 * 24);
    CHECK(cost_of(Method::zbuffer, "bits:9").bits == 308 * 9);
    CHECK(cost_of(Method::zbuffer, "depth:9").bits == 52 * 53 + 256 * 9);
    CHECK_MESSAGE(cost_of(Method::zbuffer, "grid:3").bits == 308 * 8, "17 * 2^3 = 136 has 8 bits");
    CHECK_FALSE(cost_of(Method::zbuffer, "filtered").bits.has_value());
    CHECK_FALSE(cost_of(Method::zbuffer, "exact").bits.has_value());
}

TEST_CASE("The front: each of its runs is cheaper or less wrong than every other, and every other run is dominated" *
          doctest::skip(sanitized)) {
    const AdmittedScene scene = SceneBuilder(area_16)
                                    .polygon({{1.3, 2.1, -.5}, {14.9, 4.7, .5}, {6.2, 15.1, .2}})
                                    .polygon({{13.7, 1.2, -.3}, {2.9, 12.4, .6}, {15.3, 14.8, .1}})
                                    .build();
    const SceneChart chart = charted(scene);
    for (std::size_t cost = 0; cost < cost_axes.size(); ++cost) {
        for (std::size_t error = 0; error < error_axes.size(); ++error) {
            CAPTURE(cost_axes[cost].name);
            CAPTURE(error_axes[error].name);
            std::set<std::pair<double, double>> front;
            const auto place = [&](const ChartRun& run) {
                return std::pair(*cost_axes[cost].of(run), error_axes[error].of(run));
            };
            for (const auto& run : chart.runs) {
                if (run.on_front[cost][error]) front.insert(place(run));
            }
            REQUIRE_FALSE(front.empty());
            for (auto next = std::next(front.begin()); next != front.end(); ++next) {
                CHECK(std::prev(next)->first < next->first);
                CHECK(std::prev(next)->second > next->second);
            }
            for (const auto& run : chart.runs) {
                if (run.on_front[cost][error] || !run.found.complete || !cost_axes[cost].of(run)) continue;
                const auto beats = [own = place(run)](const auto& other) {
                    return other.first <= own.first && other.second <= own.second;
                };
                CHECK(std::any_of(front.begin(), front.end(), beats));
            }
        }
    }
}

TEST_CASE("A run that ended by a fault is on no front") {
    // The printed ShowLine divides by zero at the tip of a triangle; exact rationals have no infinity to continue with.
    const AdmittedScene scene = SceneBuilder(area_16).polygon({{2, 2, 0}, {14, 8, 0}, {4, 12, 0}}).build();
    int ended = 0;
    for (const auto& run : charted(scene).runs) {
        if (run.found.complete) continue;
        ++ended;
        CHECK(run.way.edition == Edition::printed);
        CHECK(run.way.kernel.name() == "exact");
        for (const auto& errors : run.on_front) CHECK(std::count(errors.begin(), errors.end(), true) == 0);
    }
    CHECK(ended == 1);
}

TEST_CASE("Pictures: each distinct one once, the right one first, as runs of equal pixels") {
    ScenePictures pictures(3, {white, white, blue, blue, white, white});
    CHECK(pictures.place_of({white, blue, blue, blue, white, white}) == 1);
    CHECK(pictures.place_of({white, white, blue, blue, white, white}) == 0);
    CHECK(json::parse(pictures.json()) ==
          json::parse(R"({"width": 3, "colors": ["#ffffff", "#0000ff"], "shown": [[2,0,2,1,2,0], [1,0,3,1,2,0]]})"));
}

TEST_CASE("A run's picture differs from the right one in its wrong pixels") {
    const AdmittedScene scene = SceneBuilder(area_16).polygon({{2, 2, 0}, {14, 8, 0}, {4, 12, 0}}).build();
    const json reported = json::parse(chart_json(std::vector<SceneChart>{charted(scene)}))["scenes"][0];
    const auto pixels_of = [&](std::size_t picture) {
        std::vector<int> pixels;
        const auto runs = reported["pictures"]["shown"][picture].get<std::vector<int>>();
        for (std::size_t i = 0; i < runs.size(); i += 2) pixels.insert(pixels.end(), std::size_t(runs[i]), runs[i + 1]);
        return pixels;
    };
    const auto right = pixels_of(0);
    REQUIRE(right.size() == 256);
    for (const json& run : reported["runs"]) {
        // Only the methods of the course are judged by the same picture.
        if (run["method"] != "zbuffer" && run["method"] != "warnock") continue;
        const auto own = pixels_of(run["picture"]);
        int wrong = 0;
        for (std::size_t i = 0; i < right.size(); ++i) wrong += own[i] == right[i] ? 0 : 1;
        CHECK(wrong == run["wrongPixels"].get<int>());
    }
}

TEST_CASE("JSON and CSV agree for any name of the scene") {
    Scene named = whole_quad();
    named.name = "a \"quad\", </script>\nand more";
    const AdmittedScene scene = admit(std::move(named));
    const std::vector<SceneChart> charts{charted(scene)};
    const json chart = json::parse(chart_json(charts));
    CHECK(chart["format"] == "vidno-chart/1");
    const json& reported = chart["scenes"][0];
    CHECK(reported["name"] == scene->name);
    CHECK(reported["kind"] == "ordinary");
    CHECK(reported["pixels"] == 256);
    CHECK(reported["scene"] == json::parse(scene_json(scene)));
    CHECK(reported["runs"].size() == ways_to_draw(scene).size());

    const json& first = reported["runs"][0];
    CHECK(first["method"] == "warnock");
    CHECK(first["kernel"] == "float");
    CHECK(first["knob"].is_null());
    CHECK(first["operations"] == 26);
    CHECK(first["counts"]["orientations"] == 16);

    std::istringstream csv(chart_csv(charts));
    std::string head, row;
    std::getline(csv, head);
    CHECK(head.rfind("scene.name,scene.kind,", 0) == 0);
    std::getline(csv, row);  // the name goes on in the next line
    CHECK(row == "\"a \"\"quad\"\", </script>");
    std::getline(csv, row);
    CHECK(row.rfind("and more\",\"ordinary\",0,256,1,0.0,\"warnock\",\"float\",\"corrected\",1,,,true,", 0) == 0);
}

TEST_CASE("The scenes of charts: ordinary and degenerate ones, and accuracy has a cost on each" *
          doctest::skip(sanitized)) {
    struct Example {
        std::string name;
        bool degenerate;
    };
    for (const Example& example : {Example{"close-walls", false}, Example{"crossing", false},
                                   Example{"far-away", false}, Example{"mesh", true}, Example{"one-plane", true}}) {
        CAPTURE(example.name);
        const std::string file = VIDNO_ROOT "/lessons/charts/" + example.name + ".json";
        const AdmittedScene scene = read_scene(read_file(file), file).scene;
        const Examiner examiner(scene);
        CHECK((examiner.unsteady_pixels() > 0) == example.degenerate);
        std::uint64_t fewer_operations = 0;
        std::uint64_t more_wrong = std::numeric_limits<std::uint64_t>::max();
        for (const int smallest_window : {32, 16, 8, 4}) {
            const Findings found = examined(scene, Method::warnock, "double", smallest_window);
            const auto operations = std::accumulate(found.operations.begin(), found.operations.end(), std::uint64_t{0});
            CHECK(operations > 2 * std::exchange(fewer_operations, operations));
            CHECK(found.wrong_pixels < std::exchange(more_wrong, found.wrong_pixels));
        }
        CHECK(examined(scene, Method::zbuffer, "filtered").wrong_pixels == 0);
    }
}
