// The kernel `filtered`: its bounds hold, and its decisions are right where the bounds cannot decide.

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <random>

#include "support/kettner.h"
#include "support/reference.h"
#include "support/scenes.h"
#include "support/stage.h"

using namespace vidno;
using namespace vidno::test;

namespace {

/// A double and the exact value that it approximates, computed alongside.
struct Shadowed {
    Bounded bounded;
    Rational exact;

    bool holds() const {
        if (!std::isfinite(bounded.value) || !std::isfinite(bounded.error)) return true;  // nothing is claimed
        const Rational off = abs(Rational(bounded.value) - exact);
        return off <= Rational(bounded.error) && Rational(bounded.low()) <= exact && exact <= Rational(bounded.high());
    }
    static Rational abs(const Rational& value) { return value < 0 ? Rational(-value) : value; }
};

Shadowed combine(int operation, const Shadowed& a, const Shadowed& b) {
    switch (operation) {
        case 0: return {a.bounded + b.bounded, a.exact + b.exact};
        case 1: return {a.bounded - b.bounded, a.exact - b.exact};
        case 2: return {a.bounded * b.bounded, a.exact * b.exact};
        default: return {a.bounded / b.bounded, b.exact == 0 ? Rational(0) : Rational(a.exact / b.exact)};
    }
}

int wrong_pixels(Method method, const AdmittedScene& scene, auto kernel, const Picture& expected) {
    return different_pixels(render(method, scene, kernel), expected);
}

}  // namespace

TEST_CASE("Bounded: the exact result of a formula lies within the bound") {
    // Chains of random operations; small whole numbers make cancellation and division by nearly zero common.
    std::mt19937 random(5);
    const auto any = [&] {
        const double whole = int(random() % 9) - 4;
        const double value = random() % 3 == 0 ? whole : std::ldexp(double(random()) + 1, int(random() % 90) - 70);
        return Shadowed{Bounded(value), Rational(value)};
    };
    int inexact = 0;
    for (int chain = 0; chain < 3000; ++chain) {
        Shadowed value = any();
        for (int step = 0; step < 6; ++step) {
            const int operation = int(random() % 4);
            const Shadowed other = any();
            if (operation == 3 && other.exact == 0) continue;
            value = random() % 2 == 0 || operation == 3 ? combine(operation, value, other)
                                                        : combine(operation, other, value);
            REQUIRE(value.holds());
            inexact += value.bounded.is_exact() ? 0 : 1;
        }
    }
    CHECK(inexact > 10000);
}

TEST_CASE("Bounded: the bound of a quotient holds where a part of it underflows") {
    // The divisor is 2^-549 in doubles, exactly 2^-549 (1 + 2^-5). Its bound, 2^-552, times the quotient, 2^-525, is
    // less than half of the least double.
    const auto given = [](double value) { return Shadowed{Bounded(value), Rational(value)}; };
    const Shadowed product = combine(2, given(0x1p-500 + 0x1p-527), given(1 + 0x1p-27));
    const Shadowed divisor = combine(1, product, given(0x1p-500 + 0x1p-526 - 0x1p-549));
    CHECK(divisor.bounded.value == 0x1p-549);
    const Shadowed quotient = combine(3, given(0x1p-1074), divisor);
    CHECK(std::isfinite(quotient.bounded.error));
    CHECK(quotient.holds());
}

TEST_CASE("Bounded: division by a number that may be zero has no bound") {
    const Bounded tiny(1, 1);
    CHECK((Bounded(1) / tiny).error == std::numeric_limits<double>::infinity());
    CHECK_FALSE(sign_is_certain(tiny));
    CHECK(sign_is_certain(Bounded(1, .5)));
    CHECK_FALSE(sign_is_certain(Bounded(std::nan(""), 0)));
}

TEST_CASE("Orientation: right on the published maps, where double is not") {
    for (const auto& map : kettner_maps) {
        CAPTURE(map.q.x);
        Filtered filtered;
        filtered.see(SceneBuilder({0, 0, 32, 32}).polygon({{0, 0, 0}, {32, 0, 0}, {0, 32, 0}}).build());
        int wrong = 0, wrong_in_double = 0;
        map.for_each_place([&](const glm::dvec3& p) {
            const auto sign = [&](const auto& kernel) {
                return kernel.sign(kernel.cross(kernel.vertex(p), kernel.vertex(map.q), kernel.vertex(map.r)));
            };
            const Sign truth = sign(Exact{});
            wrong += sign(filtered) == truth ? 0 : 1;
            wrong_in_double += sign(Double{}) == truth ? 0 : 1;
        });
        CHECK(wrong == 0);
        CHECK(wrong_in_double > 1000);
    }
}

TEST_CASE("Depths that tie in doubles are distinguished") {
    // At x = 1 - 2^-5 one plane is at 1/4, the other lower by 2^-54 * 2^-5, which no double near 1/4 can show.
    Stage<Filtered> stage(SceneBuilder({0, 0, 1, 1})
                              .quad(0, 0, 1, 1, .25)
                              .polygon({{0, 0, .25 - 0x1p-54}, {1, 0, .25}, {1, 1, .25}, {0, 1, .25 - 0x1p-54}})
                              .build());
    const auto point = stage.point(1 - 0x1p-5, .5);
    const auto level = Corrected::depth(stage.run, stage.polygon(0), point);
    const auto tilted = Corrected::depth(stage.run, stage.polygon(1), point);
    CHECK(as_double(level) == as_double(tilted));
    CHECK(stage.run.kernel.nearer(level, tilted, point));
    CHECK_FALSE(stage.run.kernel.nearer(tilted, level, point));
    CHECK_FALSE(stage.run.kernel.nearer(level, level, point));
}

TEST_CASE("Next to coincidences: no wrong pixel, and some under double") {
    RandomScenes random(31);
    int wrong_in_double = 0;
    for (int admitted = 0; admitted < 2000;) {
        const auto moved = moved_by_ulps(random.scene(), random);
        if (!moved) continue;
        const AdmittedScene& scene = *moved;
        ++admitted;
        CAPTURE(admitted);
        const Picture expected = Reference(scene).picture();
        for (const Method method : {Method::warnock, Method::zbuffer}) {
            CHECK(wrong_pixels(method, scene, Filtered{}, expected) == 0);
            wrong_in_double += wrong_pixels(method, scene, Double{}, expected);
        }
    }
    CHECK(wrong_in_double > 0);
}

TEST_CASE("Depths that a cell of the Z-buffer cannot distinguish") {
    // 1/2 and 1/2 + 2^-30 are one float; 1/2 and 1/2 are equal, and the first polygon stays.
    const AdmittedScene scene = SceneBuilder({0, 0, 3, 1})
                                    .quad(0, 0, 3, 1, .5)
                                    .quad(0, 0, 1, 1, .5 + 0x1p-30)
                                    .quad(1, 0, 2, 1, .5)
                                    .quad(2, 0, 3, 1, .5 - 0x1p-30)
                                    .build();
    const Picture picture = render(Method::zbuffer, scene, Filtered{});
    CHECK(picture.at(0, 0) == color_of(1));
    CHECK(picture.at(1, 0) == color_of(0));
    CHECK(picture.at(2, 0) == color_of(0));
}

TEST_CASE("Lines of the Z-buffer of every length, up to each side of the area") {
    // Behind and in front of the middle quad are quads from column `first` to `end`. Two rows: what lies after the last
    // pixel of one is the first pixel of the next, or nothing.
    for (int width = 1; width <= 18; ++width) {
        for (int first = 0; first < width; ++first) {
            for (int end = first + 1; end <= width; ++end) {
                const AdmittedScene scene = SceneBuilder({-3, 5, width, 2})
                                                .quad(-3, 5, width - 3, 7, 0)
                                                .quad(first - 3, 5, end - 3, 7, .5)
                                                .quad(first - 3, 5, end - 3, 7, -.5)
                                                .build();
                const Picture picture = render(Method::zbuffer, scene, Filtered{});
                int wrong = 0;
                for (int y = 5; y < 7; ++y) {
                    for (int x = 0; x < width; ++x) {
                        const Color expected = color_of(first <= x && x < end ? 1 : 0);
                        wrong += picture.at(x - 3, y) == expected ? 0 : 1;
                    }
                }
                CAPTURE(width);
                CAPTURE(first);
                CAPTURE(end);
                CHECK(wrong == 0);
            }
        }
    }
}

TEST_CASE("Planes that cross along a line, at slopes around the bound of the cells") {
    // The tilted plane rises by 2^-k a pixel and is level with the other, at z, at x = 20: from that pixel on it is
    // nearer. Near 3/4 the numbers of a cell are 2^-24 apart.
    for (int k = 6; k <= 45; ++k) {
        for (const double z : {0., .75 + 0x1p-26, -.75}) {
            const double rise = std::ldexp(1, -k);
            const Corners tilted{
                {0, 0, z - 20 * rise}, {40, 0, z + 20 * rise}, {40, 1, z + 20 * rise}, {0, 1, z - 20 * rise}};
            if (z + 20 * rise > 1 || z - 20 * rise < -1) continue;
            const AdmittedScene tilted_last = SceneBuilder({0, 0, 40, 1}).quad(0, 0, 40, 1, z).polygon(tilted).build();
            const AdmittedScene tilted_first = SceneBuilder({0, 0, 40, 1}).polygon(tilted).quad(0, 0, 40, 1, z).build();
            const Picture last = render(Method::zbuffer, tilted_last, Filtered{});
            const Picture first = render(Method::zbuffer, tilted_first, Filtered{});
            int wrong = 0;
            for (int x = 0; x < 40; ++x) {
                wrong += last.at(x, 0) == color_of(x >= 20 ? 1 : 0) ? 0 : 1;
                wrong += first.at(x, 0) == color_of(x >= 20 ? 0 : 1) ? 0 : 1;
            }
            CAPTURE(k);
            CAPTURE(z);
            CHECK(wrong == 0);
        }
    }
}

TEST_CASE("Steep planes do not fit the cells: they are compared all the same") {
    // The sliver is 2^-30 wide in y and rises by 1 there, so its depths are known only roughly. Its lower edge is on
    // the centres of the row, at depth 0.
    for (const double z : {-0x1p-40, 0x1p-40}) {
        const AdmittedScene scene = SceneBuilder({0, 0, 20, 1})
                                        .quad(0, 0, 20, 1, z)
                                        .polygon({{0, .5 - 0x1p-30, 1}, {20, .5 - 0x1p-30, 1}, {20, .5, 0}, {0, .5, 0}})
                                        .build();
        const Picture picture = render(Method::zbuffer, scene, Filtered{});
        CHECK(picture == Picture(scene->area, color_of(z < 0 ? 1 : 0)));
    }
}

TEST_CASE("An edge at or near a centre has no certain first pixel after it") {
    const auto first_after = [](double value, double error) {
        return FilterBounds::first_after(Bounded(value, error), -2, 6);
    };
    // The centre of pixel 3 is 3 1/2.
    CHECK(first_after(3.5 + 0x1p-20, 0x1p-21) == 4);
    CHECK(first_after(3.5 - 0x1p-20, 0x1p-21) == 3);
    CHECK(first_after(3.5 + 0x1p-20, 0x1p-19) == std::nullopt);
    CHECK(first_after(3.5 - 0x1p-20, 0x1p-19) == std::nullopt);
    CHECK(first_after(3.5, 0) == std::nullopt);
    CHECK_MESSAGE(first_after(std::nextafter(3.5, 3), 0) == std::nullopt, "roundoff could move it to the centre");
    // Off the area, whose pixels are -2 to 5.
    CHECK(first_after(-100, .25) == -2);
    CHECK(first_after(-1.75, .125) == -2);
    CHECK(first_after(5.75, .125) == 6);
    CHECK(first_after(100, .25) == 6);
    // Nothing is known.
    const double infinity = std::numeric_limits<double>::infinity();
    CHECK(first_after(3, infinity) == std::nullopt);
    CHECK(first_after(3, std::nan("")) == std::nullopt);
    CHECK(first_after(infinity, infinity) == std::nullopt);
    CHECK(first_after(std::nan(""), std::nan("")) == std::nullopt);
}

TEST_CASE("A plane that is edge-on but for an ulp: no bound holds, and it is drawn right") {
    // The triangle is hardly more than its edge from (0, 0) to (8, 8), which passes through the centres of the diagonal
    // and rises from -1 to 1. From the fifth pixel on it is in front of the quad at 0.
    const AdmittedScene scene =
        SceneBuilder({0, 0, 8, 8}).quad(0, 0, 8, 8, 0).polygon({{0, 0, -1}, {8, 8, 1}, {4, 4 + 0x1p-50, .5}}).build();
    for (const Method method : {Method::warnock, Method::zbuffer}) {
        const Picture picture = render(method, scene, Filtered{});
        for (int y = 0; y < 8; ++y) {
            for (int x = 0; x < 8; ++x) {
                CAPTURE(x);
                CAPTURE(y);
                CHECK((picture.at(x, y) == color_of(1)) == (x == y && x >= 4));
            }
        }
    }
}

TEST_CASE("A window's corner that an edge passes through by chance") {
    // The edge from (8 - 2^-50, -5) to (8 + 2^-49, -14) crosses y = -8 at x = 8, the left side of the window. So the
    // vertex cut by the top side lies exactly on the left side, which doubles cannot show.
    Stage<Filtered> stage(SceneBuilder({8, -8, 2, 2})
                              .polygon({{8 + 0x1p-49, -14, 0}, {9, -14, 0}, {9, -5, 0}, {8 - 0x1p-50, -5, 0}})
                              .build());
    const auto clipped = Corrected::polygon_clip(stage.run, stage.polygon(), Window{8, -8, 2, 2});
    std::set<std::array<double, 2>> corners;
    for (const auto& v : clipped) corners.insert({as_double(v.x), as_double(v.y)});
    CHECK(corners == std::set<std::array<double, 2>>{{8, -8}, {9, -8}, {9, -6}, {8, -6}});
}

TEST_CASE("Coordinates that overflow are still decided right") {
    // The triangle's sides are so long that every product of them is infinite.
    const double far = 0x1p1000;
    const AdmittedScene scene = SceneBuilder({-2, -2, 4, 4})
                                    .polygon({{-far, -far, 0}, {far, -far, 0}, {far, far, 0}})
                                    .quad(-2, -2, 2, 2, -.5)
                                    .build();
    const Picture expected = Reference(scene).picture();
    for (const Method method : {Method::warnock, Method::zbuffer}) {
        CHECK(wrong_pixels(method, scene, Filtered{}, expected) == 0);
    }
}

TEST_CASE("A clipped vertex whose computed coordinate is infinite") {
    // The edge from (-1, 2e155) to (1e155, 2): its differences have a product of 2e310.
    const AdmittedScene scene = SceneBuilder({0, 0, 2, 2}).polygon({{-1, 2e155, 0}, {1, 1, 0}, {1e155, 2, 0}}).build();
    const Picture expected = Reference(scene).picture();
    for (const Method method : {Method::warnock, Method::zbuffer}) {
        CAPTURE(int(method));
        CHECK(wrong_pixels(method, scene, Filtered{}, expected) == 0);
    }
}
