// Conditions, what their names measure, and scenes found for them.

#include <doctest/doctest.h>

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

TEST_CASE("a condition determines a method that has its lines") {
    CHECK(method_for(Condition("windows > 1")) == Method::warnock);
    CHECK(method_for(Condition("Z16 > 0")) == Method::zbuffer);
    CHECK_THROWS_AS(method_for(Condition("Z16 > 0 && W7 > 0")), Refused);
    CHECK_THROWS_AS(expect_suits(Condition("Z16 > 0"), Method::warnock), Refused);
    CHECK_THROWS_AS(expect_suits(Condition("wrong(depth:8) > 0"), Method::warnock), Refused);
}

TEST_CASE("a trace until a condition ends with the step that meets it") {
    const AdmittedScene scene = scene_of({far_square, nearer_corner}, 4, 4);
    for (const Detail detail : {Detail::windows, Detail::polygons, Detail::signs}) {
        RunRequest request{Method::warnock, kernel_of(KernelKind::binary64), Edition::corrected, scene, detail};
        const auto last = events_until("W13 == 2", request);
        REQUIRE(last);
        std::uint64_t events = 0, splits = 0;
        FunctionSink sink([&](const EventView& event) {
            const auto* decide = event.get_if<event::Decide>();
            splits += decide && decide->which == Case::split ? 1 : 0;
            if (++events == *last) CHECK((decide && splits == 2));
        });
        request.sink = &sink;
        traced_run(request);
        CHECK(events > *last);
        CHECK_FALSE(events_until("windows > 9", request));
        CHECK(events_until("polygons == 2", request).value_or(2) <= 1);  // the first is of level polygons
        CHECK_THROWS_AS(events_until("zeros > 0", request), Refused);
    }
}

TEST_CASE("a search finds the same small scene again") {
    const Condition condition("W12 > 0 && windows == 1");
    const auto found = search({condition, Method::warnock}).found;
    REQUIRE(found);
    CHECK(SceneSize(*found).polygons() == 1);
    CHECK(SceneSize(*found).vertices() == 3);
    CHECK(condition.is_met(measured(condition, *found, Method::warnock, kernel_of(KernelKind::exact))));
    CHECK(search({condition, Method::warnock}).found == found);
}

TEST_CASE("a search that finds nothing says which parts were never met") {
    const Condition condition("W5 > 0 && polygons == 1 && splits > 0 && windows < 0");
    SearchRequest request{condition, Method::warnock};
    request.seconds = 0.5;
    const SearchReport report = search(request);
    CHECK_FALSE(report.found);
    CHECK(report.scenes > 0);
    CHECK(report.met.at(0) > 0);
    CHECK(report.met.at(3) == 0);
    CHECK(report.most_parts == 2);
}

}  // namespace vidno
