/// The editions, for tests that run all of them.
#pragma once

#include <vector>

#include "choice/edition.h"

namespace vidno::test {

inline std::vector<Edition> all_editions() {
    std::vector<Edition> editions;
    for (std::size_t place = 0; place < edition_choices.size(); ++place) editions.push_back(Edition(place));
    return editions;
}

}  // namespace vidno::test
