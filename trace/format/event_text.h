/// EventText: events as lines of JSON, written field by field.
#pragma once

#include <string>
#include <vector>

#include "format/event.h"
#include "json/remembered_shortest.h"

namespace vidno {

/// The ids of a scene's polygons as JSON strings, in the scene's order.
using PolygonNames = std::vector<std::string>;

PolygonNames polygon_names(const Scene& scene);

class EventText {
public:
    explicit EventText(PolygonNames names) : names_(std::move(names)) {}

    /// Appends the event as one line, newline included.
    void line(Text& out, const EventView& event);

    const PolygonNames& names() const { return names_; }

private:
    PolygonNames names_;
    RememberedShortest shortest_;
};

}  // namespace vidno
