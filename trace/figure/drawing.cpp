#include "drawing.h"

#include <array>
#include <charconv>
#include <cmath>
#include <numbers>

#include "characters.h"

namespace vidno::figures {

namespace {

void move(Path& path, Point by) {
    for (auto& line : path.lines) {
        for (auto& point : line) point = point + by;
    }
}
void move(Label& label, Point by) { label.at = label.at + by; }

/// The part of a segment in a box, by Liang and Barsky, as two parameters from 0 at one end to 1 at the other.
std::optional<std::pair<double, double>> part_within(Point from, Point to, const Box& box) {
    double first = 0, last = 1;
    const auto cut = [&](double direction, double room) {
        if (direction == 0) return room >= 0;
        (direction < 0 ? first : last) =
            direction < 0 ? std::max(first, room / direction) : std::min(last, room / direction);
        return true;
    };
    const double dx = to.x - from.x;
    const double dy = to.y - from.y;
    const bool meets = cut(-dx, from.x - box.x) && cut(dx, box.right() - from.x) && cut(-dy, from.y - box.y) &&
                       cut(dy, box.bottom() - from.y);
    if (!meets || first > last) return std::nullopt;
    return std::pair(first, last);
}

// Advance widths of Helvetica in thousandths of the size: U+0020 to U+007E, and of its Cyrillic from U+0410 to U+044F.
constexpr std::array<short, 95> latin{278,  278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333, 278, 278,
                                      556,  556, 556, 556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556,
                                      1015, 667, 667, 722, 722, 667, 611, 778, 722, 278, 500, 667, 556, 833, 722, 778,
                                      667,  778, 722, 667, 611, 722, 667, 944, 667, 667, 611, 278, 278, 278, 469, 556,
                                      333,  556, 556, 500, 556, 556, 278, 556, 556, 222, 222, 500, 222, 833, 556, 556,
                                      556,  556, 333, 500, 278, 556, 500, 722, 500, 500, 500, 334, 260, 334, 584};
constexpr std::array<short, 64> cyrillic{
    667, 656, 667, 542, 677, 667, 923, 604, 719,  719, 583, 656, 833, 722, 778, 719, 667, 722, 611, 635, 760, 667,
    740, 667, 917, 938, 792, 885, 656, 719, 1010, 722, 556, 573, 531, 365, 583, 556, 669, 458, 559, 559, 438, 583,
    688, 552, 556, 542, 556, 500, 458, 500, 823,  500, 573, 521, 802, 823, 625, 719, 521, 510, 750, 542};
constexpr int wide = 1000, usual = 620, narrow = 400;

int thousandths_of(char32_t c) {
    if (U' ' <= c && c <= U'~') return latin[c - U' '];
    if (U'А' <= c && c <= U'я') return cyrillic[c - U'А'];
    if (c == U'—' || c == U'…' || c == U'→') return wide;
    const bool raised = (U'₀' <= c && c <= U'ₜ') || c == U'ᵢ' || c == U'·' || c == U'′' || c == U'″';
    return raised ? narrow : usual;
}

}  // namespace

void Drawing::place(const Drawing& part, Point at) {
    for (auto thing : part.things) {
        std::visit([&](auto& each) { move(each, at); }, thing);
        things.push_back(std::move(thing));
    }
}

Polyline circle(Point center, double radius) {
    constexpr int sides = 24;
    Polyline points;
    for (int i = 0; i < sides; ++i) {
        const double turn = 2 * std::numbers::pi * i / sides;
        points.push_back(center + Point{radius * std::cos(turn), radius * std::sin(turn)});
    }
    return points;
}

std::vector<Polyline> clipped(const Polyline& line, bool closed, const Box& to) {
    std::vector<Polyline> pieces;
    const std::size_t segments = line.empty() ? 0 : line.size() - (closed ? 0 : 1);
    for (std::size_t i = 0; i < segments; ++i) {
        const Point a = line[i];
        const Point b = line[(i + 1) % line.size()];
        const auto part = part_within(a, b, to);
        if (!part) continue;
        const auto at = [&](double t) {
            if (t == 0 || t == 1) return t == 0 ? a : b;
            // Between ends that are far away, rounding may put the point outside the box.
            return Point{std::clamp(std::lerp(a.x, b.x, t), to.x, to.right()),
                         std::clamp(std::lerp(a.y, b.y, t), to.y, to.bottom())};
        };
        if (pieces.empty() || !(pieces.back().back() == at(part->first))) pieces.push_back({at(part->first)});
        pieces.back().push_back(at(part->second));
    }
    return pieces;
}

std::string decimal(double value) {
    std::array<char, 64> text;
    const double thousandths = std::round(value * 1000);
    if (thousandths == 0) return "0";
    const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), thousandths / 1000);
    return {text.data(), end};
}

double width_of(std::string_view text, double size, bool bold) {
    double thousandths = 0;
    for (const char32_t c : characters_of(text)) thousandths += thousandths_of(c);
    return thousandths / 1000 * (bold ? 1.08 : 1) * size / points_per_millimetre;
}

}  // namespace vidno::figures
