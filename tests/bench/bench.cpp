// What drawing, recording and exporting cost: ./dev bench
#include <benchmark/benchmark.h>

#include <chrono>
#include <limits>

#include "bench/event_object.h"
#include "bench/overdraw.h"
#include "event_json.h"
#include "recorder.h"
#include "trace_writer.h"
#include "vidno/vidno.h"

namespace {

using namespace vidno;

constexpr auto warnock = Method::warnock;
constexpr auto zbuffer = Method::zbuffer;

/// Drawing with the visitor that hears nothing: so many random triangles at 512 x 512, four deep.
template <Method method>
void draw(benchmark::State& state) {
    const Scene scene = random_triangles(int(state.range(0)), 512, 4);
    for (auto _ : state) benchmark::DoNotOptimize(render(method, scene, Double{}));
}
BENCHMARK(draw<warnock>)->Arg(100)->Arg(1000)->Arg(10000)->Unit(benchmark::kMillisecond);
BENCHMARK(draw<zbuffer>)->Arg(100)->Arg(1000)->Arg(10000)->Unit(benchmark::kMillisecond);

template <class Sink>
void run(Method method, const Scene& scene, Sink& sink) {
    Recording<Sink> recording{Detail::signs, sink};
    render(method, scene, Double{}, Recorder<Double, Sink>(recording));
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
        TraceWriter writer({method, "corrected", "double", Detail::signs, scene},
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
    const auto keep = [&](const auto& event) { events.emplace_back(event); };
    run(method, scene, keep);
    return events;
}

double least_seconds(const auto& work) {
    using clock = std::chrono::steady_clock;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 5; ++i) {
        const auto start = clock::now();
        work();
        least = std::min(least, std::chrono::duration<double>(clock::now() - start).count());
    }
    return least;
}

/// Events to text as the trace is written; compared with a tree of JSON values built and dumped for each event.
template <Method method>
void export_lines(benchmark::State& state) {
    const Scene scene = traced_scene();
    const auto events = events_of<method>(scene);
    std::size_t bytes = 0;
    // In blocks, as the writer hands them on: what is measured is the text, not the memory for all of it.
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
        in_blocks(text, [&](const Event& event) { std::visit([&](const auto& e) { lines.line(text, e); }, event); });
    };
    std::string dumped;
    const auto build_and_dump = [&, object = EventObject(scene)] {
        in_blocks(dumped, [&](const Event& event) { (dumped += std::visit(object, event).dump()) += '\n'; });
    };
    for (auto _ : state) write();
    per_event(state, double(events.size()));
    state.SetBytesProcessed(state.iterations() * std::int64_t(bytes));
    state.counters["faster than trees"] = least_seconds(build_and_dump) / least_seconds(write);
}
BENCHMARK(export_lines<warnock>)->Unit(benchmark::kMillisecond);
BENCHMARK(export_lines<zbuffer>)->Unit(benchmark::kMillisecond);

}  // namespace
