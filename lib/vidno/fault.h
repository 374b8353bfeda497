/// Fault: why a procedure cannot continue. A printed procedure may read past a list, divide by zero or loop without
/// end. One that constructs points in rounded numbers may not terminate.
#pragma once

#include <string_view>

#include "line.h"

namespace vidno {

struct Fault {
    Line at;
    std::string_view reason;
};

}  // namespace vidno
