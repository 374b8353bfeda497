#include "check/whereabouts.h"

#include <algorithm>
#include <cmath>
#include <concepts>

namespace vidno {

namespace {

void add(std::vector<PolygonPlace>& polygons, const std::optional<PolygonPlace>& polygon) {
    if (polygon && std::find(polygons.begin(), polygons.end(), *polygon) == polygons.end())
        polygons.push_back(*polygon);
}

// The events that have a polygon.
template <class E>
concept OfPolygon = requires(const E& e) {
    { e.polygon } -> std::convertible_to<PolygonPlace>;
};
template <class E>
concept OfClipPolygon = requires(const E& e) {
    { e.clip } -> std::convertible_to<PolygonPlace>;
};
template <class E>
concept OfOther = requires(const E& e) {
    { e.other } -> std::convertible_to<PolygonPlace>;
};

int pixel_at(const Value& coordinate) { return int(std::floor(number_of(coordinate))); }

}  // namespace

Whereabouts::Whereabouts(const Area& area) : area_(area) {}

Whereabouts::Nearest& Whereabouts::shown(int x, int y) {
    return shown_[std::size_t(y - area_.y) * std::size_t(area_.width) + std::size_t(x - area_.x)];
}

PixelRectangle Whereabouts::clipped(const Window& window) const {
    const int left = std::max(area_.x, int(std::floor(window.x)));
    const int top = std::max(area_.y, int(std::floor(window.y)));
    const int right = std::min(area_.right(), int(std::ceil(window.right())));
    const int bottom = std::min(area_.bottom(), int(std::ceil(window.bottom())));
    return {left, top, std::max(0, right - left), std::max(0, bottom - top)};
}

void Whereabouts::follow(const EventView& event) {
    if (const auto* pop = event.get_if<event::Pop>()) window_ = pop->window;
    if (event.get_if<event::Clear>()) {
        shown_.assign(std::size_t(area_.width) * std::size_t(area_.height), {});
    }
    if (event.get_if<event::Corners>()) at_corners_.fill({});
    if (const auto* call = event.get_if<event::Call>(); call && call->of == Procedure::point_color) at_point_.reset();
    if (const auto* compare = event.get_if<event::Compare>(); compare && compare->nearer) {
        (compare->corner ? at_corners_[std::size_t(*compare->corner)] : at_point_) = compare->polygon;
    }
    if (const auto* line = event.get_if<event::ShownLine>()) row_ = line->row;
    if (const auto* pixel = event.get_if<event::Pixel>(); pixel && pixel->shown && !shown_.empty()) {
        shown(pixel->x, pixel->y) = polygon_;
    }
    event.visit([&]<class E>(const E& e) {
        if constexpr (OfPolygon<E>) polygon_ = e.polygon;
    });
}

std::vector<PolygonPlace> Whereabouts::polygons(const EventView& event) const {
    std::vector<PolygonPlace> found;
    event.visit([&]<class E>(const E& e) {
        if constexpr (OfPolygon<E>) add(found, e.polygon);
        if constexpr (OfClipPolygon<E>) add(found, e.clip);
        if constexpr (OfOther<E>) add(found, e.other);
    });
    if (found.empty()) add(found, polygon_);
    if (const auto* compare = event.get_if<event::Compare>()) {
        add(found, compare->corner ? at_corners_[std::size_t(*compare->corner)] : at_point_);
    }
    if (const auto* pixel = event.get_if<event::Pixel>(); pixel && !shown_.empty())
        add(found, shown(pixel->x, pixel->y));
    return found;
}

PixelRectangle Whereabouts::pixels(const EventView& event, Decision of, std::optional<int> pixel) const {
    // FillPolygon asks for its rows before its first row; the pixel is a row.
    if (of == Decision::rows && pixel) return {area_.x, *pixel, area_.width, 1};
    const auto on_row = [&](int row) {
        return pixel ? PixelRectangle{*pixel, row, 1, 1} : PixelRectangle{area_.x, row, area_.width, 1};
    };
    if (const auto* one = event.get_if<event::Pixel>()) return {one->x, one->y, 1, 1};
    if (const auto* row = event.get_if<event::Row>()) return on_row(row->row);
    if (event.get_if<event::Columns>() || event.get_if<event::Miss>() || event.get_if<event::Slope>())
        return on_row(row_);
    if (const auto* order = event.get_if<event::Order>()) {
        return {pixel_at(order->point.x), pixel_at(order->point.y), 1, 1};
    }
    if (const auto* flag = event.get_if<event::Visibility>()) return {flag->x, area_.y, 1, area_.height};
    if (window_) return clipped(*window_);
    if (pixel) return {area_.x, *pixel, area_.width, 1};
    return whole();
}

}  // namespace vidno
