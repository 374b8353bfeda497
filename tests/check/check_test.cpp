// The exact shadow: its verdicts on single decisions, on whole runs, and in a trace.

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <sstream>

#include "check/check.h"
#include "check/checked_trace.h"
#include "format/trace_reader.h"
#include "output.h"
#include "run/run_time_kernel.h"
#include "run/write_trace.h"
#include "scene/snapped_scene.h"
#include "support/editions.h"
#include "support/kernels.h"
#include "support/kettner.h"
#include "support/scenes.h"

using namespace vidno;
using namespace vidno::test;

namespace {

/// A judged kernel, and what its judge and surveyor reported.
struct Court {
    std::vector<Verdict> verdicts;
    double off = 0;
    Judge judge = [this](const Verdict& verdict) { verdicts.push_back(verdict); };
    Surveyor survey = [this](const Surveyed& point) { off = point.off; };
    RunTimeKernel kernel;

    explicit Court(std::string_view name) : kernel(*kernel_named(name), {&judge, &survey}) {}

    Verdict last() const { return verdicts.back(); }
};

CheckReport checked(const AdmittedScene& scene, Method method, std::string_view kernel,
                    Edition edition = Edition::corrected) {
    return check_run({method, *kernel_named(kernel), edition, scene}, right_picture(scene));
}

std::uint64_t wrong_decisions(const CheckReport& report) {
    std::uint64_t wrong = 0;
    for (const auto& each : report.procedures) wrong += each.wrong_for_scene;
    return wrong;
}

/// The events of a trace, without what only a checked one tells; how many decisions carry a truth, how many are wrong.
struct Read {
    std::string plain;
    int truths = 0, disagreements = 0;
};

Read read_back(const std::string& trace) {
    TraceReader reader(LineReader::of_text(trace), "trace");
    EventText text(polygon_names(reader.header().scene));
    Text lines;
    Read read;
    while (const auto event = reader.next()) {
        if (event->get_if<event::Disagree>()) {
            ++read.disagreements;
            continue;
        }
        event->visit([&](auto e) {
            if constexpr (requires { e.decides; }) {
                read.truths += e.checked.exact ? 1 : 0;
                e.checked = {};
            }
            text.line(lines, e);
        });
    }
    read.plain = lines.string();
    return read;
}

}  // namespace

TEST_CASE_TEMPLATE("A decision that is right says so", K, Float, Double) {
    Court court(K::name);
    const auto& kernel = court.kernel;
    const auto value =
        kernel.cross(kernel.vertex({0, 0, 0}), kernel.vertex({4, 0, 0}), kernel.point(1, 2));  // 4 * 2 - 0 * 1
    CHECK(double(value) == 8);
    CHECK(court.last().of == Decision::orientation);
    CHECK(court.last().taken == Answer(1));
    CHECK(court.last().truth.answer == Answer(1));
    CHECK(court.last().right_for_operands);
    CHECK_FALSE(court.last().wrong());
}

TEST_CASE("A number that drifted: right as it stands, wrong for the scene") {
    // 1/2 + 2^-30 is 1/2 as a float: the first centre at or after it is 0 by the float, 1 by the scene.
    Court court("float");
    const auto x = court.kernel.vertex({.5 + 0x1p-30, 0, 0}).x;
    CHECK(court.kernel.first_centre(x, 0, 4) == 0);
    CHECK(court.last().taken == Answer(0));
    CHECK(court.last().truth.answer == Answer(1));
    CHECK(court.last().wrong());
    CHECK(court.last().cause() == Cause::drifted);
}

TEST_CASE("Intersections: how far the computed one lies from the exact one") {
    // From (0, 0) to (1, 3), cut where cp / (cp - cq) = 1/3: at (1/3, 1). The float nearest to 1/3 is 11184811 / 2^25,
    // off by (3 * 11184811 - 2^25) / (3 * 2^25) = 1 / (3 * 2^25); times 3 that rounds to 1.
    Court court("float");
    const auto& kernel = court.kernel;
    const RunTimeNumber cp(1), cq(-2);
    const auto found = kernel.meet(kernel.vertex({0, 0, 0}), kernel.vertex({1, 3, 0}), cp, cq);
    CHECK(double(found.x) == 11184811 * 0x1p-25);
    CHECK(double(found.y) == 1);
    CHECK(court.off == doctest::Approx(0x1p-25 / 3).epsilon(1e-12));
}

TEST_CASE("A judged number keeps minus zero") {
    const auto negative = -RunTimeNumber(0);
    CHECK(std::signbit(negative.value()));
    CHECK(*negative.truth() == 0);
    CHECK(1 / negative.value() == -std::numeric_limits<double>::infinity());
}

TEST_CASE("After a division by an exact zero there is no truth") {
    Court court("double");
    const auto& kernel = court.kernel;
    const auto tiny = kernel.vertex({.1, .2, .3});
    const auto nothing =
        (tiny.x + tiny.x) - tiny.y;  // 0 in doubles and exactly: 2 * 0.1 and 0.2 are one double doubled
    CHECK(*nothing.truth() == 0);
    const auto lost = tiny.z / nothing;
    CHECK_FALSE(lost.truth());
    CHECK(tiny.x < lost);
    CHECK(court.last().of == Decision::comparison);
    CHECK_FALSE(court.last().truth.answer);
    CHECK_FALSE(court.last().wrong());
}

TEST_CASE("Depths: any polygon is nearer than none") {
    Court court("double");
    const auto& kernel = court.kernel;
    const RunTimeKernel::Depth z(kernel.vertex({0, 0, -1}).z);
    CHECK(kernel.nearer(z, kernel.farthest(), Pixel{}));
    CHECK(court.last().truth.answer == Answer(true));
    CHECK_FALSE(kernel.nearer(kernel.farthest(), kernel.farthest(), Pixel{}));
    CHECK(court.last().truth.answer == Answer(false));
}

TEST_CASE("On the published maps the shadow finds precisely the places where double is wrong") {
    for (const auto& map : kettner_maps) {
        CAPTURE(map.q.x);
        Court court("double");
        int wrong = 0, differently = 0;
        map.for_each_place([&](const glm::dvec3& p) {
            const auto sign_by = [&](const auto& kernel) {
                return kernel.sign(kernel.cross(kernel.vertex(p), kernel.vertex(map.q), kernel.vertex(map.r)));
            };
            const bool differs = sign_by(Double{}) != sign_by(Exact{});
            court.verdicts.clear();
            sign_by(court.kernel);
            REQUIRE(court.verdicts.size() == 1);
            wrong += court.last().wrong() ? 1 : 0;
            differently += court.last().wrong() != differs ? 1 : 0;
            if (court.last().wrong()) REQUIRE(court.last().cause() == Cause::rounded);
        });
        CHECK(differently == 0);
        CHECK(wrong > 1000);
    }
}

TEST_CASE("A run with only right decisions paints the right picture, and a run with wrong pixels has wrong decisions") {
    RandomScenes random(8);
    int wrong_pictures = 0, right_pictures = 0;
    for (int i = 0; i < 150; ++i) {
        CAPTURE(i);
        const AdmittedScene scene = random.scene();
        for (const Method method : {Method::warnock, Method::zbuffer}) {
            const CheckReport report = checked(scene, method, "float");
            if (report.wrong_pixels > 0) CHECK(wrong_decisions(report) > 0);
            CHECK(report.found_something() == (report.wrong_pixels > 0 || wrong_decisions(report) > 0));
            (report.wrong_pixels > 0 ? wrong_pictures : right_pictures) += 1;
        }
    }
    CHECK(wrong_pictures > 0);
    CHECK(right_pictures > 0);
}

TEST_CASE("Under filtered and exact nothing is wrong") {
    RandomScenes random(9);
    for (int i = 0; i < 30; ++i) {
        const AdmittedScene scene = random.scene();
        for (const Method method : {Method::warnock, Method::zbuffer}) {
            for (const std::string_view kernel : {"filtered", "exact"}) {
                CHECK_FALSE(checked(scene, method, kernel).found_something());
            }
        }
    }
}

TEST_CASE("A run under filtered counts which stage decided") {
    // A square over 8 x 8 centres, none on its outline: each of its depths is nearer than no polygon.
    const AdmittedScene plain = SceneBuilder(area_16).quad(4, 4, 12, 12, .5).build();
    const auto easy = checked(plain, Method::zbuffer, "filtered").decided_by;
    CHECK(easy[std::size_t(FilterStage::scene)] == 64);
    CHECK(easy[std::size_t(FilterStage::exact)] == 0);
    // One square twice: 64 depths are equal, which no bound decides.
    const AdmittedScene tied = SceneBuilder(area_16).quad(4, 4, 12, 12, .5).quad(4, 4, 12, 12, .5).build();
    const auto hard = checked(tied, Method::zbuffer, "filtered").decided_by;
    CHECK(hard[std::size_t(FilterStage::scene)] == 64);
    CHECK(hard[std::size_t(FilterStage::exact)] == 64);
    for (const char* kernel : {"float", "double", "exact"}) {
        CHECK(checked(plain, Method::zbuffer, kernel).decided_by == decltype(easy){});
    }
}

TEST_CASE("The printed text paints wrong pixels without a wrong decision: its procedures are wrong") {
    // X-W3: the near square, 8 x 8 pixels, does not surround the window and is overlooked for the far one, which does.
    const AdmittedScene scene = SceneBuilder(area_16).polygon(far_quad).polygon(near_square).build();
    const CheckReport report = checked(scene, Method::warnock, "double", Edition::printed);
    CHECK(report.wrong_pixels == 64);
    CHECK(wrong_decisions(report) == 0);
    CHECK(report.found_something());
}

TEST_CASE("A checked trace is the trace, with the truth beside each decision") {
    RandomScenes random(10);
    int truths = 0, disagreements = 0;
    for (int i = 0; i < 12; i += thinning) {
        const AdmittedScene drawn = random.scene();
        for (const std::string name : {"float", "double", "bits:9", "depth:5", "filtered", "grid:3", "exact"}) {
            const NamedKernel kernel = *kernel_named(name);
            const AdmittedScene scene = kernel.snaps() ? snapped_scene(drawn, 3).scene : drawn;
            for (const Method method : {Method::warnock, Method::zbuffer, Method::weiler_atherton}) {
                for (const Edition edition : all_editions()) {
                    if (!kernel.choice->runs(method, edition)) continue;
                    for (const Detail detail : {Detail::windows, Detail::polygons, Detail::signs}) {
                        CAPTURE(i);
                        CAPTURE(name);
                        const RunRequest request{method, kernel, edition, scene, detail};
                        const auto traced = [&](bool checked) {
                            std::ostringstream text;
                            TraceWriter writer(TraceHeader{method, edition, name, detail, scene},
                                               [&](std::string_view part) { text << part; });
                            CHECK((checked ? write_checked_trace(request, writer) : write_trace(request, writer)));
                            return read_back(text.str());
                        };
                        const Read plain = traced(false);
                        const Read reported = traced(true);
                        CHECK(reported.plain == plain.plain);
                        CHECK(plain.truths + plain.disagreements == 0);
                        truths += reported.truths;
                        disagreements += reported.disagreements;
                    }
                }
            }
        }
    }
    CHECK(truths > 10000);
    CHECK(disagreements > 0);
}
