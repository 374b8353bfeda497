/// Problem: an error in the files of a lesson, and its place.
#pragma once

#include <string>
#include <vector>

namespace vidno {

struct Problem {
    std::string file;
    int line = 1;  // from 1
    std::string what;

    std::string text() const { return file + ":" + std::to_string(line) + ": " + what; }
};

using Problems = std::vector<Problem>;

}  // namespace vidno
