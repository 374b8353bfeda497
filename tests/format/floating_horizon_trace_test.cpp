// The trace of the floating horizon: graded, the same after reading it back, and checked.

#include <doctest/doctest.h>

#include <fstream>
#include <sstream>

#include "check/check.h"
#include "check/checked_trace.h"
#include "format/event_text.h"
#include "format/trace_reader.h"
#include "replay/floating_horizon_state.h"
#include "replay/state.h"
#include "run/write_trace.h"
#include "support/random_curves.h"

using namespace vidno;
using namespace vidno::test;

namespace {

struct Choice {
    std::string kernel;
    Edition edition;
};

std::vector<Choice> all_choices() {
    std::vector<Choice> choices;
    for (const std::string kernel : {"float", "double", "bits:4", "bits:11", "filtered", "exact"}) {
        for (const Edition edition : {Edition::corrected, Edition::printed}) {
            if (kernel_named(kernel)->choice->runs_floating_horizon(edition)) choices.push_back({kernel, edition});
        }
    }
    return choices;
}

Surface some_surface() { return {"some", some_curves()}; }

FloatingHorizonHeader header_of(const Surface& surface, const Choice& choice, Detail detail) {
    return {choice.edition, choice.kernel, detail, surface};
}

struct TracedRun {
    std::string text;
    bool whole;
};

TracedRun traced(const Surface& surface, const Choice& choice, Detail detail, bool checked = false,
                 std::uint64_t most_events = TraceWriter::no_limit) {
    std::string text;
    TraceWriter writer(
        header_of(surface, choice, detail), [&](std::string_view part) { text += part; }, most_events);
    const FloatingHorizonRequest request{*kernel_named(choice.kernel), choice.edition, surface.curves, detail};
    const bool whole = checked ? write_checked_trace(request, writer) : write_trace(request, writer);
    return {text, whole};
}

DrawnLines lines_of_run(const Surface& surface, const Choice& choice) {
    return run(FloatingHorizonRequest{*kernel_named(choice.kernel), choice.edition, surface.curves});
}

FloatingHorizonTraceReader reader_of(const std::string& text) {
    return FloatingHorizonTraceReader(TraceFile(LineReader::of_text(text), "trace"));
}

std::vector<Event> events_of(const std::string& text) {
    std::vector<Event> events;
    FloatingHorizonTraceReader reader = reader_of(text);
    while (const auto event = reader.next()) events.push_back(event->copy());
    return events;
}

std::string text_of(const std::vector<Event>& events) {
    EventText lines({});
    Text text;
    for (const auto& event : events) lines.line(text, event);
    return text.string();
}

bool same_ends(const LineEnd<Value>& a, const LineEnd<Value>& b) {
    return a.point.x == b.point.x && a.point.y == b.point.y && a.left == b.left && a.right == b.right;
}

bool same_lines(const DrawnLines& a, const DrawnLines& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& p, const auto& q) {
        return p.segment == q.segment && same_ends(p.from, q.from) && same_ends(p.to, q.to);
    });
}

}  // namespace

TEST_CASE("Curves: the lines are rebuilt at every level, and their hash is that of the file") {
    const Surface surface = some_surface();
    for (const auto& choice : all_choices()) {
        CAPTURE(choice.kernel);
        CAPTURE(name_of(choice.edition));
        const DrawnLines own = lines_of_run(surface, choice);
        for (const Detail detail : {Detail::windows, Detail::polygons, Detail::signs}) {
            CAPTURE(int(detail));
            FloatingHorizonTraceReader reader = reader_of(traced(surface, choice, detail).text);
            FloatingHorizonState state(reader.header());
            while (const auto event = reader.next()) state.apply(*event);
            CHECK(same_lines(state.values().lines, own));
            REQUIRE(reader.end().has_value());
            CHECK(reader.end()->hash == lines_hash(own));
        }
    }
}

TEST_CASE("Curves: the hash is that of the lines as text") {
    // The second crosses the first at (5.5, 8).
    const Surface surface{
        "", CurveSceneBuilder({0, 0, 13, 16}).curve({{0, 8}, {12, 8}}).curve({{0, 13.5}, {12, 1.5}}).build()};
    CHECK(lines_hash(lines_of_run(surface, {"double", Edition::corrected})) ==
          hash_text("[0,[0,8],[12,8]]\n[1,[0,13.5],[5.5,8]]\n[1,[5.5,8],[12,1.5]]\n"));
    CHECK(lines_hash(lines_of_run(surface, {"exact", Edition::corrected})) ==
          hash_text("[0,[\"0/1\",\"8/1\"],[\"12/1\",\"8/1\"]]\n[1,[\"0/1\",\"27/2\"],[\"11/2\",\"8/1\"]]\n"
                    "[1,[\"11/2\",\"8/1\"],[\"12/1\",\"3/2\"]]\n"));
}

TEST_CASE("Curves: a lower level is a higher one with events left out") {
    const Surface surface = some_surface();
    for (const auto& choice : all_choices()) {
        CAPTURE(choice.kernel);
        for (const Detail detail : {Detail::windows, Detail::polygons}) {
            std::vector<Event> left;
            for (const auto& event : events_of(traced(surface, choice, Detail::signs).text)) {
                const auto* call = event.get_if<event::Call>();
                const Detail from =
                    call ? event::calls_from(call->of) : event.visit([](const auto& e) { return e.kind.from; });
                if (from <= detail) left.push_back(event);
            }
            CHECK(text_of(left) == text_of(events_of(traced(surface, choice, detail).text)));
        }
    }
}

TEST_CASE("Curves: read back and written again the bytes are the same, twice traced too") {
    const Surface surface = some_surface();
    for (const auto& choice : all_choices()) {
        const std::string text = traced(surface, choice, Detail::signs).text;
        CHECK(text == traced(surface, choice, Detail::signs).text);
        FloatingHorizonTraceReader reader = reader_of(text);
        std::string again;
        TraceWriter writer(reader.header(), [&](std::string_view part) { again += part; });
        FloatingHorizonState state(reader.header());
        while (const auto event = reader.next()) {
            writer.hear(*event);
            state.apply(*event);
        }
        writer.finish("lines", lines_hash(state.values().lines));
        CHECK(again == text);
    }
}

TEST_CASE("Curves: the example of FORMAT.md is what the program writes") {
    std::ifstream file(VIDNO_ROOT "/trace/FORMAT.md");
    std::stringstream format;
    format << file.rdbuf();
    const std::string opening = "```jsonl\n";
    const auto begin = format.str().find(opening, format.str().find("## An example of curves")) + opening.size();
    const std::string example = format.str().substr(begin, format.str().find("```", begin) - begin);
    const FloatingHorizonHeader header = reader_of(example).header();
    CHECK(traced(header.scene, {header.kernel, header.edition}, header.detail).text == example);
}

TEST_CASE("Curves: a limit keeps the events so far and marks the trace as partial") {
    const auto [text, whole] = traced(some_surface(), {"double", Edition::corrected}, Detail::signs, false, 10);
    CHECK_FALSE(whole);
    FloatingHorizonTraceReader reader = reader_of(text);
    while (reader.next()) {
    }
    CHECK(reader.events() == 10);
    REQUIRE(reader.end().has_value());
    CHECK(reader.end()->partial);
}

TEST_CASE("Curves: a trace of curves is not read as one of polygons, nor the other way round") {
    const std::string text = traced(some_surface(), {"double", Edition::corrected}, Detail::windows).text;
    CHECK(std::holds_alternative<FloatingHorizonTraceReader>(open_trace(LineReader::of_text(text), "trace")));
    CHECK_THROWS_WITH_AS(TraceReader(LineReader::of_text(text), "trace"),
                         "trace:1: /method: floating-horizon, which this command does not take", Refused);
    const FloatingHorizonHeader header = header_of(some_surface(), {"double", Edition::corrected}, Detail::signs);
    FloatingHorizonState state(header);
    CHECK_THROWS_AS(state.apply(event::Pop{}), Impossible);
    const TraceHeader polygons{
        {}, {}, "double", Detail::signs, {.name = {}, .area = {0, 0, 1, 1}, .background = {}, .polygons = {}}};
    State other(polygons);
    CHECK_THROWS_AS(other.apply(event::Curve{}), Impossible);
}

TEST_CASE("Curves: a line that no run reports is refused, with its number") {
    const std::string text = traced(some_surface(), {"double", Edition::corrected}, Detail::polygons).text;
    const auto refused = [&](const std::string& from, const std::string& to) {
        std::string changed = text;
        const auto at = changed.find(from);
        REQUIRE(at != changed.npos);
        try {
            events_of(changed.replace(at, from.size(), to));
        } catch (const Refused& refusal) {
            return std::string(refusal.what());
        }
        return std::string("taken");
    };
    CHECK(refused("\"double\"", "\"depth:8\"") ==
          "trace:1: /kernel: floating-horizon does not run under this kernel and edition");
    CHECK(refused("\"corrected\"", "\"one-list\"") ==
          "trace:1: /kernel: floating-horizon does not run under this kernel and edition");
    CHECK(refused("[8,12]", "[-2,12]") == "trace:1: /scene/curves/0/1/0: not right of the sample before");
    CHECK(refused("\"curves\"", "\"function\":\"x\",\"curves\"") ==
          "trace:1: /scene/function: a trace has samples instead");
    CHECK(refused("\"flag\":2", "\"flag\":3") == "trace:6: /flag: not -1, 0, 1 or 2");
    CHECK(refused("\"lines\":", "\"picture\":").ends_with("/end: unknown key picture"));
}

TEST_CASE("Curves: an event that cannot follow") {
    const FloatingHorizonHeader header = header_of(some_surface(), {"double", Edition::corrected}, Detail::signs);
    const auto impossible = [&](const std::vector<Event>& events) -> std::string {
        FloatingHorizonState state(header);
        try {
            for (const auto& event : events) state.apply(event);
        } catch (const Impossible& reason) {
            return reason.reason;
        }
        return "possible";
    };
    event::DrawLine line;
    line.segment = {-2, 8};
    CHECK(impossible({event::Curve{Line::FH2, 5}}) == "no curve of the scene");
    CHECK(impossible({line}) == "a segment of no curve");
    CHECK(impossible({event::Curve{Line::FH2, 1}, line}) == "no segment of the curve");
    CHECK(impossible({event::Curve{Line::FH2, 0}, line}) == "possible");
    CHECK(impossible({event::Raise{Line::H2, 12, 0}}) == "a column outside the area");
    event::Visibility looked;
    looked.x = 12;
    CHECK(impossible({event::Call{Line::FH4, Procedure::visibility}, looked}) == "a column outside the area");
    CHECK(impossible({event::Horizon{}}) == "a result of a procedure that is not running");
}

namespace {

struct CheckedEvents {
    std::vector<event::Visibility> flags;  // with their truth
    std::vector<Event> plain;              // the same run without what only a check tells
    int disagreements = 0, wrong_flags = 0;
};

CheckedEvents checked(const Surface& surface, const Choice& choice) {
    CheckedEvents found;
    for (const Event& event : events_of(traced(surface, choice, Detail::signs, true).text)) {
        if (const auto* wrong = event.get_if<event::Disagree>()) {
            ++found.disagreements;
            found.wrong_flags += wrong->of == Decision::visibility ? 1 : 0;
        } else if (const auto* flag = event.get_if<event::Visibility>()) {
            found.flags.push_back(*flag);
            event::Visibility plain = *flag;
            plain.checked = {};
            found.plain.push_back(plain);
        } else {
            found.plain.push_back(event);
        }
    }
    return found;
}

bool is_visible(const Answer& flag) { return std::get<int>(flag) != int(VisibilityFlag::hidden); }

/// The flags that the rule gives for each column of each curve, in order.
std::vector<bool> by_the_rule(const AdmittedCurves& scene) {
    std::vector<bool> visible;
    const FloatingHorizonReference reference(scene);
    for (const auto& curve : reference.curves())
        visible.insert(visible.end(), curve.visible.begin(), curve.visible.end());
    return visible;
}

Surface next_to_coincidences(RandomCurves& random) { return {"", moved_by_ulps(random.scene(), random)}; }

}  // namespace

TEST_CASE("Curves: a checked run is the same run, with the truth beside every flag") {
    const Surface surface = some_surface();
    for (const auto& choice : all_choices()) {
        CAPTURE(choice.kernel);
        CAPTURE(name_of(choice.edition));
        const CheckedEvents found = checked(surface, choice);
        CHECK(text_of(found.plain) == text_of(events_of(traced(surface, choice, Detail::signs).text)));
        for (const auto& flag : found.flags) CHECK(flag.checked.exact.has_value());
        // Only filtered reports what decided, and only where there was a horizon to compare with.
        const auto by = std::count_if(found.flags.begin(), found.flags.end(),
                                      [](const auto& flag) { return flag.checked.by.has_value(); });
        CHECK((by > 0) == (choice.kernel == "filtered"));
    }
}

TEST_CASE("Curves: exact and filtered decide as the rule says, and their check finds nothing") {
    RandomCurves random(23);
    for (int i = 0; i < 150; ++i) {
        CAPTURE(i);
        const Surface surface = next_to_coincidences(random);
        const auto rule = by_the_rule(surface.curves);
        for (const std::string kernel : {"exact", "filtered"}) {
            const CheckedEvents found = checked(surface, {kernel, Edition::corrected});
            REQUIRE(found.flags.size() == rule.size());
            for (std::size_t j = 0; j < rule.size(); ++j) {
                CHECK(is_visible(found.flags[j].decision()) == rule[j]);
                CHECK(found.flags[j].checked.exact->answer == found.flags[j].decision());
            }
            CHECK(found.disagreements == 0);
            CHECK_FALSE(check_run(FloatingHorizonRequest{*kernel_named(kernel), Edition::corrected, surface.curves})
                            .found_something());
        }
    }
}

TEST_CASE("Curves: beside a wrong decision under double, the truth is that of the rule") {
    RandomCurves random(29);
    int wrong_runs = 0;
    for (int i = 0; i < 300; ++i) {
        CAPTURE(i);
        const Surface surface = next_to_coincidences(random);
        const auto rule = by_the_rule(surface.curves);
        const CheckedEvents found = checked(surface, {"double", Edition::corrected});
        REQUIRE(found.flags.size() == rule.size());
        int wrong = 0;
        for (const auto& flag : found.flags) wrong += flag.checked.exact->answer == flag.decision() ? 0 : 1;
        CHECK(wrong == found.wrong_flags);
        wrong_runs += wrong > 0 ? 1 : 0;
        // Along the path that was taken; up to the first wrong decision this is the rule's own path.
        for (std::size_t j = 0; j < rule.size() && found.disagreements == found.wrong_flags; ++j) {
            const Answer truth = *found.flags[j].checked.exact->answer;
            CHECK(is_visible(truth) == rule[j]);
            if (truth != found.flags[j].decision()) break;
        }
    }
    CHECK(wrong_runs > 20);
}

TEST_CASE("Curves: a check counts decisions by procedure, and the columns that are wrong") {
    // The second curve is below the first over all of its columns: as printed it is not drawn (X-H1). Three decisions
    // of Visibility on each curve: its three columns; the text looks at two, its samples.
    const AdmittedCurves scene =
        CurveSceneBuilder({0, 0, 4, 16}).curve({{0, 4}, {2, 4}}).curve({{0, 12}, {2, 12}}).build();
    const auto decisions = [](const FloatingHorizonCheckReport& report, Procedure procedure) {
        const auto of = std::find_if(report.procedures.begin(), report.procedures.end(),
                                     [&](const auto& each) { return each.procedure == procedure; });
        return of == report.procedures.end() ? 0 : of->decisions;
    };
    const auto right = check_run(FloatingHorizonRequest{*kernel_named("double"), Edition::corrected, scene});
    CHECK(right.columns == 6);
    CHECK(right.wrong_columns == 0);
    CHECK(decisions(right, Procedure::visibility) == 6);
    CHECK_FALSE(right.found_something());
    const auto printed = check_run(FloatingHorizonRequest{*kernel_named("double"), Edition::printed, scene});
    CHECK(printed.wrong_columns == 3);
    CHECK(decisions(printed, Procedure::visibility) == 4);
    CHECK(printed.found_something());
}

TEST_CASE("Curves: how far double's intersections are from the exact ones") {
    // 0.1 + x / 3 from (0, 0.1) to (9, 3.1) comes to 1 at x = 2.7 (nearly, for 0.1 and 3.1 are no doubles).
    const AdmittedCurves scene =
        CurveSceneBuilder({0, 0, 10, 16}).curve({{0, 1}, {9, 1}}).curve({{0, 0.1}, {9, 3.1}}).build();
    const auto report = check_run(FloatingHorizonRequest{*kernel_named("double"), Edition::corrected, scene});
    CHECK(report.intersections == 2);  // the line that ends above, and the one that begins below
    CHECK(report.farthest_off < 1e-14);
    const auto in_bits = check_run(FloatingHorizonRequest{*kernel_named("bits:6"), Edition::corrected, scene});
    CHECK(in_bits.farthest_off > 1e-3);
}
