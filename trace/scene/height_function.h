/// HeightFunction: y of x and z, given as text.
#pragma once

#include <functional>
#include <string>

namespace vidno {

using HeightFunction = std::function<double(double x, double z)>;

/// The text is an expression of muParser in x, z and pi. Throws Refused, with only the reason, for an invalid one.
/// The values are the same on every machine.
HeightFunction height_function(const std::string& text);

}  // namespace vidno
