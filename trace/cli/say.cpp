#include <charconv>
#include <iostream>

#include "cli/commands.h"
#include "cli/shared/losses.h"
#include "cli/shared/progress.h"
#include "cli/shared/run_options.h"
#include "cli/shared/trace_files.h"
#include "say/sentence.h"

namespace vidno::cli {

namespace {

using Step = std::uint64_t;

struct SayOptions {
    std::string trace, language = "en";
    std::optional<Step> step;
    std::optional<std::string> steps;
};

struct Steps {
    Step first = 1;
    std::optional<Step> last{};  // none: to the end
};

/// `5..16`, both ends included.
Steps steps_from(const std::string& text) {
    const auto number = [&](std::string_view part) {
        Step read = 0;
        const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), read);
        if (error != std::errc() || end != part.data() + part.size()) throw Refused("--steps " + text + ": not A..B");
        return read;
    };
    const std::size_t dots = std::min(text.find(".."), text.size());
    const Steps steps{number(std::string_view(text).substr(0, dots)),
                      number(std::string_view(text).substr(std::min(dots + 2, text.size())))};
    if (steps.first == 0 || steps.first > *steps.last)
        throw Refused("--steps " + text + ": this range contains no step");
    return steps;
}

Steps chosen_steps(const SayOptions& options) {
    if (options.step == Step{0}) throw Refused("--step 0: the first step is 1");
    if (options.step) return {*options.step, *options.step};
    return options.steps ? steps_from(*options.steps) : Steps{};
}

State state_before(const TraceReader& reader) { return State(reader.header()); }
FloatingHorizonState state_before(const FloatingHorizonTraceReader& reader) {
    return FloatingHorizonState(reader.header());
}

int say_steps(const SayOptions& options, auto& reader) {
    const auto language = Language(place_in(language_codes, options.language));
    const auto [first, last] = chosen_steps(options);
    auto state = state_before(reader);
    Progress progress("steps");
    const auto take = [&, first = first](const EventView& event) {
        state.apply(event);
        progress.show(state.step());
        if (state.step() < first) return;
        progress.clear();
        std::cout << state.step() << ": " << say::sentence(event, state, language) << '\n';
    };
    while (state.step() != last && take_next(reader, take)) {
    }
    progress.clear();
    if (state.step() < last.value_or(0)) refuse_step(options.trace, *last, state.step());
    Losses losses;
    losses.add(reader);
    return losses.told();
}

int say_run(const SayOptions& options) {
    AnyTraceReader opened = open_trace(LineReader(options.trace), options.trace);
    return std::visit([&](auto& reader) { return say_steps(options, reader); }, opened);
}

}  // namespace

void add_say(CLI::App& program, int& status) {
    auto& command = *program.add_subcommand("say", "Say in words what happens in a run, one line a step");
    const auto options = std::make_shared<SayOptions>();
    command.add_option("TRACE", options->trace, "A trace, .jsonl or .jsonl.gz; - for standard input")->required();
    auto* step = command.add_option("--step", options->step, "One step, as a number of events [all]");
    command.add_option("--steps", options->steps, "The steps A..B, both included")->excludes(step);
    command.add_option("--language", options->language, "The language")
        ->check(CLI::IsMember(words(language_codes)))
        ->capture_default_str();
    command.footer(
        "The sentences are those of the page and of the captions of figures. Exit status 1: the trace was cut short, "
        "is "
        "partial, or its run lost something.");
    command.callback([options, &status] { status = say_run(*options); });
}

}  // namespace vidno::cli
