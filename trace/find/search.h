/// Search: a small scene whose run satisfies a condition.
///
/// How     random scenes on coarse lattices, with more polygons or curves, larger areas and finer lattices as the
///         search goes on; and small changes of the best scenes so far: those nearest to the condition and, once it is
///         met, the smallest (scene_size.h). What is found is shrunk. The search ends when it has not found a smaller
///         scene for as long as it took to find the first one.
/// Equal arguments give equal scenes on every machine, unless the time ends the search.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "find/condition.h"
#include "scene/surface.h"

namespace vidno {

struct SearchRequest {
    const Condition& condition;
    std::string_view method;  // a name of the command line; it suits the condition
    std::uint64_t seed = 1;
    double seconds = 60;
    std::function<void(std::uint64_t scenes)> progress = [](std::uint64_t) {};
};

struct SearchReport {
    std::optional<AnyScene> found;     // curves for the floating horizon
    std::uint64_t scenes = 0;          // that were run
    std::size_t most_parts_drawn = 0;  // polygons or curves in random scenes
    int widest = 0;                    // side of an area of these
    std::vector<std::uint64_t> met{};  // for each part of the condition, by how many scenes
    std::size_t most_parts = 0;        // that one scene met
    std::vector<bool> met_by_best{};   // which parts the nearest scene met, if none met all
};

SearchReport search(const SearchRequest& request);

}  // namespace vidno
