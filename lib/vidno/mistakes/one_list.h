/// OneList: all parts of a window share one list.
///
/// Believed   that a part gets its own copy of its parent's list, while only a pointer or a reference is copied.
/// Goes wrong a polygon that one part removes in PW3, or marks in PW8, is removed or marked for its siblings too.
/// Seen       where a polygon lies beside the part that is examined first: it is missing in the parts after it.
#pragma once

#include "../corrected.h"

namespace vidno::mistakes {

struct OneList : Corrected {
    static constexpr std::string_view name = "one-list";

    /// W13
    template <class List>
    static std::shared_ptr<List> list_for_part(const std::shared_ptr<List>& list) {
        return list;
    }
};

}  // namespace vidno::mistakes
