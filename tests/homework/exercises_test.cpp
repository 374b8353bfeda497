// Exercises made from a scene: equally hard, with other numbers.

#include <doctest/doctest.h>

#include <filesystem>
#include <set>

#include "homework/exercises.h"
#include "homework/profile.h"
#include "output.h"
#include "refused.h"
#include "run/run.h"
#include "scene/scene_json.h"
#include "stability/shrink.h"
#include "support/scenes.h"
#include "support/workplace.h"

namespace vidno {

namespace {

struct Original {
    const char* scene;
    Method method;
};

const std::array originals{Original{VIDNO_ROOT "/lessons/01-four-relations/scene.json", Method::warnock},
                           Original{VIDNO_ROOT "/lessons/03-subdivision/scene.json", Method::warnock},
                           Original{VIDNO_ROOT "/lessons/07-z-buffer-ael/scene.json", Method::zbuffer},
                           // Two polygons in one plane, whose slope of 1/128 is not short.
                           Original{VIDNO_ROOT "/lessons/08-show-line/scene.json", Method::zbuffer}};

AdmittedScene read(const std::string& file) { return read_scene(read_file(file), file).scene; }

std::vector<AdmittedScene> some_exercises(const AdmittedScene& scene, Method method, std::uint64_t seed = 7) {
    return exercises_of(scene, method, 6, seed, [](std::size_t) {});
}

int most_binary_places(const ScenePolygon& polygon) {
    int most = 0;
    for (const auto& vertex : polygon.vertices) {
        for (int axis = 0; axis < 3; ++axis) most = std::max(most, binary_places(vertex[axis]));
    }
    return most;
}

/// The pixels' colours, read as if the picture were mirrored (1, 2) or turned by half (3).
std::vector<Color> seen(const Picture& picture, int how) {
    const Area& area = picture.area();
    std::vector<Color> colors;
    for (int y = 0; y < area.height; ++y) {
        for (int x = 0; x < area.width; ++x) {
            colors.push_back(
                picture.at(area.x + (how & 1 ? area.width - 1 - x : x), area.y + (how & 2 ? area.height - 1 - y : y)));
        }
    }
    return colors;
}

}  // namespace

TEST_CASE("profile: the windows of one quad in the upper left quarter, by hand") {
    // The quad's box is inside the whole window, and no other polygon is there: one window, one entry, W10 and W11.
    const AdmittedScene scene = test::SceneBuilder(test::area_16).quad(1, 1, 5, 5, 0).build();
    const Profile profile = profiled_run(scene, Method::warnock).profile;
    CHECK(profile.counts == std::map<std::string, std::uint64_t>{{"entries of APLs", 1}, {"single at level 0", 1}});
    CHECK(profile.met.contains("line W11"));
    CHECK_FALSE(profile.met.contains("line W13"));
    CHECK_FALSE(profile.met.contains("tie"));
}

TEST_CASE("profile: rows, changes of the AEL and pixels of a quad behind another, by hand") {
    // Four rows, 1.5 to 4.5; two edges enter and leave, and step to each of the other three rows. The second quad
    // covers the same 16 pixels at the same depth, so it loses each of them in a tie.
    const AdmittedScene scene = test::SceneBuilder(test::area_16).quad(1, 1, 5, 5, 0).quad(1, 1, 5, 5, 0).build();
    const Profile profile = profiled_run(scene, Method::zbuffer).profile;
    CHECK(profile.counts == std::map<std::string, std::uint64_t>{{"changes of the AEL of A", 10},
                                                                 {"changes of the AEL of B", 10},
                                                                 {"pixels rejected of B", 16},
                                                                 {"pixels written of A", 16},
                                                                 {"rows of A", 4},
                                                                 {"rows of B", 4}});
    CHECK(profile.met.contains("tie"));
}

TEST_CASE("profile: equally hard means counts within a tenth and a total within a twentieth") {
    const Profile original{{"line W13"}, {{"split at level 0", 1}, {"pixel at level 4", 40}}};
    const auto with = [&](std::uint64_t splits, std::uint64_t pixels) {
        Profile profile = original;
        profile.counts = {{"split at level 0", splits}, {"pixel at level 4", pixels}};
        return profile;
    };
    CHECK(is_as_hard(original, original));
    CHECK(is_as_hard(with(1, 43), original));        // a twentieth of 41, 2.05, is rounded up to 3
    CHECK_FALSE(is_as_hard(with(1, 44), original));  // a tenth of 40, but more than a twentieth of the whole
    CHECK_FALSE(is_as_hard(with(3, 40), original));  // 2 more than 1
    CHECK_FALSE(is_as_hard({{"line W12"}, original.counts}, original));
}

TEST_CASE("exercises: each scene is valid, is as hard as the lesson's, and has no finer numbers" *
          doctest::skip(test::sanitized)) {
    for (const auto& [name, method] : originals) {
        const std::string file = name;
        CAPTURE(file);
        const AdmittedScene original = read(file);
        const Profile profile = profiled_run(original, method).profile;
        const auto exercises = some_exercises(original, method);
        REQUIRE(exercises.size() == 6);
        for (const AdmittedScene& exercise : exercises) {
            CHECK(read_scene(scene_json(exercise), "exercise.json").warnings.empty());
            CHECK(read_scene(scene_json(exercise), "exercise.json").scene == exercise);
            CHECK(by_hand(exercise, method, "exercise.json").note.empty());
            CHECK(is_as_hard(profiled_run(exercise, method).profile, profile));
            REQUIRE(exercise->polygons.size() == original->polygons.size());
            for (std::size_t i = 0; i < exercise->polygons.size(); ++i) {
                CHECK(exercise->polygons[i].id == original->polygons[i].id);
                CHECK(exercise->polygons[i].color == original->polygons[i].color);
                CHECK(exercise->polygons[i].vertices.size() == original->polygons[i].vertices.size());
                CHECK(most_binary_places(exercise->polygons[i]) <= most_binary_places(original->polygons[i]));
            }
        }
    }
}

namespace {

/// Counts the slopes and depths of an exact run, and keeps those with more than two digits on a side of the line.
class Digits final : public EventSink {
public:
    void hear(const EventView& event) override {
        event.visit([this](const auto& e) { note(e); });
    }
    std::size_t count = 0;
    std::vector<std::string> long_ones{};

private:
    void note(const event::Depth& e) { look_at(e.z); }
    void note(const event::AelAdd& e) {
        for (const Value& value : {e.z, e.dx, e.dz}) look_at(value);
    }
    void note(const event::AelStep& e) { look_at(e.z); }
    void note(const event::Slope& e) { look_at(e.dz); }
    void note(const event::Pixel& e) { look_at(e.z); }
    void note(const auto&) {}

    void look_at(const Value& value) {
        if (!value.fraction) return;  // minus infinity
        ++count;
        const std::string& text = *value.fraction;
        const auto line = text.find('/');
        const std::size_t sign = text.starts_with('-') ? 1 : 0;
        if (line - sign > 2 || text.size() - line - 1 > 2) long_ones.push_back(text);
    }
};

}  // namespace

TEST_CASE("exercises: a short number is a fraction with at most two digits on each side of its line") {
    for (const double number : {0., 0.25, -17. / 22, 99. / 98, 1. / 99, 99., -1. / 3}) CHECK(is_short(number));
    for (const double number : {1. / 100, 100., 101. / 2, 0.2596, -5. / 128}) CHECK_FALSE(is_short(number));
}

TEST_CASE("exercises: slopes and depths that are computed are short, although the lesson's are not" *
          doctest::skip(test::sanitized)) {
    for (const auto& [name, method] : originals) {
        const std::string file = name;
        CAPTURE(file);
        const auto digits_of = [&, by = method](const AdmittedScene& scene) {
            Digits digits;
            run({by, kernel_of(KernelKind::exact), Edition::corrected, scene, Detail::signs, &digits});
            return digits;
        };
        const AdmittedScene original = read(file);
        // The pentagon of lesson 7 has an edge that begins on row 12, at a depth of 11/128; lesson 8 has a slope of
        // 1/128.
        const std::size_t longer = digits_of(original).long_ones.size();
        CHECK((longer == 0) == (method == Method::warnock));
        for (const AdmittedScene& exercise : some_exercises(original, method)) {
            const Digits digits = digits_of(exercise);
            CHECK(digits.count > 100);
            // In lesson 8 edges and area leave no room for short numbers alone.
            if (file.find("/08-") != std::string::npos) {
                CHECK(digits.long_ones.size() <= longer);
            } else {
                CHECK(digits.long_ones == std::vector<std::string>{});
            }
        }
    }
}

TEST_CASE("exercises: no two show the same picture, mirrored or not, nor that of the original" *
          doctest::skip(test::sanitized)) {
    for (const auto& [name, method] : originals) {
        const std::string file = name;
        CAPTURE(file);
        auto scenes = some_exercises(read(file), method);
        scenes.push_back(read(file));
        for (std::size_t i = 0; i < scenes.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                const Picture one = profiled_run(scenes[i], method).picture;
                const Picture other = profiled_run(scenes[j], method).picture;
                for (int how = 0; how < 4; ++how) CHECK(seen(one, 0) != seen(other, how));
            }
        }
    }
}

TEST_CASE("exercises: the same seed gives the same scenes, another seed gives others") {
    const AdmittedScene scene = read(originals[0].scene);
    const auto exercises = some_exercises(scene, Method::warnock);
    CHECK(some_exercises(scene, Method::warnock) == exercises);
    CHECK(some_exercises(scene, Method::warnock, 8) != exercises);
}

TEST_CASE("homework: no exercises if nothing can be moved, and exit 1 for fewer than requested") {
    // One pixel that one polygon covers: every exercise made from it has the same picture.
    const Workplace work;
    const std::string scene =
        work.write("scene.json", R"({"format":"vidno-scene/1","window":{"x":0,"y":0,"width":1,"height":1},"polygons":[)"
                                 R"({"color":"#ff0000","vertices":[[0,0,0],[1,0,0],[1,1,0],[0,1,0]]}]})");
    const auto outcome = program("homework " + scene + " --count 3 -o " + work.file("homework"));
    CHECK(outcome.status == 1);
    CHECK(outcome.text.find("0 of 3 exercises") != std::string::npos);
    CHECK(std::filesystem::is_empty(work.file("homework")));
}

TEST_CASE("homework: numbered files, the same bytes each time, also by the command's earlier name") {
    const Workplace work;
    const std::string words = std::string(" ") + originals[2].scene + " --method zbuffer --count 3 --seed 5 -o ";
    REQUIRE(program("homework" + words + work.file("a")).status == 0);
    REQUIRE(program("variants" + words + work.file("b")).status == 0);
    for (const std::string name : {"01.json", "02.json", "03.json"}) {
        CHECK(work.read("a/" + name) == work.read("b/" + name));
        CHECK(work.read("a/" + name).find("A pentagon and its active edges · " + name.substr(0, 2)) !=
              std::string::npos);
    }
}

TEST_CASE("exercises: a scene without polygons is refused") {
    CHECK_THROWS_WITH_AS(by_hand(test::SceneBuilder(test::area_16).build(), Method::warnock, "scene.json"),
                         "scene.json: polygons: there are none", Refused);
}

TEST_CASE("exercises: decimal coordinates are rounded to a lattice on which the picture stays the same") {
    // Multiples of 1/2 and of 1/4 would put both squares at one depth, where the first wins; 1/8 keeps them apart.
    const AdmittedScene scene =
        test::SceneBuilder(test::area_16).quad(1, 1, 5.1, 5.1, 0.15).quad(3.1, 3.1, 9, 9, 0.2).build();
    const auto [rounded, note] = by_hand(scene, Method::zbuffer, "scene.json");
    CHECK(note == "coordinates rounded to multiples of 1/8; the picture stays the same");
    CHECK(rounded->polygons[0].vertices[2] == glm::dvec3{5.125, 5.125, 0.125});
    CHECK(rounded->polygons[1].vertices[0] == glm::dvec3{3.125, 3.125, 0.25});
}

}  // namespace vidno
