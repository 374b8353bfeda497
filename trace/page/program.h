/// Runs another program to its end.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace vidno {

/// Runs a program from the path with an input, and returns its output. Its error messages go to standard error. Throws
/// Refused if there is no such program, or with the last error message if its exit status is not 0.
std::string output_of(const std::vector<std::string>& command, std::string_view input);

}  // namespace vidno
