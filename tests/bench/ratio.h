/// The time of some work relative to other work.
#pragma once

#include <algorithm>
#include <chrono>
#include <vector>

namespace vidno {

inline double seconds(const auto& work) {
    using clock = std::chrono::steady_clock;
    const auto start = clock::now();
    work();
    return std::chrono::duration<double>(clock::now() - start).count();
}

/// The median of alternating runs.
inline double times(const auto& other, const auto& work) {
    std::vector<double> ratios;
    for (int i = 0; i < 9; ++i) {
        const double others = seconds(other);
        ratios.push_back(seconds(work) / others);
    }
    std::ranges::nth_element(ratios, ratios.begin() + 4);
    return ratios[4];
}

}  // namespace vidno
