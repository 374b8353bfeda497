/// Paints: whether an event gives a pixel its colour.
#pragma once

#include <algorithm>
#include <concepts>

#include "format/event.h"

namespace vidno {

/// The row of a run of pixels: its own, or that of its event.
template <class E, class Run>
int row_of(const E& event, const Run& run) {
    if constexpr (requires { run.row; }) {
        return run.row;
    } else {
        return event.row;
    }
}

/// Whether the event gives this pixel its colour. An event that has runs of pixels paints these. Clear does not count:
/// it prepares all pixels alike, and says nothing of this one.
template <class E>
bool paints(const E& event, int x, int y) {
    if constexpr (std::same_as<E, event::Fill>) {
        const auto& [left, top, width, height] = event.rect;
        return Area{left, top, width, height}.contains(x, y);
    } else if constexpr (requires { event.runs; }) {
        return std::any_of(event.runs.begin(), event.runs.end(),
                           [&](const auto& run) { return row_of(event, run) == y && run.first <= x && x < run.end; });
    } else {
        return false;
    }
}

}  // namespace vidno
