// Each defect of the printed text of Warnock's algorithm with its witness: the corrected text passes where the printed
// one fails. The expected figures come from an independent run in exact fractions, or are computed beside the check.
// Where a defect is a rule of the set, a set with this one defect shows it alone.

#include <doctest/doctest.h>

#include "support/reference.h"
#include "support/scenes.h"
#include "support/stage.h"
#include "support/visitors.h"

using namespace vidno;
using namespace vidno::test;

namespace {

struct OnlyXW1 : Corrected {
    static bool discards(bool surrounding, bool outside) { return Printed::discards(surrounding, outside); }
};
struct OnlyXW2 : Corrected {
    static auto first_corner_depth(const auto& kernel) { return Printed::first_corner_depth(kernel); }
};
struct OnlyXW3 : Corrected {
    static bool uncovers(int k) { return Printed::uncovers(k); }
};
struct OnlyXW5 : Corrected {
    static Window root_window(const Area& area) { return Printed::root_window(area); }
};
struct OnlyXW9 : Corrected {
    static auto list_for_part(const auto& list) { return Printed::list_for_part(list); }
};

AdmittedScene two_squares(bool near_first) {
    SceneBuilder builder(area_16);
    return near_first ? builder.polygon(near_square).polygon(far_quad).build()
                      : builder.polygon(far_quad).polygon(near_square).build();
}

template <class Set, class K>
int windows_of(const AdmittedScene& scene) {
    int windows = 0;
    render<Set>(Method::warnock, scene, K{}, CountWindows(windows));
    return windows;
}

template <class Set, class K>
int wrong_pixels(const AdmittedScene& scene) {
    return different_pixels(render<Set>(Method::warnock, scene, K{}), Reference(scene).picture());
}

}  // namespace

TEST_CASE_TEMPLATE("X-W1: polygons outside a window are never removed", K, VIDNO_PRINTED_KERNELS) {
    const AdmittedScene scene = two_squares(true);
    CHECK(windows_of<Corrected, K>(scene) == 149);
    CHECK(windows_of<OnlyXW1, K>(scene) == 261);
    CHECK_MESSAGE((wrong_pixels<OnlyXW1, K>(scene) == 0), "the picture is the same");
}

TEST_CASE_TEMPLATE("X-W2: corner depths that start at 0 hide no polygon below", K, VIDNO_PRINTED_KERNELS) {
    // Every window is split: 1 + 4 + 16 + 64 + 256 = 341.
    const AdmittedScene scene = SceneBuilder(area_16).quad(-1, -1, 17, 17, -.5).quad(-1, -1, 17, 17, -.9).build();
    CHECK(windows_of<Corrected, K>(scene) == 1);
    CHECK(windows_of<OnlyXW2, K>(scene) == 341);
    CHECK(windows_of<Printed, K>(scene) == 341);
}

TEST_CASE_TEMPLATE("X-W3: a nearer polygon that does not surround is overlooked", K, VIDNO_PRINTED_KERNELS) {
    const AdmittedScene scene = two_squares(false);
    CHECK(wrong_pixels<Corrected, K>(scene) == 0);
    CHECK(wrong_pixels<OnlyXW3, K>(scene) == 64);
    CHECK(windows_of<OnlyXW3, K>(scene) == 1);
    CHECK(wrong_pixels<Printed, K>(scene) == 64);
}

TEST_CASE("X-W4: the search for the first sign runs past the end of the list") {
    // All three cross products are 0 as `double` computes them at (0, 0); the polygon is not edge-on.
    const AdmittedScene scene =
        SceneBuilder(area_16).polygon({{6.1, .61, 0}, {8.4, .8400000000000001, 0}, {2, .2, 0}}).build();
    REQUIRE_FALSE(scene->polygons[0].edge_on);
    Stage<Double> rounded(scene);
    CHECK_THROWS_AS(Printed::surround_test(rounded.run, rounded.point(0, 0), rounded.polygon()), Fault);
    CHECK_FALSE(Corrected::surround_test(rounded.run, rounded.point(0, 0), rounded.polygon()));
    Stage<Exact> exact(scene);
    CHECK_FALSE_MESSAGE(Printed::surround_test(exact.run, exact.point(0, 0), exact.polygon()), "not for exact signs");
}

TEST_CASE("X-W5: halving an area that is no power of two ends inside pixels") {
    const auto wrong = [](int side, auto set) {
        const AdmittedScene scene = SceneBuilder({0, 0, side, side})
                                        .polygon(far_quad)
                                        .polygon(near_square)
                                        .polygon({{1, 1, .7}, {14, 2, .2}, {5, 13, .9}})
                                        .build();
        return wrong_pixels<decltype(set), Exact>(scene);
    };
    for (const int side : {16, 15, 10}) CHECK(wrong(side, Corrected{}) == 0);
    CHECK(wrong(16, OnlyXW5{}) == 0);
    CHECK(wrong(15, OnlyXW5{}) == 12);
    CHECK(wrong(10, OnlyXW5{}) == 5);
}

TEST_CASE_TEMPLATE("X-W6: three collinear vertices give no plane", K, VIDNO_PRINTED_KERNELS) {
    const AdmittedScene scene =
        SceneBuilder({0, 0, 2, 2}).polygon({{0, 0, 0}, {1, 1, .125}, {2, 2, .25}, {0, 2, .875}}).build();
    const auto plane = Stage<K, Printed>(scene).polygon().plane;
    CHECK(plane.a == 0);
    CHECK(plane.b == 0);
    CHECK(plane.c == 0);
    CHECK(plane.d == 0);
    CHECK(render<Printed>(Method::warnock, scene, K{}) == Picture(scene->area, white));
    CHECK(render(Method::warnock, scene, K{}).at(0, 1) == color_of(0));
}

TEST_CASE("X-W7: the product of two small cross products underflows") {
    // At the window's left side the products are +-16e-170, their product -2.56e-338 is 0 in binary64.
    const AdmittedScene scene = SceneBuilder(area_16).quad(-1e-170, 1, 1e-170, 2, 0).build();
    const auto clipped = [&]<class Set>(Set) {
        Stage<Double, Set> stage(scene);
        return Set::polygon_clip(stage.run, stage.polygon(), Window{0, 0, 16, 16}).size();
    };
    CHECK(clipped(Corrected{}) == 4);
    CHECK_MESSAGE(clipped(Printed{}) == 2, "both crossings with the side are missed");
}

TEST_CASE("X-W8: a polygon exactly edge-on has a computed c that is not 0") {
    const Corners line{{2.3, 5.6, 0}, {4.3, 7.35, 1}, {6.3, 9.1, 0}};
    const AdmittedScene scene = SceneBuilder(area_16).polygon(line).build();
    REQUIRE(scene->polygons[0].edge_on);
    Stage<Double, Printed> stage(scene);
    CHECK(stage.polygon().plane.c != 0);
    CHECK(Printed::takes_part(stage.run, stage.polygon()));
    CHECK_FALSE(Corrected::takes_part(stage.run, stage.polygon()));
    CHECK_MESSAGE(std::abs(Printed::depth(stage.run, stage.polygon(), stage.point(0, 0))) > 1e9, "the depth explodes");
}

TEST_CASE_TEMPLATE("X-W9: one list for all windows", K, VIDNO_PRINTED_KERNELS) {
    const AdmittedScene scene = two_squares(false);
    CHECK(windows_of<OnlyXW9, K>(scene) == 13);
    CHECK(wrong_pixels<OnlyXW9, K>(scene) == 64);
}

TEST_CASE_TEMPLATE("The printed edition of Warnock's algorithm runs to its end on every scene", K,
                   VIDNO_PRINTED_KERNELS) {
    RandomScenes random(7);
    int ended = 0;
    for (int i = 0; i < 60; ++i) {
        ended += int(render<Printed>(Method::warnock, random.scene(), K{}).pixels().size() > 0);
    }
    CHECK(ended == 60);
}
