/// The template that the units for runs without a trace instantiate: Untraced, once `KernelOf` makes their kernel.
#pragma once

#include <cmath>

#include "run/floating_horizon_lines.h"
#include "run/untraced.h"
#include "run/weiler_atherton_run.h"
#include "vidno/family/family.h"
#include "vidno/printed.h"
#include "vidno/printed_floating_horizon.h"
#include "vidno/vidno.h"

namespace vidno {

/// `KernelOf<kind>::made(parameter)` is the kernel.
template <KernelKind kind>
struct KernelOf;

/// The visitor of a run without a trace: it reports progress at each window, polygon, list or curve, and whether
/// something is lost.
struct Pacer : NoTrace {
    const std::function<void()>& progress;
    bool* loses = nullptr;  // none: nobody asks
    bool is_always_right = false;

    void fault(Line, std::string_view) { lose(); }
    void fault(Line, std::string_view, int, int) { lose(); }
    void plane(Line, const auto&, const auto& plane) {
        for (const auto& number : {plane.a, plane.b, plane.c, plane.d}) expect_finite(number);
    }
    void show_region(Line, const auto&, const auto& region) {
        for (const auto& loop : region.loops) {
            for (const auto& vertex : loop) {
                expect_finite(vertex.at.x);
                expect_finite(vertex.at.y);
            }
        }
    }
    void pop(Line, const auto&) { progress(); }
    void polygon(Line, const auto&) { progress(); }
    void pop_list(Line, const auto& /*pieces*/) { progress(); }
    void curve(Line, int /*curve*/) { progress(); }

private:
    void lose() {
        if (loses) *loses = true;
    }
    void expect_finite(const auto& number) {
        if constexpr (requires { double(number); }) {
            if (!is_always_right && !std::isfinite(double(number))) lose();
        }
    }
};

inline Pacer pacer_of(const RunRequest& request) {
    return {{}, request.progress, request.loses, request.kernel.is_always_right()};
}

template <KernelKind kind>
using UntracedKernel = decltype(KernelOf<kind>::made(0));

template <KernelKind kind>
UntracedKernel<kind> kernel_for(const auto& request) {
    return KernelOf<kind>::made(request.kernel.parameter);
}

template <class Set, Kernel K>
Picture untraced_set(const RunRequest& request, const K& kernel) {
    return render<Set>(request.method, request.scene, kernel, pacer_of(request), request.smallest_window);
}

template <KernelKind kind>
Picture Untraced<kind>::course(const RunRequest& request) {
    const auto kernel = kernel_for<kind>(request);
    if constexpr (PrintedKernel<UntracedKernel<kind>>) {
        if (request.edition == Edition::printed) return untraced_set<Printed>(request, kernel);
    }
    return untraced_set<Corrected>(request, kernel);
}

template <KernelKind kind>
Picture Untraced<kind>::family(const RunRequest& request) {
    const auto kernel = kernel_for<kind>(request);
    return family::with_set_of(request.method, [&]<class Set>(Set) { return untraced_set<Set>(request, kernel); });
}

template <KernelKind kind>
Picture Untraced<kind>::weiler_atherton(const RunRequest& request) {
    return weiler_atherton_run(request, kernel_for<kind>(request), pacer_of(request));
}

template <KernelKind kind>
DrawnLines Untraced<kind>::floating_horizon(const FloatingHorizonRequest& request) {
    const auto kernel = kernel_for<kind>(request);
    const Pacer pacer{{}, request.progress};
    if constexpr (PrintedKernel<UntracedKernel<kind>>) {
        if (request.edition == Edition::printed) return lines_drawn<PrintedFloatingHorizon>(request, kernel, pacer);
    }
    return lines_drawn<CorrectedFloatingHorizon>(request, kernel, pacer);
}

}  // namespace vidno
