/// Whereabouts: what a decision of a run is about, by the events before it: its polygons, and the pixels whose colour it may change.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "format/event_sink.h"

namespace vidno {

class Whereabouts {
public:
    explicit Whereabouts(const Area& area);

    /// Hears every event of level `signs`.
    void follow(const EventView& event);

    // Of the decisions that this event tells, or is the first to follow; asked before the event is followed. Not known before `draw`:
    // the polygon of FillPolygon.

    std::vector<PolygonPlace> polygons(const EventView& event) const;

    /// With the pixel, a column or a row, next to whose centre the decision was taken.
    PixelRectangle pixels(const EventView& event, std::optional<int> pixel) const;

private:
    using Nearest = std::optional<PolygonPlace>;

    PixelRectangle whole() const { return {area_.x, area_.y, area_.width, area_.height}; }
    PixelRectangle clipped(const Window& window) const;
    Nearest& shown(int x, int y);
    const Nearest& shown(int x, int y) const { return const_cast<Whereabouts&>(*this).shown(x, y); }

    Area area_;
    std::optional<Window> window_;       // of Warnock's algorithm
    Nearest polygon_;                    // the last one that was named
    std::array<Nearest, 4> at_corners_;  // nearest so far
    Nearest at_point_;
    std::vector<Nearest> shown_;  // by the Z-buffer, pixel by pixel
    int row_ = 0;                 // of ShowLine
};

}  // namespace vidno
