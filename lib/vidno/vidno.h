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

enum class Method : unsigned char { warnock, zbuffer };
inline constexpr std::array<std::string_view, 2> method_names{"warnock", "zbuffer"};

/// The picture that a method paints, told to the trace step by step. A fault of the procedures (only a printed text
/// has any) ends the run and is told as well; the picture is what was painted until then. Warnock's algorithm splits
/// no window whose side is `smallest_window`, in pixels.
template <class Set = Corrected, Kernel K, class Trace = NoTrace>
Picture render(Method method, const Scene& scene, K kernel, Trace trace = {}, double smallest_window = 1) {
    Picture picture(scene.area, scene.background);
    try {
        Run<Set, K, Trace> run(scene, std::move(kernel), trace, picture);
        run.smallest_window = smallest_window;
        if (method == Method::warnock) {
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
