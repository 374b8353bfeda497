#include "scene/elementary.h"

// The functions of formulas, for the script of the npm package.
#define VIDNO_EXPORTED(name) \
    extern "C" [[clang::export_name(#name)]] double vidno_##name(double x) { return vidno::elementary::name(x); }
VIDNO_ELEMENTARY(VIDNO_EXPORTED)

extern "C" [[clang::export_name("atan2")]] double vidno_atan2(double y, double x) {
    return vidno::elementary::atan2(y, x);
}

extern "C" [[clang::export_name("pow")]] double vidno_pow(double base, double exponent) {
    return vidno::elementary::pow(base, exponent);
}
