/// ThreeListsWarnock: a polygon that surrounds a window or is outside it has that relation to its parts too, and is not
/// tested again.
///
/// Three lists hold the polygons over the whole run: the surrounding ones, those outside, and the third, of all others.
/// Windows are visited depth first, so the first two lists are stacks, as AW is. A polygon that joined a list at a
/// window belongs there for the parts of that window, which have higher levels and come before any other window. When a
/// window of the same level or a lower one comes, the polygon goes back to the third list.
///
/// Source  J. E. Warnock, A hidden surface algorithm for computer generated halftone pictures, 1969; the course's full
///         form.
/// Takes   a run with its polygons.
/// Gives   the run's picture: at each pixel centre the colour of the nearest polygon, the first of equally near ones.
/// Time    a window tests the polygons whose outlines its parent saw, and compares the depths of those that may show.
#pragma once

#include "calls.h"
#include "polygon_lists.h"
#include "windows.h"

namespace vidno {

struct ThreeListsWarnock {
    template <class Run>
    static void warnock(Run& run) {
        using enum Line;
        using K = typename Run::Arithmetic;
        auto& trace = run.trace;

        PolygonLists<K> lists{{}, {}, *first_list(run)};
        const auto& [surrounding, outside, third] = lists;
        std::vector<LeveledWindow<K>> active_windows;  // AW
        active_windows.push_back({run.set.root_window(run.area), 0, &third});
        trace.push_root(WF1, active_windows);

        while (!active_windows.empty()) {
            const Window window = active_windows.back().window;
            const int level = active_windows.back().level;
            active_windows.pop_back();
            trace.pop(WF2, window);
            take_back(run, lists, level);
            const Relation last_left = sort_out(run, lists, window, level);

            if (surrounding.empty() && third.empty()) {
                trace.decide(WF5, Case::empty);
                run.fill(WF5, window, run.background);
            } else if (surrounding.empty() && third.size() == 1) {
                trace.decide(WF6, Case::single);
                run.fill(WF6, window, run.background);
                const auto& polygon = *third.front().polygon;
                if (last_left == Relation::inside) {
                    run.fill_polygon(WF7, polygon.vertices, polygon);
                } else {
                    run.fill_polygon(WF8, run.polygon_clip(WF8, polygon, window), polygon);
                }
            } else if (surrounding.size() == 1 && third.empty()) {
                trace.decide(WF9, Case::surrounded);
                run.fill(WF9, window, surrounding.front().polygon->color);
            } else if (const auto* hiding =
                           surrounding.empty() ? nullptr : calls::hiding_polygon(run, WF10, window, lists.shown())) {
                trace.decide(WF10, Case::surrounded);
                run.fill(WF10, window, hiding->color);
            } else if (is_smallest(run, window)) {
                trace.decide(WF11, Case::pixel);
                run.fill(WF11, window, run.point_color(WF11, centre_of(run.kernel, window), lists.shown()));
            } else {
                trace.decide(WF12, Case::split);
                for (const Window& part : run.set.split(run, window, third)) {
                    if (off_area(part, run.area)) {
                        trace.skip(WF12, part);
                        continue;
                    }
                    active_windows.push_back({part, level + 1, &third});
                    trace.push_part(WF12, active_windows, true);
                }
            }
        }
    }

private:
    /// Moves back to the third list the polygons that joined another list at a window that has no parts left.
    static void take_back(auto& run, auto& lists, int level) {
        using enum Line;
        auto& trace = run.trace;
        const auto take_back_from = [&](Relation relation, auto& list) {
            while (!list.empty() && list.back().level >= level) {
                trace.rejoin(WF3, relation, list);
                lists.third.push_back({list.back().polygon, false});
                list.pop_back();
            }
        };
        take_back_from(Relation::surrounding, lists.surrounding);
        take_back_from(Relation::outside, lists.outside);
        lists.put_in_order(lists.third);
    }

    /// Moves out of the third list the polygons that surround the window or are outside it. Gives the relation of the
    /// last that stays.
    static Relation sort_out(auto& run, auto& lists, const Window& window, int level) {
        using enum Line;
        auto& trace = run.trace;
        Relation last_left = Relation::outside;
        std::erase_if(lists.third, [&](const auto& entry) {
            const auto& polygon = *entry.polygon;
            const Relation relation = calls::relation(run, WF4, polygon, window);
            if (relation == Relation::inside || relation == Relation::intersecting) {
                last_left = relation;
                return false;
            }
            auto& list = relation == Relation::surrounding ? lists.surrounding : lists.outside;
            list.push_back({&polygon, level});
            trace.join(WF4, relation, list);
            return true;
        });
        return last_left;
    }
};

}  // namespace vidno
