// Committed files that are derived from the table of events must agree with it.

#include "event_table/event_table.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <string>

#include "output.h"

using namespace vidno;

namespace {

std::map<std::string, EventDescription, std::less<>> events_by_name() {
    std::map<std::string, EventDescription, std::less<>> events;
    for (const auto& event : all_events()) events.emplace(event.name, event);
    return events;
}

Line line_named(std::string_view name) {
    const auto place = std::find(line_names.begin(), line_names.end(), name);
    REQUIRE_MESSAGE(place != line_names.end(), name);
    return Line(place - line_names.begin());
}

/// "W7 to W10, PC4" as labels.
LineSet lines_named(const std::string& text) {
    LineSet lines{};
    const std::regex range(R"(([A-Z]+)(\d+)(?: to [A-Z]+(\d+))?)");
    for (std::sregex_iterator found(text.begin(), text.end(), range), end; found != end; ++found) {
        const int first = std::stoi((*found)[2]);
        const int last = (*found)[3].matched ? std::stoi((*found)[3]) : first;
        for (int number = first; number <= last; ++number) {
            lines.add(line_named((*found)[1].str() + std::to_string(number)));
        }
    }
    return lines;
}

}  // namespace

TEST_CASE("FORMAT.md and the schemas agree with the tables of events and choices (`./dev derive` rewrites them)") {
    for (const DerivedDocument& document : derived_documents()) {
        CAPTURE(document.file);
        const std::string text = read_file(VIDNO_ROOT "/trace/" + std::string(document.file));
        CHECK(text == document.derived(text));
    }
}

TEST_CASE("FORMAT.md says which edition of which method runs under which kernel") {
    const std::string format = read_file(VIDNO_ROOT "/trace/FORMAT.md");
    const auto says = [&](const std::string& row) { return format.find("\n" + row + "\n") != std::string::npos; };
    CHECK(says("| `warnock` | `printed` | `float`, `double`, `bits`, `exact` |"));
    CHECK(says("| `warnock-angles` | `octants-not-split` | `double`, `exact` |"));
    CHECK(says("| `weiler-atherton` | `corrected` | `float`, `double`, `bits`, `filtered`, `exact` |"));
    CHECK(says("| `one-list` | all parts of a window share one list |"));
    CHECK(says(
        "| `bits:P` | every result rounded to P bits; decisions follow from the rounded values; P from 4 to 24 |"));
}

TEST_CASE("The calls of the header for students have the levels and lines of their events, and its results are bold") {
    // | `line(row, from_x, ...)`, `miss()` | p | says | L1, L2 |
    const std::string readme = read_file(VIDNO_ROOT "/lessons/student/README.md");
    const auto events = events_by_name();
    const std::regex row(R"(\n\| (\**)(`\w+\(.*?\)`)\** \| ([wps](?:, [wps])*) \| (.*?) \| ([A-Z0-9a-z, ]+) \|)");
    const std::regex call(R"(`(\w+)\()");
    std::set<std::string> reported;
    for (std::sregex_iterator found(readme.begin(), readme.end(), row), end; found != end; ++found) {
        const std::string calls = (*found)[2], levels = (*found)[3], says = (*found)[4];
        const LineSet lines = lines_named((*found)[5]);
        CAPTURE(calls);
        LineSet known{};
        std::string known_levels;
        for (std::sregex_iterator each(calls.begin(), calls.end(), call); each != end; ++each) {
            const std::string name = (*each)[1];
            REQUIRE_MESSAGE(events.count(name) == 1, name);
            const EventDescription& event = events.at(name);
            for (const auto line : names_of(event.lines)) known.add(line_named(line));
            const char level = detail_names[std::size_t(event.from)][0];
            if (known_levels.find(level) == std::string::npos)
                known_levels += (known_levels.empty() ? "" : ", ") + std::string(1, level);
            const bool is_bold = (*found)[1].length() > 0 || says.find("**result**") != std::string::npos;
            CHECK(is_bold == event.result_of.has_value());
            reported.insert(name);
        }
        CHECK(levels == known_levels);
        for (const auto name : names_of(lines)) {
            CHECK_MESSAGE(known.has(line_named(name)), name);
        }
    }
    CHECK(reported.size() > 40);
}

TEST_CASE("The fields of events: names of values, ranges, lists and words") {
    const auto events = events_by_name();
    const auto field = [&](const char* event, std::size_t place) { return events.at(event).fields.at(place); };
    CHECK(field("surround", 1).shape.name == "point");
    CHECK(field("nearer", 2).meaning.most == 4);
    CHECK(field("nearer", 1).shape.kind == Shape::Kind::list);
    CHECK(field("decide", 0).shape.words ==
          std::vector<std::string_view>{"empty", "surrounded", "pixel", "single", "split"});
    CHECK(field("push", 1).is_optional);
    CHECK(names_of(events.at("push").lines) == std::vector<std::string_view>{"W3", "W13", "WS1", "WS6", "WF1", "WF12"});
    CHECK(events.at("surround").result_of == Procedure::surround_test);
}
