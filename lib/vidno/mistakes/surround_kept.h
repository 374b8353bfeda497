/// SurroundKept: hasSurround is never reset.
///
/// Believed   that a window found to be surrounded stays so.
/// Goes wrong a later polygon that is nearer but does not surround the window changes nothing in PW7.
/// Seen       where a near polygon lies in front of a far one that comes first: the near one is overlooked.
#pragma once

#include "../corrected.h"

namespace vidno::mistakes {

struct SurroundKept : Corrected {
    static constexpr std::string_view name = "surround-kept";

    /// PW7
    static bool uncovers(int /*k*/) { return false; }
};

}  // namespace vidno::mistakes
