#include "plane.h"

#include <cmath>

namespace vidno::figures {

namespace {

constexpr double ticks_height = 3.6;  // above
constexpr double below = 1.2;

/// The luminance of a colour by ITU-R BT.709.
double lightness(const Color& color) { return 0.2126 * color.red + 0.7152 * color.green + 0.0722 * color.blue; }

Color mixed(const Color& color, const Color& with, double share) {
    const auto part = [&](int a, int b) { return std::uint8_t(std::lround(a + (b - a) * share)); };
    return {part(color.red, with.red), part(color.green, with.green), part(color.blue, with.blue)};
}

Color grey_of(const Color& color) {
    const auto light = std::uint8_t(std::lround(lightness(color)));
    return {light, light, light};
}

}  // namespace

Color printed(const Color& color, bool greyscale) { return greyscale ? grey_of(color) : color; }

Color tinted(const Color& color, bool greyscale) { return mixed(printed(color, greyscale), paper, 0.55); }

Color deep(const Color& color, bool greyscale) {
    const Color dark = mixed(color, ink, 0.35);
    return greyscale ? mixed(grey_of(color), Color{}, 0.6) : dark;
}

std::string integer_text(int value) { return (value < 0 ? "−" : "") + std::to_string(std::abs(value)); }

Plane plane_without_frame(const Area& area) {
    constexpr double width = 80;  // millimetres
    const double scale = width / area.width;
    return {area, scale, {-scale * area.x, -scale * area.y}, {0, 0, width, scale * area.height}};
}

Plane plane_in(const Area& area, double width, double most_height) {
    constexpr double margin = 0.04;  // of the longer side
    const double ticks_width = 1.2 + std::max({3.8, width_of(integer_text(area.y), tick_size),
                                               width_of(integer_text(area.bottom()), tick_size)});
    const double around = margin * std::max(area.width, area.height);
    const double scale = std::min((width - ticks_width) / (area.width + 2 * around),
                                  (most_height - ticks_height - below) / (area.height + 2 * around));
    const Box shown{ticks_width + (width - ticks_width - scale * (area.width + 2 * around)) / 2, ticks_height,
                    scale * (area.width + 2 * around), scale * (area.height + 2 * around)};
    const Point origin{shown.x + scale * (around - area.x), shown.y + scale * (around - area.y)};
    return {area, scale, origin, shown};
}

double height_of(const Plane& plane) { return plane.shown.bottom() + below; }

void add_rimmed(Drawing& to, const Path& path) {
    Path rim = path;
    rim.fill.reset();
    rim.stroke = Stroke{paper, path.stroke->width + 1, {}};
    to.add(std::move(rim));
    to.add(path);
}

}  // namespace vidno::figures
