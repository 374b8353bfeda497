#include "replay/division.h"

#include <cmath>
#include <set>
#include <tuple>

namespace vidno {

namespace {

enum WindowSide : std::uint8_t { left = 1, right = 2, upper = 4, lower = 8 };

/// A side of 1 or less is not halved.
double halved_side(double side, int level) {
    for (; level > 0 && side > 1; --level) side /= 2;
    return side;
}

/// The window of a level that contains a point.
Window window_at(const Window& root, int level, double x, double y) {
    const double width = halved_side(root.width, level), height = halved_side(root.height, level);
    return {root.x + std::floor((x - root.x) / width) * width, root.y + std::floor((y - root.y) / height) * height,
            width, height};
}

/// The first whole place whose centre is at `at` or after it.
int centre_after(double at) {
    constexpr double far = farthest_offset;  // a trace may name any window
    return int(std::ceil(std::clamp(at, -far, far) - 0.5));
}

}  // namespace

void Division::divide(const Window& window, const Window& root) { cuts_anywhere_ ? cut(window) : halve(window, root); }

void Division::halve(const Window& window, const Window& root) {
    const double halvings = std::log2(std::max(root.width / window.width, root.height / window.height));
    const double level = halvings > 0 ? std::min(std::round(halvings), 255.0) : 0;
    marks_.fill(pixels_of(marks_.area(), window), std::uint8_t(level));
}

void Division::cut(const Window& window) {
    const int first = int(window.x), end = int(window.right());
    for (int y = int(window.y); y < int(window.bottom()); ++y) {
        const int sides = (y == int(window.y) ? upper : 0) | (y + 1 == int(window.bottom()) ? lower : 0);
        marks_.fill(PixelRun{y, first, end}, std::uint8_t(sides));
        if (first == end) continue;
        marks_.set(first, y, std::uint8_t(sides | left | (end == first + 1 ? right : 0)));
        if (end > first + 1) marks_.set(end - 1, y, std::uint8_t(sides | right));
    }
}

std::vector<Window> Division::windows(const Window& root, const Area& shown, double least) const {
    if (cuts_anywhere_) return cut_out(least);
    return root.width > 0 && root.height > 0 ? halved(root, shown, least) : std::vector<Window>{};
}

/// The windows that contain a pixel in no smaller window.
std::vector<Window> Division::halved(const Window& root, const Area& shown, double least) const {
    int finest = 0;
    while (finest < 255 && halved_side(std::min(root.width, root.height), finest + 1) >= least) ++finest;
    std::vector<Window> found;
    std::set<std::tuple<int, double, double>> known;
    const Area& area = marks_.area();
    const int bottom = std::min(area.bottom(), shown.bottom()), end = std::min(area.right(), shown.right());
    for (int y = std::max(area.y, shown.y); y < bottom;) {
        for (int x = std::max(area.x, shown.x); x < end;) {
            const int level = std::min<int>(marks_.at(x, y), finest);
            const Window window = window_at(root, level, x + 0.5, y + 0.5);
            if (known.emplace(level, window.x, window.y).second) found.push_back(window);
            x = std::max(x + 1, centre_after(window.right()));
        }
        // All rows of the smallest distinguishable windows meet the same windows.
        y = std::max(y + 1, centre_after(window_at(root, finest, area.x, y + 0.5).bottom()));
    }
    return found;
}

/// Without the windows that are too small to distinguish, and without one that is being cut: its first part begins at
/// the same place.
std::vector<Window> Division::cut_out(double least) const {
    std::vector<Window> found;
    const Area& area = marks_.area();
    const auto is_at = [&](int x, int y, int sides) { return (marks_.at(x, y) & sides) == sides; };
    for (int y = area.y; y < area.bottom(); ++y) {
        for (int x = area.x; x < area.right(); ++x) {
            if (!is_at(x, y, left | upper)) continue;
            int last = x, lowest = y;
            while (last + 1 < area.right() && !is_at(last, y, right)) ++last;
            while (lowest + 1 < area.bottom() && !is_at(x, lowest, lower)) ++lowest;
            const Window window{double(x), double(y), double(last - x + 1), double(lowest - y + 1)};
            if (std::min(window.width, window.height) >= least) found.push_back(window);
        }
    }
    return found;
}

}  // namespace vidno
