#include "scene/elementary.h"

#include <cmath>

// A dragged surface is sampled anew for each frame, and functions that are rounded once would take a hundred times as
// long. These may differ from them in the last digit.
namespace vidno::elementary {

#define VIDNO_DEFINED(name) \
    double name(double x) { return std::name(x); }
VIDNO_ELEMENTARY(VIDNO_DEFINED)

double atan2(double y, double x) { return std::atan2(y, x); }
double pow(double base, double exponent) { return std::pow(base, exponent); }

}  // namespace vidno::elementary
