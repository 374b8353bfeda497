/// Running a method as chosen at run time: one translation unit a kernel, two editions, with a trace or without.
#pragma once

#include <functional>
#include <string_view>

#include "trace_writer.h"

namespace vidno {

struct RunRequest {
    Method method;
    bool printed;  // the edition
    const Scene& scene;
    Detail detail = Detail::windows;
    TraceWriter* writer = nullptr;           // none: no trace
    std::function<void()> progress = [] {};  // without a trace, called at each window or polygon; checked, at each step
};

/// Throws EventLimitReached out of the writer.
using RunKernel = Picture (*)(const RunRequest&);

Picture run_float(const RunRequest&);
Picture run_double(const RunRequest&);
Picture run_filtered(const RunRequest&);  // the corrected edition only
Picture run_exact(const RunRequest&);

struct KernelChoice {
    std::string_view name;
    std::string_view rule;
    RunKernel run;
    bool runs_printed = true;
};

inline constexpr std::array kernel_choices{
    KernelChoice{"float", "IEEE binary32; decisions as they fall", run_float},
    KernelChoice{"double", "IEEE binary64; decisions as they fall", run_double},
    KernelChoice{"filtered",
                 "binary64 with an error bound, exact where that cannot decide: always right; corrected only",
                 run_filtered, false},
    KernelChoice{"exact", "exact rationals; every decision is right, the reference", run_exact},
};

}  // namespace vidno
