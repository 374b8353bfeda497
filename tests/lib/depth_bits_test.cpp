// The kernel `depth:B`: a Z-buffer of B bits.

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "support/scenes.h"
#include "vidno/kernels/depth_bits.h"
#include "vidno/vidno.h"

using namespace vidno;
using namespace vidno::test;

namespace {

struct KeepDepth : NoTrace {
    double* last;
    explicit KeepDepth(double& place) : last(&place) {}
    void pixel(Line, int, int, const auto& z, const auto&, bool) { *last = double(z); }
};

}  // namespace

TEST_CASE("Two bits hold four depths: -1, -1/3, 1/3 and 1") {
    const DepthBits kernel(2);
    CHECK(kernel.to_store(-1) == -1);
    CHECK(kernel.to_store(1) == 1);
    CHECK(kernel.to_store(-0.34) == doctest::Approx(-1 / 3.));
    CHECK(kernel.to_store(0.6) == doctest::Approx(1 / 3.));
    CHECK_MESSAGE(kernel.to_store(0) == doctest::Approx(1 / 3.), "half way goes up");
    CHECK_MESSAGE(kernel.to_store(-0.67) == -1, "-2/3 is half way between -1 and -1/3");
    CHECK_MESSAGE(kernel.to_store(1.25) == 1, "a depth that drifted out of the range");
    CHECK_MESSAGE(kernel.to_store(-7) == -1, "and on the other side");
}

TEST_CASE("Storing keeps the order, is idempotent, and is off by at most half a step") {
    std::mt19937 random(11);
    const auto depth = [&] { return std::ldexp(double(random()), -31) - 1; };
    for (int i = 0; i < 20000; ++i) {
        const int bits = fewest_depth_bits + int(random() % (most_depth_bits - fewest_depth_bits + 1));
        const DepthBits kernel(bits);
        const double z = depth();
        const double other = depth();
        const double stored = kernel.to_store(z);
        CAPTURE(bits);
        CAPTURE(z);
        CHECK(kernel.to_store(stored) == stored);
        CHECK((z <= other ? stored <= kernel.to_store(other) : stored >= kernel.to_store(other)));
        const double half_a_step = 1 / (std::ldexp(1, bits) - 1);
        CHECK(std::abs(stored - z) <= half_a_step * (1 + 1e-6));
    }
}

TEST_CASE("Depths closer than a step are equal, and the first polygon wins") {
    // 4 bits store the rounded (z + 1) / 2 * 15: 11.25 for 0.5, 11.4 for 0.52, and 11.625, rounded to 12, for 0.55.
    const auto shown = [](double second, int bits) {
        const AdmittedScene scene = SceneBuilder(area_16).quad(-1, -1, 17, 17, .5).quad(-1, -1, 17, 17, second).build();
        return render(Method::zbuffer, scene, DepthBits(bits)).at(8, 8);
    };
    CHECK(shown(0.55, 4) == color_of(1));
    CHECK(shown(0.52, 4) == color_of(0));
    CHECK_MESSAGE(shown(0.52, 8) == color_of(1), "of 8 bits: 191.25 and 193.8");
}

TEST_CASE("The trace reports the depth that the buffer stores") {
    double reported = 0;
    const AdmittedScene scene = SceneBuilder({0, 0, 1, 1}).quad(-1, -1, 2, 2, 0).build();
    render(Method::zbuffer, scene, DepthBits(2), KeepDepth(reported));
    CHECK(reported == doctest::Approx(1 / 3.));
}
