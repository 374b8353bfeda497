/// Figure: moments of a run as drawings, side by side.
#pragma once

#include <array>
#include <optional>

#include "floating_horizon_moment.h"
#include "parts.h"
#include "pixel_history.h"

namespace vidno::figures {

enum class Part : unsigned char { picture, windows, list, listing, history };
inline constexpr std::array<std::string_view, 5> part_names{"picture", "windows", "list", "listing", "history"};

struct Options {
    std::vector<Part> show{Part::picture, Part::windows};
    Style style{};
    double width = 80;                    // millimetres, of all that stand side by side
    std::optional<double> most_height{};  // of the plane
    std::size_t moments = 1;              // the number that will be added
    bool is_film = false;                 // the moments are shown one after the other, each in the whole width

    bool shows(Part part) const { return std::find(show.begin(), show.end(), part) != show.end(); }
    /// Whether the figure has the plane, and whether it has text.
    bool shows_plane() const { return shows(Part::picture) || shows(Part::windows); }
    bool shows_text() const { return shows(Part::list) || shows(Part::listing) || shows(Part::history); }
};

/// The caption of a moment: the sentence of its step.
std::string caption_of(const Moment& moment, Language language);
std::string caption_of(const FloatingHorizonMoment& moment, Language language);

/// The letter of a panel: "(a)" for 0, "(z)" for 25, "(aa)" for 26.
std::string letter_of(std::size_t place);

class Figure {
public:
    explicit Figure(const Options& options);

    /// Throws Refused if the trace does not contain a part. The history is needed if it is shown.
    void add(const Moment& moment, const std::optional<PixelHistory>& history);
    /// A run of curves has the parts picture, windows (here the horizons and the current curve) and listing.
    void add(const FloatingHorizonMoment& moment);

    /// One drawing per moment. Each part has the same place in all of them, so that nothing jumps.
    std::vector<Drawing> panels() const;

    /// All moments in one drawing, in rows.
    Drawing strip() const;

private:
    static constexpr double tallest_plane = 1.25;  // of its width

    /// One part for all moments, with a size that fits each.
    struct Parts {
        std::vector<Drawing> drawings;
        double height = 0;
    };

    bool is_beside() const;
    double most_plane_height() const { return options_.most_height.value_or(tallest_plane * plane_width_); }
    Drawing plane(const Moment& moment, const std::optional<PixelHistory>& history) const;
    Drawing plane(const FloatingHorizonMoment& moment) const;
    void add(std::string caption, std::optional<Drawing> plane, std::vector<Drawing> texts);
    Drawing panel(std::size_t moment) const;

    Options options_;
    std::size_t columns_;
    double panel_width_, plane_width_, text_width_;
    Parts planes_;
    std::vector<Parts> texts_;
    std::vector<std::vector<std::string>> captions_;  // in lines
    std::size_t caption_lines_ = 0;                   // of the longest
};

}  // namespace vidno::figures
