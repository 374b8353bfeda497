// The Z-buffer, right: it tests every pixel of the area, and the depths start at minus infinity.
#include <limits>

#include "z_buffer_style.h"

struct HalfPlanes : PlainStyle {
    static double start() { return -std::numeric_limits<double>::infinity(); }
};

int main() { run_as<HalfPlanes>("half_planes.jsonl"); }
