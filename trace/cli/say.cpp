#include <iostream>

#include "check/check.h"
#include "check/decision_of.h"
#include "choice/kernel_choice.h"
#include "cli/commands.h"
#include "cli/shared/losses.h"
#include "cli/shared/progress.h"
#include "cli/shared/read_numbers.h"
#include "cli/shared/run_options.h"
#include "cli/shared/trace_files.h"
#include "say/decision.h"
#include "say/pixel_history.h"
#include "say/sentence.h"
#include "say/verdict.h"
#include "scene/exact_scene.h"

namespace vidno::cli {

namespace {

using Step = std::uint64_t;

struct SayOptions {
    std::string trace, language = "en";
    std::optional<Step> step;
    std::optional<std::string> steps, pixel;
    bool calculation = false;
};

struct StepsSaid {
    Step first = 1;
    std::optional<Step> last{};  // none: to the end
};

/// `5..16`, both ends included.
StepsSaid steps_from(const std::string& text) {
    const std::string option = "--steps " + text;
    const auto dots = text.find("..");
    if (dots == text.npos) throw Refused(option + ": not A..B");
    const Step first = whole_number(text.substr(0, dots), option), last = whole_number(text.substr(dots + 2), option);
    if (first == 0 || first > last) throw Refused(option + ": this range contains no step");
    return {first, last};
}

StepsSaid chosen_steps(const SayOptions& options) {
    if (options.step == Step{0}) throw Refused("--step 0: the first step is 1");
    if (options.step) return {*options.step, *options.step};
    return options.steps ? steps_from(*options.steps) : StepsSaid{};
}

void print(const say::SaidDecision& decision) {
    std::cout << "    " << decision.title << '\n';
    for (const auto& [name, number] : decision.numbers) std::cout << "    " << name << " = " << number << '\n';
    for (const auto& [name, answer] : decision.answers) std::cout << "    " << name << ": " << answer << '\n';
    std::cout << "    " << decision.judgement << '\n';
    for (const auto& [title, lines] : decision.calculations) {
        std::cout << "    " << title << '\n';
        for (const auto& line : lines) std::cout << "        " << line << '\n';
    }
}

/// Counts the events of a run, and the steps with wrong decisions.
struct Counts {
    say::Tally tally{};
    std::uint64_t wrong_steps = 0;
    bool is_checked = false, was_disagree = false;

    void take(const EventView& event) {
        ++tally[event.place()];
        const bool is_disagree = event.get_if<event::Disagree>() != nullptr;
        wrong_steps += is_disagree && !was_disagree;
        was_disagree = is_disagree;
        const auto decision = decision_of(event);
        is_checked = is_checked || is_disagree || (decision && decision->checked.exact);
    }
};

/// How the picture of a whole run compares with the right one. Large ones are not compared, since that takes seconds.
say::Comparison compared(const State& end, const Counts&) {
    constexpr long long most_pixels = 1 << 20;
    constexpr std::size_t most_polygons = 5000;
    const Scene& scene = end.header().scene;
    const Area& area = scene.area;
    const bool is_large = static_cast<long long>(area.width) * area.height > most_pixels;
    if (is_large || scene.polygons.size() > most_polygons) return {};
    const Picture right = right_picture(exact_scene::admit(scene), end.header().method);
    return {say::Comparison::Is::known, different_pixels(end.screen().picture(), right)};
}
say::Comparison compared(const FloatingHorizonState& end, const Counts& counts) {
    const bool is_known = counts.is_checked || is_always_right(end.header().kernel);
    return {is_known ? say::Comparison::Is::known : say::Comparison::Is::unknown, counts.wrong_steps};
}

int say_steps(const SayOptions& options, auto& reader) {
    const auto language = Language(place_in(language_codes, options.language));
    const auto [first, last] = chosen_steps(options);
    auto state = state_of(reader);
    const AnyHeader header = reader.header();
    say::DecidingStep around;
    Counts counts;
    Progress progress("steps");
    const auto print_decision = [&] {
        const auto said = say::decision(around, header, language);
        if (said) print(*said);
    };
    const auto take = [&, first = first, last = last](const EventView& event) {
        state.apply(event);
        counts.take(event);
        progress.show(state.step());
        if (options.calculation) {
            around = {std::move(around.event), std::move(around.next), event.copy()};
            if (state.step() > first) print_decision();
        }
        if (state.step() < first || (last && state.step() > *last)) return;
        progress.clear();
        std::cout << state.step() << ": " << say::sentence(event, state, language).whole() << '\n';
    };
    // The event after the last one may be the verdict on its decision.
    const auto beyond = last ? std::optional(*last + options.calculation) : std::nullopt;
    while (state.step() != beyond && take_next(reader, take)) {
    }
    progress.clear();
    if (state.step() < last.value_or(0)) refuse_step(options.trace, *last, state.step());
    if (options.calculation && state.step() != beyond) {
        around = {std::move(around.event), std::move(around.next), std::nullopt};
        print_decision();
    }
    if (first == 1 && !last && !reader.lacks()) {
        std::cout << say::verdict(header, counts.tally, compared(state, counts), language) << '\n';
    }
    Losses losses;
    losses.add(reader);
    return losses.report();
}

Area area_of(const State& state) { return state.header().scene.area; }
Area area_of(const FloatingHorizonState& state) { return state.header().scene.curves->area; }

/// The steps that concern a pixel, each with what it means for it, and why it has its colour.
int say_history(const SayOptions& options, auto& reader) {
    constexpr std::array<std::string_view, say::outcome_names.size()> signs{"✓", "✗", "■", "!", "·"};
    const auto language = Language(place_in(language_codes, options.language));
    auto state = state_of(reader);
    const Pixel pixel = pixel_in(*options.pixel, area_of(state));
    say::PixelStory story(pixel, reader.header(), language);
    Progress progress("steps");
    const auto take = [&](const EventView& event) {
        state.apply(event);
        progress.show(state.step());
        const auto entry = story.take(event, state);
        if (!entry) return;
        progress.clear();
        std::cout << state.step() << ": " << signs[std::size_t(entry->outcome)] << ' ' << entry->said.whole() << '\n';
    };
    while (take_next(reader, take)) {
    }
    progress.clear();
    if (!story.why().empty()) std::cout << story.why() << '\n';
    Losses losses;
    losses.add(reader);
    return losses.report();
}

int say_run(const SayOptions& options) {
    AnyTraceReader opened = open_trace(LineReader(options.trace), options.trace);
    return std::visit(
        [&](auto& reader) { return options.pixel ? say_history(options, reader) : say_steps(options, reader); },
        opened);
}

}  // namespace

void add_say(CLI::App& program, int& status) {
    auto& command = *program.add_subcommand("say", "Say in words what happens in a run, one line a step");
    const auto options = std::make_shared<SayOptions>();
    command.add_option("TRACE", options->trace, "A trace, .jsonl or .jsonl.gz; - for standard input")->required();
    auto* step = command.add_option("--step", options->step, "One step, as a number of events [all]");
    auto* steps = command.add_option("--steps", options->steps, "The steps A..B, both included")->excludes(step);
    command
        .add_option("--pixel", options->pixel,
                    "X,Y: the steps that concern this pixel, or, of curves, the column X; and why it has its colour")
        ->excludes(step)
        ->excludes(steps);
    command
        .add_flag("--calculation", options->calculation,
                  "Also each decision: its numbers, its answer, the exact one, and the calculation of a checked trace")
        ->excludes("--pixel");
    command.add_option("--language", options->language, "The language")
        ->check(CLI::IsMember(words(language_codes)))
        ->capture_default_str();
    command.footer(
        "The sentences are those of the page and of the captions of figures. After all steps, the last line is the "
        "verdict on the run. A pixel passes a test (✓) or not (✗), is "
        "painted (■), or meets a wrong decision (!). Exit status 1: the trace was cut short, is partial, or its run "
        "lost something.");
    command.callback([options, &status] { status = say_run(*options); });
}

}  // namespace vidno::cli
