// Sign maps: the published ones by independent arithmetic, the other decisions, and the files of decisions and of maps.

#include "sign_map/map.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "output.h"
#include "sign_map/mapped_decision_json.h"
#include "support/kettner.h"
#include "support/places.h"
#include "support/scenes.h"

using namespace vidno;
using namespace vidno::test;

namespace {

constexpr int side = sanitized ? 64 : MappedDecision::side;
constexpr double u = 0x1p-53;

MappedDecision lesson(const std::string& name) {
    const std::string file = VIDNO_ROOT "/lessons/maps/" + name + ".json";
    return read_mapped_decision(read_file(file), file);
}

const std::array<std::string, 6> all_lessons{"kettner-2a", "kettner-2b", "kettner-2c", "surround", "clip", "depth"};

SignMap map_of(const MappedDecision& decision, std::string_view kernel) {
    return sign_map(decision, *kernel_named(kernel), side);
}

Sign sign_of(auto value) { return Sign{int(value > 0) - int(value < 0)}; }

/// (b - a) x (c - a), in plain doubles.
Sign formula(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return sign_of((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}

/// The formula without rounding: the points are whole multiples of 2^-53 below 32, so the products are below 2^118.
Sign exact_formula(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    __extension__ using Whole = __int128;
    const auto whole = [](double v) { return Whole(std::int64_t(std::ldexp(v, 53))); };
    return sign_of((whole(b.x) - whole(a.x)) * (whole(c.y) - whole(a.y)) -
                   (whole(b.y) - whole(a.y)) * (whole(c.x) - whole(a.x)));
}

/// How many cells differ from `expected(i, j)`.
int unexpected(const SignMap& map, auto&& expected) {
    int count = 0;
    for (int j = 0; j < side; ++j) {
        for (int i = 0; i < side; ++i) count += map.at(i, j).computed == expected(i, j) ? 0 : 1;
    }
    return count;
}

std::string message_for(const std::string& text) {
    try {
        read_mapped_decision(text, "f.json");
        return "taken";
    } catch (const Refused& refused) {
        return refused.what();
    }
}

/// A decision with these keys beside the common ones.
std::string decision_with(const std::string& more, const std::string& p = "[0.5, 0.5]",
                          const std::string& step = "\"0x1p-53\"") {
    return R"({"format": "vidno-question/1", "p": )" + p + R"(, "step": )" + step + (more.empty() ? "" : ", ") + more +
           "}";
}

}  // namespace

TEST_CASE("The published maps: each sign is the formula's, each truth that of whole numbers") {
    const std::array names{"kettner-2a", "kettner-2b", "kettner-2c"};
    for (std::size_t n = 0; n < names.size(); ++n) {
        CAPTURE(names[n]);
        const glm::dvec2 p = kettner_maps[n].p;
        const glm::dvec2 q = kettner_maps[n].q;
        const glm::dvec2 r = kettner_maps[n].r;
        const SignMap map = map_of(lesson(names[n]), "double");
        SignMap::Counts counts{};
        int wrong = 0;
        for (int j = 0; j < side; ++j) {
            for (int i = 0; i < side; ++i) {
                const glm::dvec2 place{p.x + i * u, p.y + j * u};
                const Sign computed = formula(place, q, r);
                const Sign exact = exact_formula(place, q, r);
                REQUIRE(map.at(i, j).computed == computed);
                REQUIRE(map.at(i, j).exact == exact);
                ++counts[place_of(computed)][place_of(exact)];
                wrong += computed == exact ? 0 : 1;
            }
        }
        CHECK(map.counts() == counts);
        CHECK(map.differing() == wrong);
    }
}

TEST_CASE("Figure 2 (a) and (c): q and r lie on the diagonal, so the truth is the sign of Y - X") {
    for (const auto* name : {"kettner-2a", "kettner-2c"}) {
        CAPTURE(name);
        const SignMap map = map_of(lesson(name), "exact");
        CHECK(unexpected(map, [](int x, int y) { return sign_of(y - x); }) == 0);
        constexpr int on = side, above = side * (side - 1) / 2;
        CHECK(map.counts() == SignMap::Counts{{{above, 0, 0}, {0, on, 0}, {0, 0, above}}});
    }
}

TEST_CASE("Figure 2: some places are seen on the wrong side of the line") {
    for (const auto* name : {"kettner-2a", "kettner-2b", "kettner-2c"}) {
        CAPTURE(name);
        const auto counts = map_of(lesson(name), "double").counts();
        CHECK(counts[0][2] > 0);
        CHECK(counts[2][0] > 0);
    }
}

TEST_CASE("The pivot changes the computed answer, not the exact one") {
    const MappedDecision decision = lesson("kettner-2a");
    const auto [q, r, pivot] = std::get<MappedOrientation>(decision.asked);
    REQUIRE(pivot == 0);
    const auto map_from = [&decision](int other) {
        MappedDecision changed = decision;
        std::get<MappedOrientation>(changed.asked).pivot = other;
        return map_of(changed, "double");
    };
    const SignMap from_p = map_from(0);
    const SignMap from_q = map_from(1);
    const SignMap from_r = map_from(2);
    int as_written = 0, computed_otherwise = 0, true_otherwise = 0;
    for (int j = 0; j < side; ++j) {
        for (int i = 0; i < side; ++i) {
            const glm::dvec2 p = decision.place(i, j);
            const auto &by_p = from_p.at(i, j), &by_q = from_q.at(i, j), &by_r = from_r.at(i, j);
            as_written += by_p.computed == formula(p, q, r) && by_q.computed == formula(q, r, p) &&
                          by_r.computed == formula(r, p, q);
            computed_otherwise += by_q.computed != by_p.computed && by_r.computed != by_p.computed;
            true_otherwise += by_q.exact != by_p.exact || by_r.exact != by_p.exact;
        }
    }
    CHECK(as_written == side * side);
    CHECK(computed_otherwise > 0);
    CHECK(true_otherwise == 0);
}

TEST_CASE("Every decision of the lessons: double is wrong somewhere, filtered and exact nowhere") {
    for (std::size_t n = 0; n < all_lessons.size(); n += thinning) {
        CAPTURE(all_lessons[n]);
        const MappedDecision decision = lesson(all_lessons[n]);
        CHECK(map_of(decision, "double").differing() > 0);
        CHECK(map_of(decision, "filtered").differing() == 0);
        CHECK(map_of(decision, "exact").differing() == 0);
    }
}

TEST_CASE("In float, and in fewer bits, all places are the same") {
    // All places (1/2 + X u, 1/2 + Y u) are 1/2 in numbers of 24 bits, which lies on the line. So the answer is zero
    // everywhere, and right on the diagonal. In 4 bits q - p = 11.5 is 12, r - p = 23.5 is 24: the sign is zero too.
    for (const auto* kernel : {"float", "bits:24", "bits:4"}) {
        CAPTURE(kernel);
        const SignMap map = map_of(lesson("kettner-2a"), kernel);
        CHECK(map.kernel == kernel);
        CHECK(unexpected(map, [](int, int) { return Sign::zero; }) == 0);
        CHECK(map.differing() == side * side - side);
    }
}

TEST_CASE("SurroundTest: outside of a triangle's tip, and held by double") {
    // The tip is A = (1/2 + 32 u, 1/2 + 32 u), B = (24, 12), C = (24, 24), and p = (1/2, 1/2 + 32 u). With d = 23.5 -
    // 32 u the edge from C to A has the cross product (A - C) x (p - C) = d d - 23.5 d = -32 u d < 0, the others more
    // than 0: p is outside. As doubles, 2^-43 apart here, both products are 23.5 * 23.5 - 2^-43: no side, and that edge
    // is passed.
    const MappedDecision decision = lesson("surround");
    const SignMap::Cell cell = map_of(decision, "double").at(0, 32);
    CHECK(cell.computed == Sign::positive);
    CHECK(cell.exact == Sign::negative);
    CHECK_FALSE(map_of(decision, "filtered").at(0, 32).differs());
}

TEST_CASE("Clip side: a step of p that the computed cut does not follow") {
    // p and q lie on the diagonal, as the corner does; so above it, y growing, the cut is left of the corner: outside.
    // The cut's x is a double near 12, p.x + (q.x - p.x) t; a step of 2^-53 is lost in q.x - p.x = 23.5 and in the sum,
    // and p.y does not change: the computed answer is one, and the truth is zero at the first place, negative at the
    // next.
    const MappedDecision decision = lesson("clip");
    const SignMap by_double = map_of(decision, "double");
    CHECK(by_double.at(0, 0).computed == by_double.at(1, 0).computed);
    CHECK(unexpected(map_of(decision, "exact"), [](int x, int y) { return sign_of(y - x); }) == 0);
    CHECK(unexpected(map_of(decision, "filtered"), [](int x, int y) { return sign_of(y - x); }) == 0);
}

TEST_CASE("Depth order: planes that doubles cannot distinguish") {
    // At x = 1 - 2^-5 + X u one plane is at 1/4, the other lower by (2^-5 - X u) 2^-54, which no double near 1/4 can
    // show.
    const double low = .25 - 0x1p-54;
    const MappedDecision decision{
        "",
        {1 - 0x1p-5, .5},
        u,
        MappedDepth{{ScenePolygon{"", {}, {{0, 0, .25}, {1, 0, .25}, {1, 1, .25}, {0, 1, .25}}},
                     ScenePolygon{"", {}, {{0, 0, low}, {1, 0, .25}, {1, 1, .25}, {0, 1, low}}}}}};
    CHECK(unexpected(map_of(decision, "exact"), [](int, int) { return Sign::positive; }) == 0);
    CHECK(unexpected(map_of(decision, "filtered"), [](int, int) { return Sign::positive; }) == 0);
    CHECK(unexpected(map_of(decision, "double"), [](int, int) { return Sign::negative; }) == 0);
}

TEST_CASE("The picture: p at the lower left, and wrong answers dark, also in grey") {
    const SignMap map = map_of(lesson("kettner-2a"), "double");
    const Picture picture = picture_of(map);
    const int zoom = picture.area().width / side;
    REQUIRE(picture.area() == Area{0, 0, side * zoom, side * zoom});
    int darkest_right = 255, lightest_wrong = 0;
    for (int j = 0; j < side; ++j) {
        for (int i = 0; i < side; ++i) {
            const Color color = picture.at(i * zoom + zoom / 2, (side - 1 - j) * zoom + zoom / 2);
            const int lightness = (299 * color.red + 587 * color.green + 114 * color.blue) / 1000;  // BT.601
            if (map.at(i, j).differs()) {
                lightest_wrong = std::max(lightest_wrong, lightness);
            } else {
                darkest_right = std::min(darkest_right, lightness);
            }
        }
    }
    CHECK(lightest_wrong + 64 < darkest_right);
}

TEST_CASE("The picture: black and white side by side where the truth changes") {
    // Place (10, 10) is on the line, (9, 10) beside it on the positive side.
    const Picture picture = picture_of(map_of(lesson("kettner-2a"), "exact"));
    const int zoom = picture.area().width / side;
    const int row = (side - 1 - 10) * zoom + zoom / 2;
    CHECK(picture.at(10 * zoom, row) == Color{0, 0, 0});
    CHECK(picture.at(10 * zoom - 1, row) == Color{255, 255, 255});
}

TEST_CASE("The map as JSON: every computed answer with every exact one") {
    const SignMap map = map_of(lesson("surround"), "bits:12");
    const auto json = nlohmann::json::parse(map_json(map));
    CHECK(json["format"] == "vidno-map/1");
    CHECK(json["decision"] == "surround");
    CHECK(json["kernel"] == "bits:12");
    CHECK(json["differ"] == map.differing());
    REQUIRE(json["counts"].size() == 4);  // outside and inside, twice
    CHECK(json["counts"][1]["computed"] == "outside");
    CHECK(json["counts"][1]["exact"] == "inside");
    CHECK(json["counts"][1]["places"] == map.counts()[0][2]);
}

TEST_CASE("A smaller map is the lower left part of the whole one") {
    for (std::size_t n = 0; n < all_lessons.size(); n += thinning) {
        CAPTURE(all_lessons[n]);
        const MappedDecision decision = lesson(all_lessons[n]);
        const SignMap whole = map_of(decision, "double");
        const SignMap part = sign_map(decision, *kernel_named("double"), 5);
        REQUIRE(part.cells.size() == 5 * 5);
        for (int j = 0; j < 5; ++j) {
            for (int i = 0; i < 5; ++i) {
                CHECK(part.at(i, j).computed == whole.at(i, j).computed);
                CHECK(part.at(i, j).exact == whole.at(i, j).exact);
            }
        }
    }
}

TEST_CASE("The files of the published maps have the numbers of the paper") {
    const std::array names{"kettner-2a", "kettner-2b", "kettner-2c"};
    for (std::size_t n = 0; n < names.size(); ++n) {
        CAPTURE(names[n]);
        const MappedDecision decision = lesson(names[n]);
        const auto& asked = std::get<MappedOrientation>(decision.asked);
        CHECK(decision.p == glm::dvec2(kettner_maps[n].p));
        CHECK(asked.q == glm::dvec2(kettner_maps[n].q));
        CHECK(asked.r == glm::dvec2(kettner_maps[n].r));
        CHECK(asked.pivot == 0);
        CHECK(decision.place(255, 1) == decision.p + glm::dvec2(255 * u, u));
    }
}

TEST_CASE("A file without a decision is refused with the place and the reason") {
    const std::string line = R"("orientation": {"q": [12, 12], "r": [24, 24], "pivot": "p"})";
    const auto clip = [](const std::string& q, int cut, int that_side) {
        return R"("clip": {"q": )" + q + R"(, "window": {"x": 12, "y": 12, "width": 4, "height": 4}, "cut": )" +
               std::to_string(cut) + R"(, "side": )" + std::to_string(that_side) + "}";
    };
    REQUIRE(message_for(decision_with(line)) == "taken");
    REQUIRE(message_for(decision_with(clip("[24, 24]", 1, 2))) == "taken");

    struct BadInput {
        std::string text, message;
    };
    const std::vector<BadInput> table{
        {"", "line 1, column 1: not valid JSON"},
        {"[]", "not an object"},
        {"{}", "\"format\" is missing\nf.json: \"p\" is missing\nf.json: \"step\" is missing"},
        {R"({"format": "vidno-scene/1", "p": [0, 0], "step": 1})", "/format: not \"vidno-question/1\""},
        {decision_with(""), "not exactly one of \"orientation\", \"surround\", \"clip\", \"depth\""},
        {decision_with(line + R"(, "surround": {"polygon": [[0, 0], [1, 0], [0, 1]]})"),
         "not exactly one of \"orientation\", \"surround\", \"clip\", \"depth\""},
        {decision_with(line + R"(, "kernel": "double")"), "/kernel: unknown key"},
        {decision_with(line, "[0.5]"), "/p: not two coordinates"},
        {decision_with(line, "[0.5, 0.5]", "0"), "/step: not positive"},
        {decision_with(line, "[12, 0.5]"), "/step: 255 steps from p on, not every place is a double"},
        {decision_with(line, "[0.5, 0.5]", "1e308"), "/step: 255 steps from p on, not every place is a double"},
        {decision_with(R"("orientation": {"q": [12, 12], "r": [24, 24]})"), "/orientation: \"pivot\" is missing"},
        {decision_with(R"("orientation": {"q": [12, 12], "r": [24, 24], "pivot": "s"})"),
         "/orientation/pivot: not \"p\", \"q\" or \"r\""},
        {decision_with(R"("surround": {"polygon": [[0, 0], [1, 0]]})"), "/surround/polygon: fewer than three vertices"},
        {decision_with(R"("surround": {"polygon": [[0, 0], [4, 0], [1, 1], [0, 4]]})"),
         "/surround/polygon: not convex: the outline does not go once around the convex hull of its vertices"},
        {decision_with(R"("surround": {"polygon": [[0, 0], [2, 1e-15], [4, 0], [0, 4]]})"),
         "/surround/polygon: not exactly convex, as a map requires"},
        {decision_with(R"("surround": {"polygon": [[0, 0], [1, 1], [2, 2]]})"), "/surround/polygon: seen edge-on"},
        {decision_with(R"("surround": {"polygon": [[0, 0], [1, 1], [2, "x"]]})"),
         "/surround/polygon/2/1: not a hexadecimal number such as \"0x1.8p-3\""},
        {decision_with(clip("[24, 24]", 4, 4)), "/clip/cut: not from 1 to 3"},
        {decision_with(clip("[24, 24]", 2, 1)), "/clip/side: not from 3 to 4"},
        {decision_with(clip("[24, 12]", 1, 2)), "/clip/cut: the edge from p to q does not cross this side"},
        {decision_with(R"("depth": {"polygons": []})"), "/depth/polygons: not two polygons"},
        {decision_with(R"("depth": {"polygons": [[[0, 0, 0], [1, 0, 0], [0, 1, 2]], []]})"),
         "/depth/polygons/0: z outside -1 to 1"},
    };
    for (const auto& bad : table) {
        CAPTURE(bad.text);
        CHECK(without_places(message_for(bad.text)) == "f.json: " + bad.message);
    }
}
