// Conditions, what their names measure, and scenes found for them.

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>

#include "find/measures.h"
#include "find/scene_size.h"
#include "find/search.h"
#include "find/until.h"
#include "refused.h"
#include "scene/exact_scene.h"

namespace vidno {

namespace {

std::string refusal_of_condition(const std::string& text) {
    try {
        const Condition condition(text);
    } catch (const Refused& refused) {
        return refused.what();
    }
    return "";
}

AdmittedScene scene_of(std::vector<std::vector<glm::dvec3>> outlines, int width, int height) {
    Scene scene;
    scene.area = {0, 0, width, height};
    for (auto& vertices : outlines) {
        const auto place = int(scene.polygons.size());
        scene.polygons.push_back({std::string(1, char('A' + place)), {std::uint8_t(place), 0, 0}, vertices, false});
    }
    return exact_scene::admit(std::move(scene));
}

const std::vector<glm::dvec3> far_square{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
const std::vector<glm::dvec3> nearer_corner{{0, 0, .5}, {1, 0, .5}, {1, 1, .5}, {0, 1, .5}};

double value_of(const std::string& name, const AdmittedScene& scene, Method method = Method::warnock) {
    return measured(Condition(name), scene, method, kernel_of(KernelKind::exact)).front();
}

}  // namespace

TEST_CASE("a condition that cannot be read is refused with the place") {
    CHECK(refusal_of_condition("PW7 > ") == "PW7 > : at character 7: something is missing at the end");
    CHECK(refusal_of_condition("PW7 = 1") == "PW7 = 1: at character 5: equality is written ==");
    CHECK(refusal_of_condition("W5 > 0 && foo") == "W5 > 0 && foo: at character 11: no name foo (vidno find --list)");
    CHECK(refusal_of_condition("W4 > 0") == "W4 > 0: at character 1: no step is reported at the line W4");
    CHECK(refusal_of_condition("(W5 > 1") == "(W5 > 1: at character 8: a parenthesis is missing");
    CHECK(refusal_of_condition("W5 5") == "W5 5: at character 4: an operator is missing before it");
    CHECK(refusal_of_condition("pixels > 1") == "pixels > 1: at character 1: pixels is written pixels(ID)");
    CHECK(refusal_of_condition("W5 > 1, W7") == "W5 > 1, W7: at character 7: unexpected comma; write && or ||");
    // A letter of two bytes is one character.
    CHECK(refusal_of_condition("pixels(Ж) > ^") == "pixels(Ж) > ^: at character 13: unexpected operator ^");
    CHECK(refusal_of_condition(" ") == "the condition is empty");
}

TEST_CASE("a condition has names, parts and a distance") {
    const Condition condition("pixels( A )>3 && (wrong(bits:9) == 0 || windows<=1e1) && pixels(A) != 5");
    REQUIRE(condition.names().size() == 3);
    CHECK(condition.names()[0].text() == "pixels(A)");
    CHECK(condition.names()[1].text() == "wrong(bits:9)");
    CHECK(condition.names()[2].text() == "windows");
    CHECK(condition.parts() ==
          std::vector<std::string>{"pixels( A )>3", "wrong(bits:9) == 0 || windows<=1e1", "pixels(A) != 5"});
    CHECK(condition.is_met({4, 1, 10}));
    CHECK(condition.distance({4, 1, 10}) == 0);
    CHECK_FALSE(condition.is_met({5, 0, 0}));
    CHECK_FALSE(condition.is_met({5, 0, 0}, 2));
    CHECK(condition.is_met({5, 0, 0}, 0));
    CHECK(condition.distance({0, 0, 0}) > condition.distance({2, 0, 0}));
    CHECK(condition.distance({4, 9, 50}) > condition.distance({4, 9, 11}));
    CHECK(Condition("!(ulps < 4)").is_met({std::numeric_limits<double>::infinity()}));
    CHECK(Condition("W5 > 1 ? W7 : W8").is_met({2, 0, 1}) == false);
}

TEST_CASE("what the names of a condition measure") {
    const AdmittedScene scene = scene_of({far_square, nearer_corner}, 4, 4);
    CHECK(value_of("windows", scene) == 9);
    CHECK(value_of("splits", scene) == 2);
    CHECK(value_of("depth_of_stack", scene) == 4);  // the corner comes last
    CHECK(value_of("W13", scene) == 2);
    CHECK(value_of("W5", scene) == 9);
    CHECK(value_of("W3", scene) == 1);
    CHECK(value_of("polygons", scene) == 2);
    CHECK(value_of("vertices", scene) == 8);
    CHECK(value_of("coordinates", scene) == 4);
    CHECK(value_of("pixels(A)", scene) == 15);
    CHECK(value_of("pixels(B)", scene) == 1);
    CHECK(value_of("pixels(C)", scene) == 0);
    CHECK(value_of("wrong(float)", scene) == 0);
    CHECK(value_of("zeros", scene) > 0);
    CHECK(value_of("Z6", scene, Method::zbuffer) == 5);
    CHECK(value_of("L6", scene, Method::zbuffer) == 17);
    // Halves are the units here.
    CHECK(value_of("coordinates", scene_of({{{0, 0, 0}, {1.5, 0, 0}, {1, 1, .25}}}, 1, 1)) == 3);
}

TEST_CASE("pixels are counted for each polygon, although colours are equal") {
    Scene scene = scene_of({far_square, nearer_corner}, 4, 4);
    for (auto& polygon : scene.polygons) polygon.color = scene.background;
    CHECK(value_of("pixels(A)", exact_scene::admit(std::move(scene))) == 15);
}

TEST_CASE("what the names of a condition measure in curves") {
    // The farther curve rises out of the nearer one between the columns 0 and 1, and meets it again on column 2.
    const AdmittedCurves curves = admit(CurveScene{{0, 0, 3, 4}, {{{{0, 2}, {2, 2}}}, {{{0, 2.5}, {1, 1}, {2, 2}}}}});
    const auto value = [&](const std::string& name) {
        return measured(Condition(name), curves, kernel_of(KernelKind::exact)).front();
    };
    CHECK(value("curves") == 2);
    CHECK(value("samples") == 5);
    CHECK(value("coordinates") == 5);  // halves
    CHECK(value("FH4") == 2);
    CHECK(value("FH5") == 4);  // two columns of each curve
    CHECK(value("wrong(double)") == 0);
    CHECK(value("zeros") > 0);
}

TEST_CASE("a condition determines a method that has its names") {
    CHECK(method_for(Condition("windows > 1")) == "warnock");
    CHECK(method_for(Condition("Z16 > 0")) == "zbuffer");
    CHECK(method_for(Condition("FH8 > 0")) == "floating-horizon");
    CHECK(method_for(Condition("curves > 1")) == "floating-horizon");
    CHECK_THROWS_AS(method_for(Condition("Z16 > 0 && W7 > 0")), Refused);
    CHECK_THROWS_AS(method_for(Condition("FH8 > 0 && windows > 0")), Refused);
    CHECK_THROWS_AS(expect_suits(Condition("Z16 > 0"), "warnock"), Refused);
    CHECK_THROWS_AS(expect_suits(Condition("wrong(depth:8) > 0"), "warnock"), Refused);
    CHECK_THROWS_AS(expect_suits(Condition("wrong(depth:8) > 0"), "floating-horizon"), Refused);
}

TEST_CASE("a trace until a condition is the beginning of the whole trace, and ends with the step that meets it") {
    const AdmittedScene scene = scene_of({far_square, nearer_corner}, 4, 4);
    for (const Detail detail : {Detail::windows, Detail::polygons, Detail::signs}) {
        const RunRequest request{Method::warnock, kernel_of(KernelKind::binary64), Edition::corrected, scene, detail};
        const auto traced = [&](const std::string& until) {
            std::string text;
            TraceWriter writer(TraceHeader{request.method, request.edition, request.kernel.name(), detail, scene},
                               [&](std::string_view part) { text += part; });
            const bool whole = until.empty() ? write_trace(request, writer) : write_trace_until(until, request, writer);
            return std::pair{whole, text};
        };
        const auto events_of = [](const std::string& text) { return text.substr(0, text.rfind("{\"end\"")); };
        const auto [is_whole, whole] = traced("");
        REQUIRE(is_whole);
        const auto [second_is_whole, second] = traced("W13 == 2");
        CHECK_FALSE(second_is_whole);
        const std::string begin = events_of(second);
        CHECK(whole.starts_with(begin));
        // The second window is split at its last step.
        CHECK(begin.substr(begin.rfind('\n', begin.size() - 2) + 1).find("\"at\":\"W13\"") != std::string::npos);
        CHECK(second.ends_with("\"partial\":true}}\n"));
        CHECK(traced("windows > 9") == std::pair{true, whole});
        // It is met from the beginning, by the first step, which is not of level windows.
        const std::string first = traced("polygons == 2").second;
        CHECK(std::count(first.begin(), first.end(), '\n') == (detail == Detail::windows ? 2 : 3));
        CHECK_THROWS_AS(traced("zeros > 0"), Refused);
    }
}

TEST_CASE("a search finds the same small scene again") {
    const Condition condition("W12 > 0 && windows == 1");
    const auto found = search({condition, "warnock"}).found;
    REQUIRE(found);
    const auto& scene = std::get<AdmittedScene>(*found);
    CHECK(SceneSize(*scene).parts() == 1);
    CHECK(SceneSize(*scene).points() == 3);
    CHECK(condition.is_met(measured(condition, scene, Method::warnock, kernel_of(KernelKind::exact))));
    CHECK(search({condition, "warnock"}).found == found);
}

TEST_CASE("a search finds curves for the lines of the floating horizon") {
    // Two curves that cross: the farther one leaves one horizon between two columns.
    const Condition condition("FH8 > 0");
    const auto found = search({condition, method_for(condition)}).found;
    REQUIRE(found);
    const auto& curves = std::get<Surface>(*found).curves;
    CHECK(SceneSize(*curves).parts() == 2);
    CHECK(SceneSize(*curves).points() == 4);
    CHECK(condition.is_met(measured(condition, curves, kernel_of(KernelKind::exact))));
}

TEST_CASE("a search that finds nothing says which parts were never met") {
    const Condition condition("W5 > 0 && polygons == 1 && splits > 0 && windows < 0");
    SearchRequest request{condition, "warnock"};
    request.seconds = 0.5;
    const SearchReport report = search(request);
    CHECK_FALSE(report.found);
    CHECK(report.scenes > 0);
    CHECK(report.met.at(0) > 0);
    CHECK(report.met.at(3) == 0);
    CHECK(report.most_parts == 2);
}

}  // namespace vidno
