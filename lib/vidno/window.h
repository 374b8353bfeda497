/// Window: a rectangle of the plane that Warnock's algorithm looks at.
///
/// A window is a whole-pixel rectangle that was halved repeatedly, so a double holds each of its coordinates exactly
/// (30 bits of offset, 14 halvings), in every edition and under every kernel.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstddef>
#include <string_view>

#include "scene.h"

namespace vidno {

/// The text's names. y grows downward: left bottom is the upper left corner on the screen.
enum class Corner { left_bottom, left_top, right_bottom, right_top };
inline constexpr std::array<std::string_view, 4> corner_names{"lb", "lt", "rb", "rt"};

struct Window {
    double x = 0, y = 0, width = 0, height = 0;

    double right() const { return x + width; }
    double bottom() const { return y + height; }
    bool operator==(const Window&) const = default;
};

inline bool off_area(const Window& window, const Area& area) {
    return window.x >= area.right() || window.right() <= area.x || window.y >= area.bottom() ||
           window.bottom() <= area.y;
}

/// The smallest power-of-two square at the area's corner that covers it. Its windows end at whole pixels.
inline Window covering_square(const Area& area) {
    const auto side = double(std::bit_ceil(unsigned(std::max(area.width, area.height))));
    return {double(area.x), double(area.y), side, side};
}

/// The parts of a window: at most four, so that they need no allocated memory.
class WindowParts {
public:
    void push_back(const Window& part) {
        assert(count_ < parts_.size());
        parts_[count_++] = part;
    }

    const Window* begin() const { return parts_.data(); }
    const Window* end() const { return parts_.data() + count_; }

private:
    std::size_t count_ = 0;
    std::array<Window, 4> parts_;
};

/// The window with each side longer than 1 halved: four parts, two, or one.
inline WindowParts parts_of(const Window& window) {
    const int columns = window.width > 1 ? 2 : 1;
    const int rows = window.height > 1 ? 2 : 1;
    const double width = window.width / columns;
    const double height = window.height / rows;
    WindowParts parts;
    for (int i = 0; i < columns; ++i) {
        for (int j = 0; j < rows; ++j) parts.push_back({window.x + i * width, window.y + j * height, width, height});
    }
    return parts;
}

inline Window whole_area(const Area& area) {
    return {double(area.x), double(area.y), double(area.width), double(area.height)};
}

}  // namespace vidno
