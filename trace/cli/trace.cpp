#include "check/checked_trace.h"
#include "cli/commands.h"
#include "cli/shared/losses.h"
#include "cli/shared/progress.h"
#include "cli/shared/run_options.h"
#include "cli/shared/scene_files.h"
#include "counted.h"
#include "find/until.h"
#include "output.h"
#include "run/write_trace.h"

namespace vidno::cli {

namespace {

constexpr std::string_view example_scene = R"(  {"window": {"x": 0, "y": 0, "width": 16, "height": 16},
   "polygons": [
     {"id": "far",  "vertices": [[1, 1, 0.2], [13, 1, 0.2], [13, 13, 0.2], [1, 13, 0.2]]},
     {"id": "near", "vertices": [[5, 4, 0.7], [15, 6, 0.7], [8, 15, 0.7]]}
   ]
  })";

struct TraceOptions : RunOptions {
    std::string output;
    std::string until;  // a condition, or empty
    std::uint64_t most_events = TraceWriter::no_limit;
    bool check = false;
};

/// Traces a run of either kind, with its header.
int write_traced(const auto& header, const auto& request, const TraceOptions& options) {
    OutputFile file(options.output);
    Progress progress("events");
    TraceWriter* running = nullptr;
    const auto write = [&](std::string_view text) {
        file.write(text);
        if (running) progress.show(running->events());
    };
    TraceWriter writer(header, write, options.most_events);
    running = &writer;
    const bool whole = options.check           ? write_checked_trace(request, writer)
                       : options.until.empty() ? write_trace(request, writer)
                                               : write_trace_until(options.until, request, writer);
    progress.clear();
    file.commit();
    Losses losses;
    losses.add(options.scene, writer.losses());
    if (!whole) {
        const std::string events = counted(writer.events(), "event", "events");
        const std::string by = options.until.empty() ? "--max-events" : "--until " + options.until;
        losses.add(options.output, {{"partial: stopped after " + events + " (" + by + ")", {}}});
    } else if (!options.until.empty()) {
        losses.add(options.output, {{"whole: the run never meets --until " + options.until, {}}});
    }
    return losses.report();
}

int trace_scene(const TraceOptions& options, const AdmittedScene& given) {
    const NamedKernel kernel = kernel_of(options);
    const AdmittedScene scene = scene_for(kernel, given, options.scene);
    expect_admitted(method_of(options), scene, options.scene);
    const RunRequest request = request_of(options, kernel, scene);
    return write_traced(TraceHeader{request.method, request.edition, kernel.name(), request.detail, scene}, request,
                        options);
}
int trace_scene(const TraceOptions& options, const Surface& surface) {
    const FloatingHorizonRequest request = request_of(options, surface);
    return write_traced(FloatingHorizonHeader{request.edition, request.kernel.name(), request.detail, surface}, request,
                        options);
}

int trace(TraceOptions options) {
    const AnyScene any = any_scene_for(options, true);
    return std::visit([&](const auto& scene) { return trace_scene(options, scene); }, any);
}

}  // namespace

void add_trace(CLI::App& program, int& status) {
    auto& command = *program.add_subcommand("trace", "Run a method and record every step");
    const auto options = std::make_shared<TraceOptions>();
    add_any_run_options(command, *options);
    command.add_option("--detail", options->detail, "The level of detail; each level adds events to the one before")
        ->check(CLI::IsMember(words(detail_names)))
        ->capture_default_str();
    auto* check = command.add_flag("--check", options->check,
                                   "Write the exact answer beside each decision, and mark wrong decisions");
    auto* most = command.add_option("--max-events", options->most_events, "Stop after this many events, and keep them")
                     ->check(a_count());
    command
        .add_option("--until", options->until,
                    "Stop after the first step at which this condition is met, such as 'W13 == 2' (vidno find --list)")
        ->excludes(most)
        ->excludes(check);
    command.add_option("-o", options->output, "The trace, .jsonl or .jsonl.gz; - for standard output")->required();
    command.footer(
        "Example: vidno trace scene.json --method warnock --detail signs -o run.jsonl.gz\n"
        "Exit status 1: the run lost something, --max-events or --until ended it, or it never met --until; standard "
        "error says what and where.\n"
        "A scene written by hand (greater z is nearer; names, colours and the window have defaults):\n" +
        std::string(example_scene));
    command.callback([options, &status] { status = trace(*options); });
}

}  // namespace vidno::cli
