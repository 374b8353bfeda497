// Surfaces: reading them, and the places of their samples.

#include "scene/surface.h"

#include <doctest/doctest.h>

#include <cmath>

#include "output.h"
#include "refused.h"
#include "scene/sampling.h"
#include "support/curves.h"
#include "support/places.h"

using namespace vidno;
using namespace vidno::test;

namespace {

/// x and y are columns and rows of the screen: a level line is the function 0 at the height 20.
FunctionSurface seen_from_the_front(HeightFunction function, int columns, int samples) {
    FunctionSurface surface;
    surface.function = std::move(function);
    surface.left = 0;
    surface.right = columns;
    surface.curves = 2;
    surface.samples = samples;
    surface.view = {.origin = {0, 20}, .across = {columns, 0}, .back = {0, 0}, .up = 1};
    return surface;
}

/// 0 but for one column, where it is 10.
HeightFunction peak_at(int column) {
    return [column](double x, double) { return x == column ? 10 : 0; };
}

std::vector<int> columns_of(const Curve& curve) {
    std::vector<int> columns;
    for (const auto& sample : curve.samples) columns.push_back(sample.x);
    return columns;
}

bool is_on(const Curve& curve, int column, double y) {
    return std::any_of(curve.samples.begin(), curve.samples.end(),
                       [&](const Sample& sample) { return sample.x == column && sample.y == y; });
}

/// The y of the sample on a column, which must exist.
double row_over(const Curve& curve, int column) {
    const auto found = std::find_if(curve.samples.begin(), curve.samples.end(),
                                    [&](const Sample& sample) { return sample.x == column; });
    REQUIRE(found != curve.samples.end());
    return found->y;
}

std::string refusal_of(const std::string& text) {
    try {
        read_surface(text, "s.json");
    } catch (const Refused& refused) {
        return refused.what();
    }
    return "taken";
}

/// A small surface of a function, and the same with one part of its text replaced.
const std::string small = R"({"format":"vidno-surface/1","window":{"x":0,"y":0,"width":20,"height":16},)"
                          R"("function":"x + z","x":[0,4],"z":[2,0],"curves":3,"samples":5,)"
                          R"("view":{"origin":[1,12],"across":[8,4],"back":[2,-1],"up":0.5}})";
std::string changed(std::string text, const std::string& from, const std::string& to) {
    const auto at = text.find(from);
    REQUIRE(at != text.npos);
    return text.replace(at, from.size(), to);
}

}  // namespace

TEST_CASE("Surface: a function becomes curves on whole columns") {
    // Over a column i of 8 x is i / 2. The left end of curve k is at (1 + 2 k, 12 - k); to the right the curve goes
    // down by 4 / 8 a column; half a pixel upward is one of y, and z is 2, 1, 0: 12 - k + i / 2 - (i / 2 + 2 - k) / 2.
    const Surface surface = read_surface(small, "s.json");
    REQUIRE(surface.curves->curves.size() == 3);
    for (int k = 0; k < 3; ++k) {
        std::vector<Sample> expected;
        for (int i = 0; i <= 8; i += 2) expected.push_back({1 + 2 * k + i, 11 - k / 2. + i / 4.});
        CHECK(surface.curves->curves[std::size_t(k)].samples == expected);
        CHECK(on_columns(surface.curves->curves[std::size_t(k)], surface.curves->area));
    }
}

TEST_CASE("Surface: samples stand on the nearest columns when they do not go evenly") {
    // 10 columns in 4 parts: 0, 2.5, 5, 7.5, 10.
    const auto surface = seen_from_the_front([](double, double) { return 0; }, 10, 5);
    CHECK(columns_of(sampled(surface)[0]) == std::vector{0, 3, 5, 8, 10});
}

TEST_CASE("Surface: a peak narrower than the step is missed, and found where samples are denser") {
    auto surface = seen_from_the_front(peak_at(5), 16, 3);
    CHECK_MESSAGE((columns_of(sampled(surface)[0]) == std::vector{0, 8, 16}), "plain sampling sees a level line");
    CHECK_FALSE(is_on(sampled(surface)[0], 5, 10));
    // Intervals that contain the peak are halved: 0..8, 4..8, 4..6; level ones never.
    surface.tolerance = 0.25;
    const auto curves = sampled(surface);
    CHECK(columns_of(curves[0]) == std::vector{0, 4, 5, 6, 8, 16});
    CHECK(is_on(curves[0], 5, 10));
    CHECK(sample_count({{}, curves}) == 12);
}

TEST_CASE("Surface: denser samples find a peak on any column, and are no more than needed") {
    for (int peak = 0; peak <= 64; ++peak) {
        CAPTURE(peak);
        auto surface = seen_from_the_front(peak_at(peak), 64, 3);
        surface.tolerance = 0.25;
        const Curve curve = sampled(surface)[0];
        CHECK(is_on(curve, peak, 10));
        CHECK(curve.samples.size() <=
              3 + 2 * 5);  // 32 columns are halved five times on the way to one, from both its sides
    }
}

TEST_CASE("Surface: with a tolerance no column is farther off than that, and each has at most one sample") {
    const auto wave = [](double x, double) { return 10 * std::sin(x * x / 400); };  // quicker to the right
    auto surface = seen_from_the_front(wave, 200, 6);
    std::size_t last = 0;
    for (const double tolerance : {4., 1., 0.25, 0.01, 1e-9}) {
        CAPTURE(tolerance);
        surface.tolerance = tolerance;
        const Curve curve = sampled(surface)[0];
        for (int x = 0; x <= 200; ++x) {
            const double exactly = CGAL::to_double(FloatingHorizonReference::height(curve, x));
            CHECK(std::abs(exactly - (20 - wave(x, 0))) <= tolerance + 1e-12);
        }
        CHECK(curve.samples.size() > last);
        last = curve.samples.size();
    }
    CHECK(last == 201);
}

TEST_CASE("Surface: a surface that is written and read again is the same") {
    const Surface surface = read_surface(small, "s.json");
    CHECK(read_surface(surface_json(surface), "again") == surface);
    const Surface given{
        "g", CurveSceneBuilder({-3, 0, 8, 8}).curve({{-3, 0.1}, {4, -1e300}}).curve({{0, 5}, {1, 6}, {2, 5}}).build()};
    CHECK(surface_json(given) ==
          R"({"format":"vidno-surface/1","name":"g","window":{"x":-3,"y":0,"width":8,"height":8},)"
          R"("curves":[[[-3,0.1],[4,-1e+300]],[[0,5],[1,6],[2,5]]]})");
    CHECK(read_surface(surface_json(given), "again") == given);
}

namespace {

/// The columns of each piece of each curve.
using PieceColumns = std::vector<std::vector<std::vector<int>>>;
PieceColumns columns_of_pieces(const CurveScene& scene) {
    PieceColumns found;
    for (const Curve& curve : scene.curves) {
        found.emplace_back();
        for (const Piece& piece : pieces_of(curve)) {
            found.back().emplace_back();
            for (const Sample& sample : piece) found.back().back().push_back(sample.x);
        }
    }
    return found;
}

/// x and z at -2, -1, 0, 1 and 2. The left end of curve k is over column k, and the samples are two columns apart.
std::string over_five_by_five(const std::string& function) {
    return R"({"function":")" + function + R"(","x":[-2,2],"z":[2,-2],"curves":5,"samples":5,)" +
           R"("view":{"origin":[0,12],"across":[8,0],"back":[1,-1],"up":1}})";
}
const std::string half_ball = "sqrt(4 - x^2 - z^2)";

}  // namespace

TEST_CASE("Surface: where the function is not finite, the curve has a gap") {
    // At z = 2 and -2 only x = 0 is in the half ball, at 1 and -1 x from -sqrt(3) to sqrt(3), at 0 all of them.
    const Surface surface = read_surface(over_five_by_five(half_ball), "s.json");
    CHECK(columns_of_pieces(surface.curves) == PieceColumns{{}, {{3, 5, 7}}, {{2, 4, 6, 8, 10}}, {{5, 7, 9}}, {}});
    const auto& samples = surface.curves->curves[1].samples;
    CHECK(samples[2].y == doctest::Approx(12 - 1 - std::sqrt(3.)));
    CHECK(samples[3].y == doctest::Approx(12 - 1 - std::sqrt(2.)));
    CHECK(
        gaps_in_words(surface.curves) ==
        "gaps: no finite height at 12 of 25 samples, first at curve 0, column 0; 2 samples between gaps are not drawn");
    CHECK(column_count(surface.curves) == 5 + 9 + 5);
    CHECK_MESSAGE((surface.curves->area == Area{0, 7, 13, 6}),
                  "columns 0 to 4 + 8, heights from 12 - 3 - sqrt(3) to 12");
}

TEST_CASE("Surface: sin(r) / r has a gap at r = 0, where it is not defined, and a formula can close it") {
    const std::string r = "sqrt(x^2 + z^2)";
    const Surface surface = read_surface(over_five_by_five("sin(" + r + ") / " + r), "s.json");
    CHECK(
        columns_of_pieces(surface.curves) ==
        PieceColumns{{{0, 2, 4, 6, 8}}, {{1, 3, 5, 7, 9}}, {{2, 4}, {8, 10}}, {{3, 5, 7, 9, 11}}, {{4, 6, 8, 10, 12}}});
    CHECK(gaps_in_words(surface.curves) == "gaps: no finite height at 1 of 25 samples, first at curve 2, column 6");
    const Surface closed = read_surface(over_five_by_five("x == 0 && z == 0 ? 1 : sin(" + r + ") / " + r), "s.json");
    CHECK(gaps_in_words(closed.curves).empty());
    CHECK(row_over(closed.curves->curves[2], 6) == 12 - 2 - 1);
}

TEST_CASE("Surface: with a tolerance a gap begins and ends on the right columns") {
    // Over column c of 16 x is c / 4 - 2. At z = 1 the half ball reaches to sqrt(3), and 1.5 < sqrt(3) < 1.75: columns
    // 2 to 14.
    FunctionSurface surface = seen_from_the_front(height_function(half_ball), 16, 3);
    surface.left = -2;
    surface.right = 2;
    surface.nearest = surface.farthest = 1;
    CHECK(columns_of_pieces({{}, sampled(surface)}) == PieceColumns{{}, {}});
    for (const double tolerance : {100., 1., 0.01}) {
        CAPTURE(tolerance);
        surface.tolerance = tolerance;
        for (const Curve& curve : sampled(surface)) {
            const auto pieces = pieces_of(curve);
            REQUIRE(pieces.size() == 1);
            CHECK(pieces.front().front().x == 2);
            CHECK(pieces.front().back().x == 14);
        }
    }
    // A gap of one column, between samples on both sides of it.
    surface.function = [](double x, double) { return x == 0.25 ? std::nan("") : 0; };
    surface.tolerance = 1;
    CHECK(columns_of_pieces({{}, {sampled(surface)[0]}}) == PieceColumns{{{0, 8}, {10, 12, 16}}});
}

TEST_CASE("Surface: a sample without a y is null, and a curve with gaps is read again as it was written") {
    const std::string text = R"({"format":"vidno-surface/1","name":"","window":{"x":0,"y":0,"width":9,"height":9},)"
                             R"("curves":[[[0,null],[1,2],[3,2.5],[4,null],[6,1],[8,1]],[[0,null],[8,null]]]})";
    const Surface surface = read_surface(text, "s.json");
    CHECK(columns_of_pieces(surface.curves) == PieceColumns{{{1, 3}, {6, 8}}, {}});
    CHECK(surface_json(surface) == text);
    CHECK(gaps_in_words(surface.curves) == "gaps: no finite height at 4 of 8 samples, first at curve 0, column 0");
    const Surface dome = read_surface(over_five_by_five(half_ball), "s.json");
    CHECK(read_surface(surface_json(dome), "again") == dome);
}

TEST_CASE("Surface: a bad file is refused with the place and the reason") {
    const auto refused = [](const std::string& from, const std::string& to) {
        return without_places(refusal_of(changed(small, from, to)));
    };
    CHECK(without_places(refusal_of("[]")) == "s.json: not an object");
    CHECK(refused("surface/1", "scene/1") == "s.json: /format: not \"vidno-surface/1\"");
    CHECK(refused("\"curves\"", "\"planes\"") == "s.json: \"curves\" is missing\ns.json: /planes: unknown key");
    CHECK(refused("x + z", "x + y") == "s.json: /function: y: the formula gives its value; there are x, z, pi and e");
    CHECK(refused("x + z", "x #\\n") == "s.json: /function: #: not understood");
    CHECK(refused("\"x + z\"", "5") == "s.json: /function: not a string");
    CHECK(refused("x + z", "sqrt(-1 - x^2)") == "s.json: /function: not finite at any sample");
    CHECK(refused("[0,4]", "[4,4]") == "s.json: /x: the two numbers are equal");
    CHECK(refused("\"curves\":3", "\"curves\":1") == "s.json: /curves: not from 2 to 4096");
    CHECK(refused("\"samples\":5", "\"samples\":10") == "s.json: /samples: not from 2 to 9");
    CHECK(refused("[1,12]", "[0.5,12]") == "s.json: /view/origin/0: not a whole number");
    CHECK(refused("0.5}", "0}") == "s.json: /view/up: not greater than 0");
    CHECK(refused("[1,12]", "[8,12]") ==
          "s.json: /view: curve 2 is over the columns 12 to 20, and the window has 0 to 19");

    const auto curves = [](const std::string& text) {
        return without_places(refusal_of(
            R"({"format":"vidno-surface/1","window":{"x":0,"y":0,"width":9,"height":9},"curves":)" + text + "}"));
    };
    CHECK(curves("[]") == "taken");
    CHECK(curves("[[[0,1]]]") == "s.json: /curves/0: fewer than two samples");
    CHECK(curves("[[[0,1],[0,2]]]") == "s.json: /curves/0/1/0: not right of the sample before");
    CHECK(curves("[[[0,1],[9,2]]]") == "s.json: /curves/0/1/0: not from 0 to 8");
    CHECK(curves("[[[0,1],[2]]]") == "s.json: /curves/0/1: not a column and a y");
    CHECK(curves("[[[0,1],[2,\"nan\"]]]").starts_with("s.json: /curves/0/1/1: not a hexadecimal number"));
    CHECK(curves("[[[0,null],[2,null]],[[0,null],[1,null]]]") == "s.json: /curves: no sample has a y");
}

TEST_CASE("Surface: format, name and window have defaults") {
    const Surface drawn = read_surface(R"({"curves": [[[-2, 0.5], [3, 4]], [[0, 7.25], [1, 7]]]})", "s.json");
    CHECK(drawn.name.empty());
    CHECK_MESSAGE((drawn.curves->area == Area{-2, 0, 6, 8}), "columns -2 to 3, heights from 1/2 to 7 1/4");
    // The curves of `small` are over the columns 1 to 13; they go from the row 10, at the farthest one's left end, down
    // to the row 13.
    const std::string window = R"("window":{"x":0,"y":0,"width":20,"height":16},)";
    const Surface of_function = read_surface(changed(small, window, ""), "s.json");
    CHECK(of_function.curves->area == Area{1, 10, 13, 4});
    CHECK(of_function.curves->curves == read_surface(small, "s.json").curves->curves);
    CHECK(read_function(changed(small, window, ""), "s.json").area == Area{1, 10, 13, 4});
    CHECK(without_places(refusal_of(R"({"curves": []})")) ==
          "s.json: \"window\" is missing, and there are no samples to derive it from");
}

TEST_CASE("Surface: one pass reports every fault with line, column and path") {
    CHECK(refusal_of("{\"window\": {\"x\": 0, \"y\": 0, \"width\": 9, \"height\": 0},\n"
                     " \"curves\": [\n"
                     "  [[0, 1], [0, 2]],\n"
                     "  [[0, 1], 7, [3, \"x\"]]\n"
                     " ]}") ==
          "s.json: line 1, column 51: /window/height: not from 1 to 16384\n"
          "s.json: line 3, column 13: /curves/0/1/0: not right of the sample before\n"
          "s.json: line 4, column 12: /curves/1/1: not an array\n"
          "s.json: line 4, column 19: /curves/1/2/1: not a hexadecimal number such as \"0x1.8p-3\"");
    CHECK(without_places(refusal_of(changed(changed(small, "[0,4]", "4"), "0.5}", "0}"))) ==
          "s.json: /x: not an array\ns.json: /view/up: not greater than 0");
}

TEST_CASE("Surface: the text's figure has a pit in its middle, and a wave around it") {
    const std::string file = VIDNO_ROOT "/lessons/surfaces/waves-and-pit.json";
    const Surface surface = read_surface(read_file(file), file);
    REQUIRE(surface.curves->curves.size() == 41);
    // In the middle of curve 20, x = z = pi, a = 0: y = sin(pi) cos(pi) / 5 - 3/2. On the screen, from the view: the
    // end of the curve is at (20 + 40, 105 - 40), and the middle 100 columns and 30 rows farther, and 60 * 3/2 rows
    // down.
    CHECK(row_over(surface.curves->curves[20], 160) == doctest::Approx(65 + 30 + 90));
    // At the corner x = 0, z = 2 pi sin is 0, and exp(-2 pi^2) nearly so.
    CHECK(row_over(surface.curves->curves[0], 20) == doctest::Approx(105));
    CHECK_MESSAGE(sample_count(surface.curves) > 41 * 51, "the pit bends more sharply than every fourth column shows");
    CHECK(sample_count(surface.curves) < 41 * 60);
}
