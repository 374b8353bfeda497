// What a run loses: an untraced run knows that it lost something exactly if its trace has a fault, and says which
// polygon and step.

#include <doctest/doctest.h>

#include <cmath>

#include "check/check.h"
#include "choice/method.h"
#include "run/run.h"
#include "support/reference.h"
#include "support/scenes.h"

using namespace vidno;
using namespace vidno::test;

namespace {

/// Faults and planes out of range, counted by their names alone.
std::size_t faults_in_trace(const RunRequest& request) {
    std::string text;
    TraceWriter writer(
        TraceHeader{request.method, request.edition, request.kernel.name(), Detail::signs, request.scene},
        [&](std::string_view part) { text += part; });
    RunRequest traced = request;
    traced.detail = Detail::signs;
    traced.sink = &writer;
    traced_run(traced);
    writer.finish_partial();
    std::size_t faults = 0;
    for (auto at = text.find("{\"e\":\"fault\""); at != text.npos; at = text.find("{\"e\":\"fault\"", at + 1)) ++faults;
    return faults;
}

double shown_area(RunRequest request) {
    std::vector<ShownRegion> regions;
    request.regions = &regions;
    run(request);
    double area = 0;
    for (const auto& region : regions) area += number_of(region.area);
    return area;
}

constexpr std::array rounding{"float", "double", "bits:4", "bits:8", "bits:12", "bits:24"};
constexpr std::array always_right{"filtered", "exact"};

/// What the rounding of coordinates alone may change in an area of 8 x 8 pixels: each of its vertices moves by an ulp
/// of 16.
double tolerance(const NamedKernel& kernel) {
    const int bits = kernel.name() == "float" ? 24 : kernel.name() == "double" ? 53 : kernel.parameter;
    return std::ldexp(16.0 * 64, -bits);
}

}  // namespace

TEST_CASE("Random and degenerate scenes: a run is announced as lossy exactly if its trace has faults") {
    RandomPolygons random(std::mt19937(52));
    std::size_t announced = 0, silent = 0;
    for (int trial = 0; trial < 96 / thinning; ++trial) {
        const AdmittedScene scene = random_scene(families[std::size_t(trial) % families.size()], random);
        for (std::size_t place = 0; place < method_names.size(); ++place) {
            const auto method = Method(place);
            if (refusal_of(method, scene)) continue;
            const auto check_announced = [&](const std::string& name) {
                const NamedKernel kernel = *kernel_named(name);
                if (!kernel.choice->runs(method, Edition::corrected)) return;
                CAPTURE(method_names[place]);
                CAPTURE(name);
                CAPTURE(trial);
                RunRequest request{method, kernel, Edition::corrected, scene};
                bool loses = false;
                request.loses = &loses;
                run(request);
                const std::size_t faults = faults_in_trace(request);
                CHECK(loses == (faults > 0));
                if (kernel.is_always_right()) CHECK_FALSE(loses);
                ++(loses ? announced : silent);
                if (!loses) return;
                for (const Loss& loss : losses_of(request)) {
                    CHECK_FALSE(loss.what.empty());
                    if (loss.what.find("an outline does not close") == loss.what.npos) continue;
                    CHECK(loss.where.find("step ") == 0);
                    CHECK(loss.where.find(", polygon") != loss.where.npos);
                }
            };
            for (const char* name : rounding) check_announced(name);
            for (const char* name : always_right) check_announced(name);
        }
    }
    CHECK(announced > 0);
    CHECK(silent > announced);
}

TEST_CASE("1,000 random and degenerate scenes: a picture is announced exactly if a loss of its run makes it wrong") {
    RandomPolygons random(std::mt19937(1000));
    std::size_t announced = 0, right_in_spite = 0, wrong_by_rounding = 0;
    for (int trial = 0; trial < 1000 / thinning; ++trial) {
        const AdmittedScene scene = random_scene(families[std::size_t(trial) % families.size()], random);
        const Picture exact = Reference(scene).picture();
        for (std::size_t place = 0; place < method_names.size(); ++place) {
            const auto method = Method(place);
            if (refusal_of(method, scene)) continue;
            for (const std::string name : {"float", "double", "bits:4", "bits:8", "bits:12", "bits:24", "depth:8"}) {
                const NamedKernel kernel = *kernel_named(name);
                if (!kernel.choice->runs(method, Edition::corrected)) continue;
                CAPTURE(method_names[place]);
                CAPTURE(name);
                CAPTURE(trial);
                bool loses = false;
                RunRequest request{method, kernel, Edition::corrected, scene};
                request.loses = &loses;
                const Picture picture = run(request);
                const bool is_announced = loses && picture != right_picture(scene, method);
                const bool is_wrong = !(picture == exact);
                // A picture may also be wrong by rounded depths or edges alone, of which no part is missing.
                const bool has_loss = (loses || is_wrong) && !losses_of(request).empty();
                CHECK(is_announced == (is_wrong && has_loss));
                announced += is_announced ? 1 : 0;
                right_in_spite += has_loss && !is_wrong ? 1 : 0;
                wrong_by_rounding += is_wrong && !has_loss ? 1 : 0;
            }
        }
    }
    CHECK(announced > 0);
    CHECK(right_in_spite > 0);
    CHECK(wrong_by_rounding > 0);
}

TEST_CASE("Random and degenerate scenes: regions whose areas add up to another sum than exactly are announced") {
    // The regions are a division of the union of the polygons, whose area is the same in every order of the work.
    RandomPolygons random(std::mt19937(3));
    std::size_t lost = 0;
    for (int trial = 0; trial < 96 / thinning; ++trial) {
        const AdmittedScene scene = random_scene(families[std::size_t(trial) % families.size()], random);
        const RunRequest exact{Method::weiler_atherton, kernel_of(KernelKind::exact), Edition::corrected, scene};
        const double right = shown_area(exact);
        for (const std::string name : rounding) {
            CAPTURE(name);
            CAPTURE(trial);
            CAPTURE(right);
            RunRequest request{Method::weiler_atherton, *kernel_named(name), Edition::corrected, scene};
            bool loses = false;
            request.loses = &loses;
            const double area = shown_area(request);
            CAPTURE(area);
            if (!(std::abs(area - right) <= tolerance(request.kernel))) {
                ++lost;
                CHECK(loses);
            }
        }
    }
    CHECK(lost > 0);
}

TEST_CASE("The losses of a run are the first ones, and a count of the others") {
    // As printed, the row and the column just past the 16 x 16 pixels are written: 16 writes in column 16 and 17 in row
    // 16.
    const AdmittedScene scene = SceneBuilder(area_16).quad(-2, -2, 18, 18, 0).build();
    const RunRequest request{Method::zbuffer, kernel_of(KernelKind::binary64), Edition::printed, scene};
    const auto losses = losses_of(request);
    REQUIRE(losses.size() == 21);
    CHECK(losses.back().what == "13 more losses of this run");
    CHECK(losses.front().where.find("L6, polygon \"A\", pixel (16, 0)") != std::string::npos);
}
