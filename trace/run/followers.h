/// Followers: listeners to a run besides the sink of its events. They hear of a decision before the event that reports
/// it.
#pragma once

#include <functional>

#include "format/verdict.h"
#include "vidno/kernel.h"

namespace vidno {

/// A point that a run constructed: an intersection, or a vertex made by clipping.
struct Surveyed {
    double off;                    // from the exact one, in pixels
    const Calculator* calculator;  // for its x and y, valid while the surveyor hears of it
};
using Surveyor = std::function<void(const Surveyed&)>;

/// Under `filtered`, hears what decided each comparison.
using StageCount = std::function<void(FilterStage)>;

/// Under `filtered` and `exact`, hears each sign of Weiler and Atherton's algorithm. The judge of such a run hears only
/// the decisions that its events report.
using HearSign = std::function<void(Sign)>;

/// Reports to the count, if there is one.
struct StageTally {
    const StageCount* count = nullptr;
    void operator()(FilterStage stage) const {
        if (count) (*count)(stage);
    }
};

struct Followers {
    const Judge* judge = nullptr;  // if there is one, the run is judged: float, double, bits and depth
    const Surveyor* survey = nullptr;
    const StageCount* count = nullptr;
    const HearSign* hear_sign = nullptr;
};

}  // namespace vidno
