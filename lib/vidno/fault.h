/// Fault: a printed procedure cannot go on: a list read past its end, a division by zero, an endless loop.
#pragma once

#include <string_view>

#include "line.h"

namespace vidno {

struct Fault {
    Line at;
    std::string_view reason;
};

}  // namespace vidno
