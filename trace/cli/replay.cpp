#include "cli/commands.h"
#include "cli/shared/losses.h"
#include "cli/shared/progress.h"
#include "cli/shared/trace_files.h"
#include "figure/encoded.h"
#include "figure/floating_horizon_parts.h"
#include "format/trace_reader.h"
#include "output.h"
#include "picture/image.h"

namespace vidno::cli {

namespace {

struct ReplayOptions {
    std::string trace, output;
    std::optional<std::uint64_t> step;
};

std::string hash_of(const State& state) { return picture_hash(state.picture()); }
std::string hash_of(const FloatingHorizonState& state) { return lines_hash(state.values().lines); }

/// The painted picture or the drawn lines, in the format given by the file name.
std::string encoded(const State& state, const std::string& name) { return encode_image(state.picture(), name); }
std::string encoded(const FloatingHorizonState& state, const std::string& name) {
    const Surface& surface = state.header().scene;
    return figures::encoded(figures::drawn_lines(state.values().lines, surface.curves->area), {surface.name}, name);
}

/// The curves that a picture does not show whole.
std::vector<Loss> cut_curves(const State&) { return {}; }
std::vector<Loss> cut_curves(const FloatingHorizonState& state) {
    const Area& area = state.header().scene.curves->area;
    return figures::cut_curves(state.values().lines, figures::plane_without_frame(area));
}

/// Compares the file's last line with what was read.
void expect_stated(const TraceFile& trace, const auto& state, Losses& losses) {
    if (!trace.end() || trace.end()->partial || trace.end()->hash == hash_of(state)) return;
    losses.add(trace.place(), {{"the events do not paint the picture that the trace states", {}}});
}

int replay_run(const ReplayOptions& options, auto& reader) {
    const bool all_states = options.output.ends_with(".jsonl");
    const bool one_state = options.output.ends_with(".json");
    auto state = state_of(reader);
    if (!all_states && !one_state) encoded(state, options.output);  // refuses a wrong name before the work

    OutputFile file(options.output);
    Progress progress("steps");
    if (all_states) file.write(state_json(state));
    const auto apply = [&](const EventView& event) { state.apply(event); };
    while (state.step() != options.step && take_next(reader, apply)) {
        progress.show(state.step());
        if (all_states) file.write(state_json(state));
    }
    if (options.step && state.step() < *options.step) {
        refuse_step(options.trace, *options.step, state.step());
    }
    if (one_state) file.write(state_json(state));
    if (!all_states && !one_state) file.write(encoded(state, options.output));
    file.commit();
    progress.clear();
    Losses losses;
    if (!all_states && !one_state) losses.add(options.trace, cut_curves(state));
    losses.add(reader);
    if (!options.step) expect_stated(reader, state, losses);
    return losses.report();
}

int replay(const ReplayOptions& options) {
    AnyTraceReader opened = open_trace(LineReader(options.trace), options.trace);
    return std::visit([&](auto& reader) { return replay_run(options, reader); }, opened);
}

}  // namespace

void add_replay(CLI::App& program, int& status) {
    auto& command = *program.add_subcommand("replay", "Rebuild the picture from the events of a trace alone");
    const auto options = std::make_shared<ReplayOptions>();
    command.add_option("TRACE", options->trace, "A trace, .jsonl or .jsonl.gz; - for standard input")->required();
    command.add_option("--step", options->step, "The step, as a number of events [all]");
    command
        .add_option("-o", options->output,
                    "The picture, .png or .ppm; for curves .svg, .pdf, .png or .tex; or the whole state: .json at that "
                    "step, .jsonl at every step")
        ->required();
    command.footer(
        "Exit status 1: the trace was cut short, is partial, its run lost something, or it does not paint the picture "
        "that it states.");
    command.callback([options, &status] { status = replay(*options); });
}

}  // namespace vidno::cli
