/// vidno: hidden surfaces by the textbook, one small step at a time.
///
///     const vidno::AdmittedScene scene = vidno::admit(my_scene);  // vidno/admission.h
///     vidno::Picture picture = vidno::render(vidno::Method::warnock, scene, vidno::Double{});
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

#include "admitted.h"
#include "corrected.h"
#include "fault.h"
#include "kernels/machine.h"
#include "z_buffer/whole_lines.h"

namespace vidno {

/// The picture that a method paints by the procedures of the set; the trace hears each step. A fault of the procedures,
/// which only the printed text has, ends the run and is reported to the trace; the picture is then what was painted so
/// far. Warnock's algorithm does not split a window whose side is `smallest_window`, in pixels.
///
/// Throws std::invalid_argument if the method is not one of the set's `methods`, or the smallest window is smaller than
/// a pixel.
template <class Set = Corrected, Kernel K, class Trace = NoTrace>
Picture render(Method method, const AdmittedScene& scene, K kernel, Trace trace = {}, double smallest_window = 1,
               Set set = {}) {
    constexpr auto& methods = Set::methods;
    constexpr bool is_unseen = std::is_same_v<Set, Corrected> && std::is_same_v<Trace, NoTrace>;
    if constexpr (is_unseen && ComparesLines<K>) {
        if (method == Method::zbuffer) {
            return render(method, scene, std::move(kernel), trace, smallest_window, WholeLines());
        }
    }
    if (std::find(methods.begin(), methods.end(), method) == methods.end()) {
        throw std::invalid_argument("the procedure set " + std::string(Set::name) + " does not run the method " +
                                    std::string(method_names[std::size_t(method)]));
    }
    if (!(smallest_window >= 1)) throw std::invalid_argument("the smallest window is smaller than a pixel");
    constexpr auto z_buffers = std::count(methods.begin(), methods.end(), Method::zbuffer);
    Picture picture(scene->area, scene->background);
    try {
        Run<Set, K, Trace> run(scene, std::move(kernel), trace, picture, std::move(set));
        run.smallest_window = smallest_window;
        if constexpr (z_buffers > 0) {
            if (method == Method::zbuffer) run.set.z_buffer(run);
        }
        if constexpr (methods.size() > z_buffers) {
            if (method != Method::zbuffer) run.set.warnock(run);
        }
    } catch (const Fault& fault) {
        trace.fault(fault.at, fault.reason);
    }
    return picture;
}

}  // namespace vidno
