/// Weiler and Atherton's algorithm is not in the page's library: live.cpp refuses to run it.

#include <cstdlib>

#include "check_regions.h"

namespace vidno {

Picture run_regions_float(const RunRequest&) { std::abort(); }
Picture run_regions_double(const RunRequest&) { std::abort(); }
Picture run_regions_bits(const RunRequest&) { std::abort(); }
Picture run_regions_filtered(const RunRequest&) { std::abort(); }
Picture run_regions_exact(const RunRequest&) { std::abort(); }
Picture judged_regions(const RunRequest&, const Judge&, const Surveyor&, const std::function<void(FilterStage)>&,
                       const std::function<void(const Event&)>&) {
    std::abort();
}

}  // namespace vidno
