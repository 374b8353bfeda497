/// Loss: something that a command's output lacks, and its place: a line of a file, a step, a polygon.
#pragma once

#include <string>

namespace vidno {

struct Loss {
    std::string what;
    std::string where;
};

}  // namespace vidno
