// The quick readers of events and scenes: they read what the program writes, and always agree with the trees.

#include <doctest/doctest.h>

#include <filesystem>
#include <random>
#include <set>

#include "check/check.h"
#include "check/checked_trace.h"
#include "format/floating_horizon_trace.h"
#include "format/trace_reader.h"
#include "output.h"
#include "run/write_trace.h"
#include "support/agreement.h"
#include "support/editions.h"
#include "support/random_curves.h"
#include "support/scenes.h"

using namespace vidno;
using namespace vidno::test;

namespace {

struct TraceLines {
    EventContext context;
    PolygonNames names;
    std::vector<std::string> events;

    TraceLines(const auto& header, const std::string& text)
        : context{header.detail, header.kernel == "exact", KnownPolygons(polygon_names(header.scene))},
          names(polygon_names(header.scene)) {
        LineReader lines = LineReader::of_text(text);
        std::string line;
        lines.next(line);
        while (lines.next(line)) {
            if (!line.starts_with(R"({"end")")) events.push_back(line);
        }
    }
};

TraceLines traced(const auto& header, const auto& request, bool checked) {
    std::string text;
    TraceWriter writer(header, [&](std::string_view part) { text += part; });
    checked ? write_checked_trace(request, writer) : write_trace(request, writer);
    return {header, text};
}

/// Traces that contain every event that a run can report: all methods, plain and checked, in numbers of every form.
std::vector<TraceLines> traces_of_all_methods() {
    std::vector<TraceLines> traces;
    RandomScenes random(51);
    RandomCurves curves(52);
    for (const std::string name : {"float", "double", "bits:9", "filtered", "exact"}) {
        const NamedKernel kernel = *kernel_named(name);
        for (const Edition edition : all_editions()) {
            for (std::size_t place = 0; place < method_names.size(); ++place) {
                const auto method = Method(place);
                if (!kernel.choice->runs(method, edition)) continue;
                const AdmittedScene scene = random.scene();
                traces.push_back(traced(TraceHeader{method, edition, name, Detail::signs, scene},
                                        RunRequest{method, kernel, edition, scene, Detail::signs}, place % 2 == 0));
            }
            if (!kernel.choice->runs_floating_horizon(edition)) continue;
            const Surface surface{"", curves.scene()};
            traces.push_back(traced(FloatingHorizonHeader{edition, name, Detail::signs, surface},
                                    FloatingHorizonRequest{kernel, edition, surface.curves, Detail::signs}, true));
        }
    }
    return traces;
}

/// The text with one byte changed, added or removed.
std::string spoiled(std::string text, std::mt19937& random) {
    constexpr std::string_view bytes = "0123456789-+.eE\",:[]{}\\/ntf \x01\x80";
    const char byte = bytes[random() % bytes.size()];
    const std::size_t at = random() % text.size();
    switch (random() % 3) {
        case 0: text[at] = byte; break;
        case 1: text.insert(at, 1, byte); break;
        default: text.erase(at, 1);
    }
    return text;
}

}  // namespace

TEST_CASE("Every line of a trace is read quickly, as the tree reads it") {
    std::set<std::string> reported;
    for (const auto& [context, names, events] : traces_of_all_methods()) {
        for (std::size_t i = 0; i < events.size(); ++i) {
            const std::string& line = events[i];
            const bool is_new = reported.insert(line.substr(6, line.find('"', 6) - 6)).second;
            if (!is_new && i % thinning != 0) continue;
            CAPTURE(line);
            const auto [is_quick, agrees] = agreement_on_event(line, context, names);
            REQUIRE(is_quick);
            REQUIRE(agrees);
        }
    }
    // Only the printed text tells `skip`. Most other events must occur.
    CHECK(reported.size() > AllEvents::count * 9 / 10);
}

TEST_CASE("A line with a wrong byte is read as the tree reads it, or not at all") {
    std::mt19937 random(53);
    int quick = 0, otherwise = 0;
    for (const auto& [context, names, events] : traces_of_all_methods()) {
        for (std::size_t i = 0; i < events.size(); i += thinning * (1 + random() % 20)) {
            const std::string line = spoiled(events[i], random);
            CAPTURE(line);
            const auto [is_quick, agrees] = agreement_on_event(line, context, names);
            REQUIRE(agrees);
            ++(is_quick ? quick : otherwise);
        }
    }
    CHECK(quick > 100 / thinning);
    CHECK(otherwise > 1000 / thinning);
}

TEST_CASE("Lines that the quick reader of events leaves to the tree reader") {
    const EventContext context{Detail::polygons, false, KnownPolygons({"\"A\""})};
    const auto is_quick = [&](const std::string& line) {
        QuickEvents quick(context);
        return quick.read(line).has_value();
    };
    CHECK(is_quick(R"({"e":"scanline","at":"Z6","y":2.5,"row":2})"));
    CHECK_MESSAGE(!is_quick(R"({"e":"scanline","at":"Z6","row":2,"y":2.5})"), "another order");
    CHECK_MESSAGE(!is_quick(R"({"e":"scanline", "at":"Z6","y":2.5,"row":2})"), "a space");
    CHECK_MESSAGE(!is_quick(R"({"e":"scanline","at":"Z6","y":02.5,"row":2})"), "not JSON");
    CHECK_MESSAGE(!is_quick(R"({"e":"scanline","at":"Z6","y":2.,"row":2})"), "not JSON");
    CHECK_MESSAGE(!is_quick(R"({"e":"scanline","at":"Z6","y":2.5,"row":2147483648})"), "no int");
    CHECK_MESSAGE(!is_quick(R"({"e":"scanline","at":"Z6","y":"5/2","row":2})"), "a fraction is for exact alone");
    CHECK_MESSAGE(!is_quick(R"({"e":"discard","at":"PW3","polygon":"B"})"), "no such polygon");
    CHECK_MESSAGE(!is_quick(R"({"e":"slope","at":"L3","dz":1})"), "above the level of the trace");
    CHECK_MESSAGE(!is_quick(R"({"e":"discard","at":"PW3","polygon":"A"} )"), "text after it");
}

TEST_CASE("Ids with escapes and letters of any language are found in their written form") {
    Scene scene{.name = {}, .area = {0, 0, 1, 1}, .background = {}, .polygons = {}};
    for (const std::string id : {"\"", "a\\b", "Ж", "\x01"}) scene.polygons.push_back({id, {}, {}, false});
    const PolygonNames names = polygon_names(scene);
    const EventContext context{Detail::polygons, false, KnownPolygons(names)};
    QuickEvents quick(context);
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto event = quick.read(R"({"e":"discard","at":"PW3","polygon":)" + names[i] + "}");
        REQUIRE(event.has_value());
        CHECK(event->get_if<event::Discard>()->polygon.index == int(i));
    }
}

TEST_CASE("The quick reader reads the ordinary scenes of the lessons as the tree reader does") {
    int quick = 0;
    for (const auto& file : std::filesystem::recursive_directory_iterator(VIDNO_ROOT "/lessons")) {
        if (file.path().extension() != ".json") continue;
        CAPTURE(file.path());
        const std::string text = read_file(file.path());
        const auto [is_quick, agrees] = agreement_on_scene(text);
        CHECK(agrees);
        quick += is_quick ? 1 : 0;
    }
    CHECK(quick > 30);
}

TEST_CASE("A scene with a wrong byte is read as the tree reads it, or not at all") {
    std::mt19937 random(54);
    RandomScenes scenes(55);
    int quick = 0;
    for (int i = 0; i < 3000; ++i) {
        const std::string text = scene_json(scenes.scene());
        REQUIRE(agreement_on_scene(text).is_quick);
        const std::string changed = spoiled(text, random);
        CAPTURE(changed);
        const auto [is_quick, agrees] = agreement_on_scene(changed);
        REQUIRE(agrees);
        quick += is_quick ? 1 : 0;
    }
    CHECK(quick > 300);
}

TEST_CASE("A scene with a repeated key is left to the tree reader, which refuses it") {
    const std::string polygon = R"({"color":"#000000","vertices":[[0,0,0],[1,0,0],[0,1,0]]})";
    const auto scene = [&](const std::string& more) {
        return R"({"format":"vidno-scene/1",)" + more + R"("window":{"x":0,"y":0,"width":4,"height":4},"polygons":[)" +
               polygon + "]}";
    };
    const auto [is_quick, agrees] = agreement_on_scene(scene(R"("name":"",)"));
    CHECK(is_quick);
    CHECK(agrees);
    CHECK_FALSE(agreement_on_scene(scene(R"("name":"","name":"a",)")).is_quick);
    CHECK_FALSE(agreement_on_scene(scene(R"("polygons":[],)")).is_quick);
    CHECK_FALSE(agreement_on_scene(scene(R"("light":1,)")).is_quick);
}
