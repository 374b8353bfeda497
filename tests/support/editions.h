/// The named editions, for tests that run all of them.
#pragma once

#include <vector>

#include "choice/edition.h"

namespace vidno::test {

inline std::vector<Edition> all_editions() {
    std::vector<Edition> editions;
    for (const auto& named : named_editions) editions.push_back(named.edition);
    return editions;
}

}  // namespace vidno::test
