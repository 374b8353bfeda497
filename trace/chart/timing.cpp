#include "chart/timing.h"

#include <algorithm>
#include <chrono>

namespace vidno {

namespace {

double seconds_of(const std::function<void()>& run) {
    using Clock = std::chrono::steady_clock;
    constexpr double long_enough = 0.002;
    const auto start = Clock::now();
    std::chrono::duration<double> taken{};
    int times = 0;
    do {
        run();
        ++times;
        taken = Clock::now() - start;
    } while (taken.count() < long_enough);
    return taken.count() / times;
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace

std::vector<double> median_seconds(const std::vector<std::function<void()>>& runs, int rounds,
                                   const std::function<void()>& progress) {
    std::vector<std::vector<double>> seconds(runs.size());
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t i = 0; i < runs.size(); ++i) {
            seconds[i].push_back(seconds_of(runs[i]));
            progress();
        }
    }
    std::vector<double> medians;
    for (auto& each : seconds) medians.push_back(median(std::move(each)));
    return medians;
}

}  // namespace vidno
