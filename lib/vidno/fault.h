/// Fault: a procedure cannot go on. A printed one: a list read past its end, a division by zero, an endless loop. One that constructs,
/// in numbers that round: it has lost its way.
#pragma once

#include <string_view>

#include "line.h"

namespace vidno {

struct Fault {
    Line at;
    std::string_view reason;
};

}  // namespace vidno
