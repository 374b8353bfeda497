#include "scene/elementary.h"

#include <boost/config.hpp>
#undef BOOST_HAS_FLOAT128  // GCC's own wide numbers would need libquadmath
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

namespace vidno::elementary {

namespace {

using Wide = boost::multiprecision::cpp_bin_float_quad;

/// The wide value, rounded once. Libraries agree on zeros and on what is not finite, so `narrow` is one of these
/// already.
double rounded(double narrow, auto&& wide) {
    return narrow != 0 && std::isfinite(narrow) ? static_cast<double>(wide()) : narrow;
}

}  // namespace

#define VIDNO_DEFINED(name)                                          \
    double name(double x) {                                          \
        return rounded(std::name(x), [x] { return name(Wide(x)); }); \
    }
VIDNO_ELEMENTARY(VIDNO_DEFINED)
#undef VIDNO_DEFINED

double atan2(double y, double x) {
    return rounded(std::atan2(y, x), [=] { return atan2(Wide(y), Wide(x)); });
}

double pow(double base, double exponent) {
    // The most frequent power; the product is rounded once, too.
    if (exponent == 2) return base * base;
    return rounded(std::pow(base, exponent), [=] { return pow(Wide(base), Wide(exponent)); });
}

}  // namespace vidno::elementary
