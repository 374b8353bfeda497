/// HeightFunction: y of x and z, given as text.
#pragma once

#include <functional>
#include <string>

namespace vidno {

using HeightFunction = std::function<double(double x, double z)>;

/// The text is an expression of muParser in x, z and pi. Throws Refused, with the reason alone, for one that it does not take.
/// What sines and powers come to in their last bits is the affair of the machine.
HeightFunction height_function(const std::string& text);

}  // namespace vidno
