/// PolygonLists: the three lists of Warnock's algorithm, kept for the whole run, and the windows that share them.
#pragma once

#include "../run.h"

namespace vidno {

/// An entry of the stack AW.
template <Kernel K>
struct LeveledWindow {
    Window window;
    int level;                             // 0: the first; 1: a part of it, and so on
    const ActivePolygonList<K>* polygons;  // the third list
};

template <Kernel K>
struct PolygonLists {
    struct Joined {
        const Polygon<K>* polygon;
        int level;  // of the window at which it joined
    };
    std::vector<Joined> surrounding, outside;  // in the order of joining: the levels rise
    ActivePolygonList<K> third;                // all others, in the order of the scene

    /// All polygons that may show, in the order of the scene.
    ActivePolygonList<K> shown() const {
        ActivePolygonList<K> list = third;
        for (const auto& [polygon, level] : surrounding) list.push_back({polygon, true});
        put_in_order(list);
        return list;
    }

    static void put_in_order(ActivePolygonList<K>& list) {
        const auto before = [](const auto& a, const auto& b) { return a.polygon->index < b.polygon->index; };
        std::sort(list.begin(), list.end(), before);
    }
};

}  // namespace vidno
