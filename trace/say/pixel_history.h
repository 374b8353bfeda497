/// The history of a pixel: the steps that concern it, what each means for it, and why it has its colour. In a run of
/// curves, that of a column.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "choice/language.h"
#include "replay/floating_horizon_state.h"
#include "replay/state.h"
#include "say/exactly.h"
#include "vidno/kernel.h"

namespace vidno::say {

/// What a step means for the pixel: a test was passed or failed, a colour written, a decision wrong, or none of these.
enum class Outcome : unsigned char { pass, fail, paint, wrong, note };
inline constexpr std::array<std::string_view, 5> outcome_names{"pass", "fail", "paint", "wrong", "note"};

/// What was current at the step: a window, a polygon, or a curve.
using Heading = std::variant<std::monostate, Window, PolygonPlace, int>;

/// Follows a pixel through a run. It keeps what it needs of the run by itself, and need not even see most events.
class PixelWatch {
public:
    /// The header must outlive it.
    PixelWatch(Pixel pixel, const TraceHeader& header);
    PixelWatch(Pixel pixel, const FloatingHorizonHeader& header) : pixel_(pixel), header_(&header) {}

    /// Whether it must see the next event, as far as its name tells, given as the place of its type in AllEvents.
    bool needs(std::size_t name) const;
    /// Whether the text of such an event in the trace tells that it need not be read.
    bool is_elsewhere(std::size_t name, std::string_view line) const;
    /// Takes the event of this step. None if it does not concern the pixel.
    std::optional<Outcome> see(const EventView& event, std::uint64_t step);
    /// After the event that was seen last.
    Heading heading(const EventView& event) const;

    /// What it remembers between events.
    struct Memory {
        std::uint64_t step = 0;                 // of the event that was seen last
        std::uint64_t said_at = 0;              // the last step that concerned the pixel
        std::optional<Window> window{};         // Warnock: the current one
        std::optional<int> row{};               // Warnock: that of FillPolygon, if the last event was one
        bool is_at_centre = false;              // Warnock: whether the point of SurroundTest is that of PointColor
        std::optional<PolygonPlace> polygon{};  // Z-buffer: the current one
        bool is_on_row = false;                 // Z-buffer: whether ShowLine is on the pixel's row
        std::optional<int> curve{};             // floating horizon: the current one
    };

private:
    std::optional<Outcome> judged(const EventView& event) const;
    const TraceHeader& header() const { return **std::get_if<const TraceHeader*>(&header_); }

    Pixel pixel_;
    std::variant<const TraceHeader*, const FloatingHorizonHeader*> header_;
    Memory memory_;
    std::optional<State> regions_;  // Weiler and Atherton's algorithm needs the current list
};

/// The sentence of a step in the history: its own, or, for a polygon that missed the pixel, only that.
Statement sentence_for_pixel(const EventView& event, Outcome outcome, const State& after, Language language);
Statement sentence_for_pixel(const EventView& event, Outcome outcome, const FloatingHorizonState& after,
                             Language language);

/// Finds where a run goes wrong about a pixel.
class GoesWrong {
public:
    GoesWrong(Pixel pixel, const TraceHeader& header);
    GoesWrong(Pixel, const FloatingHorizonHeader&) {}

    /// Whether it must see the event.
    bool needs(const EventView& event) const;
    void see(const EventView& event, const State& after);
    void see(const EventView&, const FloatingHorizonState&) {}
    /// The next step of the pixel's history, and what it says.
    void hear(std::uint64_t step, const Statement& said);

    /// The step at which the polygon that should show left the current list; otherwise the step since which the history
    /// is wrong, if it is.
    std::optional<std::uint64_t> step(const State& after) const;

private:
    std::optional<int> owner_{};                  // the polygon that should show
    std::map<int, std::uint64_t> left_list_{};    // when it left each list
    std::optional<std::uint64_t> wrong_since_{};  // without a right step in between
    bool is_wrong_ = false;
};

/// Why the step that painted the pixel last gave it its colour; and what should show there instead. `wrong_at`: where
/// the run goes wrong about it, if that is known. `is_later`: it will have the colour only then.
Statement why(const EventView& event, const State& after, Pixel pixel, std::optional<std::uint64_t> wrong_at,
              Language language, bool is_later = false);

/// Says the history of a pixel while a run goes on.
class PixelStory {
public:
    struct Entry {
        Outcome outcome;
        Statement said;
    };

    /// The header must outlive it.
    PixelStory(Pixel pixel, const auto& header, Language language)
        : pixel_(pixel), language_(language), watch_(pixel, header), goes_wrong_(pixel, header) {}

    /// Takes the next event, after which the run has this state. None if it does not concern the pixel.
    template <class AfterEvent>
    std::optional<Entry> take(const EventView& event, const AfterEvent& after) {
        goes_wrong_.see(event, after);
        const auto outcome = watch_.see(event, after.step());
        if (!outcome) return std::nullopt;
        Statement said = sentence_for_pixel(event, *outcome, after, language_);
        if (*outcome != Outcome::paint) {
            goes_wrong_.hear(after.step(), said);
        } else if constexpr (std::same_as<AfterEvent, State>) {
            why_ = say::why(event, after, pixel_, goes_wrong_.step(after), language_).whole();
        }
        return Entry{*outcome, std::move(said)};
    }

    /// Why it has the colour that was painted last. Empty if none was; the columns of curves have none.
    const std::string& why() const { return why_; }

private:
    Pixel pixel_;
    Language language_;
    PixelWatch watch_;
    GoesWrong goes_wrong_;
    std::string why_;
};

}  // namespace vidno::say
