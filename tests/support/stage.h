/// A run for calling single procedures.
#pragma once

#include "kernels.h"
#include "vidno/printed.h"
#include "vidno/vidno.h"

namespace vidno::test {

template <class K, class Set = Corrected, class Trace = NoTrace>
struct Stage {
    AdmittedScene scene;
    Picture picture;
    Run<Set, K, Trace> run;

    explicit Stage(AdmittedScene given, Trace trace = {})
        : scene(scene_for<K>(std::move(given))),
          picture(scene->area, scene->background),
          run(scene, K{}, trace, picture) {}

    const Polygon<K>& polygon(std::size_t index = 0) const { return run.polygons[index]; }
    Point<typename K::Coordinate> point(double x, double y) const { return run.kernel.point(x, y); }

    ActivePolygonList<K> all_active() const {
        ActivePolygonList<K> list;
        for (const auto& polygon : run.polygons) list.push_back({&polygon, false});
        return list;
    }
};

}  // namespace vidno::test
