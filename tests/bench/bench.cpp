// The cost of drawing, of always right kernels, of recording and of exporting: ./dev bench
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <random>
#include <vector>

#include "bench/event_object.h"
#include "bench/overdraw.h"
#include "format/event_json.h"
#include "format/trace_writer.h"
#include "run/recorder.h"
#include "scene/snapped_scene.h"
#include "vidno/kernels/filtered.h"
#include "vidno/kernels/filtered_regions.h"
#include "vidno/vidno.h"
#include "vidno/weiler_atherton.h"

namespace {

using namespace vidno;

constexpr auto warnock = Method::warnock;
constexpr auto zbuffer = Method::zbuffer;

/// Draws N random triangles at 512 x 512, four deep, with the visitor that ignores all events.
template <Method method>
void draw(benchmark::State& state) {
    const Scene scene = random_triangles(int(state.range(0)), 512, 4);
    for (auto _ : state) benchmark::DoNotOptimize(render(method, scene, Double{}));
}
BENCHMARK(draw<warnock>)->Arg(100)->Arg(1000)->Arg(10000)->Unit(benchmark::kMillisecond);
BENCHMARK(draw<zbuffer>)->Arg(100)->Arg(1000)->Arg(10000)->Unit(benchmark::kMillisecond);

double seconds(const auto& work) {
    using clock = std::chrono::steady_clock;
    const auto start = clock::now();
    work();
    return std::chrono::duration<double>(clock::now() - start).count();
}

/// The time of some work relative to other work: the median of alternating runs.
double times(const auto& other, const auto& work) {
    std::vector<double> ratios;
    for (int i = 0; i < 9; ++i) {
        const double others = seconds(other);
        ratios.push_back(seconds(work) / others);
    }
    std::ranges::nth_element(ratios, ratios.begin() + 4);
    return ratios[4];
}

/// The same under `filtered`, which is always right.
template <Method method>
void draw_filtered(benchmark::State& state) {
    const Scene scene = random_triangles(int(state.range(0)), 512, 4);
    const auto draw_in = [&](auto kernel) { benchmark::DoNotOptimize(render(method, scene, kernel)); };
    for (auto _ : state) draw_in(Filtered{});
    state.counters["times double"] = times([&] { draw_in(Double{}); }, [&] { draw_in(Filtered{}); });
}
BENCHMARK(draw_filtered<warnock>)->Arg(100)->Arg(1000)->Arg(10000)->Unit(benchmark::kMillisecond);
BENCHMARK(draw_filtered<zbuffer>)->Arg(100)->Arg(1000)->Arg(10000)->Unit(benchmark::kMillisecond);

/// The same under `grid`, which is right for the snapped scene.
template <Method method>
void draw_grid(benchmark::State& state) {
    const Scene scene = random_triangles(int(state.range(0)), 512, 4);
    const Scene snapped = snapped_scene(scene, 8).scene;
    const auto draw_snapped = [&] { benchmark::DoNotOptimize(render(method, snapped, Grid(8))); };
    for (auto _ : state) draw_snapped();
    state.counters["times double"] =
        times([&] { benchmark::DoNotOptimize(render(method, scene, Double{})); }, draw_snapped);
}
BENCHMARK(draw_grid<warnock>)->Arg(100)->Arg(1000)->Arg(10000)->Unit(benchmark::kMillisecond);
BENCHMARK(draw_grid<zbuffer>)->Arg(100)->Arg(1000)->Arg(10000)->Unit(benchmark::kMillisecond);

/// The visible regions of triangles, many of which pierce each other.
template <class K>
void regions(benchmark::State& state) {
    const Scene scene = small_triangles(int(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(visible_regions(scene, K{}));
}
BENCHMARK(regions<Double>)->Arg(100)->Arg(200)->Arg(400)->Unit(benchmark::kMillisecond);
BENCHMARK(regions<Filtered>)->Arg(100)->Arg(200)->Arg(400)->Unit(benchmark::kMillisecond);
BENCHMARK(regions<Exact>)->Arg(100)->Arg(200)->Arg(400)->Unit(benchmark::kMillisecond);

/// Orientation tests of random points, at most 512 pixels apart, under `filtered` and by CGAL's filtered predicate.
void orient(benchmark::State& state) {
    std::mt19937 random(1);
    std::uniform_real_distribution<> coordinate(0, 512);
    Scene scene;
    scene.area = {0, 0, 512, 512};
    Filtered filtered;
    filtered.see(scene);
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

void run(Method method, const Scene& scene, EventSink& sink) {
    Recording recording{Detail::signs, sink};
    render(method, scene, Double{}, Recorder<Double>(recording));
}

Scene traced_scene() { return random_triangles(100, 64, 4); }

void per_event(benchmark::State& state, double events) {
    using benchmark::Counter;
    state.counters["events"] = events;
    state.counters["time/event"] = Counter(events, Counter::kIsIterationInvariantRate | Counter::kInvert);
}

/// From the run to lines of JSON in memory, every event.
template <Method method>
void record(benchmark::State& state) {
    const Scene scene = traced_scene();
    double bytes = 0;
    double events = 0;
    for (auto _ : state) {
        TraceWriter writer({method, Edition::corrected, "double", Detail::signs, scene},
                           [&](std::string_view text) { bytes += double(text.size()); });
        run(method, scene, writer);
        events = double(writer.events());
    }
    per_event(state, events);
    state.SetBytesProcessed(std::int64_t(bytes));
}
BENCHMARK(record<warnock>)->Unit(benchmark::kMillisecond);
BENCHMARK(record<zbuffer>)->Unit(benchmark::kMillisecond);

template <Method method>
std::vector<Event> events_of(const Scene& scene) {
    std::vector<Event> events;
    HeardBy keep([&](const EventView& event) { events.push_back(event.copy()); });
    run(method, scene, keep);
    return events;
}

/// Events to text as the trace is written; compared with a tree of JSON values built and dumped for each event.
template <Method method>
void export_lines(benchmark::State& state) {
    const Scene scene = traced_scene();
    const auto events = events_of<method>(scene);
    std::size_t bytes = 0;
    // In blocks, as the writer passes them on: we measure the formatting, not the memory for the whole text.
    const auto in_blocks = [&](auto& text, const auto& append) {
        bytes = 0;
        for (const auto& event : events) {
            append(event);
            if (text.size() < 65536) continue;
            bytes += text.size();
            benchmark::DoNotOptimize(text);
            text.clear();
        }
    };
    Text text;
    EventText lines(polygon_names(scene));
    const auto write = [&] {
        in_blocks(text, [&](const Event& event) { event.visit([&](const auto& e) { lines.line(text, e); }); });
    };
    std::string dumped;
    const auto build_and_dump = [&, object = EventObject(scene)] {
        in_blocks(dumped, [&](const Event& event) { (dumped += event.visit(object).dump()) += '\n'; });
    };
    for (auto _ : state) write();
    per_event(state, double(events.size()));
    state.SetBytesProcessed(state.iterations() * std::int64_t(bytes));
    state.counters["faster than trees"] = times(write, build_and_dump);
}
BENCHMARK(export_lines<warnock>)->Unit(benchmark::kMillisecond);
BENCHMARK(export_lines<zbuffer>)->Unit(benchmark::kMillisecond);

}  // namespace
