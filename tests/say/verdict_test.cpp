// The verdict on a run: what it claims, and that it claims exactness only after a comparison.

#include "say/verdict.h"

#include <doctest/doctest.h>

#include "support/curves.h"
#include "support/scenes.h"

using namespace vidno;
using namespace vidno::say;

namespace {

using enum Comparison::Is;

TraceHeader header_of(Method method, Edition edition = Edition::corrected) {
    const AdmittedScene scene =
        test::SceneBuilder(test::area_16).polygon(test::far_quad).polygon(test::near_square).build();
    return {method, edition, "double", Detail::signs, scene};
}

Tally tally_with(std::size_t event, std::uint64_t count) {
    Tally tally{};
    tally[event] = count;
    return tally;
}

std::string said(const AnyHeader& header, const Tally& tally, const Comparison& comparison,
                 Language language = Language::english) {
    return verdict(header, tally, comparison, language);
}

const Tally windows = tally_with(event_place<event::Pop>, 21);

}  // namespace

TEST_CASE("a verdict says whether a picture is right only if it was compared") {
    const TraceHeader header = header_of(Method::warnock);
    CHECK(said(header, windows, {}) == "Finished: 256 pixels, not compared with exact arithmetic; 21 windows.");
    CHECK(said(header, windows, {awaited}) ==
          "Finished: 256 pixels, being compared with exact arithmetic; 21 windows…");
    CHECK(said(header, windows, {known, 0}) == "Finished: 256 pixels, all as in exact arithmetic; 21 windows.");
    CHECK(said(header, windows, {known, 1}) == "Finished: 256 pixels, 1 differs from exact arithmetic; 21 windows.");
    CHECK(said(header, windows, {known, 3}, Language::russian) ==
          "Готово: 256 пикселей, не как в точной арифметике: 3; 21 окно.");
}

TEST_CASE("a verdict on a text that is not the corrected one blames no arithmetic") {
    CHECK(said(header_of(Method::warnock, Edition::printed), windows, {known, 2}) ==
          "Finished: 256 pixels, 2 differ from the correct picture; 21 windows.");
}

TEST_CASE("where polygons share a colour, a verdict is about colours") {
    TraceHeader header = header_of(Method::zbuffer);
    header.scene.polygons[1].color = header.scene.polygons[0].color;
    CHECK(said(header, tally_with(event_place<event::Pixel>, 1), {known, 0}) ==
          "Finished: 256 pixels, all colours as in exact arithmetic; 1 depth comparison.");
}

TEST_CASE("a verdict counts the first of the things that a method does") {
    Tally tally = tally_with(event_place<event::Show>, 2);
    tally[event_place<event::Behind>] = 5;
    CHECK(said(header_of(Method::weiler_atherton), tally, {}, Language::russian) ==
          "Готово: 256 пикселей, с точной арифметикой не сверено; 2 видимые области.");
    CHECK(said(header_of(Method::zbuffer, Edition::corrected), {}, {}) ==
          "Finished: 256 pixels, not compared with exact arithmetic.");
}

TEST_CASE("a verdict on curves is about decisions") {
    FloatingHorizonHeader header{
        Edition::corrected, "double", Detail::signs,
        Surface{"Curves", test::CurveSceneBuilder({0, 0, 4, 4}).curve({{0, 1}, {3, 2}}).build()}};
    const Tally curves = tally_with(event_place<event::Curve>, 8);
    CHECK(said(header, curves, {known, 0}) == "Finished: 8 curves; every decision as in exact arithmetic.");
    CHECK(said(header, curves, {known, 1}) == "Finished: 8 curves; wrong decisions at 1 step.");
    CHECK(said(header, curves, {known, 2}, Language::russian) == "Готово: 8 кривых; шагов с неверными решениями: 2.");
    header.edition = Edition::printed;
    CHECK(said(header, curves, {known, 0}) ==
          "Finished: 8 curves; every decision as in exact arithmetic, but this is not the corrected text.");
}
