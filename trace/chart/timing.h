/// Timing: what pictures cost, side by side.
#pragma once

#include <functional>
#include <vector>

namespace vidno {

/// The seconds that each run needs: the median of several rounds, in each of which every run has its turn. A run that is too
/// short for the clock is repeated. `progress` is called after each turn.
std::vector<double> median_seconds(const std::vector<std::function<void()>>& runs, int rounds,
                                   const std::function<void()>& progress);

}  // namespace vidno
