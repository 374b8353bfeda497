/// Timing: the times of several runs, measured side by side.
#pragma once

#include <functional>
#include <vector>

namespace vidno {

/// The seconds that each run needs: the median of several rounds, in each of which every run is timed once. A run that
/// is too short for the clock is repeated. `progress` is called after each measurement.
std::vector<double> median_seconds(const std::vector<std::function<void()>>& runs, int rounds,
                                   const std::function<void()>& progress);

}  // namespace vidno
