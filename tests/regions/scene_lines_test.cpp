// The lines of a scene: which pieces of the outlines are visible. The places are computed by hand.

#include "regions/scene_lines.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "choice/kernel_choice.h"
#include "run/run.h"
#include "scene/scene_json.h"
#include "support/scenes.h"
#include "support/workplace.h"

using namespace vidno;

namespace {

SceneLines lines_of(const AdmittedScene& scene, const std::string& kernel = "exact") {
    std::vector<ShownRegion> regions;
    RunRequest request{Method::weiler_atherton, *kernel_named(kernel), Edition::corrected, scene};
    request.regions = &regions;
    run(request);
    return scene_lines(regions, scene);
}

/// The pieces from left to right, or from top to bottom, in order.
std::vector<LinePiece> in_order(std::vector<LinePiece> pieces) {
    for (auto& [from, to] : pieces) {
        if (to < from) std::swap(from, to);
    }
    std::sort(pieces.begin(), pieces.end(),
              [](const auto& a, const auto& b) { return std::pair(a.from, a.to) < std::pair(b.from, b.to); });
    return pieces;
}

}  // namespace

TEST_CASE("A square behind the corner of another one has two hidden pieces of edges") {
    // The far square goes from (4, 4) to (12, 12), the near one covers it up to (8, 8).
    const AdmittedScene scene = test::SceneBuilder(test::area_16).quad(0, 0, 8, 8, .5).quad(4, 4, 12, 12, .25).build();
    for (const char* kernel : {"exact", "double"}) {
        CAPTURE(kernel);
        const SceneLines lines = lines_of(scene, kernel);
        CHECK(in_order(lines.visible) == std::vector<LinePiece>{{{0, 0}, {0, 8}},
                                                                {{0, 0}, {8, 0}},
                                                                {{0, 8}, {8, 8}},
                                                                {{4, 8}, {4, 12}},
                                                                {{4, 12}, {12, 12}},
                                                                {{8, 0}, {8, 8}},
                                                                {{8, 4}, {12, 4}},
                                                                {{12, 4}, {12, 12}}});
        CHECK(in_order(lines.hidden) == std::vector<LinePiece>{{{4, 4}, {4, 8}}, {{4, 4}, {8, 4}}});
    }
}

TEST_CASE("A border between two regions of one polygon is no line of the scene") {
    // W rises to 1 at x = 12 and comes first. It cuts Q, at 3/4, along y = 2, but Q is in front: there W has x / 12 <
    // 3/4. So that piece of the edge of W is hidden, and the border of the two regions of Q along it is not drawn.
    const AdmittedScene scene = test::SceneBuilder(test::area_16)
                                    .polygon({{0, 2, 0}, {12, 2, 1}, {12, 10, 1}, {0, 10, 0}})
                                    .quad(2, 0, 4, 6, .75)
                                    .build();
    const SceneLines lines = lines_of(scene);
    CHECK(in_order(lines.hidden) == std::vector<LinePiece>{{{2, 2}, {4, 2}}});
    const auto is_visible = [&](const LinePiece& piece) {
        return std::count(lines.visible.begin(), lines.visible.end(), piece);
    };
    CHECK(is_visible({{2, 2}, {4, 2}}) == 0);
    CHECK(is_visible({{4, 2}, {2, 2}}) == 0);
    // The length of both outlines is 2 (12 + 8) + 2 (2 + 6) = 56.
    double length = 0;
    for (const auto& [from, to] : lines.visible) length += std::abs(to[0] - from[0]) + std::abs(to[1] - from[1]);
    CHECK(length == 56 - 2);
}

TEST_CASE("Polygons that pierce each other have a visible line where they meet") {
    // P at x / 16 and R at 1 - x / 16 on the same square: equal at x = 8.
    const AdmittedScene scene = test::SceneBuilder(test::area_16)
                                    .polygon({{0, 0, 0}, {16, 0, 1}, {16, 16, 1}, {0, 16, 0}})
                                    .polygon({{0, 0, 1}, {16, 0, 0}, {16, 16, 0}, {0, 16, 1}})
                                    .build();
    const SceneLines lines = lines_of(scene);
    const std::vector<LinePiece> visible = in_order(lines.visible);
    CHECK(std::count(visible.begin(), visible.end(), LinePiece{{8, 0}, {8, 16}}) == 1);
    CHECK_MESSAGE(lines.hidden.empty(), "each outline lies on the other");
}

TEST_CASE("render --lines: the hidden lines dashed or omitted, for visible regions alone") {
    const Workplace work;
    const std::string scene = VIDNO_ROOT "/lessons/14-weiler-atherton/scene.json";
    const auto drawn = [&](const std::string& options) {
        return program("render " + scene + " --method weiler-atherton --kernel exact " + options + " -o " +
                       work.file("lines.svg"));
    };
    REQUIRE(drawn("--lines dashed").status == 0);
    CHECK(work.read("lines.svg").find("stroke-dasharray") != std::string::npos);
    REQUIRE(drawn("--lines omitted").status == 0);
    CHECK(work.read("lines.svg").find("stroke-dasharray") == std::string::npos);
    const std::string only = "--lines: only for --method weiler-atherton, as .svg, .pdf or .tex";
    CHECK(program("render " + scene + " --lines dashed -o " + work.file("a.svg")).text.find(only) != std::string::npos);
    CHECK(
        program("render " VIDNO_ROOT "/lessons/15-floating-horizon/scene.json --lines dashed -o " + work.file("b.svg"))
            .text.find(only) != std::string::npos);
}

TEST_CASE("The parts of one face have no line where they meet, be they in front or hidden") {
    const std::string face = R"("vertices":[[0,0,0],[8,0,0],[8,4,0],[4,4,0],[4,8,0],[0,8,0]])";
    const auto scene_before = [&](const std::string& cover) {
        return read_scene(R"({"window":{"x":0,"y":0,"width":16,"height":16},"polygons":[{"id":"L",)" + face + "}" +
                              cover + "]}",
                          "f.json")
            .scene;
    };
    const auto length = [](const std::vector<LinePiece>& pieces) {
        double sum = 0;
        for (const auto& [from, to] : pieces) sum += std::hypot(to[0] - from[0], to[1] - from[1]);
        return sum;
    };
    const double outline = 8 + 4 + 4 + 4 + 4 + 8;
    for (const char* kernel : {"exact", "double"}) {
        CAPTURE(kernel);
        const SceneLines alone = lines_of(scene_before(""), kernel);
        CHECK(length(alone.visible) == outline);
        CHECK(alone.hidden.empty());
        const SceneLines covered =
            lines_of(scene_before(R"(,{"id":"Q","vertices":[[0,0,1],[9,0,1],[9,9,1],[0,9,1]]})"), kernel);
        CHECK(length(covered.visible) == 4 * 9);
        CHECK_MESSAGE(length(covered.hidden) == outline - 2 * 8, "two of its edges are on the square's outline");
    }
}
