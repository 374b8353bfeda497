// The contents of the list of decisions, against hand calculations. coincidences_test.cpp compares its exact zeros with
// counts in rationals.

#include <doctest/doctest.h>

#include <set>

#include "check/check.h"
#include "check/checked_trace.h"
#include "check/findings_text.h"
#include "support/checked.h"
#include "support/scenes.h"

using namespace vidno;
using namespace vidno::test;

TEST_CASE("A square with its corners on pixel centres: the list names its coincidences and no others") {
    // From (0.5, 0.5) to (2.5, 2.5) on 4 x 4 pixels: rows 0 to 2, whose left ends are the centre of column 0 and right
    // ends that of 2.
    const AdmittedScene scene = SceneBuilder({0, 0, 4, 4}).quad(.5, .5, 2.5, 2.5, .25).build();
    const Checked found = checked(scene, Method::zbuffer, "double");
    std::set<std::pair<int, int>> pixels;
    for (const auto& each : of_kind(found, FindingKind::zero)) {
        CHECK(each.gap->exact.text == "0/1");
        const bool of_columns =
            each.procedure == Procedure::show_line && each.gap->if_zero == Coincidence::on_pixel_centre;
        if (of_columns) pixels.emplace(each.pixels.x, each.pixels.y);
    }
    CHECK(pixels == std::set<std::pair<int, int>>{{0, 0}, {2, 0}, {0, 1}, {2, 1}, {0, 2}, {2, 2}});
    CHECK(of_kind(found, FindingKind::wrong).empty());
}

TEST_CASE("The list gives the operands of a wrong decision") {
    // As a float 1/2 + 2^-30 is 1/2: the left end of the only row is the centre of column 0 by the float, and beyond it
    // by the scene. There the floats are 2^-24 apart: the two numbers are 2^-30 / 2^-24 = 1/64 ulp from each other.
    const AdmittedScene scene = SceneBuilder({0, 0, 4, 1}).quad(.5 + 0x1p-30, 0, 3, 1, .25).build();
    FindingList list(Procedure::z_buffer, scene->area, 0);
    const RunRequest request{Method::zbuffer, *kernel_named("float"), Edition::corrected, scene};
    const CheckReport report = check_run(
        request, right_picture(scene), [](const auto&) {}, &list);
    CHECK(report.wrong_pixels == 1);
    std::vector<Finding> wrong;
    for (const auto& each : list.findings()) {
        if (each.kind == FindingKind::wrong) wrong.push_back(each);
    }
    REQUIRE(wrong.size() == 1);
    const std::string step = std::to_string(wrong[0].step);
    const std::string operands = R"([["x","1/2","536870913/1073741824"],["low","0/1","0/1"],["end","4/1","4/1"]])";
    const std::string lines = findings_jsonl(findings_header(request), wrong);
    CHECK(
        lines ==
        "{\"format\":\"vidno-decisions/"
        "1\",\"method\":\"zbuffer\",\"edition\":\"corrected\",\"kernel\":\"float\",\"scene\":\"\"}\n"
        "{\"kind\":\"wrong\",\"step\":" +
            step +
            ",\"at\":\"L4\",\"procedure\":\"ShowLine\",\"polygons\":[\"A\"],\"pixels\":[0,0,1,1],"
            "\"of\":\"first_centre\",\"taken\":0,\"exact\":1,\"cause\":\"drifted\",\"coincidence\":\"on_pixel_centre\","
            "\"computed\":0,\"gap\":\"1/1073741824\",\"sign\":1,\"ulps\":0.015625,\"operands\":" +
            operands + "}\n");
    CHECK(
        findings_csv(findings_header(request), wrong) ==
        "kind,step,at,procedure,of,polygons,pixels,taken,exact,cause,coincidence,computed,gap,sign,ulps,off,operands\n"
        "wrong," +
            step +
            ",L4,ShowLine,first_centre,A,\"[0,0,1,1]\",0,1,drifted,on_pixel_centre,0,1/1073741824,1,0.015625,,"
            "x = 1/2 (536870913/1073741824); low = 0/1; end = 4/1\n");
}

TEST_CASE("A checked trace has the operands at each decision, and at a disagreement at the step of the list") {
    // The scene of the test above.
    const AdmittedScene scene = SceneBuilder({0, 0, 4, 1}).quad(.5 + 0x1p-30, 0, 3, 1, .25).build();
    std::string trace;
    const RunRequest request{Method::zbuffer, *kernel_named("float"), Edition::corrected, scene, Detail::signs};
    TraceWriter writer(TraceHeader{request.method, request.edition, "float", request.detail, scene},
                       [&](std::string_view part) { trace += part; });
    write_checked_trace(request, writer);
    const std::string right = R"(,["right","3/1","3/1"],["low","0/1","0/1"],["end","4/1","4/1"]])";
    CHECK(trace.find(R"("exact":[1,3],"operands":[["left","1/2","536870913/1073741824"])" + right + "}\n" +
                     R"({"e":"disagree","at":"L4","of":"first_centre","taken":0,"exact":1,"cause":"drifted",)" +
                     R"("operands":[["x","1/2","536870913/1073741824"],["low","0/1","0/1"],["end","4/1","4/1"]]})") !=
          std::string::npos);
    // It is the only one, and the first step in the report is that of the event before it.
    CHECK(trace.find("disagree") == trace.rfind("disagree"));
    const auto report = check_run(request, right_picture(scene));
    const auto before = std::count(trace.begin(), trace.begin() + std::ptrdiff_t(trace.find("disagree")), '\n');
    REQUIRE(report.procedures.size() == 2);
    CHECK(report.procedures[1].procedure == Procedure::show_line);
    CHECK(report.procedures[1].first_wrong == std::uint64_t(before) - 1);  // less the header
}

TEST_CASE("The list has the requested number of narrow decisions, and these are the narrowest") {
    RandomScenes random(21);
    for (int i = 0; i < 40; i += thinning) {
        const AdmittedScene scene = random.scene();
        const auto few = of_kind(checked(scene, Method::warnock, "double", 5), FindingKind::narrow);
        auto all = of_kind(checked(scene, Method::warnock, "double", 1'000'000), FindingKind::narrow);
        REQUIRE(few.size() == std::min<std::size_t>(5, all.size()));
        std::sort(all.begin(), all.end(), [](auto& a, auto& b) { return a.gap->ulps < b.gap->ulps; });
        for (const auto& each : few) CHECK(each.gap->ulps <= all[few.size() - 1].gap->ulps);
        for (const auto& each : all) CHECK(each.gap->sign != Sign::zero);
    }
}

TEST_CASE("A constructed point half a pixel off is an error, and the report says at which step") {
    // The edges of a sliver are nearly parallel to a side of the window: cut there, with 8 bits, they come out pixels
    // away.
    RandomScenes random(24);
    int off = 0;
    for (int i = 0; i < 200; i += thinning) {
        const AdmittedScene scene = random.scene();
        const Checked found = checked(scene, Method::warnock, "bits:5");
        const auto points = of_kind(found, FindingKind::point);
        CHECK(found.report.points_off == points.size());
        if (points.empty()) continue;
        ++off;
        CHECK(found.report.found_something());
        const auto farthest =
            std::max_element(points.begin(), points.end(), [](auto& a, auto& b) { return a.off < b.off; });
        CHECK(farthest->off == found.report.farthest_off);
        CHECK(farthest->step == found.report.farthest_step);
        for (const auto& each : points) {
            CHECK(each.off > .5);
            CHECK(each.at == Line::PL5);
        }
    }
    CHECK(off > 0);
}

// The events of a window that is examined, with the level from which each appears: pop (windows), call of
// ProcessWindow (polygons), call of SurroundTest (signs), orient (signs), summary (polygons), decide (windows). Before
// each a decision was wrong.
TEST_CASE("The list has the steps of a level: that of an event, or the one that contains what happens up to it") {
    using Steps = std::vector<std::pair<std::uint64_t, bool>>;
    const auto found = [](Detail level) {
        FindingList list(Procedure::warnock, {0, 0, 1, 1}, 0, 0, level);
        const auto next = [&](const EventView& event) {
            Verdict wrong;
            wrong.of = Decision::orientation;
            wrong.right_for_operands = false;
            list.judge(wrong);
            list.follow(event);
        };
        next(event::Pop{Line::W5, {0, 0, 1, 1}});
        next(event::Call{Line::W6, Procedure::process_window});
        next(event::Call{Line::PW8, Procedure::surround_test});
        next(event::Orient{Line::S2, {0}, 0, {0., 0.}, 1., Sign::positive, {}});
        next(event::Summary{Line::W6, 1, false, {}, false});
        next(event::Decide{Line::W8, Case::surrounded});
        Steps steps;
        for (const Finding& each : list.findings()) steps.emplace_back(each.step, each.is_shown);
        return steps;
    };
    CHECK(found(Detail::signs) == Steps{{1, true}, {2, true}, {3, true}, {4, true}, {5, true}, {6, true}});
    CHECK(found(Detail::polygons) == Steps{{1, true}, {2, true}, {3, false}, {3, false}, {3, true}, {4, true}});
    CHECK(found(Detail::windows) == Steps{{1, true}, {2, false}, {2, false}, {2, false}, {2, false}, {2, true}});
}
