// A trace in memory: every step in any order, files in any pieces, broken files.

#include "replay/replay.h"

#include <doctest/doctest.h>

#include <chrono>
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
std::vector<std::string> made_traces() {
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

const std::vector<std::string>& all_traces() {
    static const std::vector<std::string> traces = made_traces();
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

/// A trace of a scene at level `polygons` with these lines after its header.
std::string with_lines(const std::vector<std::string>& lines, const Scene& scene) {
    std::string text = header_json(TraceHeader{Method::warnock, Edition::corrected, "double", Detail::polygons, scene});
    for (const auto& line : lines) text += line + '\n';
    return text;
}
/// A trace of 16 x 16 pixels.
std::string with_lines(const std::vector<std::string>& lines) {
    return with_lines(lines, {"", area_16, white, {{"A", red, near_square}, {"B", blue, near_square}}});
}
const std::string push = R"({"e":"push","at":"W3","window":[0,0,16,16],"apl":[["A",false],["B",false]]})";
const std::string pop = R"({"e":"pop","at":"W5","window":[0,0,16,16]})";
const std::string end_of_two = R"({"end":{"events":2,"picture":"sha256:"}})";

/// Puts values that differ together with those before, as a page does. They may be groups of values.
nlohmann::json merged(nlohmann::json before, const nlohmann::json& news, bool has_groups = true) {
    for (const auto& [key, value] : news.items()) {
        if (value.is_object() && value.contains("rest")) {
            auto& list = before[key];
            list.erase(list.begin() + value["from"].get<int>(), list.end());
            list.insert(list.end(), value["rest"].begin(), value["rest"].end());
        } else if (has_groups && value.is_object()) {
            before[key] = merged(before[key], value, false);
        } else {
            before[key] = value;
        }
    }
    return before;
}

/// The seconds that an act takes.
double seconds(auto&& act) {
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    act();
    return std::chrono::duration<double>(Clock::now() - start).count();
}
/// Far more seconds than a test needs, even on a machine that is busy with others.
constexpr double patience = 20;

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
            const nlohmann::json reported = nlohmann::json::parse(news.view());
            known = known.is_null() ? reported : merged(known, reported);
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
    const auto reported = [](const std::vector<std::string>& lines, std::size_t piece) {
        const std::string text = with_lines(lines);
        Replay replay;
        for (std::size_t at = 0; at < text.size(); at += piece) replay.append(text.substr(at, piece));
        replay.finish();
        REQUIRE(replay.shortened());
        const auto& [why, line, reason] = *replay.shortened();
        CHECK(why == Replay::Shortened::Why::wrong);
        CHECK(replay.length() == line - (replay.end() ? 3 : 2));
        std::visit([&](const auto& state) { CHECK(state.step() == replay.length()); }, replay.seek(replay.length()));
        return std::to_string(line) + ": " + reason;
    };
    // In one piece, and line by line or less.
    for (const std::size_t piece : {std::size_t{1} << 20, std::size_t{40}}) {
        CHECK(reported({push, "nothing", pop}, piece) == "3: not JSON");
        CHECK(reported({push, pop, R"({"e":"discard","at":"PW3","polygon":"C"})"}, piece) ==
              "4: /polygon: not a polygon of the scene");
        CHECK(reported({push, pop, pop}, piece) == "4: the stack AW is empty");
        CHECK(reported({push, R"({"e":"pop","at":"W5","window":[0,0,8,8]})"}, piece) ==
              "3: not the window on top of AW");
        CHECK(reported({push, R"({"e":"clear","at":"Z1","color":"#ffffff","z":0})"}, piece) ==
              "3: an event of another method");
        CHECK(reported({push, pop, end_of_two, pop}, piece) == "5: text after the last line");
        CHECK(reported({push, R"({"end":{"events":3,"picture":""}})"}, piece) ==
              "3: /end/events: not the number of events read");
    }
}

TEST_CASE("A replay says that its file ends too early") {
    const std::string whole = with_lines({push, pop, end_of_two});
    const auto why = [](const std::string& text) -> std::string {
        Replay replay;
        append_all(replay, text);
        if (!replay.shortened()) return std::to_string(replay.length()) + " steps";
        constexpr std::string_view words[] = {"cut", "partial", "wrong"};
        return std::string(words[std::size_t(replay.shortened()->why)]) + " after " + std::to_string(replay.length());
    };
    CHECK(why(whole) == "2 steps");
    CHECK(why(whole.substr(0, whole.size() - 1)) == "2 steps");  // the last line feed alone is missing
    CHECK(why(whole.substr(0, whole.size() - 5)) == "cut after 2");
    CHECK(why(whole + "more") == "wrong after 2");
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

TEST_CASE("A trace cut in the middle keeps its good steps") {
    std::mt19937 random(4);
    for (const auto& text : all_traces()) {
        const std::vector<std::string> states = states_of(text);
        const std::size_t header = text.find('\n') + 1;
        const std::size_t size = header + random() % (text.size() - header - 1);
        const auto steps =
            std::size_t(std::count(text.begin() + std::ptrdiff_t(header), text.begin() + std::ptrdiff_t(size), '\n'));
        CAPTURE(text.substr(0, size));
        Replay replay;
        append_all(replay, text.substr(0, size));
        // A last line without its line feed is whole if that is all it lacks.
        const bool is_whole = text[size] == '\n';
        REQUIRE(replay.length() == std::min(steps + (is_whole ? 1 : 0), states.size() - 1));
        REQUIRE(replay.shortened());
        CHECK(replay.shortened()->why == Replay::Shortened::Why::cut);
        CHECK(replay.shortened()->line == replay.length() + 2);
        CHECK(replay.shortened()->reason.empty());
        CHECK(state_of(replay.seek(replay.length())) == states[std::size_t(replay.length())]);
    }
}

TEST_CASE("A replay goes back step by step, and on from there") {
    for (const auto& text : all_traces()) {
        Replay replay;
        append_all(replay, text);
        const std::vector<std::string> states = states_of(text);
        const std::size_t last = states.size() - 1, first = last - std::min<std::size_t>(last, 100 / thinning);
        std::size_t wrong = 0;
        for (std::size_t step = last; step > first; --step)
            wrong += state_of(replay.seek(step)) == states[step] ? 0 : 1;
        for (std::size_t step = first; step <= last; ++step) {
            wrong += state_of(replay.seek(step)) == states[step] ? 0 : 1;
        }
        CHECK(wrong == 0);
    }
}

TEST_CASE("Each step has its line and the index of its event") {
    for (const auto& text : all_traces()) {
        Replay replay;
        append_all(replay, text);
        std::size_t at = text.find('\n') + 1;
        for (std::uint64_t step = 1; step <= replay.length(); ++step) {
            const std::string line = text.substr(at, text.find('\n', at) - at);
            REQUIRE(replay.line(step) == line);
            const std::string name(event_names[replay.names()[std::size_t(step - 1)]]);
            REQUIRE(line.starts_with(R"({"e":")" + name + R"(",)"));
            at += line.size() + 1;
        }
        CHECK(text.substr(at).starts_with(R"({"end":)"));
    }
}

TEST_CASE("Lists of 20,000 polygons do not slow a replay down") {
    // All polygons but the first and the last leave the list, one by one.
    const int count = 20000 / thinning;
    Scene scene{"", area_16, white, {}};
    std::string apl;
    for (int i = 0; i < count; ++i) {
        const std::string id = "P" + std::to_string(i);
        scene.polygons.push_back({id, red, near_square});
        apl += (i == 0 ? "[\"" : ",[\"") + id + "\",false]";
    }
    std::vector<std::string> lines{R"({"e":"push","at":"W3","window":[0,0,16,16],"apl":[)" + apl + "]}", pop};
    for (int i = 1; i < count - 1; ++i) {
        lines.push_back(R"({"e":"discard","at":"PW3","polygon":"P)" + std::to_string(i) + "\"}");
    }
    Replay replay;
    const std::uint64_t steps = lines.size();
    const auto list_at = [&](std::uint64_t step) {
        const WarnockState& warnock = std::get<State>(replay.seek(step)).warnock();
        return warnock.list(*warnock.current()).entries();
    };
    CHECK(seconds([&] { append_all(replay, with_lines(lines, scene)); }) < patience);
    REQUIRE(replay.length() == steps);
    std::mt19937 random(5);
    CHECK(seconds([&] {
              for (int trial = 0; trial < 200; ++trial) {
                  const std::uint64_t step = 2 + random() % (steps - 1);
                  REQUIRE(list_at(step).size() == std::size_t(count) - std::size_t(step - 2));
              }
          }) < patience);
    CHECK(seconds([&] {
              for (std::uint64_t step = steps / 2; step < steps / 2 + 200; ++step) {
                  Text reported;
                  replay.append_values(reported, step);
              }
          }) < patience);
    CHECK(list_at(steps) == std::vector<AplEntry>{{{0}, false}, {{count - 1}, false}});
}

TEST_CASE("The largest area does not slow a replay down") {
    // Each step fills one pixel of a diagonal, with its own colour. Each state of the area takes half a megabyte even
    // if tiles are shared, so few of them are kept.
    const int steps = 50000 / thinning;
    Scene scene{"", {0, 0, largest_side, largest_side}, white, {{"A", red, near_square}}};
    std::vector<std::string> lines{R"({"e":"push","at":"W3","window":[0,0,16384,16384],"apl":[]})",
                                   R"({"e":"pop","at":"W5","window":[0,0,16384,16384]})"};
    const auto color_at = [](int step) { return Color{1, std::uint8_t(step % 251), std::uint8_t(step % 253)}; };
    for (int step = 3; step <= steps; ++step) {
        Text line;
        line += R"({"e":"fill","at":"W7","rect":[)";
        append_integer(line, step % largest_side);
        line += ',';
        append_integer(line, step % largest_side);
        line += R"(,1,1],"color":)";
        append_color(line, color_at(step));
        line += '}';
        lines.push_back(line.string());
    }
    Replay replay;
    CHECK(seconds([&] { append_all(replay, with_lines(lines, scene)); }) < patience);
    REQUIRE(replay.length() == std::uint64_t(steps));
    const auto check_at = [&](int step) {
        const Screen& screen = std::get<State>(replay.seek(std::uint64_t(step))).screen();
        const Screen::Pixel& pixel = screen.pixel(step % largest_side, step % largest_side);
        CHECK(pixel == Screen::Pixel{color_at(step), std::uint32_t(step)});
        CHECK(screen.pixel(0, 1).painter == 0);
    };
    CHECK(seconds([&] {
              for (const int step : {steps, 3, steps / 2, steps / 2 + 1, 4, steps - 1}) check_at(step);
              for (int step = steps; step > steps - 50; --step) check_at(step);
          }) < patience);
}
