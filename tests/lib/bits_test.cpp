// The kernel `bits:P`: each result is the exact one rounded once, and P = 24 is `float`.

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "support/reference.h"
#include "support/scenes.h"
#include "support/stage.h"
#include "vidno/kernels/bits.h"

using namespace vidno;
using namespace vidno::test;

namespace {

/// The neighbours of a positive value among the numbers with a given number of bits, and which of them is nearer, by
/// rationals.
double nearest_with_bits(int bits, const Rational& value) {
    const double about = CGAL::to_double(value);
    const double step = std::ldexp(1, std::ilogb(about) + 1 - bits);
    double below = std::floor(about / step) * step;
    while (Rational(below) > value) below -= step;
    while (Rational(below + step) <= value) below += step;
    const Rational to_below = value - Rational(below);
    const Rational to_above = Rational(below + step) - value;
    if (to_below == to_above) return std::fmod(below / step, 2) == 0 ? below : below + step;
    return to_below < to_above ? below : below + step;
}

}  // namespace

TEST_CASE("Rounding: to nearest, ties to even, into the next power of two") {
    CHECK(rounded_to(4, 13) == 13);
    CHECK(rounded_to(4, 16.5) == 16);
    CHECK(rounded_to(4, 17) == 16);  // between 16 = 1000b * 2 and 18 = 1001b * 2
    CHECK(rounded_to(4, 19) == 20);  // between 18 and 20 = 1010b * 2
    CHECK(rounded_to(4, -19) == -20);
    CHECK(rounded_to(4, 31.5) == 32);
    CHECK(rounded_to(24, 0.1) == double(0.1F));
    CHECK(rounded_to(4, 0) == 0);
    CHECK(std::signbit(rounded_to(4, -0.)));
    const double infinity = std::numeric_limits<double>::infinity();
    CHECK(rounded_to(4, infinity) == infinity);
    CHECK(rounded_to(4, std::numeric_limits<double>::max()) == infinity);
    CHECK(std::isnan(rounded_to(4, std::nan(""))));
}

TEST_CASE("Each operation is the exact one, rounded once") {
    std::mt19937 random(8);
    for (int i = 0; i < 20000; ++i) {
        const int bits = fewest_bits + int(random() % (most_bits - fewest_bits + 1));
        const Bits kernel(bits);
        // Few different exponents, so that sums often carry, cancel and tie.
        const auto any = [&] { return kernel.number(std::ldexp(1 + random() % 4096, int(random() % 30) - 15)); };
        const Rounded a = any();
        const Rounded b = any();
        const Rational exact_a(double{a}), exact_b(double{b});
        CAPTURE(bits);
        CAPTURE(double(a));
        CAPTURE(double(b));
        CHECK(double(a + b) == nearest_with_bits(bits, exact_a + exact_b));
        CHECK(double(a * b) == nearest_with_bits(bits, exact_a * exact_b));
        CHECK(double(a / b) == nearest_with_bits(bits, exact_a / exact_b));
        if (a > b) CHECK(double(a - b) == nearest_with_bits(bits, exact_a - exact_b));
    }
}

TEST_CASE("A constant takes the bits of the other operand") {
    const Bits kernel(4);
    CHECK(double(Rounded(1) + kernel.number(30)) == 32);  // 31 has five bits; 30 and 32 are equally near, 32 is even
    CHECK(double(Rounded(1) + Rounded(30)) == 31);
}

TEST_CASE("With 24 bits, both methods and editions paint what `float` paints") {
    RandomScenes random(24);
    int pixels_that_differ_from_exact = 0;
    for (int i = 0; i < 300; ++i) {
        CAPTURE(i);
        const AdmittedScene scene = random.scene();
        for (const Method method : {Method::warnock, Method::zbuffer}) {
            const Picture picture = render<Corrected>(method, scene, Bits(24));
            CHECK(picture == render<Corrected>(method, scene, Float{}));
            CHECK(render<Printed>(method, scene, Bits(24)) == render<Printed>(method, scene, Float{}));
            pixels_that_differ_from_exact += different_pixels(picture, Reference(scene).picture());
        }
    }
    CHECK(pixels_that_differ_from_exact > 0);
}

TEST_CASE("Fewer bits, more wrong pixels") {
    RandomScenes random(7);
    std::array<int, 4> wrong{};
    for (int i = 0; i < 200; ++i) {
        const AdmittedScene scene = random.scene();
        const Picture expected = Reference(scene).picture();
        for (std::size_t knob = 0; knob < wrong.size(); ++knob) {
            const int bits = std::array{4, 8, 12, 24}[knob];
            wrong[knob] += different_pixels(render(Method::zbuffer, scene, Bits(bits)), expected);
        }
    }
    CHECK(wrong[0] > wrong[1]);
    CHECK(wrong[1] > wrong[2]);
    CHECK(wrong[2] > wrong[3]);
}

TEST_CASE("Four bits suffice for small whole coordinates, and a fifth distinguishes halves") {
    // A quad to the centre of the seventh column: 13/2 has four bits, 15/2 too, 17/2 five.
    const auto painted = [](int bits, double right) {
        const AdmittedScene scene = SceneBuilder({0, 0, 12, 1}).quad(0, 0, right, 1, .5).build();
        const Picture picture = render(Method::zbuffer, scene, Bits(bits));
        return std::count(picture.pixels().begin(), picture.pixels().end(), color_of(0));
    };
    CHECK(painted(4, 6.5) == 7);
    CHECK(painted(4, 6.25) == 6);
    CHECK(painted(5, 8.5) == 9);
    CHECK(painted(5, 8.25) == 8);
    CHECK(painted(4, 8.25) == 9);  // 8.25 and the centre 8.5 are both 8
}
