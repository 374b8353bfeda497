/// The templates that the units for runs of curves instantiate.
#pragma once

#include "run/floating_horizon_run.h"
#include "vidno/floating_horizon.h"

namespace vidno {

template <class Set, Kernel K>
DrawnLines lines_drawn(const FloatingHorizonRequest& request, const K& kernel, const auto& trace, const Set& set = {}) {
    const auto end = [](const auto& e) {
        return LineEnd<Value>{{as_value<K>(e.point.x), as_value<K>(e.point.y)}, e.left, e.right};
    };
    DrawnLines drawn;
    for (const auto& [segment, from, to] : visible_lines(request.scene, kernel, trace, set).lines) {
        drawn.push_back({segment, end(from), end(to)});
    }
    return drawn;
}

}  // namespace vidno
