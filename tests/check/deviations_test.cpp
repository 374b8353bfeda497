// The table of deviations: each has a witness in the atlas that tells it from the corrected run, and from every other.

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "check/check.h"
#include "choice/edition.h"
#include "output.h"
#include "run/floating_horizon_run.h"
#include "run/write_trace.h"
#include "scene/scene_json.h"
#include "scene/surface.h"
#include "support/reference.h"
#include "support/scenes.h"

using namespace vidno;
using namespace vidno::test;
using nlohmann::json;

namespace {

std::vector<Deviation> all_deviations() {
    std::vector<Deviation> all;
    for (std::size_t i = 0; i < deviations.size(); ++i) all.push_back(Deviation(i));
    return all;
}

std::string file_of(std::string_view witness) {
    return VIDNO_ROOT "/lessons/failures/" + std::string(witness) + ".json";
}

/// The entry of the atlas, and the run that fails.
struct Witness {
    json entry;
    std::string method;
    NamedKernel kernel;

    explicit Witness(Deviation deviation)
        : entry(json::parse(read_file(file_of(choice_of(deviation).witness)))),
          method(entry["fails"]["method"]),
          kernel(*kernel_named(entry["fails"]["kernel"].get<std::string>())) {}

    bool of_curves() const { return method == floating_horizon_method; }
    Method method_of_polygons() const { return method_named(method); }
    bool runs(Edition edition) const {
        return of_curves() ? kernel.choice->runs_floating_horizon(edition)
                           : kernel.choice->runs(method_of_polygons(), edition);
    }

    /// The whole trace of the run, without its header.
    std::string reported(Edition edition) const {
        return reported(edition, of_curves() ? Method{} : method_of_polygons());
    }

    /// What another method of polygons reports.
    std::string reported(Edition edition, Method by) const {
        std::string text;
        const auto write = [&](std::string_view part) { text += part; };
        const std::string scene_text = entry["scene"].dump();
        if (of_curves()) {
            const Surface surface = read_surface(scene_text, "witness");
            TraceWriter writer(FloatingHorizonHeader{edition, kernel.name(), Detail::signs, surface}, write);
            write_trace(FloatingHorizonRequest{kernel, edition, surface.curves, Detail::signs}, writer);
        } else {
            const AdmittedScene scene = read_scene(scene_text, "witness").scene;
            TraceWriter writer(TraceHeader{by, edition, kernel.name(), Detail::signs, scene}, write);
            write_trace({by, kernel, edition, scene, Detail::signs}, writer);
        }
        return text.substr(text.find('\n'));
    }
};

bool tells_apart(const Witness& witness, Edition one, Edition other) {
    return witness.runs(one) && witness.runs(other) && witness.reported(one) != witness.reported(other);
}

/// Whether a method, not always that of the witness, tells the editions apart.
bool tells_apart(const Witness& witness, Method by, Edition one, Edition other) {
    const auto runs = [&](Edition edition) { return witness.kernel.choice->runs(by, edition); };
    return !witness.of_curves() && runs(one) && runs(other) && witness.reported(one, by) != witness.reported(other, by);
}

bool share_a_method(Deviation one, Deviation other) {
    const auto& methods = choice_of(one).methods;
    const auto& others = choice_of(other).methods;
    return (methods.empty() && others.empty()) || std::any_of(methods.begin(), methods.end(), [&](Method method) {
               return std::find(others.begin(), others.end(), method) != others.end();
           });
}

const json& listings() {
    static const json read = json::parse(read_file(VIDNO_ROOT "/trace/listings/listings.json"));
    return read;
}

/// The labels of the lines that the listings mark as printed, by the ids of the defects.
std::map<std::string, std::vector<std::string>> printed_lines() {
    std::map<std::string, std::vector<std::string>> lines;
    for (const json& procedure : listings()["procedures"]) {
        for (const json& line : procedure["lines"]) {
            if (!line.contains("printed")) continue;
            for (std::string defect : line["printed"]["defects"]) {
                std::transform(defect.begin(), defect.end(), defect.begin(),
                               [](unsigned char c) { return std::tolower(c); });
                lines[defect].push_back(line["at"]);
            }
        }
    }
    return lines;
}

}  // namespace

TEST_CASE("Deviations: each has a witness whose failing run is its own, and that tells it from the corrected run") {
    for (const Deviation deviation : all_deviations()) {
        const std::string name = name_of(deviation);
        CAPTURE(name);
        const Witness witness(deviation);
        CHECK(edition_named(witness.entry["fails"]["edition"].get<std::string>()) == Edition(deviation));
        CHECK(witness.entry["holds"]["edition"] == "corrected");
        CHECK(tells_apart(witness, deviation, Edition::corrected));
    }
}

TEST_CASE("Deviations: the witness of one of two that share a method tells them apart") {
    for (const Deviation one : all_deviations()) {
        for (const Deviation other : all_deviations()) {
            if (!(one < other) || !share_a_method(one, other)) continue;
            const std::string names = name_of(one) + " and " + name_of(other);
            CAPTURE(names);
            CHECK((tells_apart(Witness(one), one, other) || tells_apart(Witness(other), one, other)));
        }
    }
}

TEST_CASE(
    "Deviations: a witness tells each from the corrected run and from every other one by each method that has it") {
    for (const Deviation one : all_deviations()) {
        const Witness witness(one);
        for (const Method method : choice_of(one).methods) {
            CAPTURE(int(method));
            const std::string name = name_of(one);
            CAPTURE(name);
            CHECK(tells_apart(witness, method, one, Edition::corrected));
            for (const Deviation other : all_deviations()) {
                const auto& methods = choice_of(other).methods;
                if (!(one < other) || std::find(methods.begin(), methods.end(), method) == methods.end()) continue;
                const std::string other_name = name_of(other);
                CAPTURE(other_name);
                CHECK((tells_apart(witness, method, one, other) || tells_apart(Witness(other), method, one, other)));
            }
        }
    }
}

TEST_CASE("Deviations: a defect changes the lines that the listings have as printed") {
    auto lines = printed_lines();
    for (const auto* without_effect : {"x-w10", "x-z8", "x-h7"})
        CHECK(lines.erase(without_effect) == 1);  // on our runs
    CHECK(lines.erase("x-z9") == 1);              // only the whole printed text has it
    for (const auto& choice : deviations) {
        if (choice.defect.empty() || !choice.mistake.empty()) continue;
        CAPTURE(choice.defect);
        std::vector<std::string> labels;
        for (const Line line : choice.lines) labels.emplace_back(line_names[std::size_t(line)]);
        CHECK(lines[std::string(choice.defect)] == labels);
        lines.erase(std::string(choice.defect));
    }
    CHECK(lines == std::map<std::string, std::vector<std::string>>{{"x-w9", {"W13"}}});
}

TEST_CASE("Deviations: a mistake says how it writes each of its lines, otherwise than the listings") {
    std::map<std::string, json> corrected;
    for (const json& procedure : listings()["procedures"]) {
        for (const json& line : procedure["lines"]) corrected[line["at"]] = line;
    }
    for (const auto& choice : deviations) {
        CAPTURE(choice.title.english);
        for (std::size_t i = 0; i < choice.reads.size(); ++i) {
            const auto& [english, russian] = choice.reads[i];
            const bool has_line = !choice.mistake.empty() && i < choice.lines.size();
            CHECK(english.empty() != has_line);
            CHECK(russian.empty() != has_line);
            if (!has_line) continue;
            const json& line = corrected.at(std::string(line_names[std::size_t(choice.lines[i])]));
            CHECK(line["en"] != english);
            CHECK(line["ru"] != russian);
        }
    }
}

TEST_CASE("Deviations: each has a name, a sentence in each language, and lines") {
    std::set<std::string> names;
    for (const Deviation deviation : all_deviations()) {
        const auto& choice = choice_of(deviation);
        names.insert(name_of(deviation));
        CHECK_FALSE(choice.title.english.empty());
        CHECK_FALSE(choice.title.russian.empty());
        CHECK_FALSE(choice.says.english.empty());
        CHECK_FALSE(choice.says.russian.empty());
        CHECK_FALSE(choice.lines.empty());
    }
    CHECK(names.size() == deviations.size());
}

TEST_CASE("Editions: single defects are named in any order, and called in that of the table") {
    const auto edition = edition_named("printed:x-w4+x-w2");
    REQUIRE(edition);
    CHECK(edition->has(Deviation::x_w2));
    CHECK(edition->has(Deviation::x_w4));
    CHECK_FALSE(edition->has(Deviation::x_w3));
    CHECK(name_of(*edition) == "printed:x-w2+x-w4");
    CHECK(edition_named("printed:x-w4+x-w4") == Edition(Deviation::x_w4));
    for (const char* const none : {"", "printed:", "printed:x-w2+", "printed:+x-w2", "printed:x-w10",
                                   "printed:one-list", "printed:x-z8", "x-w2", "corrected:x-w2"}) {
        CAPTURE(none);
        CHECK_FALSE(edition_named(none));
    }
}

TEST_CASE("Editions: one list for all parts is a usual mistake and the defect X-W9") {
    CHECK(edition_named("printed:x-w9") == edition_named("one-list"));
    CHECK(is_mistake(*edition_named("printed:x-w9")));
    CHECK(name_of(*edition_named("printed:x-w9+x-w2")) == "printed:x-w2+x-w9");
}

TEST_CASE("Editions: all defects together are the printed text") {
    std::string all = "printed:";
    for (const auto& choice : deviations) {
        if (!choice.defect.empty()) all += (all.back() == ':' ? "" : "+") + std::string(choice.defect);
    }
    CHECK(edition_named(all) == Edition::printed);
    // Each method has its own deviations and no others.
    CHECK(has_text(Edition::printed, Method::warnock));
    CHECK(has_text_of_curves(Edition::printed));
    CHECK_FALSE(has_text(Edition::printed, Method::warnock_full));
    CHECK(has_text(*edition_named("printed:x-w2+x-w6"), Method::warnock));
    CHECK_FALSE(has_text(*edition_named("printed:x-w2+x-w6"), Method::zbuffer));
    CHECK(has_text(*edition_named("printed:x-w6"), Method::zbuffer));
    CHECK_FALSE(has_text_of_curves(*edition_named("printed:x-w6")));
}

TEST_CASE("Single defects: with all of Warnock's the run is that of the printed text") {
    RandomScenes random(20261124);
    const Edition defects = *edition_named("printed:x-w1+x-w2+x-w3+x-w4+x-w5+x-w6+x-w7+x-w8+x-w9");
    for (int i = 0; i < 20; ++i) {
        CAPTURE(i);
        const AdmittedScene scene = random.scene();
        for (const char* kernel : {"double", "exact"}) {
            const NamedKernel named = *kernel_named(kernel);
            CHECK(run({Method::warnock, named, defects, scene}) ==
                  run({Method::warnock, named, Edition::printed, scene}));
        }
    }
}

TEST_CASE("Single defects: a run ends on every scene, and paints the same when it is judged") {
    RandomScenes random(20261125);
    for (int i = 0; i < 8; ++i) {
        CAPTURE(i);
        const AdmittedScene scene = random.scene();
        const Picture right = Reference(scene).picture();
        for (const Deviation deviation : all_deviations()) {
            if (is_mistake(deviation)) continue;  // tests/lib/mistakes_test.cpp
            const std::string name = name_of(deviation);
            CAPTURE(name);
            for (const Method method : choice_of(deviation).methods) {
                for (const std::string kernel : {"double", "bits:8", "depth:8"}) {
                    const NamedKernel named = *kernel_named(kernel);
                    if (!named.choice->runs(method, deviation)) continue;
                    CAPTURE(kernel);
                    const RunRequest request{method, named, deviation, scene};
                    CHECK(check_run(request, right).picture == run(request));
                }
            }
        }
    }
}
