// The trace: sufficient, graded, and the same after reading it back.

#include <doctest/doctest.h>

#include <climits>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "format/event_text.h"
#include "format/trace_reader.h"
#include "output.h"
#include "replay/state.h"
#include "run/run.h"
#include "support/editions.h"
#include "support/scenes.h"
#include "vidno/admission.h"

using namespace vidno;
using namespace vidno::test;

namespace {

struct Choice {
    Method method;
    Edition edition;
    std::string kernel;

    RunRequest request(const AdmittedScene& scene, Detail detail, TraceWriter* writer) const {
        return {method, *kernel_named(kernel), edition, scene, detail, writer};
    }
};

std::vector<Choice> all_choices() {
    std::vector<Choice> choices;
    for (std::size_t place = 0; place < method_names.size(); ++place) {
        const auto method = Method(place);
        for (const Edition edition : all_editions()) {
            for (const std::string kernel :
                 {"float", "double", "bits:4", "bits:11", "depth:6", "filtered", "grid:1", "exact"}) {
                if (kernel_named(kernel)->choice->runs(method, edition)) choices.push_back({method, edition, kernel});
            }
        }
    }
    return choices;
}

TraceHeader header_of(const AdmittedScene& scene, const Choice& choice, Detail detail) {
    return {choice.method, choice.edition, choice.kernel, detail, scene};
}

struct TracedRun {
    std::string text;
    Picture picture;
};

TracedRun traced(const AdmittedScene& scene, const Choice& choice, Detail detail) {
    std::string text;
    TraceWriter writer(header_of(scene, choice, detail), [&](std::string_view part) { text += part; });
    const Picture picture = run(choice.request(scene, detail, &writer));
    writer.finish(picture);
    return {text, picture};
}

TraceReader reader_of(const std::string& text) { return {LineReader::of_text(text), "trace"}; }

std::vector<Event> events_of(const std::string& text) {
    std::vector<Event> events;
    TraceReader reader = reader_of(text);
    while (const auto event = reader.next()) events.push_back(event->copy());
    return events;
}

/// The event as a lower level has it, none if it is left out there.
std::optional<Event> lowered(const Event& event, Detail detail) {
    const bool stays = event.visit([&](const auto& e) { return e.kind.from <= detail; });
    if (!stays) return std::nullopt;
    if (const auto* call = event.get_if<event::Call>()) {
        if (event::calls_from(call->of) > detail) return std::nullopt;
    }
    if (const auto* span = event.get_if<event::Span>(); span && detail < Detail::polygons) {
        return event::Span{span->at, span->row, span->runs, {}};
    }
    return event;
}

std::string lines_of(const std::vector<Event>& events, const Scene& scene) {
    EventText lines(polygon_names(scene));
    Text text;
    for (const auto& event : events) lines.line(text, event);
    return text.string();
}

}  // namespace

TEST_CASE("Kernels by name: a parameter where there is one, and in range") {
    for (const std::string name :
         {"float", "double", "bits:4", "bits:24", "depth:2", "depth:32", "filtered", "grid:1", "grid:20", "exact"}) {
        CAPTURE(name);
        REQUIRE(kernel_named(name).has_value());
        CHECK(kernel_named(name)->name() == name);
    }
    for (const std::string name : {"", "half", "double:2", "bits", "bits:", "bits:3", "bits:25", "bits:+9", "bits:12 ",
                                   "bits:99999999999", "depth", "depth:1", "depth:33", "grid:0", "grid:21", "grid:"}) {
        CAPTURE(name);
        CHECK_FALSE(kernel_named(name).has_value());
    }
    CHECK_MESSAGE(kernel_named("grid")->name() == "grid:8", "the grid of most hardware");
}

TEST_CASE("Sufficient: the picture at every level") {
    const AdmittedScene scene = small_scene();
    for (const auto& choice : all_choices()) {
        for (const Detail detail : {Detail::windows, Detail::polygons, Detail::signs}) {
            CAPTURE(choice.kernel);
            CAPTURE(name_of(choice.edition));
            CAPTURE(int(detail));
            const auto [text, picture] = traced(scene, choice, detail);
            TraceReader reader = reader_of(text);
            State state(reader.header());
            while (const auto event = reader.next()) state.apply(*event);
            CHECK(state.picture() == picture);
            REQUIRE(reader.end().has_value());
            CHECK(reader.end()->hash == picture_hash(picture));
            CHECK(state.calls().size() <= 2);  // a fault may leave the procedure that failed open
        }
    }
}

TEST_CASE("Recording does not change the run") {
    const AdmittedScene scene = small_scene();
    for (const auto& choice : all_choices()) {
        CHECK(traced(scene, choice, Detail::signs).picture == run(choice.request(scene, Detail::windows, nullptr)));
    }
}

TEST_CASE("Graded: a lower level is a higher one with events left out") {
    const AdmittedScene scene = small_scene();
    for (const auto& choice : all_choices()) {
        CAPTURE(choice.kernel);
        for (const Detail detail : {Detail::windows, Detail::polygons}) {
            std::vector<Event> left;
            for (const auto& event : events_of(traced(scene, choice, Detail::signs).text)) {
                if (const auto kept = lowered(event, detail)) left.push_back(*kept);
            }
            CHECK(lines_of(left, scene) == lines_of(events_of(traced(scene, choice, detail).text), scene));
        }
    }
}

TEST_CASE("Read back and written again the bytes are the same, twice traced too") {
    const AdmittedScene scene = small_scene();
    for (const auto& choice : all_choices()) {
        const std::string text = traced(scene, choice, Detail::signs).text;
        CHECK(text == traced(scene, choice, Detail::signs).text);
        TraceReader reader = reader_of(text);
        std::string again;
        TraceWriter writer(reader.header(), [&](std::string_view part) { again += part; });
        State state(reader.header());
        while (const auto event = reader.next()) {
            writer.hear(*event);
            state.apply(*event);
        }
        writer.finish(state.picture());
        CHECK(again == text);
    }
}

TEST_CASE("A number is written in its shortest form by every code path") {
    // Whole numbers and halves are formatted separately; std::to_chars gives the shortest form.
    std::vector<double> numbers{99999, 99999.5, 100000, 100000.5, -99999.5, 1e-5, .1, 123456789, 1e300};
    for (int i = -3000; i <= 3000; ++i) numbers.push_back(i / 2.0);
    for (const double number : numbers) {
        char digits[32];
        const std::string shortest(digits, std::to_chars(digits, digits + sizeof digits, number).ptr);
        Text written;
        append_number(written, number);
        CHECK(written.view() == shortest);
    }
    Text zero;
    append_number(zero, -0.0);
    CHECK(zero.view() == "0");
}

TEST_CASE("A cached number is written as before") {
    // Ten times as many numbers as are cached, from the whole range of doubles, so most entries are used and replaced;
    // and halves.
    std::mt19937_64 random(1);
    std::vector<double> numbers{5e-324, -2.2250738585072014e-308, 1.7976931348623157e308, -0.0, 0.25, -0.5};
    while (numbers.size() < 10000) {
        const auto number = std::bit_cast<double>(random());
        if (std::isfinite(number)) numbers.push_back(number);
    }
    for (int twice = 0; twice < 4096; ++twice) numbers.push_back(twice / 2.0);
    RememberedShortest remembered;
    for (int round = 0; round < 2; ++round) {
        for (const double number : numbers) {
            for (int twice = 0; twice < 2; ++twice) {
                Text plain, again;
                append_number(plain, number);
                remembered.append(again, number);
                CHECK(again.view() == plain.view());
            }
        }
    }
}

TEST_CASE("A line has room for the longest values") {
    // Bytes that JSON escapes with six, and fractions longer than any double.
    Scene scene{.name = {}, .area = {0, 0, 1, 1}, .background = {}, .polygons = {}};
    scene.polygons.push_back({.id = std::string(5000, '\x01'), .color = {}, .vertices = {}});
    const Value fraction(std::string(3000, '1') + "/" + std::string(3000, '7'));
    const Value least(-std::numeric_limits<double>::denorm_min()), longest(-2.2250738585072014e-308);
    const std::vector<Event> events{
        event::Plane{Line::I1, {0}, {longest, longest, longest, longest}},
        event::Depth{Line::D1, {0}, {fraction, fraction}, fraction},
        event::ClipResult{Line::PL1, {0}, std::vector(100, ValueVertex{longest, fraction, least})},
        event::Draw{Line::F2, {0}, {}, std::vector(100, PixelRun{INT_MIN, INT_MIN, INT_MIN})},
        event::Push{Line::W3, {-1e-300, -1e-300, -1e-300, -1e-300}, std::vector(100, AplEntry{{0}, false}), true},
        event::Fault{Line::W9, std::string(1000, '\x02'), INT_MIN, INT_MIN},
    };
    std::stringstream lines(lines_of(events, scene));
    std::vector<std::string> names;
    for (std::string line; std::getline(lines, line);) names.push_back(nlohmann::json::parse(line).at("e"));
    CHECK(names == std::vector<std::string>{"plane", "depth", "clip_result", "draw", "push", "fault"});
}

TEST_CASE("Every label of an event is in the listings") {
    std::ifstream file(VIDNO_ROOT "/trace/listings/listings.json");
    std::stringstream listings;
    listings << file.rdbuf();
    REQUIRE(listings.str().size() > 1000);
    for (const auto name : line_names) {
        CAPTURE(name);
        CHECK(listings.str().find("\"at\": \"" + std::string(name) + "\"") != std::string::npos);
    }
}

TEST_CASE("FORMAT.md: the worked example is what the program writes") {
    std::ifstream file(VIDNO_ROOT "/trace/FORMAT.md");
    std::stringstream format;
    format << file.rdbuf();
    const std::string opening = "```jsonl\n";
    const auto begin = format.str().find(opening);
    REQUIRE(begin != std::string::npos);
    const auto end = format.str().find("```", begin + opening.size());
    const std::string example = format.str().substr(begin + opening.size(), end - begin - opening.size());
    TraceReader reader = reader_of(example);
    const Choice choice{reader.header().method, Edition::corrected, "double"};
    CHECK(traced(admit(reader.header().scene), choice, reader.header().detail).text == example);
}

TEST_CASE("A limit keeps the events so far and marks the trace as partial") {
    const AdmittedScene scene = small_scene();
    const Choice choice = all_choices().front();
    std::string text;
    TraceWriter writer(
        header_of(scene, choice, Detail::signs), [&](std::string_view part) { text += part; }, 10);
    CHECK_THROWS_AS(run(choice.request(scene, Detail::signs, &writer)), EventLimitReached);
    writer.finish_partial();
    TraceReader reader = reader_of(text);
    while (reader.next()) {
    }
    CHECK(reader.events() == 10);
    REQUIRE(reader.end().has_value());
    CHECK(reader.end()->partial);
}

TEST_CASE("A state refuses an event that cannot follow") {
    const AdmittedScene scene = SceneBuilder(area_16).polygon(far_quad).build();
    const auto impossible = [&](Method method, const std::vector<Event>& events) -> std::string {
        const TraceHeader header = header_of(scene, {method, Edition::corrected, "double"}, Detail::windows);
        State state(header);
        try {
            for (const auto& event : events) state.apply(event);
        } catch (const Impossible& reason) {
            return reason.reason;
        }
        return "possible";
    };
    const auto push = [](Line at, Window window, std::optional<std::vector<AplEntry>> list) {
        event::Push event;
        event.at = at;
        event.window = window;
        event.apl = std::move(list);
        return event;
    };
    const Window whole{0, 0, 16, 16};
    const std::vector<AplEntry> none;
    event::Pop pop;
    pop.window = whole;

    CHECK(impossible(Method::warnock, {push(Line::W3, whole, std::nullopt)}) == "only the first window has a list");
    CHECK(impossible(Method::warnock, {push(Line::W3, whole, none), pop, push(Line::W13, {0, 0, 8, 8}, none)}) ==
          "only the first window has a list");
    CHECK(impossible(Method::warnock_vertex, {push(Line::WF1, {0, 0, 17, 16}, none)}) == "a window outside the area");
    CHECK(impossible(Method::warnock_vertex, {push(Line::WF1, {0, .5, 16, 8}, none)}) == "a window outside the area");
    CHECK(impossible(Method::warnock_vertex, {push(Line::WF1, whole, none)}) == "possible");

    event::Depth depth;
    depth.at = Line::PW5;
    const std::vector<Event> found{event::Corners{}, depth, depth, depth, depth};
    std::vector<Event> window{push(Line::W3, whole, none), push(Line::W3, whole, none), pop};
    window.insert(window.end(), found.begin(), found.end());
    window.push_back(event::Nearer{});
    CHECK(impossible(Method::warnock, window) == "possible");
    // The depths at the corners are those of the window before.
    window.back() = pop;
    window.insert(window.end(), found.begin() + 1, found.end());
    window.push_back(event::Nearer{});
    CHECK(impossible(Method::warnock, window) == "not preceded by four depths");

    event::AelSort twice;
    twice.edges = {1, 1};
    event::AelAdd one, two;
    one.edge = 1;
    two.edge = 2;
    event::Leave leave;
    leave.edges = {1};
    CHECK(impossible(Method::zbuffer, {one, two, one}) == "an edge that is already in AEL");
    CHECK(impossible(Method::zbuffer, {one, two, twice}) == "an order of entries that are not those of AEL");
    CHECK(impossible(Method::zbuffer, {leave}) == "an edge that is not in S");
    CHECK(impossible(Method::zbuffer, {event::Span{}}) == "a span of no polygon");
    CHECK(impossible(Method::weiler_atherton, {event::Behind{}}) == "no current list");
}
