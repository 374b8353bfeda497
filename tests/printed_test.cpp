// Each defect of the printed text with its witness: the corrected text passes where the printed one fails. The figures
// are those of an independent run in exact fractions, or are worked out beside the check. Where a defect is a rule of
// the set, a set with this one defect shows it alone.

#include <doctest/doctest.h>

#include "support/reference.h"
#include "support/scenes.h"
#include "support/stage.h"

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

Scene two_squares(bool near_first) {
    SceneBuilder builder(area_16);
    return near_first ? builder.polygon(near_square).polygon(far_quad).build()
                      : builder.polygon(far_quad).polygon(near_square).build();
}

template <class Set, class K>
int windows_of(const Scene& scene) {
    int windows = 0;
    render<Set>(Method::warnock, scene, K{}, CountWindows(windows));
    return windows;
}

template <class Set, class K>
int wrong_pixels(Method method, const Scene& scene) {
    return different_pixels(render<Set>(method, scene, K{}), Reference(scene).picture());
}

template <class Set, class K>
HearFaults::Heard faults_of(Method method, const Scene& scene) {
    HearFaults::Heard heard;
    render<Set>(method, scene, K{}, HearFaults(heard));
    return heard;
}

struct CountMisses : NoTrace {
    int* misses;
    explicit CountMisses(int& count) : misses(&count) {}
    void miss(Line at) { *misses += at == Line::L2 ? 1 : 0; }
};

template <class Set>
int rejected_lines(const Scene& scene) {
    int misses = 0;
    render<Set>(Method::zbuffer, scene, Double{}, CountMisses(misses));
    return misses;
}

}  // namespace

TEST_CASE_TEMPLATE("X-W1: polygons outside a window are never removed", K, VIDNO_PRINTED_KERNELS) {
    const Scene scene = two_squares(true);
    CHECK(windows_of<Corrected, K>(scene) == 149);
    CHECK(windows_of<OnlyXW1, K>(scene) == 261);
    CHECK_MESSAGE((wrong_pixels<OnlyXW1, K>(Method::warnock, scene) == 0), "the picture is the same");
}

TEST_CASE_TEMPLATE("X-W2: corner depths that start at 0 hide no polygon below", K, VIDNO_PRINTED_KERNELS) {
    // Every window is split: 1 + 4 + 16 + 64 + 256 = 341.
    const Scene scene = SceneBuilder(area_16).quad(-1, -1, 17, 17, -.5).quad(-1, -1, 17, 17, -.9).build();
    CHECK(windows_of<Corrected, K>(scene) == 1);
    CHECK(windows_of<OnlyXW2, K>(scene) == 341);
    CHECK(windows_of<Printed, K>(scene) == 341);
}

TEST_CASE_TEMPLATE("X-W3: a nearer polygon that does not surround is overlooked", K, VIDNO_PRINTED_KERNELS) {
    const Scene scene = two_squares(false);
    CHECK(wrong_pixels<Corrected, K>(Method::warnock, scene) == 0);
    CHECK(wrong_pixels<OnlyXW3, K>(Method::warnock, scene) == 64);
    CHECK(windows_of<OnlyXW3, K>(scene) == 1);
    CHECK(wrong_pixels<Printed, K>(Method::warnock, scene) == 64);
}

TEST_CASE("X-W4: the search for the first sign runs off the list") {
    // All three cross products are 0 as `double` computes them at (0, 0); the polygon is not edge-on.
    const Scene scene = SceneBuilder(area_16).polygon({{6.1, .61, 0}, {8.4, .8400000000000001, 0}, {2, .2, 0}}).build();
    REQUIRE_FALSE(scene.polygons[0].edge_on);
    Stage<Double> rounded(scene);
    CHECK_THROWS_AS(Printed::surround_test(rounded.run, rounded.point(0, 0), rounded.polygon()), Fault);
    CHECK_FALSE(Corrected::surround_test(rounded.run, rounded.point(0, 0), rounded.polygon()));
    Stage<Exact> exact(scene);
    CHECK_FALSE_MESSAGE(Printed::surround_test(exact.run, exact.point(0, 0), exact.polygon()), "not for exact signs");
}

TEST_CASE("X-W5: halving an area that is no power of two ends inside pixels") {
    const auto wrong = [](int side, auto set) {
        const Scene scene = SceneBuilder({0, 0, side, side})
                                .polygon(far_quad)
                                .polygon(near_square)
                                .polygon({{1, 1, .7}, {14, 2, .2}, {5, 13, .9}})
                                .build();
        return wrong_pixels<decltype(set), Exact>(Method::warnock, scene);
    };
    for (const int side : {16, 15, 10}) CHECK(wrong(side, Corrected{}) == 0);
    CHECK(wrong(16, OnlyXW5{}) == 0);
    CHECK(wrong(15, OnlyXW5{}) == 12);
    CHECK(wrong(10, OnlyXW5{}) == 5);
}

TEST_CASE_TEMPLATE("X-W6: a plane through collinear vertices is none", K, VIDNO_PRINTED_KERNELS) {
    const Scene scene =
        SceneBuilder({0, 0, 2, 2}).polygon({{0, 0, 0}, {1, 1, .125}, {2, 2, .25}, {0, 2, .875}}).build();
    const auto plane = Stage<K, Printed>(scene).polygon().plane;
    CHECK(plane.a == 0);
    CHECK(plane.b == 0);
    CHECK(plane.c == 0);
    CHECK(plane.d == 0);
    CHECK(render<Printed>(Method::warnock, scene, K{}) == Picture(scene.area, white));
    CHECK(render(Method::warnock, scene, K{}).at(0, 1) == color_of(0));
}

TEST_CASE("X-W7: the product of two small cross products underflows") {
    // At the window's left side the products are +-16e-170, their product -2.56e-338 is 0 in binary64.
    const Scene scene = SceneBuilder(area_16).quad(-1e-170, 1, 1e-170, 2, 0).build();
    const auto clipped = [&]<class Set>(Set) {
        Stage<Double, Set> stage(scene);
        return Set::polygon_clip(stage.run, stage.polygon(), Window{0, 0, 16, 16}).size();
    };
    CHECK(clipped(Corrected{}) == 4);
    CHECK_MESSAGE(clipped(Printed{}) == 2, "both crossings with the side are missed");
}

TEST_CASE("X-W8: a polygon exactly edge-on has a computed c that is not 0") {
    const Corners line{{2.3, 5.6, 0}, {4.3, 7.35, 1}, {6.3, 9.1, 0}};
    const Scene scene = SceneBuilder(area_16).polygon(line).build();
    REQUIRE(scene.polygons[0].edge_on);
    Stage<Double, Printed> stage(scene);
    CHECK(stage.polygon().plane.c != 0);
    CHECK(Printed::takes_part(stage.run, stage.polygon()));
    CHECK_FALSE(Corrected::takes_part(stage.run, stage.polygon()));
    CHECK_MESSAGE(std::abs(Printed::depth(stage.run, stage.polygon(), stage.point(0, 0))) > 1e9, "the depth explodes");
}

TEST_CASE_TEMPLATE("X-W9: one list for all windows", K, VIDNO_PRINTED_KERNELS) {
    const Scene scene = two_squares(false);
    CHECK(windows_of<OnlyXW9, K>(scene) == 13);
    CHECK(wrong_pixels<OnlyXW9, K>(Method::warnock, scene) == 64);
}

namespace {

template <class K>
void check_missing_partner(const Scene& scene) {
    const auto heard = faults_of<Printed, K>(Method::zbuffer, scene);
    CHECK(heard.at == Line::Z14);
    CHECK(heard.reason == "the last entry of AEL has no partner");
    CHECK(faults_of<Corrected, K>(Method::zbuffer, scene).count == 0);
}

}  // namespace

// On the scanline 5.2 the edge from (12, 5.3) has entered and the one to it has not left: three entries.

TEST_CASE_TEMPLATE("X-Z1: edges enter by rounded y and leave by unrounded y", K, Float, Double) {
    check_missing_partner<K>(SceneBuilder(area_16).polygon({{2, 1.2, .5}, {12, 5.3, .5}, {3, 9.4, .5}}).build());
}

TEST_CASE_TEMPLATE("X-Z1: the same with a level top, where no division by zero comes first", K, VIDNO_PRINTED_KERNELS) {
    check_missing_partner<K>(
        SceneBuilder(area_16).polygon({{2, 1.2, .5}, {4, 1.2, .5}, {12, 5.3, .5}, {3, 9.4, .5}}).build());
}

TEST_CASE("X-Z2: a line beside the area is never rejected") {
    // 8 rows, all right of the area.
    const Scene scene = SceneBuilder(area_16).quad(20, 0, 30, 8, 0).build();
    CHECK(rejected_lines<Corrected>(scene) == 8);
    CHECK(rejected_lines<Printed>(scene) == 0);
}

TEST_CASE_TEMPLATE("X-Z3: the row and the column past the area are painted", K, VIDNO_PRINTED_KERNELS) {
    // y = 0 .. 4 and x = 0 .. 4 of a 4 x 4 area: 25 pixels, 9 of them outside. Row 0 is shown a second time, for the
    // level edge at its top; its fifth pixel is outside once more. On row 4 nothing but the level edge is left.
    const Scene scene = SceneBuilder({0, 0, 4, 4}).quad(0, 0, 4, 4, 0).build();
    CHECK(faults_of<Printed, K>(Method::zbuffer, scene).count == 10);
    CHECK(faults_of<Printed, K>(Method::zbuffer, scene).at == Line::L6);
    CHECK(faults_of<Corrected, K>(Method::zbuffer, scene).count == 0);
}

namespace {

struct HearFirstSlope : NoTrace {
    std::optional<double>* heard;
    explicit HearFirstSlope(std::optional<double>& to) : heard(&to) {}
    void slope(Line, const auto& dz) {
        if (!*heard) *heard = as_double(dz);
    }
};

}  // namespace

TEST_CASE("X-Z4: the span of one point at a triangle's tip divides by zero") {
    const Scene scene = SceneBuilder(area_16).polygon({{8, 1, .5}, {12, 9, .5}, {4, 9, .5}}).build();
    std::optional<double> slope;
    render<Printed>(Method::zbuffer, scene, Double{}, HearFirstSlope(slope));
    REQUIRE(slope.has_value());
    CHECK_MESSAGE(std::isnan(*slope), "0 / 0");
    const auto exact = faults_of<Printed, Exact>(Method::zbuffer, scene);
    CHECK(exact.at == Line::L3);
    CHECK(exact.reason == "division by zero");
    slope.reset();
    const Scene on_centre = SceneBuilder(area_16).polygon({{8.5, 1.5, .5}, {12, 9, .5}, {4, 9, .5}}).build();
    render(Method::zbuffer, on_centre, Double{}, HearFirstSlope(slope));
    CHECK_MESSAGE(slope == 0, "corrected: a span of one point has no slope");
}

TEST_CASE_TEMPLATE("X-Z5: a span starts at its end, not at a pixel centre", K, VIDNO_PRINTED_KERNELS) {
    // x = 1.75 and 2.75 fall into the pixels 1 and 2; of the centres only 2.5 lies between 1.75 and 3.25.
    const Scene scene = SceneBuilder({0, 0, 5, 3}).quad(1.75, .5, 3.25, 1.5, 0).build();
    const Picture printed = render<Printed>(Method::zbuffer, scene, K{});
    const Picture corrected = render(Method::zbuffer, scene, K{});
    CHECK(printed.at(1, 0) == color_of(0));
    CHECK(corrected.at(1, 0) == white);
    CHECK(corrected.at(2, 0) == color_of(0));
}

TEST_CASE("X-Z6: where doubles are 2 apart, y + 1 is y") {
    const double far = 9007199254740992;  // 2^53
    const Scene scene = SceneBuilder(area_16).quad(0, far, 16, far + 16, 0).build();
    const auto heard = faults_of<Printed, Double>(Method::zbuffer, scene);
    CHECK(heard.at == Line::Z15);
    CHECK(faults_of<Corrected, Double>(Method::zbuffer, scene).count == 0);
    CHECK_MESSAGE((faults_of<Printed, Exact>(Method::zbuffer, scene).count == 0), "exact numbers get on");
}

TEST_CASE_TEMPLATE("X-Z7: the last polygon wins a tie", K, VIDNO_PRINTED_KERNELS) {
    const Scene scene = SceneBuilder(area_16).quad(2, 2, 10, 10, 0).quad(6, 6, 14, 14, 0).build();
    const Picture warnock = render(Method::warnock, scene, K{});
    CHECK(render(Method::zbuffer, scene, K{}) == warnock);
    CHECK(warnock.at(8, 8) == color_of(0));
    CHECK(render<Printed>(Method::zbuffer, scene, K{}).at(8, 8) == color_of(1));
}

namespace {

struct LastNext : NoTrace {
    bool* none;
    explicit LastNext(bool& to) : none(&to) {}
    template <class Next>
    void ael_drop(Line, const auto&, const Next& next) {
        if constexpr (std::is_same_v<Next, int>) {
            *none = next == no_row;
        } else {
            *none = !next.has_value();
        }
    }
};

}  // namespace

TEST_CASE_TEMPLATE("X-Z8: of an empty AEL there is no least element, and the run goes on", K, VIDNO_PRINTED_KERNELS) {
    const Scene scene = SceneBuilder(area_16).quad(2.25, 2.25, 8.25, 8.25, 0).build();
    bool none = false;
    render<Printed>(Method::zbuffer, scene, K{}, LastNext(none));
    CHECK(none);
    none = false;
    render(Method::zbuffer, scene, K{}, LastNext(none));
    CHECK(none);
}

TEST_CASE_TEMPLATE("The printed edition runs to its end on every scene", K, VIDNO_PRINTED_KERNELS) {
    RandomScenes random(7);
    int ended = 0;
    for (int i = 0; i < 60; ++i) {
        const Scene scene = random.scene();
        for (const Method method : {Method::warnock, Method::zbuffer}) {
            ended += int(render<Printed>(method, scene, K{}).pixels().size() > 0);
        }
    }
    CHECK(ended == 120);
}
