/// replay.wasm: the library in a page's own thread. It reads traces and has the state of their runs after any step.
///
/// exchange.h says how a page asks. A trace has a number. An append adds the request to the trace's file; it may end
/// anywhere. The other functions need no request. What they make is text in UTF-8: JSON, or nothing.
///
///     trace_open()           the number of a new trace, which has no bytes yet
///     trace_close(t)         forgets it
///     trace_append(t)        adds the next bytes of its file; false if the file is not a trace, for the reason in the
///                            messages, "/path: reason" or "reason"; it is then forgotten
///     trace_finish(t)        the file has ended; false in the same way
///     trace_header(t)        makes the first line as the library writes it; nothing before it was read
///     trace_shortened(t)     makes {"why":"cut"|"partial"|"wrong","line":N,"reason":R}, with the reason of a wrong
///                            line in the form of the messages, otherwise empty; nothing if the steps are those of the
///                            file so far
///     trace_length(t)        the number of steps read so far
///     trace_names(t)         for each step the index of its event in the table of events, one byte each
///     trace_line(t, step)    makes the text of a step's event as it was read
///     trace_sentence(t, step, language)
///                            makes the sentence that says what a step does, in the language with this place in the
///                            table of languages; where what it states is not so, what is so follows on a second line,
///                            and on a third one the pixel that shows it, "x y", if it is about one, as after the other
///                            sentences
///     trace_notes(t, step, language)
///                            makes the notes beside the listing at a step, [["LINE",NOTE],...]
///     trace_note(t, step, language)
///                            makes the note of a step's event; nothing if it has none
///     has_note(event)        whether events have notes, by their index in the table of events
///     trace_decision(t, step, language)
///                            makes the decision of a step (say/decision.h); nothing if it has none
///     trace_verdict(t, comparison, wrong, language)
///                            makes the verdict on the run at its end (say/verdict.h), given how it compares
///     trace_values(t, step)  shows a step, from 0, and makes its values as they differ from those that were made last
///                            (values.h)
///
/// The history of a pixel of a trace, or of a column of a run of curves, has a number, too. It reads the trace step by
/// step.
///
///     history_open(t, x, y)  the number of a new history, which has read nothing yet
///     history_close(h)       forgets it
///     history_read(h, until) reads on to this step, and makes the steps that concern the pixel as a list of
///                            {"step":N,"outcome":"pass"|"fail"|"paint"|"wrong"|"note","under":U}: a window, a polygon
///                            or a curve was current
///     history_sentence(h, step, outcome, language)
///                            makes the sentence of such a step, whose outcome is given by its place among these words
///     history_why(h, step, is_later, language)
///                            makes the reason why the pixel has the colour that this step painted, or why it will
///                            have it
///     history_holding(h)     makes {"owner":P|null,"holding":[P,...]}: the places in the scene of the owner and of all
///                            polygons that hold the pixel's centre; nothing for a run of curves, or of a method whose
///                            rule is not the picture rule
///     history_reason(h, polygon, language)
///                            makes what vidno-why/1 has of the polygon with this place, and on the next line its
///                            sentence; for -1 null, and that no polygon shows
///
/// The following are about the step that is shown, at first 0. A run of curves has no screen: for it they give what an
/// empty one has.
///
///     painted_at(t)          the last step that changed the pixels or the depths
///     divided_at(t)          the last step that divided a window
///     is_ground(t)           whether pixels that nothing has painted are background, and not merely unpainted so far
///     pixel(t, x, y)         a pixel of the plane as a canvas has it: red in the lowest byte. One that nothing has
///                            painted has the colour of the background with alpha 0. One outside the area is 0.
///     painter(t, x, y)       the step that painted it last; 0 if none has
///     pixel_rows(t, y, n)    the pixels of the area's n rows from y, one after the other
///     row_repeats(t, y)      whether the pixels of a row are those of the row above it
///     has_depths(t)          whether the pixels have depths
///     depth(t, x, y)         the depth of a pixel of the area as a double, at least nearly
///     depth_text(t, x, y)    makes it as JSON
///     windows(t, x, y, width, height, least)
///                            the windows of the area's division in a part of the plane: their number and then the x,
///                            y, width and height of each, all doubles. Windows of a lesser side than `least` are left
///                            out, or merged.
///
/// Bytes, pixels and windows stay where they are until the next call.

#include <map>
#include <memory>
#include <vector>

#include "choice/method.h"
#include "proof/why.h"
#include "replay/replay.h"
#include "say/decision.h"
#include "say/notes_in_play.h"
#include "say/pixel_history.h"
#include "say/sentence.h"
#include "say/verdict.h"
#include "wasm/exchange.h"

namespace vidno {
namespace {

using Cell = Screen::Pixel;

std::map<int, Replay>& replays() {
    static std::map<int, Replay> all;
    return all;
}

Replay& replay(int number) { return replays().at(number); }

/// Lets a trace read on. What is no trace is forgotten, since no page asks about it.
bool read_on(int number, void (*read)(Replay&, std::string& request)) {
    const bool is_read = attempt([&](Exchange& page) { read(replay(number), page.request); });
    if (!is_read) replays().erase(number);
    return is_read;
}

/// Why a pixel shows what it shows, by the picture rule.
struct PixelReasons {
    Reasons reasons;
    std::optional<int> owner;

    PixelReasons(const Scene& scene, Pixel pixel) : reasons(scene), owner(reasons.owner(pixel.x, pixel.y)) {}
};

/// A pixel that is followed through a trace.
struct Followed {
    int trace;
    Pixel pixel;
    say::PixelWatch watch;
    std::uint64_t seen = 0;                                       // the last step that was read
    std::vector<std::pair<std::uint64_t, say::Outcome>> steps{};  // that concern the pixel
    std::optional<say::GoesWrong> goes_wrong{};                   // as far as the page has asked
    std::uint64_t judged = 0;                                     // the last step that it saw
    std::size_t heard = 0;                                        // the steps of the history that it heard
    std::unique_ptr<const PixelReasons> reasons{};                // once they were asked for
};

/// Values in which no polygon is named by its place.
void append_json(Text& out, const auto& value) {
    const PolygonNames none;
    RememberedShortest shortest;
    FieldWriter<Text&>(out, none, shortest).value(value);
}

void append_statement(Text& out, const say::Statement& said) {
    out += said.text;
    if (said.exactly.empty()) return;
    out += '\n';
    out += said.exactly;
    if (!said.pixel) return;
    out += '\n';
    append_integer(out, said.pixel->first);
    out += ' ';
    append_integer(out, said.pixel->second);
}

/// Where the run goes wrong about the pixel before a step of its history. While the page reads a history, it asks about
/// one step after the other, with each frame: what was seen is not seen again.
std::optional<std::uint64_t> goes_wrong_before(Followed& history, std::uint64_t step) {
    Replay& of = replay(history.trace);
    const auto& header = std::get<TraceHeader>(of.header());
    if (!say::can_be_wrong(header)) return std::nullopt;
    if (!history.goes_wrong || step <= history.judged) {
        history.goes_wrong.emplace(history.pixel, header);
        history.judged = history.heard = 0;
    }
    for (; history.judged + 1 < step; ++history.judged) {
        const std::uint64_t next = history.judged + 1;
        if (of.names()[next - 1] != event_place<event::Discard> || !history.goes_wrong->needs(of.event(next))) continue;
        const auto [event, after] = of.look_at(next);
        history.goes_wrong->see(event, std::get<State>(after));
    }
    for (; history.heard < history.steps.size() && history.steps[history.heard].first < step; ++history.heard) {
        const auto& [each, outcome] = history.steps[history.heard];
        if (outcome == say::Outcome::paint) continue;
        const auto [event, after] = of.look_at(each);
        history.goes_wrong->hear(each,
                                 say::sentence_for_pixel(event, outcome, std::get<State>(after), Language::english));
    }
    return history.goes_wrong->step(std::get<State>(of.look_at(step).after));
}

std::map<int, Followed>& histories() {
    static std::map<int, Followed> all;
    return all;
}

void append_heading(Text& out, const say::Heading& heading, const AnyHeader& header) {
    if (const auto* window = std::get_if<Window>(&heading)) {
        out += '[';
        append_number(out, window->x);
        for (const double each : {window->y, window->width, window->height}) {
            out += ',';
            append_number(out, each);
        }
        out += ']';
    } else if (const auto* polygon = std::get_if<PolygonPlace>(&heading)) {
        append_string(out, std::get<TraceHeader>(header).scene.polygons[std::size_t(polygon->index)].id);
    } else if (const auto* curve = std::get_if<int>(&heading)) {
        append_integer(out, *curve);
    } else {
        out += "null";
    }
}

say::PixelWatch watch_of(const AnyHeader& any, Pixel pixel) {
    return std::visit([&](const auto& header) { return say::PixelWatch(pixel, header); }, any);
}

/// Lets a history read the next step.
void read_step(Followed& history, Text& out, bool& is_first) {
    Replay& of = replay(history.trace);
    const std::uint64_t step = ++history.seen;
    const std::size_t name = of.names()[step - 1];
    if (!history.watch.needs(name) || history.watch.is_elsewhere(name, of.line(step))) return;
    const EventView event = of.event(step);
    const auto outcome = history.watch.see(event, step);
    if (!outcome) return;
    history.steps.emplace_back(step, *outcome);
    out += is_first ? "" : ",";
    is_first = false;
    out += std::string_view(R"({"step":)");
    append_integer(out, step);
    out += std::string_view(R"(,"outcome":")");
    out += say::outcome_names[std::size_t(*outcome)];
    out += std::string_view(R"(","under":)");
    append_heading(out, history.watch.heading(event), of.header());
    out += '}';
}

const PixelReasons& reasons_of(Followed& history, const Scene& scene) {
    if (!history.reasons) history.reasons = std::make_unique<PixelReasons>(scene, history.pixel);
    return *history.reasons;
}

void append_holding(Text& out, Followed& history, const TraceHeader& header) {
    if (choice_of(header.method).rule.rule != picture_rule.rule) return;
    const auto& [reasons, owner] = reasons_of(history, header.scene);
    out += std::string_view(R"({"owner":)");
    owner ? append_integer(out, *owner) : void(out += std::string_view("null"));
    out += std::string_view(R"(,"holding":)");
    char before = '[';
    for (const int place : reasons.holding(history.pixel.x, history.pixel.y)) {
        out += before;
        append_integer(out, place);
        before = ',';
    }
    if (before == '[') out += before;
    out += std::string_view("]}");
}

void append_reason(Text& out, Followed& history, const Scene& scene, std::optional<int> polygon, Language language) {
    const auto& [reasons, owner] = reasons_of(history, scene);
    const auto [x, y] = history.pixel;
    if (!polygon) {
        out += std::string_view("null\n");
        out += sentence_of_owner(reasons, x, y, std::nullopt, scene, language);
        return;
    }
    const AtPixel found = reasons.at(x, y, *polygon, owner);
    append_at_pixel(out, found, scene);
    out += '\n';
    out += sentence(found, scene, language);
}

/// The screen of a run of polygons.
const Screen* screen_of(int number) {
    const auto* state = std::get_if<State>(&replay(number).shown());
    return state != nullptr ? &state->screen() : nullptr;
}

std::uint32_t in_canvas(const Cell& pixel) {
    const auto& [color, painter] = pixel;
    const std::uint32_t opacity = painter == 0 ? 0 : 0xFF;
    return color.red | std::uint32_t{color.green} << 8 | std::uint32_t{color.blue} << 16 | opacity << 24;
}

bool look_the_same(const Cell& one, const Cell& other) { return in_canvas(one) == in_canvas(other); }

/// A pixel of the plane, if it is one of the area.
const Cell* pixel_at(int number, int x, int y) {
    const Screen* screen = screen_of(number);
    return screen != nullptr && screen->area().contains(x, y) ? &screen->pixel(x, y) : nullptr;
}

const Value* depth_at(int number, int x, int y) {
    const Screen* screen = screen_of(number);
    const bool has_one = screen != nullptr && screen->depths() && screen->area().contains(x, y);
    return has_one ? &screen->depths()->at(x, y) : nullptr;
}

void append_shortened(Text& out, const Replay::Shortened& shortened) {
    constexpr std::string_view names[] = {"cut", "partial", "wrong"};
    out += std::string_view(R"({"why":")");
    out += names[std::size_t(shortened.why)];
    out += std::string_view(R"(","line":)");
    append_integer(out, shortened.line);
    out += std::string_view(R"(,"reason":)");
    append_string(out, shortened.reason);
    out += '}';
}

}  // namespace
}  // namespace vidno

extern "C" {

[[clang::export_name("trace_open")]] int vidno_trace_open() {
    static int last = 0;
    vidno::replays().try_emplace(++last);
    return last;
}

[[clang::export_name("trace_close")]] void vidno_trace_close(int trace) { vidno::replays().erase(trace); }

[[clang::export_name("trace_append")]] bool vidno_trace_append(int trace) {
    return vidno::read_on(trace, [](vidno::Replay& replay, std::string& bytes) { replay.append(std::move(bytes)); });
}

[[clang::export_name("trace_finish")]] bool vidno_trace_finish(int trace) {
    return vidno::read_on(trace, [](vidno::Replay& replay, std::string&) { replay.finish(); });
}

[[clang::export_name("trace_header")]] void vidno_trace_header(int trace) {
    vidno::attempt([&](vidno::Exchange& page) {
        if (!vidno::replay(trace).has_begun()) return;
        std::visit([&](const auto& header) { page.made += vidno::header_json(header); }, vidno::replay(trace).header());
    });
}

[[clang::export_name("trace_shortened")]] void vidno_trace_shortened(int trace) {
    vidno::attempt([&](vidno::Exchange& page) {
        if (const auto& shortened = vidno::replay(trace).shortened()) vidno::append_shortened(page.made, *shortened);
    });
}

[[clang::export_name("trace_length")]] std::size_t vidno_trace_length(int trace) {
    return std::size_t(vidno::replay(trace).length());
}

[[clang::export_name("trace_names")]] const std::uint8_t* vidno_trace_names(int trace) {
    return vidno::replay(trace).names().data();
}

[[clang::export_name("trace_line")]] void vidno_trace_line(int trace, std::size_t step) {
    vidno::attempt([&](vidno::Exchange& page) { page.made += vidno::replay(trace).line(step); });
}

[[clang::export_name("trace_sentence")]] void vidno_trace_sentence(int trace, std::size_t step, int language) {
    vidno::attempt([&](vidno::Exchange& page) {
        const auto seen = vidno::replay(trace).look_at(step);
        std::visit(
            [&](const auto& after) {
                vidno::append_statement(page.made, vidno::say::sentence(seen.event, after, vidno::Language(language)));
            },
            seen.after);
    });
}

[[clang::export_name("trace_notes")]] void vidno_trace_notes(int trace, std::size_t step, int language) {
    vidno::attempt([&](vidno::Exchange& page) {
        vidno::append_json(page.made, vidno::say::notes_in_play(vidno::replay(trace), step, vidno::Language(language)));
    });
}

[[clang::export_name("trace_note")]] void vidno_trace_note(int trace, std::size_t step, int language) {
    vidno::attempt([&](vidno::Exchange& page) {
        vidno::Replay& replay = vidno::replay(trace);
        const vidno::EventView event = replay.event(step);
        page.made += std::visit(
            [&](const auto& run) { return vidno::say::note(event, run, vidno::Language(language)); }, replay.shown());
    });
}

[[clang::export_name("has_note")]] bool vidno_has_note(std::size_t event) { return vidno::say::has_note(event); }

[[clang::export_name("trace_decision")]] void vidno_trace_decision(int trace, std::size_t step, int language) {
    vidno::attempt([&](vidno::Exchange& page) {
        const auto said = vidno::say::decision(vidno::replay(trace), step, vidno::Language(language));
        if (said) vidno::append_json(page.made, *said);
    });
}

[[clang::export_name("trace_verdict")]] void vidno_trace_verdict(int trace, int comparison, std::size_t wrong,
                                                                 int language) {
    vidno::attempt([&](vidno::Exchange& page) {
        const vidno::Replay& replay = vidno::replay(trace);
        vidno::say::Tally tally{};
        for (const auto event : replay.names()) ++tally[event];
        page.made += vidno::say::verdict(replay.header(), tally, {vidno::say::Comparison::Is(comparison), wrong},
                                         vidno::Language(language));
    });
}

[[clang::export_name("history_open")]] int vidno_history_open(int trace, int x, int y) {
    static int last = 0;
    const auto& header = vidno::replay(trace).header();
    vidno::histories().emplace(++last, vidno::Followed{trace, {x, y}, vidno::watch_of(header, {x, y})});
    return last;
}

[[clang::export_name("history_close")]] void vidno_history_close(int history) { vidno::histories().erase(history); }

[[clang::export_name("history_read")]] void vidno_history_read(int history, std::size_t until) {
    vidno::attempt([&](vidno::Exchange& page) {
        auto& followed = vidno::histories().at(history);
        bool is_first = true;
        page.made += '[';
        while (followed.seen < until) vidno::read_step(followed, page.made, is_first);
        page.made += ']';
    });
}

[[clang::export_name("history_sentence")]] void vidno_history_sentence(int history, std::size_t step, int outcome,
                                                                       int language) {
    vidno::attempt([&](vidno::Exchange& page) {
        const auto seen = vidno::replay(vidno::histories().at(history).trace).look_at(step);
        std::visit(
            [&](const auto& after) {
                vidno::append_statement(page.made,
                                        vidno::say::sentence_for_pixel(seen.event, vidno::say::Outcome(outcome), after,
                                                                       vidno::Language(language)));
            },
            seen.after);
    });
}

[[clang::export_name("history_why")]] void vidno_history_why(int history, std::size_t step, bool is_later,
                                                             int language) {
    vidno::attempt([&](vidno::Exchange& page) {
        vidno::Followed& followed = vidno::histories().at(history);
        vidno::Replay& replay = vidno::replay(followed.trace);
        if (!std::holds_alternative<vidno::TraceHeader>(replay.header())) return;
        const auto wrong_at = vidno::goes_wrong_before(followed, step);
        const auto [event, after] = replay.look_at(step);
        vidno::append_statement(page.made, vidno::say::why(event, std::get<vidno::State>(after), followed.pixel,
                                                           wrong_at, vidno::Language(language), is_later));
    });
}

[[clang::export_name("history_holding")]] void vidno_history_holding(int history) {
    vidno::attempt([&](vidno::Exchange& page) {
        vidno::Followed& followed = vidno::histories().at(history);
        const auto* header = std::get_if<vidno::TraceHeader>(&vidno::replay(followed.trace).header());
        if (header != nullptr) vidno::append_holding(page.made, followed, *header);
    });
}

[[clang::export_name("history_reason")]] void vidno_history_reason(int history, int polygon, int language) {
    vidno::attempt([&](vidno::Exchange& page) {
        vidno::Followed& followed = vidno::histories().at(history);
        const auto& header = std::get<vidno::TraceHeader>(vidno::replay(followed.trace).header());
        const auto place = polygon < 0 ? std::nullopt : std::optional(polygon);
        vidno::append_reason(page.made, followed, header.scene, place, vidno::Language(language));
    });
}

[[clang::export_name("trace_values")]] void vidno_trace_values(int trace, std::size_t step) {
    vidno::attempt([&](vidno::Exchange& page) { vidno::replay(trace).append_values(page.made, step); });
}

[[clang::export_name("painted_at")]] std::uint32_t vidno_painted_at(int trace) {
    const vidno::Screen* screen = vidno::screen_of(trace);
    return screen != nullptr ? screen->painted_at() : 0;
}

[[clang::export_name("divided_at")]] std::uint32_t vidno_divided_at(int trace) {
    const vidno::Screen* screen = vidno::screen_of(trace);
    return screen != nullptr ? screen->divided_at() : 0;
}

[[clang::export_name("is_ground")]] bool vidno_is_ground(int trace) {
    const vidno::Screen* screen = vidno::screen_of(trace);
    return screen != nullptr && screen->is_ground();
}

[[clang::export_name("pixel")]] std::uint32_t vidno_pixel(int trace, int x, int y) {
    const vidno::Cell* pixel = vidno::pixel_at(trace, x, y);
    return pixel != nullptr ? vidno::in_canvas(*pixel) : 0;
}

[[clang::export_name("painter")]] std::uint32_t vidno_painter(int trace, int x, int y) {
    const vidno::Cell* pixel = vidno::pixel_at(trace, x, y);
    return pixel != nullptr ? pixel->painter : 0;
}

[[clang::export_name("pixel_rows")]] const std::uint32_t* vidno_pixel_rows(int trace, int first, int count) {
    static std::vector<std::uint32_t> rows;
    rows.clear();
    if (const vidno::Screen* screen = vidno::screen_of(trace)) {
        rows.reserve(std::size_t(screen->area().width) * std::size_t(count));
        for (int y = first; y < first + count; ++y) {
            screen->pixels().for_row(y, [](const vidno::Cell* pixels, int length) {
                std::transform(pixels, pixels + length, std::back_inserter(rows), vidno::in_canvas);
            });
        }
    }
    return rows.data();
}

[[clang::export_name("row_repeats")]] bool vidno_row_repeats(int trace, int y) {
    const vidno::Screen* screen = vidno::screen_of(trace);
    if (screen == nullptr || y <= screen->area().y) return false;
    bool repeats = true;
    int x = screen->area().x;
    screen->pixels().for_row(y, [&](const vidno::Cell* pixels, int length) {
        // The pixels above are one piece, too.
        repeats = repeats && std::equal(pixels, pixels + length, &screen->pixel(x, y - 1), vidno::look_the_same);
        x += length;
    });
    return repeats;
}

[[clang::export_name("has_depths")]] bool vidno_has_depths(int trace) {
    const vidno::Screen* screen = vidno::screen_of(trace);
    return screen != nullptr && screen->depths().has_value();
}

[[clang::export_name("depth")]] double vidno_depth(int trace, int x, int y) {
    const vidno::Value* depth = vidno::depth_at(trace, x, y);
    return depth != nullptr ? vidno::number_of(*depth) : std::numeric_limits<double>::quiet_NaN();
}

[[clang::export_name("depth_text")]] void vidno_depth_text(int trace, int x, int y) {
    vidno::attempt([&](vidno::Exchange& page) {
        const vidno::Value* depth = vidno::depth_at(trace, x, y);
        if (depth == nullptr) return;
        depth->fraction ? append_string(page.made, *depth->fraction) : append_number(page.made, depth->number);
    });
}

[[clang::export_name("windows")]] const double* vidno_windows(int trace, int x, int y, int width, int height,
                                                              double least) {
    static std::vector<double> numbers;
    numbers.assign(1, 0);
    if (const auto* state = std::get_if<vidno::State>(&vidno::replay(trace).shown())) {
        const vidno::Window root = state->warnock().root().value_or(vidno::Window{});
        const auto windows = state->screen().division().windows(root, {x, y, width, height}, least);
        numbers[0] = double(windows.size());
        for (const auto& window : windows) {
            numbers.insert(numbers.end(), {window.x, window.y, window.width, window.height});
        }
    }
    return numbers.data();
}
}
