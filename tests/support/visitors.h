/// Visitors that note the events of a run.
#pragma once

#include <string>
#include <string_view>

#include "vidno/trace.h"

namespace vidno::test {

/// How many windows Warnock's algorithm takes from its stack.
struct CountWindows : NoTrace {
    int* windows;
    explicit CountWindows(int& count) : windows(&count) {}
    void pop(Line, const auto&) { ++*windows; }
};

/// The last fault of a run.
struct HearFaults : NoTrace {
    struct Reported {
        int count = 0;
        Line at{};
        std::string reason;
    };
    Reported* reported;
    explicit HearFaults(Reported& to) : reported(&to) {}
    void fault(Line at, std::string_view reason) { *reported = {reported->count + 1, at, std::string(reason)}; }
    void fault(Line at, std::string_view reason, int, int) { fault(at, reason); }
};

}  // namespace vidno::test
