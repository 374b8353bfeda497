/// The calls of the family's procedures through a run, traced like those of the course's procedures in run.h.
#pragma once

#include "../run.h"
#include "relation.h"

namespace vidno::calls {

Relation relation(auto& run, Line at, const auto& polygon, const Window& window) {
    run.trace.call(at, Procedure::relation);
    const Relation found = run.set.relation(run, polygon, window);
    run.trace.relation(at, polygon, found);
    return found;
}

bool trial_function(auto& run, Line at, const auto& polygon, const Window& window) {
    run.trace.call(at, Procedure::trial_function);
    const bool meets = run.set.trial_function(run, polygon, window);
    run.trace.meets(at, polygon, meets);
    return meets;
}

int ray_crossings(auto& run, Line at, const auto& polygon, const Window& window) {
    run.trace.call(at, Procedure::ray_crossings);
    const int count = run.set.ray_crossings(run, polygon, window);
    run.trace.crossings(at, polygon, count);
    return count;
}

int octant_angles(auto& run, Line at, const auto& polygon, const Window& window) {
    run.trace.call(at, Procedure::octant_angles);
    const int octants = run.set.octant_angles(run, polygon, window);
    run.trace.angle(at, polygon, octants);
    return octants;
}

/// None if no polygon hides all others in the window.
auto hiding_polygon(auto& run, Line at, const Window& window, const auto& shown) {
    run.trace.call(at, Procedure::hiding_polygon);
    const auto* polygon = run.set.hiding_polygon(run, window, shown);
    run.trace.hiding(at, polygon);
    return polygon;
}

}  // namespace vidno::calls
