/// WeilerAtherton: the visible regions, as polygons. The outline of the nearest polygon separates what lies inside from
/// what lies outside, and each part is processed separately.
///
/// Source  K. Weiler, P. Atherton, Hidden surface removal using polygon area sorting, SIGGRAPH 1977; the course's text,
///         whose scan contains the depth sort.
/// Takes   a run with its polygons.
/// Gives   the run's visible regions, then its picture. The regions share only outlines. Each lies within its polygon,
///         which is the nearest there; of coplanar polygons, the first in the scene.
/// Time    one clip for each region and each piece that lies over it.
///
/// The paper clips by a copy of the first polygon as it is in the scene. We clip by the piece of it that is in the
/// list. A list covers one part of the screen, and there the two are the same.
#pragma once

#include "weiler_atherton_run.h"

namespace vidno {

struct WeilerAtherton {
    template <class Run>
    static void weiler_atherton(Run& run) {
        using enum Line;
        using List = std::vector<typename Run::Piece>;

        List pieces;
        for (const auto& polygon : run.polygons) {
            if (!run.set.takes_part(run, polygon)) continue;
            auto part = run.cut_to_area(WA1, polygon);
            if (!part.empty()) pieces.emplace_back(&polygon, std::move(part));
        }
        run.facets = run.split_piercing(WA2, std::move(pieces));

        std::vector<List> lists;
        const auto push = [&](Line at, List list) {
            run.trace.push_list(at, list);
            lists.push_back(std::move(list));
        };
        if (!run.facets.empty()) push(WA3, run.depth_sort(WA3, run.facets));
        while (!lists.empty()) {
            List list = std::move(lists.back());
            lists.pop_back();
            run.trace.pop_list(WA4, list);
            run.count_list(WA4);
            auto clip = std::move(list.front());

            List inside, outside;
            for (std::size_t i = 1; i < list.size(); ++i) {
                if (run.apart(list[i], clip)) {
                    run.trace.beside(WA5, *list[i].polygon);
                    outside.push_back(std::move(list[i]));
                    continue;
                }
                auto parts = run.region_clip(WA5, list[i], clip);
                const auto put = [&](List& to, auto& region) {
                    if (!region.empty()) to.emplace_back(list[i].polygon, std::move(region), list[i].is_ground);
                };
                put(inside, parts.inside);
                put(outside, parts.outside);
            }
            if (!outside.empty()) push(WA6, std::move(outside));
            auto nearer = run.remove_behind(WA7, inside, clip);
            if (nearer.empty()) {
                run.show(WA8, clip);
            } else {
                clip.is_ground = true;
                nearer.push_back(std::move(clip));
                push(WA9, std::move(nearer));
            }
        }
        run.paint_regions(WA10);
    }
};

}  // namespace vidno
