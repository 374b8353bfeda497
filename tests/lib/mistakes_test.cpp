// The usual mistakes: each paints its witness of the atlas wrong, as computed here by hand, paints the scenes that it
// does not affect right, and ends on every scene.

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "check/check.h"
#include "output.h"
#include "scene/scene_json.h"
#include "support/reference.h"
#include "support/scenes.h"
#include "support/stage.h"
#include "support/visitors.h"
#include "vidno/mistakes/line_for_edge.h"

using namespace vidno;
using namespace vidno::test;

namespace {

std::vector<Deviation> all_mistakes() {
    std::vector<Deviation> mistakes;
    for (std::size_t i = 0; i < deviations.size(); ++i) {
        if (is_mistake(Deviation(i))) mistakes.push_back(Deviation(i));
    }
    return mistakes;
}

/// The picture that the mistake paints, by a method and under a kernel that run it.
void for_each_picture(Deviation mistake, const AdmittedScene& scene, auto&& look) {
    int looked = 0;
    for (std::size_t place = 0; place < method_names.size(); ++place) {
        const auto method = Method(place);
        for (const std::string kernel : {"double", "exact"}) {
            const NamedKernel named = *kernel_named(kernel);
            if (!named.choice->runs(method, mistake)) continue;
            CAPTURE(kernel);
            CAPTURE(int(method));
            look(run({method, named, mistake, scene}), RunRequest{method, named, Edition::corrected, scene});
            ++looked;
        }
    }
    CHECK(looked == 2 * int(choice_of(mistake).methods.size()));
}

/// The entry of the atlas.
nlohmann::json entry_of(std::string_view name) {
    return nlohmann::json::parse(read_file(VIDNO_ROOT "/lessons/failures/mistake-" + std::string(name) + ".json"));
}

AdmittedScene witness(std::string_view name) {
    return read_scene(entry_of(name)["scene"].dump(), std::string(name)).scene;
}

/// A pixel and the polygon that is painted there; none: the background.
struct Wrong {
    int x, y;
    std::string shown;
};

Color color_of(const AdmittedScene& scene, const std::string& id) {
    const auto of_id = [&](const auto& polygon) { return polygon.id == id; };
    const auto found = std::find_if(scene->polygons.begin(), scene->polygons.end(), of_id);
    return found == scene->polygons.end() ? scene->background : found->color;
}

/// Checks that the witness is right except at these pixels.
void check_witness(Deviation mistake, std::initializer_list<Wrong> wrong) {
    const std::string name(choice_of(mistake).mistake);
    CAPTURE(name);
    const AdmittedScene scene = witness(name);
    const Picture right = Reference(scene).picture();
    Picture expected = right;
    for (const auto& [x, y, shown] : wrong) expected.paint(x, y, color_of(scene, shown));
    REQUIRE(different_pixels(expected, right) == wrong.size());
    for_each_picture(mistake, scene, [&](const Picture& painted, const RunRequest& corrected) {
        CHECK(painted == expected);
        CHECK(run(corrected) == right);
    });
}

void check_harmless(Deviation mistake, const AdmittedScene& scene) {
    const Picture right = Reference(scene).picture();
    REQUIRE(right != Picture(scene->area, scene->background));
    for_each_picture(mistake, scene, [&](const Picture& painted, const auto&) { CHECK(painted == right); });
}

template <class Set>
int windows_of(const AdmittedScene& scene) {
    int count = 0;
    render<Set>(Set::methods.front(), scene, Exact{}, CountWindows(count));
    return count;
}

/// They overlap; all their coordinates are whole.
AdmittedScene two_squares(double first_z, double second_z) {
    return SceneBuilder(area_16).quad(1, 1, 9, 9, first_z).quad(5, 5, 14, 14, second_z).build();
}

}  // namespace

TEST_CASE("One list: a polygon that the first part removes is missing in the last") {
    // The lower right one of the four windows of 1 x 1 is on top of the stack. A ends at x = 0.75, left of it, and
    // leaves the list. It holds the centre (1/2, 1/2): its side passes there at x = 3/4 (1 - 1/4) = 9/16.
    check_witness(Deviation::one_list, {{0, 0, ""}});
}

TEST_CASE("One list: a window that is not split has no siblings") {
    check_harmless(Deviation::one_list, SceneBuilder(area_16).polygon({{1, 2, 0}, {15, 4, 1}, {6, 13, 0}}).build());
}

TEST_CASE("Depths not cleared: a polygon behind z = 0 never shows") {
    // z = x - 1: -1/2 at the centre of the first pixel, 1/2 at that of the second.
    check_witness(Deviation::depths_not_cleared, {{0, 0, ""}});
    // z = 0 itself is not nearer than 0.
    const AdmittedScene level = SceneBuilder({0, 0, 1, 1}).quad(0, 0, 1, 1, 0).build();
    for_each_picture(Deviation::depths_not_cleared, level,
                     [&](const Picture& painted, const auto&) { CHECK(painted.at(0, 0) == level->background); });
}

TEST_CASE("Depths not cleared: a polygon in front of z = 0 shows") {
    check_harmless(Deviation::depths_not_cleared, two_squares(.25, .5));
}

TEST_CASE("Clip order reversed: a polygon that reaches over the window is clipped away") {
    // x / 4 + y / 2 <= 1 holds for the centres (1/2, 1/2), (3/2, 1/2) and (1/2, 3/2).
    check_witness(Deviation::clip_order_reversed, {{0, 0, ""}, {1, 0, ""}, {0, 1, ""}});
}

TEST_CASE("Clip order reversed: a polygon inside the window is not clipped") {
    check_harmless(Deviation::clip_order_reversed,
                   SceneBuilder(area_16).polygon({{1, 2, 0}, {15, 4, 1}, {6, 13, 0}}).build());
}

TEST_CASE("y flipped: row 0 is at the bottom") {
    // The centre (1/2, 1/2) is held; upside down (0, 2), (2, 2), (0, 1) holds (1/2, 3/2).
    check_witness(Deviation::y_flipped, {{0, 0, ""}, {0, 1, "A"}});
    // The picture is flipped about the middle of the area: y becomes 20 + 24 - y.
    const AdmittedScene moved = SceneBuilder({7, 20, 3, 4}).quad(7, 20, 9, 21, 0).build();
    for_each_picture(Deviation::y_flipped, moved, [&](const Picture& painted, const auto&) {
        CHECK(painted == Reference(SceneBuilder({7, 20, 3, 4}).quad(7, 23, 9, 24, 0).build()).picture());
    });
}

TEST_CASE("y flipped: a picture that is its own mirror image stays") {
    check_harmless(Deviation::y_flipped, SceneBuilder(area_16).polygon({{1, 8, 0}, {14, 2, .5}, {14, 14, .5}}).build());
}

TEST_CASE("Depth sign reversed: the farther one shows") {
    check_witness(Deviation::depth_sign_reversed, {{0, 0, "A"}});
}

TEST_CASE("Depth sign reversed: without an overlap depths do not matter, nor do equal ones") {
    check_harmless(Deviation::depth_sign_reversed,
                   SceneBuilder(area_16).quad(1, 1, 5, 5, 1).quad(6, 6, 9, 9, -1).build());
    check_harmless(Deviation::depth_sign_reversed, two_squares(.5, .5));
}

TEST_CASE("Boundary outside: the centre on a shared edge belongs to neither polygon") {
    // x + y = 1 at (1/2, 1/2).
    check_witness(Deviation::boundary_outside, {{0, 0, ""}});
}

TEST_CASE("Boundary outside: no centre lies on an outline of whole coordinates along the axes") {
    check_harmless(Deviation::boundary_outside, two_squares(.25, .5));
}

TEST_CASE("Boundary outside: a shared edge along a row is a row of holes by both methods") {
    // Both squares have the side from (2, 5 1/2) to (9, 5 1/2): the centres of columns 2 to 8 of row 5 lie on it. Those
    // of row 6 lie inside the lower one alone.
    const AdmittedScene scene = SceneBuilder(area_16).quad(2, 1, 9, 5.5, 0).quad(2, 5.5, 9, 9, 0).build();
    for_each_picture(Deviation::boundary_outside, scene, [&](const Picture& painted, const auto&) {
        for (int x = 2; x < 9; ++x) {
            CHECK(painted.at(x, 4) == scene->polygons[0].color);
            CHECK(painted.at(x, 5) == scene->background);
            CHECK(painted.at(x, 6) == scene->polygons[1].color);
        }
    });
}

TEST_CASE("Integer division: only two of three columns are examined") {
    // 3 / 2 = 1: the windows are those of columns 0 and 1. B holds (5/2, 1/2).
    check_witness(Deviation::integer_division, {{2, 0, ""}});
    // The window on its side: of 1 x 3 pixels the last is lost, and the run ends.
    const AdmittedScene upright =
        SceneBuilder({0, 0, 1, 3}).polygon({{0, 0, 0}, {2, 0, 0}, {0, 1, 0}}).quad(0, 2, 1, 3, 0).build();
    for_each_picture(Deviation::integer_division, upright, [&](const Picture& painted, const auto&) {
        CHECK(painted.at(0, 0) == upright->polygons[0].color);
        CHECK(painted.at(0, 2) == upright->background);
    });
}

TEST_CASE("Integer division: the halves of a power of two are whole") {
    check_harmless(Deviation::integer_division, two_squares(.25, .5));
    check_harmless(Deviation::integer_division,
                   SceneBuilder({3, -2, 8, 2}).quad(4, -2, 6, 0, 0).quad(5, -1, 9, 0, 1).build());
}

TEST_CASE("Surround kept: a nearer polygon inside the window is overlooked") {
    // B holds the centre, 1/4 + 1/2 < 1, and not the corner (1, 1).
    check_witness(Deviation::surround_kept, {{0, 0, "A"}});
}

TEST_CASE("Surround kept: with the near polygon first the picture is right") {
    check_harmless(Deviation::surround_kept, SceneBuilder(area_16).polygon(near_square).polygon(far_quad).build());
}

TEST_CASE("Vertex counted twice: a polygon that a ray leaves through a vertex counts as outside") {
    // The ray from (1/2, 1/2) meets the outline of A only in the vertex (3, 1/2), and pierces it there. The outline
    // surrounds the window: at x = 1 it is at y = -1/4 and y = 5/4.
    check_witness(Deviation::vertex_counted_twice, {{0, 0, ""}});
}

TEST_CASE("Vertex counted twice: a ray that only crosses edges, or touches a vertex, is counted right") {
    // The heights of vertices are not multiples of 1/2; those of all windows' centres are.
    check_harmless(Deviation::vertex_counted_twice,
                   SceneBuilder(area_16).quad(-1, -1.25, 17, 17.25, 0).quad(2, 3.75, 12, 9.25, .5).build());
    // From the centre (4, 4) of the upper left quarter the ray touches the vertex of the triangle, (12, 4).
    check_harmless(Deviation::vertex_counted_twice, SceneBuilder(area_16)
                                                        .quad(-1, -1.25, 17, 17.25, 0)
                                                        .polygon({{12, 4, .5}, {15.25, 9.25, .5}, {6.25, 10.75, .5}})
                                                        .build());
}

TEST_CASE("Octants not split: a polygon around a corner counts as surrounding") {
    // The edge from (1, -1) to (-1, 1) passes through the corner (0, 0), with A beyond it.
    check_witness(Deviation::octants_not_split, {{0, 0, "A"}});
}

TEST_CASE("Octants not split: edges along the axes are never seen under half of a full angle") {
    check_harmless(Deviation::octants_not_split, two_squares(.25, .5));
}

TEST_CASE("Line for edge: windows are split in vain, and the picture is right") {
    // The line y = x + 1 passes through the window from (0, 1) to (1, 2); the edge of B on it ends at (0, 1). With both
    // polygons the window is split into its four pixels; A alone would be drawn at once.
    check_witness(Deviation::line_for_edge, {});
    const AdmittedScene scene = witness("line-for-edge");
    CHECK(windows_of<mistakes::LineForEdge>(scene) == 1 + 4);
    CHECK(windows_of<family::Full>(scene) == 1);
}

TEST_CASE(
    "Every mistake has a witness in the atlas, wrong at its pixel by each method and kernel that can make the "
    "mistake") {
    for (const Deviation mistake : all_mistakes()) {
        const std::string_view name = choice_of(mistake).mistake;
        CAPTURE(name);
        const bool is_of_variant = is_family(choice_of(mistake).methods.front());
        CHECK_MESSAGE(choice_of(mistake).advice.english.empty() == is_of_variant, "students write no variant");
        const auto entry = entry_of(name);
        const AdmittedScene scene = witness(name);
        const Picture right = Reference(scene).picture();
        CHECK(entry["fails"]["edition"] == name);
        CHECK(entry["holds"]["edition"] == "corrected");
        for_each_picture(mistake, scene, [&](const Picture& painted, const RunRequest& corrected) {
            CHECK(run(corrected) == right);
            if (!entry["shows"].contains("pixel")) return;
            const int x = entry["shows"]["pixel"][0], y = entry["shows"]["pixel"][1];
            CHECK(painted.at(x, y) != right.at(x, y));
        });
    }
}

TEST_CASE("Every mistake ends on every scene, and its trace agrees with its picture") {
    RandomScenes random(20261122);
    std::map<Deviation, int> differing, harmless;
    for (int i = 0; i < 40; ++i) {
        CAPTURE(i);
        const AdmittedScene scene = random.scene();
        const Picture right = Reference(scene).picture();
        for (const Deviation mistake : all_mistakes()) {
            CAPTURE(choice_of(mistake).mistake);
            for_each_picture(mistake, scene, [&](const Picture& painted, RunRequest request) {
                request.edition = mistake;
                CHECK(check_run(request, right).picture == painted);
                ++(painted == right ? harmless : differing)[mistake];
            });
        }
    }
    for (const Deviation mistake : all_mistakes()) {
        CAPTURE(choice_of(mistake).mistake);
        const bool costs_time_alone = entry_of(choice_of(mistake).mistake)["shows"].contains("more_windows");
        CHECK_MESSAGE((differing[mistake] > 0) != costs_time_alone, "it is seen on some");
        CHECK_MESSAGE(harmless[mistake] > 0, "and not on others");
    }
}
