/// OneList: all parts of a window share one list.
///
/// Believed   that a part, given the list of its parent, has it for itself; what is copied is a pointer or a reference.
/// Goes wrong what one part removes in PW3, and marks in PW8, its brothers find removed and marked.
/// Seen       where a polygon lies beside the part that is looked at first: it is missing in those after it.
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
