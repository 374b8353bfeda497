/// Whereabouts: the subject of a decision, by the events before it: its polygons, and the pixels whose colour it may
/// change.
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

    // For the decisions that this event reports or is the first to follow. Query them before the event is followed. The
    // polygon of FillPolygon is not known before `draw`.

    std::vector<PolygonPlace> polygons(const EventView& event) const;

    /// With the column or row of the pixel next to whose centre the decision was taken.
    PixelRectangle pixels(const EventView& event, Decision of, std::optional<int> pixel) const;

private:
    using Nearest = std::optional<PolygonPlace>;

    PixelRectangle whole() const { return {area_.x, area_.y, area_.width, area_.height}; }
    PixelRectangle clipped(const Window& window) const;
    Nearest& shown(int x, int y);
    const Nearest& shown(int x, int y) const { return const_cast<Whereabouts&>(*this).shown(x, y); }

    Area area_;
    std::optional<Window> window_;       // of Warnock's algorithm
    Nearest polygon_;                    // the last one named
    std::array<Nearest, 4> at_corners_;  // nearest so far
    Nearest at_point_;
    std::vector<Nearest> shown_;  // by the Z-buffer, pixel by pixel
    int row_ = 0;                 // of ShowLine
};

}  // namespace vidno
