/// RelationTest: the relation of a polygon to a window, by the cheap tests first.
///
/// Takes   a polygon, edge-on or not, and a window.
/// Gives   the relation (relation.h). Where neither the box tells nor an edge meets the window, all of the window is on one
///         side of the outline: any point of it decides, by the containment test of the set.
#pragma once

#include "calls.h"

namespace vidno {

struct RelationTest {
    template <class Run>
    static Relation relation(Run& run, const Polygon<typename Run::Arithmetic>& polygon, const Window& window) {
        using enum Line;
        if (const auto found = run.set.box_test(run, polygon, window)) return *found;
        if (calls::trial_function(run, RE3, polygon, window)) return Relation::intersecting;
        return run.set.surrounds(run, polygon, window) ? Relation::surrounding : Relation::outside;  // RE4
    }
};

}  // namespace vidno
