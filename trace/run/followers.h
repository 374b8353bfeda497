/// Followers: who follows a run beside the sink of its events. They hear of a decision before the event that tells it.
#pragma once

#include <functional>

#include "format/verdict.h"
#include "vidno/kernel.h"

namespace vidno {

/// A point that a run constructed: an intersection, a vertex that clipping made.
struct Surveyed {
    double off;                    // from the exact one, in pixels
    const Calculator* calculator;  // of its x and y, while the surveyor hears of it
};
using Surveyor = std::function<void(const Surveyed&)>;

/// Hears under `filtered` what decided each comparison.
using StageCount = std::function<void(FilterStage)>;

/// Hears each sign of Weiler and Atherton's algorithm under `filtered` and `exact`.
using HearSign = std::function<void(Sign)>;

/// Tells the count, if there is one.
struct StageTally {
    const StageCount* count = nullptr;
    void operator()(FilterStage stage) const {
        if (count) (*count)(stage);
    }
};

struct Followers {
    const Judge* judge = nullptr;  // with one, the run is judged: float, double, bits and depth
    const Surveyor* survey = nullptr;
    const StageCount* count = nullptr;
    const HearSign* hear_sign = nullptr;
};

}  // namespace vidno
