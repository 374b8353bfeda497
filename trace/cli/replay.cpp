#include <iostream>

#include "commands.h"
#include "image.h"
#include "output.h"
#include "progress.h"
#include "state.h"
#include "trace_reader.h"

namespace vidno::cli {

namespace {

/// The state after the next event, false at the end.
bool advance(TraceReader& reader, State& state) {
    const auto event = reader.next();
    if (!event) return false;
    try {
        state.apply(*event);
    } catch (const Impossible& impossible) {
        throw Refused(reader.place() + ": step " + std::to_string(state.step() + 1) + ": " + impossible.reason);
    }
    return true;
}

/// What the file says of itself against what was read.
int verdict(const TraceReader& reader, const State& state) {
    if (!is_whole(reader)) return 1;
    if (reader.end()->picture != picture_hash(state.picture())) {
        std::cerr << reader.place() << ": the events paint another picture than the trace says\n";
        return 1;
    }
    return 0;
}

}  // namespace

bool is_whole(const TraceReader& reader) {
    const std::string& place = reader.place();
    if (!reader.end()) {
        std::cerr << place << ": cut short: " << reader.events() << " events read, the last line is missing\n";
        return false;
    }
    if (reader.end()->partial) {
        std::cerr << place << ": partial: the run was stopped after " << reader.events() << " events\n";
        return false;
    }
    return true;
}

int replay(const ReplayOptions& options) {
    const bool all_states = options.output.ends_with(".jsonl");
    const bool one_state = options.output.ends_with(".json");
    if (!all_states && !one_state) encode_image(Picture({0, 0, 1, 1}, {}), options.output);

    TraceReader reader(LineReader(options.trace), options.trace);
    State state(reader.header());
    OutputFile file(options.output);
    Progress progress("steps");
    if (all_states) file.write(state_json(state));
    while (state.step() != options.step && advance(reader, state)) {
        progress.show(state.step());
        if (all_states) file.write(state_json(state));
    }
    if (options.step && state.step() < *options.step) {
        throw Refused(options.trace + ": there is no step " + std::to_string(*options.step) + ", the last is " +
                      std::to_string(state.step()));
    }
    if (one_state) file.write(state_json(state));
    if (!all_states && !one_state) file.write(encode_image(state.picture(), options.output));
    file.commit();
    progress.clear();
    return options.step ? 0 : verdict(reader, state);
}

int diff(const DiffOptions& options) {
    TraceReader first(LineReader(options.first), options.first);
    TraceReader second(LineReader(options.second), options.second);
    EventText first_text(polygon_names(first.header().scene));
    EventText second_text(polygon_names(second.header().scene));
    const auto line_of = [](const std::optional<Event>& event, EventText& text) {
        Text line;
        if (event) std::visit([&](const auto& e) { text.line(line, e); }, *event);
        return event ? line.string() : "(the end)\n";
    };
    Progress progress("steps");
    for (std::uint64_t step = 1;; ++step) {
        progress.show(step);
        const auto a = first.next();
        const auto b = second.next();
        if (!a && !b) return 0;
        const std::string line_a = line_of(a, first_text);
        const std::string line_b = line_of(b, second_text);
        if (line_a == line_b) continue;
        progress.clear();
        std::cout << "the traces part at step " << step << "\n- " << line_a << "+ " << line_b;
        return 1;
    }
}

}  // namespace vidno::cli
