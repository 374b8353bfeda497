// The cost of recording a run and of writing its events.
#include <benchmark/benchmark.h>

#include <vector>

#include "bench/event_object.h"
#include "bench/overdraw.h"
#include "bench/ratio.h"
#include "format/event_text.h"
#include "format/trace_writer.h"
#include "run/recorder.h"
#include "vidno/vidno.h"

namespace {

using namespace vidno;

constexpr auto warnock = Method::warnock;
constexpr auto zbuffer = Method::zbuffer;

void run(Method method, const AdmittedScene& scene, EventSink& sink) {
    Recording recording{Detail::signs, sink};
    render(method, scene, Double{}, Recorder<Double>(recording));
}

AdmittedScene traced_scene() { return random_triangles(100, 64, 4); }

void per_event(benchmark::State& state, double events) {
    using benchmark::Counter;
    state.counters["events"] = events;
    state.counters["time/event"] = Counter(events, Counter::kIsIterationInvariantRate | Counter::kInvert);
}

/// From the run to lines of JSON in memory, every event.
template <Method method>
void record(benchmark::State& state) {
    const AdmittedScene scene = traced_scene();
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
std::vector<Event> events_of(const AdmittedScene& scene) {
    std::vector<Event> events;
    FunctionSink keep([&](const EventView& event) { events.push_back(event.copy()); });
    run(method, scene, keep);
    return events;
}

/// Events to text as the trace is written; compared with a tree of JSON values built and dumped for each event.
template <Method method>
void export_lines(benchmark::State& state) {
    const AdmittedScene scene = traced_scene();
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
    const auto write = [&] { in_blocks(text, [&](const Event& event) { lines.line(text, event); }); };
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
