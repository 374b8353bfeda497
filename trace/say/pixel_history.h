/// The history of a pixel: the steps that concern it, what each means for it, and why it has its colour. In a run of
/// curves, that of a column.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "choice/language.h"
#include "replay/floating_horizon_state.h"
#include "replay/state.h"
#include "vidno/kernel.h"

namespace vidno::say {

/// What a step means for the pixel: a test was passed or failed, a colour written, a decision wrong, or none of these.
enum class Outcome : unsigned char { pass, fail, paint, wrong, note };
inline constexpr std::array<std::string_view, 5> outcome_names{"pass", "fail", "paint", "wrong", "note"};

/// Follows a pixel through a run.
class PixelWatch {
public:
    explicit PixelWatch(Pixel pixel) : pixel_(pixel) {}

    /// Takes the next event, after which the run has this state. None if it does not concern the pixel.
    std::optional<Outcome> see(const EventView& event, const State& after);
    std::optional<Outcome> see(const EventView& event, const FloatingHorizonState& after);

    /// What it remembers between events.
    struct Memory {
        std::optional<int> row{};   // Warnock: that of FillPolygon, if the last event was one
        bool is_at_centre = false;  // Warnock: whether the point of SurroundTest is that of PointColor
        bool is_on_row = false;     // Z-buffer: whether ShowLine is on the pixel's row
        std::uint64_t said_at = 0;  // the last step that concerned the pixel
    };

private:
    std::optional<Outcome> remembered(std::optional<Outcome> outcome, std::uint64_t step);

    Pixel pixel_;
    Memory memory_;
};

/// What was current at the step: a window, a polygon, or a curve.
using Heading = std::variant<std::monostate, Window, PolygonPlace, int>;
Heading heading(const EventView& event, const State& after);
Heading heading(const EventView& event, const FloatingHorizonState& after);

/// The sentence of a step in the history: its own, or, for a polygon that missed the pixel, only that.
std::string sentence_for_pixel(const EventView& event, Outcome outcome, const State& after, Language language);
std::string sentence_for_pixel(const EventView& event, Outcome outcome, const FloatingHorizonState& after,
                               Language language);

/// Why the step that painted the pixel last gave it its colour. `is_later`: it will have it only then.
std::string why(const EventView& event, const State& after, Language language, bool is_later = false);

}  // namespace vidno::say
