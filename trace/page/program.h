/// Another program, run to its end.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace vidno {

/// Runs a program that is found on the path, gives it its input, and takes what it writes. Its complaints go to standard
/// error. Throws Refused if there is no such program or it does not end with 0: then with the last of its complaints.
std::string output_of(const std::vector<std::string>& command, std::string_view input);

}  // namespace vidno
