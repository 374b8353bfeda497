// The cost of visible regions by Weiler and Atherton's algorithm.
#include <benchmark/benchmark.h>

#include "bench/overdraw.h"
#include "vidno/kernels/filtered_regions.h"
#include "vidno/vidno.h"
#include "vidno/weiler_atherton.h"

namespace {

using namespace vidno;

/// The visible regions of triangles, many of which pierce each other.
template <class K>
void regions(benchmark::State& state) {
    const AdmittedScene scene = small_triangles(int(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(visible_regions(scene, K{}));
}
BENCHMARK(regions<Double>)->Arg(100)->Arg(200)->Arg(400)->Unit(benchmark::kMillisecond);
BENCHMARK(regions<Filtered>)->Arg(100)->Arg(200)->Arg(400)->Unit(benchmark::kMillisecond);
BENCHMARK(regions<Exact>)->Arg(100)->Arg(200)->Arg(400)->Unit(benchmark::kMillisecond);

}  // namespace
