#include <iostream>

#include "commands.h"
#include "figure/encoded.h"
#include "figure/floating_horizon_parts.h"
#include "format/trace_reader.h"
#include "output.h"
#include "picture/image.h"
#include "progress.h"
#include "state/floating_horizon_state.h"
#include "state/state.h"
#include "steps.h"

namespace vidno::cli {

namespace {

State state_of(const TraceReader& reader) { return State(reader.header()); }
FloatingHorizonState state_of(const FloatingHorizonTraceReader& reader) {
    return FloatingHorizonState(reader.header());
}

std::string hash_of(const State& state) { return picture_hash(state.picture()); }
std::string hash_of(const FloatingHorizonState& state) { return lines_hash(state.lines()); }

/// What was painted or drawn, in the format that the name says.
std::string encoded(const State& state, const std::string& name) { return encode_image(state.picture(), name); }
std::string encoded(const FloatingHorizonState& state, const std::string& name) {
    const Surface& surface = state.header().scene;
    return figures::encoded(figures::drawn_lines(state.lines(), surface.curves.area), {surface.name}, name);
}

/// What the file says of itself against what was read.
int verdict(const TraceFile& trace, const auto& state) {
    if (!is_whole(trace)) return 1;
    if (trace.end()->hash != hash_of(state)) {
        std::cerr << trace.place() << ": the events paint another picture than the trace says\n";
        return 1;
    }
    return 0;
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
    return options.step ? 0 : verdict(reader, state);
}

/// A trace of which only the events count.
struct Told {
    AnyTraceReader reader;
    EventText text;

    explicit Told(const std::string& file)
        : reader(open_trace(LineReader(file), file)),
          text(std::visit([](const auto& each) { return polygon_names(each.header().scene); }, reader)) {}

    /// None at the end.
    std::optional<std::string> next_line() {
        const auto event = std::visit([](auto& each) { return each.next(); }, reader);
        if (!event) return std::nullopt;
        Text line;
        event->visit([&](const auto& e) { text.line(line, e); });
        return line.string();
    }
};

}  // namespace

bool is_whole(const TraceFile& trace) {
    const std::string& place = trace.place();
    if (!trace.end()) {
        std::cerr << place << ": cut short: " << trace.events() << " events read, the last line is missing\n";
        return false;
    }
    if (trace.end()->partial) {
        std::cerr << place << ": partial: the run was stopped after " << trace.events() << " events\n";
        return false;
    }
    return true;
}

int replay(const ReplayOptions& options) {
    AnyTraceReader opened = open_trace(LineReader(options.trace), options.trace);
    return std::visit([&](auto& reader) { return replay_run(options, reader); }, opened);
}

int diff(const DiffOptions& options) {
    Told first(options.first);
    Told second(options.second);
    Progress progress("steps");
    for (std::uint64_t step = 1;; ++step) {
        progress.show(step);
        const auto a = first.next_line();
        const auto b = second.next_line();
        if (!a && !b) return 0;
        if (a == b) continue;
        progress.clear();
        std::cout << "the traces part at step " << step << "\n- " << a.value_or("(the end)\n") << "+ "
                  << b.value_or("(the end)\n");
        return 1;
    }
}

}  // namespace vidno::cli
