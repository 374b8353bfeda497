// A trace in memory: every step in any order, files in any pieces, broken files.

#include "replay/replay.h"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <random>

#include "format/trace_reader.h"
#include "run/write_trace.h"
#include "support/editions.h"
#include "support/random_curves.h"
#include "support/scenes.h"

using namespace vidno;
using namespace vidno::test;

namespace {

/// A run's trace.
std::string traced(const auto& header, const auto& request) {
    std::string text;
    TraceWriter writer(header, [&](std::string_view part) { text += part; });
    write_trace(request, writer);
    return text;
}

std::string traced(const AdmittedScene& scene, Method method, Detail detail, Edition edition = Edition::corrected) {
    const NamedKernel kernel = *kernel_named("double");
    return traced(TraceHeader{method, edition, kernel.name(), detail, scene},
                  RunRequest{method, kernel, edition, scene, detail});
}

std::string traced(const AdmittedCurves& curves, Detail detail) {
    const NamedKernel kernel = *kernel_named("double");
    return traced(FloatingHorizonHeader{Edition::corrected, kernel.name(), detail, {"curves", curves}},
                  FloatingHorizonRequest{kernel, Edition::corrected, curves, detail});
}

/// Traces of all methods, of corrected and of printed runs, at all levels.
std::vector<std::string> all_traces() {
    RandomScenes random(31);
    std::vector<std::string> traces;
    for (std::size_t place = 0; place < method_names.size(); ++place) {
        for (const Edition edition : all_editions()) {
            for (const Detail detail : {Detail::windows, Detail::polygons, Detail::signs}) {
                const auto method = Method(place);
                if (!kernel_named("double")->choice->runs(method, edition)) continue;
                const AdmittedScene scene = random.scene();
                if (refusal_of(method, scene)) continue;
                traces.push_back(traced(scene, method, detail, edition));
            }
        }
    }
    RandomCurves curves(32);
    for (const Detail detail : {Detail::windows, Detail::polygons, Detail::signs}) {
        traces.push_back(traced(curves.scene(), detail));
    }
    return traces;
}

void append_all(Replay& replay, const std::string& text) {
    replay.append(text);
    replay.finish();
}

std::string state_of(const AnyState& state) {
    return std::visit([](const auto& of_kind) { return state_json(of_kind); }, state);
}

/// The state at each step, as a reader of the file has it.
std::vector<std::string> states_of(const std::string& text) {
    AnyTraceReader opened = open_trace(LineReader::of_text(text), "trace");
    return std::visit(
        []<class Reader>(Reader& reader) {
            using State = std::conditional_t<std::is_same_v<Reader, TraceReader>, vidno::State, FloatingHorizonState>;
            State state(reader.header());
            std::vector<std::string> states{state_json(state)};
            while (const auto event = reader.next()) {
                state.apply(*event);
                states.push_back(state_json(state));
            }
            return states;
        },
        opened);
}

/// A trace of 16 x 16 pixels with these lines after its header.
std::string with_lines(const std::vector<std::string>& lines, const Area& area = area_16) {
    Scene scene{"", area, white, {{"A", red, near_square}, {"B", blue, near_square}}};
    std::string text = header_json(TraceHeader{Method::warnock, Edition::corrected, "double", Detail::polygons, scene});
    for (const auto& line : lines) text += line + '\n';
    return text;
}
const std::string push = R"({"e":"push","at":"W3","window":[0,0,16,16],"apl":[["A",false],["B",false]]})";
const std::string pop = R"({"e":"pop","at":"W5","window":[0,0,16,16]})";
const std::string end_of_two = R"({"end":{"events":2,"picture":"sha256:"}})";

/// Puts values that differ together with those before, as a page does.
nlohmann::json merged(nlohmann::json before, const nlohmann::json& news) {
    for (const auto& [key, value] : news.items()) {
        if (value.is_object() && value.size() == 2 && value.contains("from") && value.contains("rest")) {
            auto& list = before[key];
            list.erase(list.begin() + value["from"].get<int>(), list.end());
            for (const auto& item : value["rest"]) list.push_back(item);
        } else if (key == "warnock" || key == "zbuffer" || key == "weilerAtherton" || key == "floatingHorizon" ||
                   key == "lists") {
            before[key] = merged(before[key], value);
        } else {
            before[key] = value;
        }
    }
    return before;
}

}  // namespace

TEST_CASE("A replay has the state of every step, in any order") {
    std::mt19937 random(1);
    for (const auto& text : all_traces()) {
        CAPTURE(text.substr(0, 100));
        Replay replay;
        append_all(replay, text);
        const std::vector<std::string> states = states_of(text);
        REQUIRE(replay.length() + 1 == states.size());
        CHECK_FALSE(replay.shortened());
        int wrong = 0;
        for (int trial = 0; trial < 60 / thinning; ++trial) {
            const std::uint64_t step = random() % states.size();
            wrong += state_of(replay.seek(step)) == states[step] ? 0 : 1;
        }
        CHECK(wrong == 0);
    }
}

TEST_CASE("A replay reads a file in any pieces") {
    std::mt19937 random(2);
    for (const auto& text : all_traces()) {
        Replay whole, pieces;
        append_all(whole, text);
        for (std::size_t at = 0; at < text.size();) {
            const std::size_t size = 1 + random() % 500;
            pieces.append(text.substr(at, size));
            at += size;
        }
        pieces.finish();
        REQUIRE(pieces.length() == whole.length());
        CHECK(std::equal(pieces.names().begin(), pieces.names().end(), whole.names().begin()));
        const std::uint64_t step = 1 + random() % whole.length();
        CHECK(pieces.line(step) == whole.line(step));
        CHECK(state_of(pieces.seek(step)) == state_of(whole.seek(step)));
    }
}

TEST_CASE("Values that differ, put together, are the values in full") {
    std::mt19937 random(3);
    for (const auto& text : all_traces()) {
        Replay replay;
        append_all(replay, text);
        nlohmann::json known;
        for (int trial = 0; trial < 40 / thinning; ++trial) {
            // Steps forward, backward and far away.
            const std::uint64_t last = known.is_null() ? 0 : known["step"].get<std::uint64_t>();
            const std::uint64_t step =
                trial % 2 == 0 ? random() % (replay.length() + 1) : std::min(last + 1, replay.length());
            Text news, full;
            replay.append_values(news, step);
            const nlohmann::json told = nlohmann::json::parse(news.view());
            known = known.is_null() ? told : merged(known, told);
            std::visit(
                [&](const auto& state) {
                    const auto names =
                        std::visit([](const auto& any) { return polygon_names(any.scene); }, replay.header());
                    ValuesText(names).append(full, state);
                },
                replay.seek(step));
            nlohmann::json right = nlohmann::json::parse(full.view());
            // A list that no window has any more is not mentioned.
            if (right.contains("lists")) {
                for (const auto& [number, list] : right["lists"].items()) CHECK(known["lists"][number] == list);
                right.erase("lists");
            }
            nlohmann::json compared = known;
            compared.erase("lists");
            CHECK(compared == right);
        }
    }
}

TEST_CASE("A wrong line ends a replay, which keeps the steps before it") {
    const auto reason = [](const std::vector<std::string>& lines) {
        Replay replay;
        append_all(replay, with_lines(lines));
        REQUIRE(replay.shortened());
        CHECK(replay.shortened()->why == Replay::Shortened::Why::wrong);
        const auto steps = std::uint64_t(replay.shortened()->line - 2);
        CHECK(replay.length() == steps);
        std::visit([&](const auto& state) { CHECK(state.step() == steps); }, replay.seek(steps));
        return std::to_string(replay.shortened()->line) + ": " + replay.shortened()->reason;
    };
    CHECK(reason({push, "nothing", pop}) == "3: not JSON");
    CHECK(reason({push, pop, R"({"e":"discard","at":"PW3","polygon":"C"})"}) ==
          "4: /polygon: not a polygon of the scene");
    CHECK(reason({push, pop, pop}) == "4: the stack AW is empty");
    CHECK(reason({push, R"({"e":"pop","at":"W5","window":[0,0,8,8]})"}) == "3: not the window on top of AW");
    CHECK(reason({push, R"({"e":"clear","at":"Z1","color":"#ffffff","z":0})"}) == "3: an event of another method");
    CHECK(reason({push, pop, end_of_two, pop}) == "5: text after the last line");
    CHECK(reason({push, R"({"end":{"events":3,"picture":""}})"}) == "3: /end/events: not the number of events read");
}

TEST_CASE("A replay says that its file ends too early") {
    const std::string whole = with_lines({push, pop, end_of_two});
    const auto why = [](const std::string& text) -> std::string {
        Replay replay;
        append_all(replay, text);
        if (!replay.shortened()) return std::to_string(replay.length()) + " steps";
        return (replay.shortened()->why == Replay::Shortened::Why::cut ? "cut after " : "partial after ") +
               std::to_string(replay.length());
    };
    CHECK(why(whole) == "2 steps");
    CHECK(why(whole.substr(0, whole.size() - 1)) == "2 steps");  // the last line feed alone is missing
    CHECK(why(whole.substr(0, whole.size() - 5)) == "cut after 2");
    CHECK(why(with_lines({push, pop})) == "cut after 2");
    CHECK(why(with_lines({push, pop}).substr(0, with_lines({push, pop}).size() - 10)) == "cut after 1");
    CHECK(why(with_lines({})) == "cut after 0");
    CHECK(why(with_lines({push, R"({"end":{"events":1,"partial":true}})"})) == "partial after 1");
}

TEST_CASE("A file whose first line is not that of a trace is refused") {
    for (const std::string text :
         {"", "\n", "{}\n", "[1]\n", R"({"format":"vidno-scene/1"})", "a text\nwith lines\n"}) {
        Replay replay;
        CHECK_THROWS_AS(append_all(replay, text), Refused);
    }
}

TEST_CASE("Few states of the largest area are kept, and every step is still right") {
    // Each step fills one pixel of a diagonal, with its own colour; its line has about 60 bytes.
    const int steps = sanitized ? 5000 : 50000;
    const Area area{0, 0, largest_side, largest_side};
    std::vector<std::string> lines{R"({"e":"push","at":"W3","window":[0,0,16384,16384],"apl":[]})",
                                   R"({"e":"pop","at":"W5","window":[0,0,16384,16384]})"};
    const auto color_at = [](int step) { return Color{1, std::uint8_t(step % 251), std::uint8_t(step % 253)}; };
    for (int step = 3; step <= steps; ++step) {
        Text line;
        line += R"({"e":"fill","at":"W7","rect":[)";
        append_integer(line, step % 16384);
        line += ',';
        append_integer(line, step % 16384);
        line += R"(,1,1],"color":)";
        append_color(line, color_at(step));
        line += '}';
        lines.push_back(line.string());
    }
    Replay replay;
    append_all(replay, with_lines(lines, area));
    REQUIRE(replay.length() == std::uint64_t(steps));
    for (const int step : {steps, 3, steps / 2, steps / 2 + 1, 4, steps - 1}) {
        const Screen& screen = std::get<State>(replay.seek(std::uint64_t(step))).screen();
        CHECK(screen.color(step % 16384, step % 16384) == color_at(step));
        CHECK(screen.pixel(step % 16384, step % 16384).painter == std::uint32_t(step));
        CHECK(screen.pixel(0, 1).painter == 0);
    }
}
