/// vidno: hidden surfaces by the textbook, one small step at a time.
///
///     vidno::Picture picture = vidno::render(vidno::Method::warnock, scene, vidno::Double{});
///
/// The scene's polygons must have been admitted (admission.h).
#pragma once

#include "corrected.h"
#include "fault.h"
#include "kernels/machine.h"

namespace vidno {

/// Beside the two of the course, the Warnock family, each with a procedure set of its own (family/family.h), and Weiler and
/// Atherton's algorithm, which gives more than a picture (weiler_atherton.h).
enum class Method : unsigned char {
    warnock,
    zbuffer,
    warnock_simplest,
    warnock_full,
    warnock_angles,
    warnock_vertex,
    warnock_edges,
    warnock_bodies,
    weiler_atherton
};
inline constexpr auto method_names =
    std::to_array<std::string_view>({"warnock", "zbuffer", "warnock-simplest", "warnock-full", "warnock-angles",
                                     "warnock-vertex", "warnock-edges", "warnock-bodies", "weiler-atherton"});

constexpr bool is_family(Method method) {
    return Method::warnock_simplest <= method && method <= Method::warnock_bodies;
}

/// Those that look at windows.
constexpr bool is_warnock(Method method) { return method == Method::warnock || is_family(method); }

/// The picture that a method paints by the procedures of the set, told to the trace step by step. A fault of the procedures
/// (only a printed text has any) ends the run and is told as well; the picture is what was painted until then. Warnock's
/// algorithm splits no window whose side is `smallest_window`, in pixels.
template <class Set = Corrected, Kernel K, class Trace = NoTrace>
Picture render(Method method, const Scene& scene, K kernel, Trace trace = {}, double smallest_window = 1) {
    assert(!is_family(method) || !(std::same_as<Set, Corrected>));
    assert(method != Method::weiler_atherton);
    Picture picture(scene.area, scene.background);
    try {
        Run<Set, K, Trace> run(scene, std::move(kernel), trace, picture);
        run.smallest_window = smallest_window;
        if (is_warnock(method)) {
            Set::warnock(run);
        } else {
            Set::z_buffer(run);
        }
    } catch (const Fault& fault) {
        trace.fault(fault.at, fault.reason);
    }
    return picture;
}

}  // namespace vidno
