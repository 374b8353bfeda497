/// A run at hand: to call one procedure of it and look at what it gives.
#pragma once

#include "vidno/kernels/bits.h"
#include "vidno/kernels/exact.h"
#include "vidno/kernels/filtered.h"
#include "vidno/printed.h"
#include "vidno/snap.h"
#include "vidno/vidno.h"

namespace vidno::test {

struct Bits24 : Bits {
    Bits24() : Bits(24) {}
};

}  // namespace vidno::test

/// The kernels over which every hand-computed case is run; the printed text is not for a kernel that is always right.
#define VIDNO_PRINTED_KERNELS ::vidno::Float, ::vidno::Double, ::vidno::test::Bits24, ::vidno::Exact
#define VIDNO_KERNELS VIDNO_PRINTED_KERNELS, ::vidno::Filtered, ::vidno::test::Grid8

namespace vidno::test {

template <class K>
inline constexpr bool runs_printed = PrintedKernel<K>;

struct Grid8 : Grid {
    Grid8() : Grid(8) {}
};

/// The scene as a kernel takes it: `grid` on its grid.
template <class K>
Scene scene_for(Scene scene) {
    if constexpr (std::derived_from<K, Grid>) return snapped(std::move(scene), Resolution{8});
    return scene;
}

template <class K, class Set = Corrected, class Trace = NoTrace>
struct Stage {
    Scene scene;
    Picture picture;
    Run<Set, K, Trace> run;

    explicit Stage(Scene given, Trace trace = {})
        : scene(scene_for<K>(std::move(given))),
          picture(scene.area, scene.background),
          run(scene, K{}, trace, picture) {}

    const Polygon<K>& polygon(std::size_t index = 0) const { return run.polygons[index]; }
    Point<typename K::Coordinate> point(double x, double y) const { return run.kernel.point(x, y); }

    ActivePolygonList<K> all_active() const {
        ActivePolygonList<K> list;
        for (const auto& polygon : run.polygons) list.push_back({&polygon, false});
        return list;
    }
};

/// A number of any kernel as the nearest double.
inline double as_double(const auto& number) { return double(number); }
inline double as_double(const Rational& number) { return CGAL::to_double(number); }

/// How many windows Warnock's algorithm takes from its stack.
struct CountWindows : NoTrace {
    int* windows;
    explicit CountWindows(int& count) : windows(&count) {}
    void pop(Line, const auto&) { ++*windows; }
};

/// The last fault that ended or marred a run.
struct HearFaults : NoTrace {
    struct Heard {
        int count = 0;
        Line at{};
        std::string reason;
    };
    Heard* heard;
    explicit HearFaults(Heard& to) : heard(&to) {}
    void fault(Line at, std::string_view reason) { *heard = {heard->count + 1, at, std::string(reason)}; }
    void fault(Line at, std::string_view reason, int, int) { fault(at, reason); }
};

}  // namespace vidno::test
