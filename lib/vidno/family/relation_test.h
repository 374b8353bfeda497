/// RelationTest: the relation of a polygon to a window, with the cheap tests first.
///
/// Takes   a polygon, edge-on or not, and a window.
/// Gives   the relation (relation.h). If the box does not decide and no edge meets the window, the whole window is on
///         one side of the outline, so the containment test of the set decides for any point of it.
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
