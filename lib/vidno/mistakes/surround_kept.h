/// SurroundKept: hasSurround is never reset.
///
/// Believed   that a window which was found to be surrounded stays so.
/// Goes wrong a polygon that comes later and is nearer, but does not surround the window, changes nothing in PW7.
/// Seen       where a near polygon stands before a far one that comes first: it is overlooked.
#pragma once

#include "../corrected.h"

namespace vidno::mistakes {

struct SurroundKept : Corrected {
    static constexpr std::string_view name = "surround-kept";

    /// PW7
    static bool uncovers(int /*k*/) { return false; }
};

}  // namespace vidno::mistakes
