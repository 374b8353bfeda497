// Each defect of the printed text of the Z-buffer with its witness: the corrected text passes where the printed one
// fails. The expected figures are computed beside the check.

#include <doctest/doctest.h>

#include "support/scenes.h"
#include "support/stage.h"
#include "support/visitors.h"

using namespace vidno;
using namespace vidno::test;

namespace {

template <class Set, class K>
HearFaults::Reported faults_of(const AdmittedScene& scene) {
    HearFaults::Reported reported;
    render<Set>(Method::zbuffer, scene, K{}, HearFaults(reported));
    return reported;
}

struct CountMisses : NoTrace {
    int* misses;
    explicit CountMisses(int& count) : misses(&count) {}
    void miss(Line at) { *misses += at == Line::L2 ? 1 : 0; }
};

template <class Set>
int rejected_lines(const AdmittedScene& scene) {
    int misses = 0;
    render<Set>(Method::zbuffer, scene, Double{}, CountMisses(misses));
    return misses;
}

}  // namespace

namespace {

template <class K>
void check_missing_partner(const AdmittedScene& scene) {
    const auto reported = faults_of<Printed, K>(scene);
    CHECK(reported.at == Line::Z14);
    CHECK(reported.reason == "the last entry of AEL has no partner");
    CHECK(faults_of<Corrected, K>(scene).count == 0);
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

TEST_CASE("X-Z2: a line outside the area is never rejected") {
    // 8 rows, all right of the area.
    const AdmittedScene scene = SceneBuilder(area_16).quad(20, 0, 30, 8, 0).build();
    CHECK(rejected_lines<Corrected>(scene) == 8);
    CHECK(rejected_lines<Printed>(scene) == 0);
}

TEST_CASE_TEMPLATE("X-Z3: the row and the column past the area are painted", K, VIDNO_PRINTED_KERNELS) {
    // y = 0 .. 4 and x = 0 .. 4 of a 4 x 4 area: 25 pixels, 9 of them outside. Row 0 is shown a second time, for the
    // level edge at its top; its fifth pixel is outside once more. On row 4 nothing but the level edge is left.
    const AdmittedScene scene = SceneBuilder({0, 0, 4, 4}).quad(0, 0, 4, 4, 0).build();
    CHECK(faults_of<Printed, K>(scene).count == 10);
    CHECK(faults_of<Printed, K>(scene).at == Line::L6);
    CHECK(faults_of<Corrected, K>(scene).count == 0);
}

namespace {

struct HearFirstSlope : NoTrace {
    std::optional<double>* reported;
    explicit HearFirstSlope(std::optional<double>& to) : reported(&to) {}
    void slope(Line, const auto& dz) {
        if (!*reported) *reported = as_double(dz);
    }
};

}  // namespace

TEST_CASE("X-Z4: the span of one point at a triangle's tip divides by zero") {
    const AdmittedScene scene = SceneBuilder(area_16).polygon({{8, 1, .5}, {12, 9, .5}, {4, 9, .5}}).build();
    std::optional<double> slope;
    render<Printed>(Method::zbuffer, scene, Double{}, HearFirstSlope(slope));
    REQUIRE(slope.has_value());
    CHECK_MESSAGE(std::isnan(*slope), "0 / 0");
    const auto exact = faults_of<Printed, Exact>(scene);
    CHECK(exact.at == Line::L3);
    CHECK(exact.reason == "division by zero");
    slope.reset();
    const AdmittedScene on_centre = SceneBuilder(area_16).polygon({{8.5, 1.5, .5}, {12, 9, .5}, {4, 9, .5}}).build();
    render(Method::zbuffer, on_centre, Double{}, HearFirstSlope(slope));
    CHECK_MESSAGE(slope == 0, "corrected: a span of one point has no slope");
}

TEST_CASE_TEMPLATE("X-Z5: a span starts at its end, not at a pixel centre", K, VIDNO_PRINTED_KERNELS) {
    // x = 1.75 and 2.75 fall into the pixels 1 and 2; of the centres only 2.5 lies between 1.75 and 3.25.
    const AdmittedScene scene = SceneBuilder({0, 0, 5, 3}).quad(1.75, .5, 3.25, 1.5, 0).build();
    const Picture printed = render<Printed>(Method::zbuffer, scene, K{});
    const Picture corrected = render(Method::zbuffer, scene, K{});
    CHECK(printed.at(1, 0) == color_of(0));
    CHECK(corrected.at(1, 0) == white);
    CHECK(corrected.at(2, 0) == color_of(0));
}

TEST_CASE("X-Z6: where doubles are 2 apart, y + 1 is y") {
    const double far = 9007199254740992;  // 2^53
    const AdmittedScene scene = SceneBuilder(area_16).quad(0, far, 16, far + 16, 0).build();
    const auto reported = faults_of<Printed, Double>(scene);
    CHECK(reported.at == Line::Z15);
    CHECK(faults_of<Corrected, Double>(scene).count == 0);
    CHECK_MESSAGE((faults_of<Printed, Exact>(scene).count == 0), "exact numbers get on");
}

TEST_CASE_TEMPLATE("X-Z7: the last polygon wins a tie", K, VIDNO_PRINTED_KERNELS) {
    const AdmittedScene scene = SceneBuilder(area_16).quad(2, 2, 10, 10, 0).quad(6, 6, 14, 14, 0).build();
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

TEST_CASE_TEMPLATE("X-Z8: an empty AEL has no least element, and the run goes on", K, VIDNO_PRINTED_KERNELS) {
    const AdmittedScene scene = SceneBuilder(area_16).quad(2.25, 2.25, 8.25, 8.25, 0).build();
    bool none = false;
    render<Printed>(Method::zbuffer, scene, K{}, LastNext(none));
    CHECK(none);
    none = false;
    render(Method::zbuffer, scene, K{}, LastNext(none));
    CHECK(none);
}

TEST_CASE("X-Z9: a depth of 1 that rounding raises is not drawn") {
    // z = 1/2 + i/12 in column i. Each of the six additions rounds to a multiple of 2^-53 or, from 1 on, of 2^-52.
    const AdmittedScene scene =
        SceneBuilder({0, 0, 7, 2}).polygon({{.5, .5, .5}, {6.5, .5, 1}, {6.5, 1.5, 1}, {.5, 1.5, .5}}).build();
    CHECK(render<Printed>(Method::zbuffer, scene, Double{}).at(5, 0) == color_of(0));
    CHECK(render<Printed>(Method::zbuffer, scene, Double{}).at(6, 0) == white);
    CHECK(render(Method::zbuffer, scene, Double{}).at(6, 0) == color_of(0));
    CHECK_MESSAGE((render<Printed>(Method::zbuffer, scene, Exact{}).at(6, 0) == color_of(0)),
                  "exactly 1 is not greater than 1");
}

TEST_CASE_TEMPLATE("The printed edition of the Z-buffer runs to its end on every scene", K, VIDNO_PRINTED_KERNELS) {
    RandomScenes random(7);
    int ended = 0;
    for (int i = 0; i < 60; ++i) {
        ended += int(render<Printed>(Method::zbuffer, random.scene(), K{}).pixels().size() > 0);
    }
    CHECK(ended == 60);
}
