/// What the procedures of the Warnock family share: the first list, and the test for the smallest window.
#pragma once

#include "../run.h"

namespace vidno {

/// The polygons that take part, in the order of the scene; none is marked as surrounding yet.
template <class Run>
std::shared_ptr<ActivePolygonList<typename Run::Arithmetic>> first_list(Run& run) {
    const auto list = std::make_shared<ActivePolygonList<typename Run::Arithmetic>>();
    for (const auto& polygon : run.polygons) {
        if (run.set.takes_part(run, polygon)) list->push_back({&polygon, false});
    }
    return list;
}

/// A window that gets one colour, and is not split.
inline bool is_smallest(const auto& run, const Window& window) {
    return window.width <= run.smallest_window && window.height <= run.smallest_window;
}

auto centre_of(const auto& kernel, const Window& window) {
    return kernel.point(window.x + window.width / 2, window.y + window.height / 2);
}

}  // namespace vidno
