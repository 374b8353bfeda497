/// HeightFunction: y of x and z, given as text.
#pragma once

#include <functional>
#include <string>

namespace vidno {

using HeightFunction = std::function<double(double x, double z)>;

/// The text is an expression of muParser in x, z and pi. Throws Refused, with only the reason, for an invalid one.
/// The last bits of sines and powers depend on the machine.
HeightFunction height_function(const std::string& text);

}  // namespace vidno
