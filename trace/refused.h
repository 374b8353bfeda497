/// Refused: input is rejected. The message is one line: file, place in it, reason.
#pragma once

#include <stdexcept>

namespace vidno {

struct Refused : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace vidno
