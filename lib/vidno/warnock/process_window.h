/// ProcessWindow: which polygons may show in a window, and does one of them hide all others?
///
/// Takes   a window and its list of active polygons.
/// Gives   the number of polygons left in the list; whether one that surrounds the window is nearest at all four
///         corners, and its colour; whether a single one lies inside. Polygons outside leave the list, surrounding
///         ones are marked in it. Testing the corners suffices, since both planes are linear over the window.
#pragma once

#include "../run.h"

namespace vidno {

struct ProcessWindow {
    template <class Run>
    static WindowSummary process_window(Run& run, const Window& window,
                                        ActivePolygonList<typename Run::Arithmetic>& active_polygons) {
        using enum Line;
        auto& trace = run.trace;

        const auto corners = corners_of(run.kernel, window);
        std::array<typename Run::Depth, 4> nearest;
        nearest.fill(run.set.first_corner_depth(run.kernel));
        trace.corners(PW1, nearest[0]);
        WindowSummary found;

        auto kept = active_polygons.begin();
        for (auto [entry, surrounding] : active_polygons) {
            const auto& polygon = *entry;
            const bool outside = run.kernel.outside(polygon.box, window);
            trace.box(PW3, polygon, outside);
            if (run.set.discards(surrounding, outside)) {
                trace.discard(PW3, polygon);
                continue;
            }
            ++found.polygon_count;
            trace.count(PW4, polygon, found.polygon_count);

            const int k = compare_corners(run, polygon, corners, nearest);
            if (run.set.uncovers(k)) {
                found.has_surround = false;
                trace.uncover(PW7, polygon);
            }

            const auto holds = [&](const auto& corner) { return run.surround_test(PW8, corner, polygon); };
            if (!surrounding && std::all_of(corners.begin(), corners.end(), holds)) {
                surrounding = true;
                trace.mark(PW8, polygon);
            }
            if (surrounding && k == 4) {
                found.has_surround = true;
                found.color = polygon.color;
                trace.cover(PW9, polygon);
            } else if (found.polygon_count == 1) {
                found.insider = run.kernel.inside(polygon.box, window);
                trace.insider(PW10, polygon, found.insider);
            }
            *kept++ = {entry, surrounding};
        }
        active_polygons.erase(kept, active_polygons.end());
        return found;
    }

private:
    /// PW5 and PW6: at how many corners is the polygon nearer than those before it? It is then the nearest there.
    template <class Run>
    static int compare_corners(Run& run, const auto& polygon, const auto& corners,
                               std::array<typename Run::Depth, 4>& nearest) {
        using enum Line;
        std::array<typename Run::Depth, 4> z;
        for (int i = 0; i < 4; ++i) z[i] = run.depth(PW5, polygon, corners[i]);
        int k = 0;
        std::array<bool, 4> nearer;
        for (int i = 0; i < 4; ++i) {
            nearer[i] = run.kernel.nearer(z[i], nearest[i], corners[i]);
            run.trace.compare_corner(PW6, polygon, i, z[i], nearest[i], nearer[i]);
            if (!nearer[i]) continue;
            nearest[i] = z[i];
            ++k;
        }
        run.trace.nearer(PW6, polygon, nearer, k);
        return k;
    }
};

}  // namespace vidno
