/// Figure: moments of a run as drawings, one beside the other.
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
    std::size_t moments = 1;              // so many will be added

    bool shows(Part part) const { return std::find(show.begin(), show.end(), part) != show.end(); }
    /// Whether it has the plane, whether text.
    bool shows_plane() const { return shows(Part::picture) || shows(Part::windows); }
    bool shows_text() const { return shows(Part::list) || shows(Part::listing) || shows(Part::history); }
};

class Figure {
public:
    explicit Figure(const Options& options);

    /// Throws Refused if the trace does not tell a part. The history is needed if it is shown.
    void add(const Moment& moment, const std::optional<PixelHistory>& history);
    /// Of the parts, a run of curves has picture, windows (here the horizons and the curve at hand) and listing.
    void add(const FloatingHorizonMoment& moment);

    /// A drawing a moment. What is the same part of each has the same place, so that nothing jumps.
    std::vector<Drawing> panels() const;

    /// All in one, in rows.
    Drawing strip() const;

private:
    static constexpr double tallest_plane = 1.25;  // of its width

    /// A part, of all moments, with the size that has room for each.
    struct Parts {
        std::vector<Drawing> drawings;
        double height = 0;
    };

    bool is_beside() const;
    double most_plane_height() const { return options_.most_height.value_or(tallest_plane * plane_width_); }
    Drawing plane(const Moment& moment, const std::optional<PixelHistory>& history) const;
    Drawing plane(const FloatingHorizonMoment& moment) const;
    void add(std::uint64_t step, std::optional<Drawing> plane, std::vector<Drawing> texts);
    Drawing panel(std::size_t moment) const;

    Options options_;
    std::size_t columns_;
    double panel_width_, plane_width_, text_width_;
    Parts planes_;
    std::vector<Parts> texts_;
    std::vector<std::string> captions_;
};

}  // namespace vidno::figures
