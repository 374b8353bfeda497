/// Refused: input is rejected. The message is one line: file, place in it, reason.
#pragma once

#include <stdexcept>

namespace vidno {

struct Refused : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// OutputLost: an output could be opened, but not written to its end. The message is one line: file, reason.
struct OutputLost : Refused {
    using Refused::Refused;
};

}  // namespace vidno
