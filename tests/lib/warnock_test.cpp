// The seven Warnock procedures on cases computed by hand, over all kernels. The numbers are short binary fractions, so
// that `float` and `double` round nothing and must agree with `exact`.

#include <doctest/doctest.h>

#include <set>

#include "support/scenes.h"
#include "support/stage.h"
#include "support/visitors.h"

using namespace vidno;
using namespace vidno::test;

namespace {

// z = (x + y) / 16 over the triangle below the diagonal.
const Corners tilted_triangle{{0, 0, 0}, {8, 0, .5}, {0, 8, .5}};

AdmittedScene scene_of(const Corners& vertices, Area area = area_16) {
    return SceneBuilder(area).polygon(vertices).build();
}

std::array<double, 4> coefficients(const auto& plane) {
    return {as_double(plane.a), as_double(plane.b), as_double(plane.c), as_double(plane.d)};
}

std::set<std::array<double, 3>> as_set(const auto& vertices) {
    std::set<std::array<double, 3>> found;
    for (const auto& v : vertices) {
        found.insert({as_double(v.x), as_double(v.y), as_double(v.z)});
    }
    return found;
}

}  // namespace

TEST_CASE_TEMPLATE("SurroundTest: inside, on the outline, outside, either way round", K, VIDNO_KERNELS) {
    for (const bool reversed : {false, true}) {
        CAPTURE(reversed);
        Corners square{{2, 2, 0}, {6, 2, 0}, {6, 6, 0}, {2, 6, 0}};
        if (reversed) std::reverse(square.begin(), square.end());
        Stage<K> stage(scene_of(square));
        const auto holds = [&](double x, double y) {
            return Corrected::surround_test(stage.run, stage.point(x, y), stage.polygon());
        };
        CHECK(holds(3, 5));
        CHECK_MESSAGE(holds(2, 4), "on an edge");
        CHECK_MESSAGE(holds(6, 6), "on a vertex");
        CHECK_FALSE(holds(1, 4));
        CHECK_FALSE_MESSAGE(holds(1, 2), "on the line of an edge, beyond it");
        CHECK_FALSE(holds(6.125, 6));
    }
}

TEST_CASE_TEMPLATE("SurroundTest: collinear and repeated vertices change nothing", K, VIDNO_KERNELS) {
    Stage<K> stage(scene_of({{2, 2, 0}, {4, 2, 0}, {6, 2, 0}, {6, 2, 0}, {6, 6, 0}, {2, 6, 0}}));
    const auto holds = [&](double x, double y) {
        return Corrected::surround_test(stage.run, stage.point(x, y), stage.polygon());
    };
    CHECK(holds(4, 2));
    CHECK(holds(4, 4));
    CHECK_FALSE(holds(7, 2));
}

TEST_CASE_TEMPLATE("SurroundTest: a polygon without area holds nothing", K, VIDNO_KERNELS) {
    Stage<K> stage(scene_of({{2, 2, 0}, {6, 6, 0}, {4, 4, 1}}));
    CHECK_FALSE(Corrected::surround_test(stage.run, stage.point(4, 4), stage.polygon()));
    CHECK_FALSE(Corrected::surround_test(stage.run, stage.point(9, 9), stage.polygon()));
}

TEST_CASE_TEMPLATE("InitializePolygon: the plane of a triangle", K, VIDNO_KERNELS) {
    // u = (8, 0, 1/2), v = (0, 8, 1/2): u x v = (0 - 4, 0 - 4, 64), and d = 0 since the plane holds the origin.
    Stage<K> stage(scene_of(tilted_triangle));
    CHECK(coefficients(stage.polygon().plane) == std::array<double, 4>{-4, -4, 64, 0});
}

TEST_CASE_TEMPLATE("InitializePolygon: collinear first vertices do not matter", K, VIDNO_KERNELS) {
    // The unit square at z = x / 4 with a vertex in the middle of its first edge: normal (-1/4, 0, 1) times 2 areas 2.
    Stage<K> stage(scene_of({{0, 0, 0}, {.5, 0, .125}, {1, 0, .25}, {1, 1, .25}, {0, 1, 0}}));
    CHECK(coefficients(stage.polygon().plane) == std::array<double, 4>{-.5, 0, 2, 0});
}

TEST_CASE_TEMPLATE("Depth: on the plane, inside the polygon and outside it", K, VIDNO_KERNELS) {
    Stage<K> stage(scene_of(tilted_triangle));
    const auto depth = [&](double x, double y) {
        return as_double(stage.run.kernel.finite(Corrected::depth(stage.run, stage.polygon(), stage.point(x, y))));
    };
    CHECK(depth(0, 0) == 0);
    CHECK(depth(2, 2) == .25);
    CHECK(depth(16, 16) == 2);
    CHECK(depth(-8, 4) == -.25);
}

TEST_CASE_TEMPLATE("PolygonClip: a window cuts three corners off a triangle", K, VIDNO_KERNELS) {
    // Left of 1, above 1, right of 5 and below 5 go; the diagonal x + y = 8 meets x = 5 at y = 3 and y = 5 at x = 3.
    Stage<K> stage(scene_of(tilted_triangle));
    const auto clipped = Corrected::polygon_clip(stage.run, stage.polygon(), Window{1, 1, 4, 4});
    const std::set<std::array<double, 3>> expected{{1, 1, .125}, {5, 1, .375}, {5, 3, .5}, {3, 5, .5}, {1, 5, .375}};
    CHECK(as_set(clipped) == expected);
}

TEST_CASE_TEMPLATE("PolygonClip: a polygon that touches the window stays, one that lies apart vanishes", K,
                   VIDNO_KERNELS) {
    Stage<K> stage(scene_of(tilted_triangle));
    CHECK(Corrected::polygon_clip(stage.run, stage.polygon(), Window{9, 9, 2, 2}).empty());
    CHECK(Corrected::polygon_clip(stage.run, stage.polygon(), Window{-4, -4, 16, 16}).size() == 3);
    const auto corner = Corrected::polygon_clip(stage.run, stage.polygon(), Window{8, 0, 2, 2});
    REQUIRE_FALSE(corner.empty());
    for (const auto& vertex : corner) {
        CHECK(as_double(vertex.x) == 8);
        CHECK(as_double(vertex.y) == 0);
    }
}

TEST_CASE_TEMPLATE("PolygonClip: clipping twice is clipping once", K, VIDNO_KERNELS) {
    const Window window{1, 1, 4, 4};
    Stage<K> stage(scene_of(tilted_triangle));
    const auto once = Corrected::polygon_clip(stage.run, stage.polygon(), window);
    auto polygon = stage.polygon();
    polygon.vertices.clear();
    for (const auto& v : once) {
        polygon.vertices.push_back(stage.run.kernel.vertex({as_double(v.x), as_double(v.y), as_double(v.z)}));
    }
    const auto again = Corrected::polygon_clip(stage.run, polygon, window);
    REQUIRE(again.size() == once.size());
    for (std::size_t i = 0; i < again.size(); ++i) {
        CHECK(as_double(again[i].x) == as_double(once[i].x));
        CHECK(as_double(again[i].y) == as_double(once[i].y));
    }
}

TEST_CASE_TEMPLATE("FillPolygon: the rows of a triangle, its outline included", K, VIDNO_KERNELS) {
    // Row j has its centre at y = j + 1/2 and ends at x = 8 - y = 7.5 - j: itself a centre, so column 7 - j is painted.
    Stage<K> stage(scene_of(tilted_triangle));
    const auto runs = Corrected::fill_polygon(stage.run, stage.polygon().vertices);
    REQUIRE(runs.size() == 8);
    for (int row = 0; row < 8; ++row) CHECK(runs[std::size_t(row)] == PixelRun{row, 0, 8 - row});
}

TEST_CASE_TEMPLATE("FillPolygon: rows and columns are cut at the area", K, VIDNO_KERNELS) {
    Stage<K> stage(scene_of({{-5, -5, 0}, {50, -5, 0}, {50, 50, 0}, {-5, 50, 0}}, {2, 3, 4, 2}));
    const auto runs = Corrected::fill_polygon(stage.run, stage.polygon().vertices);
    CHECK(runs == std::vector<PixelRun>{{3, 2, 6}, {4, 2, 6}});
    CHECK_MESSAGE(Corrected::fill_polygon(stage.run, typename K::Outline{}).empty(), "no vertices, no runs");
}

TEST_CASE_TEMPLATE("PointColor: the nearest, the first of equals, or the background", K, VIDNO_KERNELS) {
    Stage<K> stage(SceneBuilder(area_16)
                       .polygon("far", red, {{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}})
                       .polygon("near", green, {{4, 4, .5}, {12, 4, .5}, {12, 12, .5}, {4, 12, .5}})
                       .polygon("equal", blue, {{6, 6, .5}, {14, 6, .5}, {14, 14, .5}, {6, 14, .5}})
                       .build());
    const auto active = stage.all_active();
    const auto color = [&](double x, double y) { return Corrected::point_color(stage.run, stage.point(x, y), active); };
    CHECK(color(2, 2) == red);
    CHECK(color(5, 5) == green);
    CHECK_MESSAGE(color(7, 7) == green, "equal depths: the first in the scene");
    CHECK(color(13, 13) == blue);
    CHECK(color(15.5, .5) == white);
}

TEST_CASE_TEMPLATE("ProcessWindow: outside leaves, surrounding is marked and hides", K, VIDNO_KERNELS) {
    Stage<K> stage(SceneBuilder(area_16).polygon(far_quad).polygon(near_square).quad(13, 13, 15, 15, .9).build());
    SUBCASE("the window inside the near square: it hides the far quad, the third is outside") {
        auto active = stage.all_active();
        const auto found = Corrected::process_window(stage.run, Window{5, 5, 2, 2}, active);
        CHECK(found.polygon_count == 2);
        CHECK(found.has_surround);
        CHECK(found.color == stage.polygon(1).color);
        REQUIRE(active.size() == 2);
        CHECK(active[0].surrounding);
        CHECK(active[1].surrounding);
    }
    SUBCASE("a window that touches the square's outline from outside still counts it") {
        auto active = stage.all_active();
        const auto found = Corrected::process_window(stage.run, Window{0, 4, 4, 4}, active);
        CHECK(found.polygon_count == 2);
        CHECK_FALSE_MESSAGE(found.has_surround, "the square is nearer at all corners and does not surround");
        CHECK(active[0].surrounding);
        CHECK_FALSE(active[1].surrounding);
    }
    SUBCASE("the order of the list does not matter to the surrounding one") {
        auto active = stage.all_active();
        std::swap(active[0], active[1]);
        CHECK(Corrected::process_window(stage.run, Window{5, 5, 2, 2}, active).color == stage.polygon(1).color);
    }
}

TEST_CASE_TEMPLATE("ProcessWindow: a single polygon inside the window", K, VIDNO_KERNELS) {
    Stage<K> stage(SceneBuilder(area_16).polygon(near_square).build());
    const auto insider = [&](const Window& window) {
        auto active = stage.all_active();
        return Corrected::process_window(stage.run, window, active).insider;
    };
    CHECK(insider({0, 0, 16, 16}));
    CHECK_FALSE_MESSAGE(insider({4, 0, 12, 16}), "touching the side is not strictly inside");
}

TEST_CASE_TEMPLATE("Warnock: the near square before the far quad", K, VIDNO_KERNELS) {
    // An independent run of the procedure in exact fractions counted 149 windows (procedures' table, X-W1).
    const AdmittedScene scene = SceneBuilder(area_16).polygon(near_square).polygon(far_quad).build();
    int windows = 0;
    const Picture picture = render(Method::warnock, scene, K{}, CountWindows(windows));
    CHECK(windows == 149);
    for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 16; ++x) {
            const bool near = 4 <= x && x < 12 && 4 <= y && y < 12;
            CHECK(picture.at(x, y) == color_of(near ? 0 : 1));
        }
    }
}

TEST_CASE("Warnock: a smallest window above the pixel gets the colour of its centre") {
    Stage<Double> stage(SceneBuilder(area_16).polygon(near_square).polygon(far_quad).build());
    stage.run.smallest_window = 16;
    Corrected::warnock(stage.run);
    // The centre (8, 8) of the one window lies in the near square.
    for (const Color& pixel : stage.picture.pixels()) CHECK(pixel == color_of(0));
}

TEST_CASE_TEMPLATE("Warnock: one window for a scene without polygons or with one over all", K, VIDNO_KERNELS) {
    int windows = 0;
    CHECK(render(Method::warnock, SceneBuilder(area_16).build(), K{}, CountWindows(windows)) ==
          Picture(area_16, white));
    CHECK(windows == 1);
    windows = 0;
    const AdmittedScene covered = SceneBuilder(area_16).polygon(far_quad).build();
    CHECK(render(Method::warnock, covered, K{}, CountWindows(windows)) == Picture(area_16, color_of(0)));
    CHECK(windows == 1);
}

TEST_CASE_TEMPLATE("Warnock: depths below 0 hide like others", K, VIDNO_KERNELS) {
    // The nearer quad surrounds the first window and is nearest at its corners: nothing is split (X-W2: 1 window).
    const AdmittedScene scene = SceneBuilder(area_16).quad(-1, -1, 17, 17, -.5).quad(-1, -1, 17, 17, -.9).build();
    int windows = 0;
    CHECK(render(Method::warnock, scene, K{}, CountWindows(windows)) == Picture(area_16, color_of(0)));
    CHECK(windows == 1);
}
