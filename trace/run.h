/// Running a method as chosen at run time: one translation unit a kernel, and one for the usual mistakes; with a trace or
/// without.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "trace_writer.h"
#include "vidno/kernels/bits.h"
#include "vidno/kernels/depth_bits.h"
#include "vidno/kernels/grid.h"

namespace vidno {

struct RunRequest;

/// Throws EventLimitReached out of the writer.
using RunKernel = Picture (*)(const RunRequest&);

Picture run_float(const RunRequest&);
Picture run_double(const RunRequest&);
Picture run_bits(const RunRequest&);
Picture run_depth(const RunRequest&);     // zbuffer only
Picture run_filtered(const RunRequest&);  // the corrected edition only
Picture run_grid(const RunRequest&);      // the corrected edition only, of a snapped scene (snapped_scene.h)
Picture run_exact(const RunRequest&);

/// An edition with a mistake, under a kernel that runs it.
Picture run_mistake(const RunRequest&);

/// The Warnock family (vidno/family/family.h), of a scene that the method takes; the corrected edition only.
Picture run_family_float(const RunRequest&);
Picture run_family_double(const RunRequest&);
Picture run_family_bits(const RunRequest&);
Picture run_family_filtered(const RunRequest&);
Picture run_family_grid(const RunRequest&);  // of a snapped scene
Picture run_family_exact(const RunRequest&);

/// Weiler and Atherton's algorithm (vidno/weiler_atherton.h); the corrected edition only.
Picture run_regions_float(const RunRequest&);
Picture run_regions_double(const RunRequest&);
Picture run_regions_bits(const RunRequest&);
Picture run_regions_filtered(const RunRequest&);
Picture run_regions_exact(const RunRequest&);

struct KernelChoice {
    /// A whole number that follows the name: `bits:12`.
    struct Parameter {
        char letter;
        int least, most;
        std::optional<int> if_not_said{};
    };

    std::string_view name;
    std::string_view rule;
    RunKernel run;
    bool runs_printed = true;
    std::optional<Parameter> parameter{};
    bool runs_warnock = true;
    bool runs_mistakes = false;
    RunKernel run_family = nullptr;   // none: it does not run the Warnock family
    RunKernel run_regions = nullptr;  // none: it does not run Weiler and Atherton's algorithm

    /// The floating horizon: it takes samples as they are, and has no depths to store.
    bool runs_curves(Edition edition) const {
        return run != run_depth && run != run_grid && !is_mistake(edition) &&
               (runs_printed || edition != Edition::printed);
    }

    bool runs(Method method, Edition edition) const {
        const auto only = choice_of(edition).only;
        if (method == Method::weiler_atherton) return run_regions && edition == Edition::corrected;
        if (is_family(method) && !(run_family && (edition == Edition::corrected || only == method))) return false;
        return (runs_warnock || method != Method::warnock) && (runs_printed || edition != Edition::printed) &&
               (runs_mistakes || !is_mistake(edition)) && (!only || *only == method);
    }
};

inline constexpr std::array kernel_choices{
    KernelChoice{.name = "float",
                 .rule = "IEEE binary32; decisions as they fall",
                 .run = run_float,
                 .run_family = run_family_float,
                 .run_regions = run_regions_float},
    KernelChoice{.name = "double",
                 .rule = "IEEE binary64; decisions as they fall",
                 .run = run_double,
                 .runs_mistakes = true,
                 .run_family = run_family_double,
                 .run_regions = run_regions_double},
    KernelChoice{.name = "bits",
                 .rule = "every result rounded to P bits; decisions as they fall",
                 .run = run_bits,
                 .parameter = {{'P', fewest_bits, most_bits}},
                 .run_family = run_family_bits,
                 .run_regions = run_regions_bits},
    KernelChoice{"depth",
                 "binary64, and a Z-buffer of B bits; zbuffer only",
                 run_depth,
                 true,
                 {{'B', fewest_depth_bits, most_depth_bits}},
                 false},
    KernelChoice{.name = "filtered",
                 .rule = "binary64 with an error bound, exact where that cannot decide: always right; corrected only",
                 .run = run_filtered,
                 .runs_printed = false,
                 .run_family = run_family_filtered,
                 .run_regions = run_regions_filtered},
    KernelChoice{
        .name = "grid",
        .rule = "x and y snapped to 1/2^K pixel, whole numbers from there: right for the snapped scene; corrected only",
        .run = run_grid,
        .runs_printed = false,
        .parameter = {{'K', 1, finest_grid, 8}},
        .run_family = run_family_grid},
    KernelChoice{.name = "exact",
                 .rule = "exact rationals; every decision is right, the reference",
                 .run = run_exact,
                 .runs_mistakes = true,
                 .run_family = run_family_exact,
                 .run_regions = run_regions_exact},
};

/// A kernel as it is named: `double`, `bits:12`, `grid` for `grid:8`.
struct NamedKernel {
    const KernelChoice* choice;
    int parameter = 0;  // if the choice has one

    std::string name() const;
    bool snaps() const { return choice->run == run_grid; }  // takes a scene that was snapped
    /// Whether a wrong decision or pixel would be an error of the program.
    bool is_always_right() const { return choice->run == run_exact || !choice->runs_printed; }
};

/// None if no kernel has that name, or its parameter is missing or out of range.
std::optional<NamedKernel> kernel_named(std::string_view name);

/// The names that there are: "float, double, bits:P (4 <= P <= 24), ...".
std::string kernel_names();

/// A visible region of Weiler and Atherton's algorithm, in the numbers of its kernel: loops, holes the other way round; its
/// area in square pixels.
struct ShownRegion {
    PolygonPlace polygon;
    RegionLoops loops;
    Value area;
};

struct RunRequest {
    Method method;
    NamedKernel kernel;
    Edition edition;
    const Scene& scene;
    Detail detail = Detail::windows;
    TraceWriter* writer = nullptr;  // none: no trace
    /// Of Warnock's algorithm, the side; a trace does not say it.
    double smallest_window = 1;
    /// Called at each window, polygon or list of a run without a trace, and at each step of one that is checked.
    std::function<void()> progress = [] {};
    /// Where those of Weiler and Atherton's algorithm go, if they are wanted.
    std::vector<ShownRegion>* regions = nullptr;
};

inline Picture run(const RunRequest& request) {
    if (is_mistake(request.edition)) return run_mistake(request);
    const KernelChoice& kernel = *request.kernel.choice;
    if (request.method == Method::weiler_atherton) return kernel.run_regions(request);
    return is_family(request.method) ? kernel.run_family(request) : kernel.run(request);
}

}  // namespace vidno
