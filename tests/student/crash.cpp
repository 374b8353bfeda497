// A program in `float` that reports a few numbers and crashes.
#include <limits>

#include "vidno_student.h"

using namespace vidno::student;

int main() {
    const Scene scene{"A crash", {0, 0, 2, 2}, {255, 255, 255}, {{"A", {0, 0, 0}, {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}}}};
    WarnockTrace trace("crash.jsonl", scene, Detail::polygons, Precision::single_precision);
    const float tenth = 0.1f, infinity = std::numeric_limits<float>::infinity();
    trace.plane(0, tenth, -0.0f, infinity, -infinity);
    trace.plane(0, 0.1, 1.0 / 3, std::numeric_limits<double>::quiet_NaN(), 1e22);
    std::abort();
}
