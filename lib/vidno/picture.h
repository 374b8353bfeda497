/// Picture: the colours of an area's pixels, and the two ways in which the procedures paint.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <vector>

#include "scene.h"
#include "window.h"

namespace vidno {

/// Whole pixels inside the area; may be empty.
struct PixelRectangle {
    int x = 0, y = 0, width = 0, height = 0;
    bool operator==(const PixelRectangle&) const = default;
};

/// The pixels first <= x < end of a row.
struct PixelRun {
    int row = 0, first = 0, end = 0;
    bool operator==(const PixelRun&) const = default;
};

/// The pixels of the area whose centres lie in the half-open window.
inline PixelRectangle pixels_of(const Area& area, const Window& window) {
    const auto centre_at_or_after = [](double v, int low, int end) {
        const double nearest = std::clamp(v - 0.5, double(low), double(end));
        const int toward_zero = int(nearest);
        return toward_zero + int(toward_zero < nearest);  // rounded up, without a call of std::ceil
    };
    const int left = centre_at_or_after(window.x, area.x, area.right());
    const int right = centre_at_or_after(window.right(), area.x, area.right());
    const int top = centre_at_or_after(window.y, area.y, area.bottom());
    const int bottom = centre_at_or_after(window.bottom(), area.y, area.bottom());
    return {left, top, right - left, bottom - top};
}

class Picture {
public:
    Picture(const Area& area, Color background)
        : area_(area), pixels_(std::size_t(area.width) * std::size_t(area.height)) {
        if (pixels_.empty()) return;
        // A row is copied faster than it is filled, because a colour has three bytes.
        const auto first_row_end = std::fill_n(pixels_.begin(), area.width, background);
        for (auto row = first_row_end; row != pixels_.end(); row += area.width) {
            std::copy(pixels_.begin(), first_row_end, row);
        }
    }

    const Area& area() const { return area_; }
    const std::vector<Color>& pixels() const { return pixels_; }  // row by row from the top

    Color at(int x, int y) const { return pixels_[index(x, y)]; }

    PixelRow<Color> row(int y) { return row_of(pixels_, area_, y); }

    void paint(int x, int y, Color color) { pixels_[index(x, y)] = color; }

    void paint(const PixelRun& run, Color color) {
        if (run.first >= run.end) return;
        const auto from = pixels_.begin() + std::ptrdiff_t(index(run.first, run.row));
        std::fill_n(from, run.end - run.first, color);
    }

    void paint(const PixelRectangle& pixels, Color color) {
        for (int row = pixels.y; row < pixels.y + pixels.height; ++row) {
            paint(PixelRun{row, pixels.x, pixels.x + pixels.width}, color);
        }
    }

    PixelRectangle pixels_of(const Window& window) const { return vidno::pixels_of(area_, window); }

    bool operator==(const Picture&) const = default;

private:
    std::size_t index(int x, int y) const {
        assert(area_.contains(x, y));
        return std::size_t(y - area_.y) * std::size_t(area_.width) + std::size_t(x - area_.x);
    }

    Area area_;
    std::vector<Color> pixels_;
};

/// How many pixels differ in two pictures of the same area.
inline std::size_t different_pixels(const Picture& a, const Picture& b) {
    assert(a.area() == b.area());
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) count += a.pixels()[i] != b.pixels()[i] ? 1 : 0;
    return count;
}

}  // namespace vidno
