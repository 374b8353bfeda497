/// What a trace of a run of curves has of its own: its first line, and what came out.
#pragma once

#include "choice/edition.h"
#include "choice/method.h"
#include "format/event_json.h"
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

/// "sha256:" and the hash of the lines in their order: `[curve,[x,y],[x,y]]` and a line feed each, with the numbers that a trace has.
std::string lines_hash(const DrawnLines& lines);

}  // namespace vidno
