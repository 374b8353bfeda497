#include "say/notes_in_play.h"

#include <map>

#include "replay/replay.h"
#include "say/sentence.h"

namespace vidno::say {

namespace {

constexpr std::uint64_t farthest = 400;

/// Where a line is: the letters of its procedure, and its number there.
struct PlaceInProcedure {
    std::string_view letters;
    int line = 0;

    explicit PlaceInProcedure(Line at) {
        const std::string_view label = line_names[std::size_t(at)];
        const auto digits = label.find_first_of("0123456789");
        letters = label.substr(0, digits);
        for (const char digit : label.substr(digits)) line = 10 * line + (digit - '0');
    }
};

/// By how much an event changes the number of running procedures at this level.
int change_of_calls(const EventView& event, Detail detail) {
    return event.visit([&]<class E>(const E&) {
        if constexpr (std::same_as<E, event::Call>) {
            return 1;
        } else if constexpr (requires { E::result_of; }) {
            return detail >= event::calls_from(E::result_of) ? -1 : 0;
        } else {
            return 0;
        }
    });
}

/// Whether an event begins a window, a polygon, a curve or a list.
bool begins(const EventView& event) {
    return event.get_if<event::Pop>() || event.get_if<event::Polygon>() || event.get_if<event::Curve>() ||
           event.get_if<event::PopList>();
}

}  // namespace

std::vector<std::pair<Line, std::string>> notes_in_play(Replay& run, std::uint64_t step, Language language) {
    const Detail detail = std::visit([](const auto& of) { return of.detail; }, run.header());
    std::map<Line, std::string> notes;
    std::map<std::string_view, int> reached;  // in each procedure, the line reached on the way back
    int within = 0;                           // the depth inside calls that have returned
    for (std::uint64_t at = step; at > 0 && at + farthest > step; --at) {
        const EventView event = run.event(at);
        const int change = change_of_calls(event, detail);
        if (within > 0) {
            within -= change;
            continue;
        }
        const Line line = event.visit([](const auto& e) { return e.at; });
        const PlaceInProcedure place(line);
        if (change > 0) reached.clear();
        const auto last = reached.find(place.letters);
        if (last == reached.end() || place.line <= last->second) {
            std::string said = std::visit([&](const auto& of) { return note(event, of, language); }, run.shown());
            if (!said.empty()) notes.try_emplace(line, std::move(said));
            reached[place.letters] = place.line;
        }
        if (change < 0) within = 1;
        if (begins(event)) break;
    }
    return {notes.begin(), notes.end()};
}

}  // namespace vidno::say
