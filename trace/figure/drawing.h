/// Drawing: the contents of a figure, the same for all writers. It has no transparency and no bitmaps.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "vidno/scene.h"

namespace vidno::figures {

/// In millimetres, y downward.
struct Point {
    double x = 0, y = 0;

    Point operator+(Point other) const { return {x + other.x, y + other.y}; }
    bool operator==(const Point&) const = default;
};

struct Box {
    double x = 0, y = 0, width = 0, height = 0;

    double right() const { return x + width; }
    double bottom() const { return y + height; }
    bool overlaps(const Box& other) const {
        return x < other.right() && other.x < right() && y < other.bottom() && other.y < bottom();
    }
    bool holds(const Box& other) const {
        return x <= other.x && other.right() <= right() && y <= other.y && other.bottom() <= bottom();
    }
    std::vector<Point> corners() const { return {{x, y}, {right(), y}, {right(), bottom()}, {x, bottom()}}; }
    bool operator==(const Box&) const = default;
};

/// Widths and dashes in points, 72 an inch.
struct Stroke {
    Color color{};
    double width = hairline;
    std::vector<double> dashes{};

    static constexpr double hairline = 0.25;  // no printer loses it
    bool operator==(const Stroke&) const = default;
};

using Polyline = std::vector<Point>;

/// Lines, or polygons if they are closed, with the same style; a point in several polygons is filled once.
struct Path {
    std::vector<Polyline> lines;
    bool closed = false;
    std::optional<Color> fill{};
    std::optional<Stroke> stroke{};
};

enum class Anchor { start, middle, end };

/// A line of text.
struct Label {
    std::string text;
    Point at;         // on the base line, where the anchor says
    double size = 8;  // points
    Anchor anchor = Anchor::start;
    bool bold = false;
    Color color{};
};

struct Drawing {
    double width = 0, height = 0;
    std::vector<std::variant<Path, Label>> things{};  // later ones above

    void add(Label label) { things.emplace_back(std::move(label)); }
    void add(Path path) {
        if (!path.lines.empty()) things.emplace_back(std::move(path));
    }

    /// Adds the contents of a drawing to this one, whose size does not change.
    void place(const Drawing& part, Point at);
};

inline constexpr double points_per_millimetre = 72 / 25.4;

inline Path rectangle(const Box& box, std::optional<Color> fill, std::optional<Stroke> stroke = {}) {
    return {{box.corners()}, true, fill, std::move(stroke)};
}

/// The corners of a polygon that looks like a circle.
Polyline circle(Point center, double radius);

/// The parts of a line, or of the outline of a polygon, that lie in a box.
std::vector<Polyline> clipped(const Polyline& line, bool closed, const Box& to);

/// The width of a line of text, in millimetres, in a font with the metrics of Helvetica, such as Arial and Liberation
/// Sans.
double width_of(std::string_view text, double size, bool bold = false);

/// A coordinate as text, rounded to a thousandth.
std::string decimal(double value);

}  // namespace vidno::figures
