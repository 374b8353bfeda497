/// Weiler and Atherton's algorithm in the page's library: told to a trace always, and never held against the truth; live.cpp refuses
/// to check it.

#include <cstdlib>

#include "check_regions.h"
#include "recorder.h"
#include "vidno/kernels/bits.h"
#include "vidno/kernels/filtered_regions.h"
#include "vidno/weiler_atherton.h"

namespace vidno {

namespace {

template <Kernel K>
Picture told(const RunRequest& request, const K& kernel) {
    Recording<TraceWriter> recording{request.detail, *request.writer};
    return visible_regions(request.scene, kernel, Recorder<K, TraceWriter>(recording)).picture;
}

}  // namespace

Picture run_regions_float(const RunRequest& request) { return told(request, Float{}); }
Picture run_regions_double(const RunRequest& request) { return told(request, Double{}); }
Picture run_regions_bits(const RunRequest& request) { return told(request, Bits(request.kernel.parameter)); }
Picture run_regions_filtered(const RunRequest& request) { return told(request, Filtered{}); }
Picture run_regions_exact(const RunRequest& request) { return told(request, Exact{}); }

Picture judged_regions(const RunRequest&, const Judge&, const Surveyor&, const std::function<void(FilterStage)>&,
                       const std::function<void(const Event&)>&) {
    std::abort();
}

}  // namespace vidno
