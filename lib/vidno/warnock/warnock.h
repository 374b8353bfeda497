/// Warnock: examines a window; paints it if it is clear what shows in it, otherwise examines its parts.
///
/// Source  J. E. Warnock, A hidden surface algorithm for computer generated halftone pictures, 1969; the course's form.
/// Takes   a run with its polygons.
/// Gives   the run's picture: at each pixel centre the colour of the nearest polygon, the first of equally near ones.
/// Time    the number of windows grows with the length of the visible edges; a window tests each polygon of its list.
#pragma once

#include "../run.h"

namespace vidno {

struct Warnock {
    template <class Run>
    static void warnock(Run& run) {
        using enum Line;
        using K = typename Run::Arithmetic;
        auto& trace = run.trace;

        std::vector<ActiveWindow<K>> active_windows;  // AW
        const auto all_polygons = std::make_shared<ActivePolygonList<K>>();
        for (const auto& polygon : run.polygons) {
            if (run.set.takes_part(run, polygon)) all_polygons->push_back({&polygon, false});
        }
        active_windows.push_back({run.set.root_window(run.area), all_polygons});
        trace.push_root(W3, active_windows);

        while (!active_windows.empty()) {
            const auto [window, active_polygons] = std::move(active_windows.back());
            active_windows.pop_back();
            trace.pop(W5, window);
            const auto found = run.process_window(W6, window, *active_polygons);

            if (found.polygon_count == 0) {
                trace.decide(W7, Case::empty);
                run.fill(W7, window, run.background);
            } else if (found.has_surround) {
                trace.decide(W8, Case::surrounded);
                run.fill(W8, window, found.color);
            } else if (window.width <= run.smallest_window && window.height <= run.smallest_window) {
                trace.decide(W9, Case::pixel);
                const auto centre = run.kernel.point(window.x + window.width / 2, window.y + window.height / 2);
                run.fill(W9, window, run.point_color(W9, centre, *active_polygons));
            } else if (found.polygon_count == 1) {
                trace.decide(W10, Case::single);
                run.fill(W10, window, run.background);
                const auto& polygon = *active_polygons->front().polygon;
                if (found.insider) {
                    run.fill_polygon(W11, polygon.vertices, polygon);
                } else {
                    run.fill_polygon(W12, run.polygon_clip(W12, polygon, window), polygon);
                }
            } else {
                trace.decide(W13, Case::split);
                for (const Window& part : run.set.parts(window)) {
                    if (off_area(part, run.area)) {
                        trace.skip(W13, part);
                        continue;
                    }
                    active_windows.push_back({part, run.set.list_for_part(active_polygons)});
                    trace.push_part(W13, active_windows, active_windows.back().polygons == active_polygons);
                }
            }
        }
    }
};

}  // namespace vidno
