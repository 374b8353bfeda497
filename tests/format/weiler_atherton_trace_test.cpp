// Weiler and Atherton's algorithm as a method of the program: its check finds wrong decisions, its regions are a file.

#include <doctest/doctest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "check/check.h"
#include "check/checked_trace.h"
#include "format/trace_reader.h"
#include "output.h"
#include "regions/region_output.h"
#include "replay/state.h"
#include "run/write_trace.h"
#include "support/scenes.h"
#include "vidno/admission.h"

using namespace vidno;
using namespace vidno::test;

namespace {

RunRequest request_of(const AdmittedScene& scene, const std::string& kernel, Detail detail = Detail::windows) {
    return {Method::weiler_atherton, *kernel_named(kernel), Edition::corrected, scene, detail};
}

std::string traced(const AdmittedScene& scene, const std::string& kernel, Detail detail, bool checked = false) {
    std::string text;
    TraceWriter writer(TraceHeader{Method::weiler_atherton, Edition::corrected, kernel, detail, scene},
                       [&](std::string_view part) { text += part; });
    const RunRequest request = request_of(scene, kernel, detail);
    checked ? write_checked_trace(request, writer) : write_trace(request, writer);
    return text;
}

AdmittedScene near_before_far() { return SceneBuilder(area_16).polygon(far_quad).quad(6, 6, 10, 10, .5).build(); }

}  // namespace

TEST_CASE("Regions: the worked example of FORMAT.md is what the program writes") {
    std::ifstream file(VIDNO_ROOT "/trace/FORMAT.md");
    std::stringstream format;
    format << file.rdbuf();
    const std::string heading = "## An example of regions", opening = "```jsonl\n";
    const auto begin = format.str().find(opening, format.str().find(heading)) + opening.size();
    const auto end = format.str().find("```", begin);
    REQUIRE(end != std::string::npos);
    const std::string example = format.str().substr(begin, end - begin);
    const TraceReader reader(LineReader::of_text(example), "FORMAT.md");
    CHECK(traced(admit(reader.header().scene), reader.header().kernel, reader.header().detail) == example);
}

// Two planes meet in one line, so two triangles pierce each other once. In double the ends of the cut were rounded off
// that line. With another line for the same planes, computed with the polygons exchanged, the parts seemed to pierce
// each other again.
TEST_CASE("Regions: the parts of two polygons that pierced each other are not cut along their line again") {
    const AdmittedScene scene = SceneBuilder({8, -9, 8, 8})
                                    .polygon({{17.5, -8, 1}, {18.09375, 0, 0}, {14, -4, 0.09375}})
                                    .polygon({{11.375, -6, 0}, {15, -11, 0.125}, {16.25, -1, 0.126953125}})
                                    .build();
    for (const std::string kernel : {"float", "double", "filtered", "exact"}) {
        CAPTURE(kernel);
        int pierced = 0, faults = 0;
        FunctionSink sink([&](const EventView& event) {
            if (event.get_if<event::Pierce>()) ++pierced;
            if (event.get_if<event::Fault>()) ++faults;
        });
        RunRequest request = request_of(scene, kernel, Detail::polygons);
        request.sink = &sink;
        CHECK(run(request) == right_picture(scene));
        CHECK(pierced == 1);
        CHECK(faults == 0);
    }
}

TEST_CASE("Regions: an event that no run reports is refused") {
    const std::string text = traced(near_before_far(), "double", Detail::polygons);
    const auto refused = [&](const std::string& part, const std::string& instead) {
        std::string changed = text;
        changed.replace(changed.find(part), part.size(), instead);
        TraceReader reader(LineReader::of_text(changed), "trace");
        State state(reader.header());
        try {
            while (const auto event = reader.next()) state.apply(*event);
        } catch (const Refused& error) {
            return std::string(error.what());
        } catch (const Impossible& impossible) {
            return impossible.reason;
        }
        return std::string();
    };
    CHECK(refused(R"("e":"pop_list","at":"WA4","clip":"B")", R"("e":"pop_list","at":"WA4","clip":"A")") ==
          "not the list on top of the stack");
    CHECK(refused(R"("e":"clipped","at":"WA5","polygon":"A")", R"("e":"clipped","at":"WA5","polygon":"B")") ==
          "not the next polygon of the current list");
    CHECK(refused(R"(,false]])", R"(,0]])").find("not true or false") != std::string::npos);
}

TEST_CASE("Regions: a check finds nothing under filtered and exact, and rounding errors under double") {
    RandomScenes random(42);
    std::uint64_t wrong_in_double = 0;
    for (int i = 0; i < 60; ++i) {
        CAPTURE(i);
        const AdmittedScene scene = random.scene();
        const Picture right = right_picture(scene);
        for (const std::string kernel : {"filtered", "exact"}) {
            const CheckReport report = check_run(request_of(scene, kernel), right);
            CHECK_FALSE(report.found_something());
            CHECK((report.procedures.empty() || report.procedures.front().decisions > 0));
        }
        const CheckReport in_double = check_run(request_of(scene, "double"), right);
        CHECK((in_double.wrong_pixels == 0 || in_double.any_wrong()));
        wrong_in_double += in_double.any_wrong() ? 1 : 0;
    }
    CHECK(wrong_in_double > 0);
}

TEST_CASE("Regions: a wrong sign is reported as a sign, and a yes or no by its own name") {
    // B's vertex is on A's edge: 4.2 + (2.78 - .8) (4.4 - 4.2) / (4.1 - .8) = 4.2 + .12 = 4.32. Rounded, it is inside
    // A.
    const AdmittedScene touch = SceneBuilder({0, 0, 5, 5})
                                    .polygon({{4.1, 4.4, .5}, {.8, 4.2, .5}, {4, 5, .5}})
                                    .polygon({{2.78, 4.32, 0}, {0, 3, 0}, {1, 2, 0}})
                                    .build();
    TraceReader reader(LineReader::of_text(traced(touch, "double", Detail::signs, true)), "trace");
    std::set<Decision> found;
    while (const auto event = reader.next()) {
        const auto* wrong = event->get_if<event::Disagree>();
        if (wrong == nullptr) continue;
        CAPTURE(decision_names[std::size_t(wrong->of)]);
        const bool yes_or_no = wrong->of == Decision::left_of || wrong->of == Decision::parallel;
        CHECK(std::holds_alternative<bool>(wrong->taken) == yes_or_no);
        found.insert(wrong->of);
    }
    CHECK(found.contains(Decision::orientation));
    CHECK(found.contains(Decision::left_of));
}

TEST_CASE("Regions as a file: polygons with their areas, exact under exact") {
    const AdmittedScene scene = near_before_far();
    std::vector<ShownRegion> regions;
    RunRequest request = request_of(scene, "exact");
    request.regions = &regions;
    run(request);
    const auto read = nlohmann::json::parse(regions_json(regions, request));
    CHECK(read["format"] == "vidno-regions/1");
    CHECK(read["kernel"] == "exact");
    REQUIRE(read["regions"].size() == 2);
    // The nearest is found first: 4 x 4 = 16. The quad over the area keeps 16 x 16 - 16 = 240, around a hole.
    CHECK(read["regions"][0]["polygon"] == "B");
    CHECK(read["regions"][0]["area"] == "16/1");
    CHECK(read["regions"][0]["loops"].size() == 1);
    CHECK(read["regions"][1]["area"] == "240/1");
    CHECK(read["regions"][1]["loops"].size() == 2);
    CHECK(read["regions"][0]["loops"][0].size() == 4);
}
