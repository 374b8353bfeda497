// The cost of drawing, of kernels that are always right, and of their orientation test.
#include <benchmark/benchmark.h>

#include <random>
#include <vector>

#include "bench/overdraw.h"
#include "bench/ratio.h"
#include "scene/snapped_scene.h"
#include "vidno/kernels/filtered.h"
#include "vidno/vidno.h"

namespace {

using namespace vidno;

constexpr auto warnock = Method::warnock;
constexpr auto zbuffer = Method::zbuffer;

/// Draws N random triangles at 512 x 512, four deep, with the visitor that ignores all events.
template <Method method>
void draw(benchmark::State& state) {
    const AdmittedScene scene = random_triangles(int(state.range(0)), 512, 4);
    for (auto _ : state) benchmark::DoNotOptimize(render(method, scene, Double{}));
}
BENCHMARK(draw<warnock>)->Arg(100)->Arg(1000)->Arg(10000)->Unit(benchmark::kMillisecond);
BENCHMARK(draw<zbuffer>)->Arg(100)->Arg(1000)->Arg(10000)->Unit(benchmark::kMillisecond);

/// Draws under `filtered`, which is always right.
template <Method method>
void draw_filtered(benchmark::State& state) {
    const AdmittedScene scene = random_triangles(int(state.range(0)), 512, 4);
    const auto draw_in = [&](auto kernel) { benchmark::DoNotOptimize(render(method, scene, kernel)); };
    for (auto _ : state) draw_in(Filtered{});
    state.counters["times double"] = times([&] { draw_in(Double{}); }, [&] { draw_in(Filtered{}); });
}
BENCHMARK(draw_filtered<warnock>)->Arg(100)->Arg(1000)->Arg(10000)->Unit(benchmark::kMillisecond);
BENCHMARK(draw_filtered<zbuffer>)->Arg(100)->Arg(1000)->Arg(10000)->Unit(benchmark::kMillisecond);

/// Draws under `grid`, which is right for the snapped scene.
template <Method method>
void draw_grid(benchmark::State& state) {
    const AdmittedScene scene = random_triangles(int(state.range(0)), 512, 4);
    const AdmittedScene snapped = snapped_scene(scene, 8).scene;
    const auto draw_snapped = [&] { benchmark::DoNotOptimize(render(method, snapped, Grid(8))); };
    for (auto _ : state) draw_snapped();
    state.counters["times double"] =
        times([&] { benchmark::DoNotOptimize(render(method, scene, Double{})); }, draw_snapped);
}
BENCHMARK(draw_grid<warnock>)->Arg(100)->Arg(1000)->Arg(10000)->Unit(benchmark::kMillisecond);
BENCHMARK(draw_grid<zbuffer>)->Arg(100)->Arg(1000)->Arg(10000)->Unit(benchmark::kMillisecond);

/// Orientation tests of random points, at most 512 pixels apart, under `filtered` and by CGAL's filtered predicate.
void orient(benchmark::State& state) {
    std::mt19937 random(1);
    std::uniform_real_distribution<> coordinate(0, 512);
    Filtered filtered;
    filtered.see(Scene{.name = {}, .area = {0, 0, 512, 512}, .background = {}, .polygons = {}});
    std::vector<glm::dvec3> corners(30000);
    for (auto& corner : corners) corner = {coordinate(random), coordinate(random), 0};

    const auto orient_in = [&](const auto& kernel) {
        using Corner = decltype(kernel.vertex(glm::dvec3{}));
        std::vector<Corner> vertices;
        for (const auto& corner : corners) vertices.push_back(kernel.vertex(corner));
        return [&kernel, vertices] {
            int sum = 0;
            for (int round = 0; round < 20; ++round) {
                for (std::size_t i = 2; i < vertices.size(); ++i) {
                    sum += int(kernel.sign(kernel.cross(vertices[i - 2], vertices[i - 1], vertices[i])));
                    benchmark::DoNotOptimize(sum);  // one at a time, as the procedures do
                }
            }
        };
    };
    using Predicates = CGAL::Exact_predicates_inexact_constructions_kernel;
    std::vector<Predicates::Point_2> points;
    for (const auto& corner : corners) points.emplace_back(corner.x, corner.y);
    const auto by_cgal = [&] {
        int sum = 0;
        for (int round = 0; round < 20; ++round) {
            for (std::size_t i = 2; i < points.size(); ++i) {
                sum += int(CGAL::orientation(points[i - 2], points[i - 1], points[i]));
                benchmark::DoNotOptimize(sum);
            }
        }
    };
    const Double machine;
    const auto in_double = orient_in(machine);
    const auto by_bound = orient_in(filtered);
    for (auto _ : state) by_bound();
    state.counters["times double"] = times(in_double, by_bound);
    state.counters["CGAL, times double"] = times(in_double, by_cgal);
}
BENCHMARK(orient)->Unit(benchmark::kMillisecond);

}  // namespace
