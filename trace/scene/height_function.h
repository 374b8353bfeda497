/// HeightFunction: y of x and z, given as text.
#pragma once

#include <functional>
#include <string_view>

namespace vidno {

using HeightFunction = std::function<double(double x, double z)>;

/// Parses a formula in x, z, pi and e, as lessons/surfaces/README.md describes them. Throws Refused, with only the
/// reason, for a text that is none. The values are the same on every machine, except that the page computes the
/// functions of elementary.h with its own library.
HeightFunction height_function(std::string_view text);

}  // namespace vidno
