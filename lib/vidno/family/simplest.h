/// SimplestWarnock: every window that may not be empty is split, down to the pixels.
///
/// Takes   a run with its polygons.
/// Gives   the run's picture: at each pixel centre the colour of the nearest polygon, the first of equally near ones. A
///         polygon leaves a window's list if its box is outside; only at a pixel PointColor asks exactly whether it
///         holds the centre.
/// Time    the number of windows grows with the area of the polygons' boxes.
#pragma once

#include "windows.h"

namespace vidno {

struct SimplestWarnock {
    template <class Run>
    static void warnock(Run& run) {
        using enum Line;
        auto& trace = run.trace;

        std::vector<ActiveWindow<typename Run::Arithmetic>> active_windows;  // AW
        active_windows.push_back({run.set.root_window(run.area), first_list(run)});
        trace.push_root(WS1, active_windows);

        while (!active_windows.empty()) {
            const auto entry = std::move(active_windows.back());
            active_windows.pop_back();
            const Window& window = entry.window;
            auto& polygons = *entry.polygons;
            trace.pop(WS2, window);
            std::erase_if(polygons, [&](const auto& active) {
                const bool outside = run.kernel.outside(active.polygon->box, window);
                trace.box(WS3, *active.polygon, outside);
                if (outside) trace.discard(WS3, *active.polygon);
                return outside;
            });

            if (polygons.empty()) {
                trace.decide(WS4, Case::empty);
                run.fill(WS4, window, run.background);
            } else if (is_smallest(run, window)) {
                trace.decide(WS5, Case::pixel);
                run.fill(WS5, window, run.point_color(WS5, centre_of(run.kernel, window), polygons));
            } else {
                trace.decide(WS6, Case::split);
                for (const Window& part : run.set.parts(window)) {
                    if (off_area(part, run.area)) {
                        trace.skip(WS6, part);
                        continue;
                    }
                    active_windows.push_back({part, run.set.list_for_part(entry.polygons)});
                    trace.push_part(WS6, active_windows, false);
                }
            }
        }
    }
};

}  // namespace vidno
