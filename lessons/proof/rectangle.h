// A rectangle of pixels. For verify.cpp.
#pragma once
#include <array>
#include <vector>
struct Rectangle {
    long x, y, width, height;

    bool contains(const Rectangle& r) const {  // in this order nothing overflows
        const bool fits = 0 < r.width && r.width <= width && 0 < r.height && r.height <= height;
        return fits && x <= r.x && r.x <= x + width - r.width && y <= r.y && r.y <= y + height - r.height;
    }
    std::vector<std::array<double, 3>> corners() const {  // (x, y, 1) for the centres of the pixels in the corners
        const double left = x + 0.5, right = x + width - 0.5, top = y + 0.5, bottom = y + height - 0.5;
        return {{left, top, 1}, {right, top, 1}, {left, bottom, 1}, {right, bottom, 1}};
    }
    std::vector<std::array<long, 2>> pixels() const {  // row by row
        std::vector<std::array<long, 2>> all;
        for (long k = 0; k < width * height; ++k) all.push_back({x + k % width, y + k / width});
        return all;
    }
};
