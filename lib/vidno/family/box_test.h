/// BoxTest: the two lines of the relation test that use only the box around the polygon.
///
/// Takes   a polygon and a window.
/// Gives   outside or inside, or nothing if the box cannot decide. A box that touches the window from outside does not
///         decide.
#pragma once

#include <optional>

#include "../run.h"
#include "relation.h"

namespace vidno {

struct BoxTest {
    template <class Run>
    static std::optional<Relation> box_test(Run& run, const Polygon<typename Run::Arithmetic>& polygon,
                                            const Window& window) {
        using enum Line;
        auto& trace = run.trace;

        const bool outside = run.kernel.outside(polygon.box, window);
        trace.box(RE1, polygon, outside);
        if (outside) return Relation::outside;
        const bool inside = run.kernel.inside(polygon.box, window);
        trace.insider(RE2, polygon, inside);
        if (inside) return Relation::inside;
        return std::nullopt;
    }
};

}  // namespace vidno
