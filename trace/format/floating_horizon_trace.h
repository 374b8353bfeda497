/// The first line and the result in the trace of a run of curves.
#pragma once

#include "choice/edition.h"
#include "choice/method.h"
#include "format/event_text.h"
#include "scene/surface.h"
#include "vidno/floating_horizon/floating_horizon_run.h"

namespace vidno {

struct FloatingHorizonHeader {
    Edition edition{};
    std::string kernel;
    Detail detail{};
    Surface scene;
    bool operator==(const FloatingHorizonHeader&) const = default;
};

/// There are none.
inline PolygonNames polygon_names(const Surface&) { return {}; }

/// The first line of a trace.
std::string header_json(const FloatingHorizonHeader& header);

/// The visible lines, as a run has them at its end.
using DrawnLines = std::vector<VisibleLine<Value>>;

/// "sha256:" and the hash of the lines in order, `[curve,[x,y],[x,y]]` and a line feed for each, with numbers as in a
/// trace.
std::string lines_hash(const DrawnLines& lines);

}  // namespace vidno
