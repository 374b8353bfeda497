#include "replay/screen.h"

#include <cmath>

#include "choice/method.h"

namespace vidno {

namespace {

constexpr std::int64_t most_depths = std::int64_t{1} << 24;

bool fits(const auto& rectangle, const Area& area) {
    const auto& [x, y, width, height] = rectangle;
    return width >= 0 && height >= 0 && x >= area.x && y >= area.y && x <= area.right() && y <= area.bottom() &&
           width <= area.right() - x && height <= area.bottom() - y;
}

}  // namespace

Screen::Screen(const TraceHeader& header)
    : pixels_(header.scene.area, {header.scene.background}),
      division_(header.scene.area, choice_of(header.method).cuts_anywhere),
      has_depths_(header.detail >= Detail::polygons &&
                  std::int64_t{area().width} * std::int64_t{area().height} <= most_depths),
      cuts_anywhere_(choice_of(header.method).cuts_anywhere) {}

Picture Screen::picture() const {
    Picture picture(area(), {});
    for (int y = area().y; y < area().bottom(); ++y) {
        Color* next = &picture.row(y)[area().x];
        pixels_.for_row(y, [&](const Pixel* first, int count) {
            next = std::transform(first, first + count, next, [](const Pixel& pixel) { return pixel.color; });
        });
    }
    return picture;
}

void Screen::paint(const PixelRectangle& pixels, const Color& color) {
    if (!fits(pixels, area())) throw Impossible{"a rectangle outside the area"};
    pixels_.fill(pixels, {color, step_});
    painted_at_ = step_;
}

void Screen::paint(const PixelRun& run, const Color& color) {
    const auto& [row, first, end] = run;
    const bool is_inside =
        area().y <= row && row < area().bottom() && area().x <= first && first <= end && end <= area().right();
    if (!is_inside) throw Impossible{"a run of pixels outside the area"};
    pixels_.fill(run, {color, step_});
    painted_at_ = step_;
}

/// A window that is cut anywhere still consists of whole pixels.
void Screen::divide(const Window& window, const Window& root) {
    if (cuts_anywhere_) {
        const auto is_whole = [](double x) { return x == std::floor(x); };
        const bool whole =
            is_whole(window.x) && is_whole(window.y) && is_whole(window.width) && is_whole(window.height);
        if (!whole || !fits(window, area())) throw Impossible{"a window outside the area"};
    }
    division_.divide(window, root);
    divided_at_ = step_;
}

void Screen::clear(const Color& color, const Value& z) {
    pixels_ = Tiles<Pixel>(area(), {color});
    if (has_depths_) depths_.emplace(area(), z);
    is_ground_ = true;
    painted_at_ = step_;
}

void Screen::store_depth(int x, int y, const Value& z) {
    if (depths_) depths_->set(x, y, z);
}

std::size_t Screen::bytes_of_copy() const {
    return pixels_.bytes_of_copy() + division_.bytes_of_copy() + (depths_ ? depths_->bytes_of_copy() : 0);
}

}  // namespace vidno
