/// The claims of the floating horizon.
#pragma once

#include <map>
#include <set>

#include "grade/curve_truth.h"
#include "grade/judge.h"
#include "state/floating_horizon_state.h"

namespace vidno {

/// Judges the events of a trace of curves, as `judge` those of polygons. There is no picture: what was drawn are lines.
Judgement judge(const FloatingHorizonHeader& header, const std::vector<Event>& events, bool complete,
                Precision precision, const Words& words = Words());

}  // namespace vidno
