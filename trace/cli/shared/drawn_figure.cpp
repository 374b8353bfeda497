#include "cli/shared/drawn_figure.h"

#include <filesystem>
#include <iostream>

#include "chart/chart.h"
#include "check/seen_failure.h"
#include "choice/method.h"
#include "cli/shared/read_numbers.h"
#include "cli/shared/run_options.h"
#include "cli/shared/scene_files.h"
#include "cli/shared/trace_files.h"
#include "event_table/joined_texts.h"
#include "figure/encoded.h"
#include "figure/figure.h"
#include "figure/figure_words.h"
#include "figure/floating_horizon_parts.h"
#include "figure/map_figure.h"
#include "figure/titles.h"
#include "format/trace_reader.h"
#include "json/document_format.h"
#include "lesson/event_lines.h"
#include "lesson/lesson.h"
#include "output.h"
#include "page/program.h"
#include "scene/scene_names.h"
#include "sign_map/mapped_decision_json.h"

namespace vidno::cli {

namespace {

using figures::About;
using figures::encoded;
using figures::Format;
using figures::format_of;
constexpr std::uint64_t most_panels = 200;
constexpr double column_width = 80, page_width = 170, slide_width = 140, slide_height = 72;  // millimetres

[[noreturn]] void refuse(const std::string& option, const std::string& reason) {
    throw Refused(option + ": " + reason);
}

std::vector<std::string> split(const std::string& text, const std::string& by) {
    std::vector<std::string> parts;
    std::size_t from = 0;
    for (auto at = text.find(by); at != text.npos; at = text.find(by, from)) {
        parts.push_back(text.substr(from, at - from));
        from = at + by.size();
    }
    parts.push_back(text.substr(from));
    return parts;
}

/// `7`, `7,9,40`, `7..40` or `7..40:3`.
std::vector<std::uint64_t> steps_of(const std::string& text) {
    const std::string option = "--steps " + text;
    std::vector<std::uint64_t> steps;
    const auto ends = split(text, "..");
    if (ends.size() == 1) {
        for (const auto& each : split(text, ",")) steps.push_back(whole_number(each, option));
        if (!std::is_sorted(steps.begin(), steps.end(), std::less_equal<>()))
            refuse(option, "the steps must be in increasing order");
    } else {
        const auto last = split(ends[1], ":");
        if (ends.size() > 2 || last.size() > 2) refuse(option, "not A..B or A..B:BY");
        const std::uint64_t first = whole_number(ends[0], option);
        const std::uint64_t end = whole_number(last[0], option);
        const std::uint64_t by = last.size() == 2 ? whole_number(last[1], option) : 1;
        if (by == 0 || first > end) refuse(option, "this range contains no step");
        if ((end - first) / by >= most_panels) refuse(option, "more than " + std::to_string(most_panels) + " steps");
        for (std::uint64_t step = first; step <= end; step += by) steps.push_back(step);
    }
    if (steps.size() > most_panels) refuse(option, "more than " + std::to_string(most_panels) + " steps");
    return steps;
}

/// `80`, `80mm` or `8cm`, in millimetres.
double length_of(const std::string& text) {
    constexpr double least = 30, most = 1000;
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const std::string unit(error == std::errc() ? end : "?");
    if (unit == "cm") number *= 10;
    if (unit != "cm" && unit != "mm") refuse("--width " + text, "not a length in mm or cm");
    if (!(number >= least && number <= most)) refuse("--width " + text, "not between 3 cm and 1 m");
    return number;
}

std::vector<figures::Part> parts_of(const FigureOptions& options) {
    std::vector<figures::Part> parts;
    for (const auto& name : split(options.show, ",")) {
        const auto place = place_in(figures::part_names, name);
        if (place == figures::part_names.size()) {
            const auto names = joined_texts(figures::part_names, ", ", [](auto each) { return std::string(each); });
            refuse("--show " + options.show, name + " is not one of " + names);
        }
        parts.push_back(figures::Part(place));
    }
    return parts;
}

figures::Style style_of(const FigureOptions& options) {
    return {Language(place_in(language_codes, options.language)), options.greyscale};
}

/// Reads a trace and draws the requested steps on the way; without steps, the last one. Calls back for each event.
void go_through(TraceFile& trace, auto& moment, const std::vector<std::uint64_t>& steps, const std::string& file,
                Losses& losses, auto&& draw, auto&& hear) {
    std::size_t next = 0;
    const auto draw_if_wanted = [&] {
        if (next == steps.size() || moment.state().step() != steps[next]) return;
        draw();
        ++next;
    };
    draw_if_wanted();
    const auto take = [&](const EventView& event) { moment.take(event); };
    while ((steps.empty() || next < steps.size()) && take_next(trace, take)) {
        hear();
        draw_if_wanted();
    }
    if (steps.empty()) draw();
    if (next < steps.size()) refuse_step(file, steps[next], moment.state().step());
    losses.add(trace);
}

/// The history of the chosen pixel, if it is shown.
std::optional<figures::PixelHistory> history_in(const FigureOptions& options, const figures::Options& drawing,
                                                const TraceHeader& header) {
    if (!drawing.shows(figures::Part::history)) {
        if (!options.pixel.empty()) refuse("--pixel", "needs --show history");
        return std::nullopt;
    }
    if (options.pixel.empty()) refuse("--show history", "needs --pixel X,Y");
    return figures::PixelHistory(pixel_in(options.pixel, header.scene.area), header, drawing.style.language);
}

figures::Figure drawn(TraceReader& reader, const std::vector<std::uint64_t>& steps, const figures::Options& drawing,
                      const FigureOptions& options, Losses& losses) {
    auto history = history_in(options, drawing, reader.header());
    figures::Figure figure(drawing);
    figures::Moment moment(reader.header());
    const auto draw = [&] { figure.add(moment, history); };
    const auto hear = [&] {
        if (history) history->take(moment);
    };
    go_through(reader, moment, steps, options.input, losses, draw, hear);
    return figure;
}

figures::Figure drawn(FloatingHorizonTraceReader& reader, const std::vector<std::uint64_t>& steps,
                      const figures::Options& drawing, const FigureOptions& options, Losses& losses) {
    if (!options.pixel.empty()) refuse("--pixel", "a run of curves paints no pixels");
    figures::Figure figure(drawing);
    figures::FloatingHorizonMoment moment(reader.header());
    go_through(
        reader, moment, steps, options.input, losses, [&] { figure.add(moment); }, [] {});
    if (drawing.shows(figures::Part::picture)) {
        const figures::Plane plane = figures::plane_in(moment.scene().area, column_width, column_width);
        losses.add(options.input, figures::cut_curves(moment.state().values().lines, plane));
    }
    return figure;
}

std::string method_in(const TraceHeader& header, Language language) {
    return figures::title_of(header.method, language);
}
std::string method_in(const FloatingHorizonHeader&, Language language) {
    return std::string(floating_horizon_choice.title.in(language));
}

std::string title_of(const auto& header, const std::vector<std::uint64_t>& steps, const std::string& given,
                     Language language) {
    const std::string name = given.empty() ? name_in(language, header.scene.name) : given;
    std::string title = name.empty() ? "" : name + " · ";
    title += method_in(header, language);
    if (!steps.empty()) {
        title += " · " + std::string(figures::words_of(language).step) + " " + std::to_string(steps.front());
    }
    return title + (steps.size() > 1 ? "–" + std::to_string(steps.back()) : "");
}

struct FigureSteps {
    LineReader lines;
    std::vector<std::uint64_t> steps;
    std::string name{};  // in the figure's language; empty: the scene's
};

/// A pin is a step of its lesson's run, so the run is traced first.
FigureSteps pinned_step(const FigureOptions& options) {
    Problems problems;
    const Lesson lesson = read_lesson(options.input, problems);
    const auto& pins = lesson.pins;
    const auto pin = std::find_if(pins.begin(), pins.end(), [&](const Pin& each) { return each.name == options.pin; });
    if (pin == pins.end()) refuse("--pin " + options.pin, options.input + " has no such pin");
    const LessonRun& run = lesson.run(pin->run);
    std::string text;
    PinSearch search(*pin);
    EventLines lines;
    trace_run(scene_of(lesson, run), run, [&](std::string_view part) {
        text += part;
        lines.take(part, [&](std::uint64_t step, std::string_view line) { search.hear(step, line); });
    });
    if (!search.step()) refuse("--pin " + options.pin, search.objection());
    return {LineReader::of_text(std::move(text)), {*search.step()}};
}

/// A failure is traced as it fails, and drawn at the step where it is seen unless another step is given.
FigureSteps failure_steps(const FigureOptions& options) {
    const Failure failure = read_failure(read_text(options.input), options.input);
    say(failure, options.input);
    std::string text;
    write_failing_run(failure, [&](std::string_view part) { text += part; });
    std::vector<std::uint64_t> steps;
    if (options.step) {
        steps = {*options.step};
    } else if (!options.steps.empty()) {
        steps = steps_of(options.steps);
    } else if (const auto step = seen(failure).step) {
        steps = {*step};
    }
    return {LineReader::of_text(std::move(text)), steps, failure.title.in(style_of(options).language)};
}

FigureSteps figure_steps(const FigureOptions& options) {
    const bool is_lesson = std::filesystem::is_directory(options.input);
    if (is_lesson != !options.pin.empty())
        refuse(options.input, "--pin is required for the folder of a lesson, and only there");
    if (is_lesson) return pinned_step(options);
    if (options.input.ends_with(".json")) return failure_steps(options);
    LineReader lines(options.input);
    if (options.step) return {std::move(lines), {*options.step}};
    if (!options.steps.empty()) return {std::move(lines), steps_of(options.steps)};
    return {std::move(lines), {}};
}

/// For a film, the ways to encode it: SVG for "-".
bool is_svg(const std::string& output) { return output == "-" || output.ends_with(".svg"); }

void expect_film(const FigureOptions& options) {
    const std::string& output = options.output;
    if (!is_svg(output) && !output.ends_with(".gif") && !output.ends_with(".mp4")) {
        refuse(output, "a film is .svg, .gif or .mp4");
    }
    if (options.steps.empty()) refuse("--film", "needs --steps A..B");
    if (options.beamer) refuse("--film", "not together with --beamer");
}

/// The frames as a film: SVG by this program, GIF and MP4 by ffmpeg from PNGs.
std::string film(const std::vector<figures::Drawing>& frames, const About& about, const FigureOptions& options) {
    if (is_svg(options.output)) return film_of(frames, options.rate, about);
    std::string pictures;
    for (const auto& frame : frames) pictures += figures::png_of(svg_of(frame, about), options.dots_an_inch);
    std::vector<std::string> command{
        "ffmpeg", "-v", "error", "-f", "image2pipe", "-c:v", "png", "-framerate", figures::decimal(options.rate),
        "-i",     "-"};
    const auto add = [&](std::initializer_list<const char*> words) {
        command.insert(command.end(), words.begin(), words.end());
    };
    if (options.output.ends_with(".gif")) {
        add({"-vf", "split[a][b];[a]palettegen[p];[b][p]paletteuse", "-f", "gif", "-"});
    } else {  // an even size, and no seeking in the output, which is a pipe
        add({"-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p", "-movflags", "frag_keyframe+empty_moov",
             "-f", "mp4", "-"});
    }
    return output_of(command, pictures);
}

/// Says which engine typesets a .tex file, if it is not the usual one.
void say_engine(const std::string& output, const std::vector<figures::Drawing>& panels) {
    const std::string beyond = figures::beyond_pdflatex(panels);
    if (beyond.empty()) return;
    std::cerr << output << ": typeset it with LuaLaTeX or XeLaTeX and a font that has " << beyond
              << ": pdfLaTeX lacks these characters\n";
}

std::string drawn_trace(const FigureOptions& options, Losses& losses) {
    if (options.film) expect_film(options);
    if (options.beamer && format_of(options.output) != Format::tikz) refuse("--beamer", "writes only .tex files");
    auto [lines, steps, name] = figure_steps(options);

    figures::Options drawing{.show = parts_of(options), .style = style_of(options)};
    if (!options.film && format_of(options.output) == Format::tikz) drawing.style.letters = figures::letters_of_tex;
    drawing.is_film = options.film;
    drawing.width = steps.size() > 1 && !options.film ? page_width : column_width;
    if (options.beamer) {
        drawing.width = slide_width;
        drawing.most_height = slide_height;
    }
    if (!options.width.empty()) drawing.width = length_of(options.width);

    drawing.moments = std::max<std::size_t>(steps.size(), 1);
    AnyTraceReader opened = open_trace(std::move(lines), options.input);
    const auto draw = [&, &steps = steps, &name = name](auto& reader) {
        const About about{title_of(reader.header(), steps, name, drawing.style.language), drawing.style.language};
        const figures::Figure figure = drawn(reader, steps, drawing, options, losses);
        if (options.film) return film(figure.panels(), about, options);
        if (drawing.style.letters == figures::letters_of_tex) say_engine(options.output, figure.panels());
        if (options.beamer) return beamer_of(figure.panels(), about);
        return encoded(figure.strip(), about, options.output, options.dots_an_inch);
    };
    return std::visit(draw, opened);
}

/// A drawing without steps has no parts to choose either, and no TikZ.
void expect_no_steps(const FigureOptions& options) {
    if (options.step || !options.steps.empty()) refuse(options.input, "maps and charts have no steps");
    if (!options.pixel.empty() || options.beamer) refuse(options.input, "--pixel and --beamer are for traces");
    if (options.film) refuse(options.input, "--film is for traces");
    if (format_of(options.output) == Format::tikz) refuse(options.output, "maps and charts are .svg, .pdf or .png");
}

std::string drawn_map(const FigureOptions& options, const std::string& text) {
    expect_no_steps(options);
    const NamedKernel kernel = *kernel_named(options.kernel);
    if (kernel.snaps()) throw Refused("--kernel grid: the places of a map do not lie on a grid");
    const SignMap map = sign_map(read_mapped_decision(text, options.input), kernel);
    const double width = options.width.empty() ? column_width : length_of(options.width);
    const figures::Style style = style_of(options);
    return encoded(figures::map_figure(map, style, width), {name_in(style.language, map.name), style.language},
                   options.output, options.dots_an_inch);
}

std::string drawn_chart(const FigureOptions& options, const std::string& text) {
    expect_no_steps(options);
    const figures::Style style = style_of(options);
    const auto panels = panels_of(read_chart(text, options.input), options.axes, style.language);
    const double width = options.width.empty() ? usual_width_of(panels) : length_of(options.width);
    return encoded(figures::chart_figure(panels, style, width), {panels.front().title, style.language}, options.output,
                   options.dots_an_inch);
}

}  // namespace

void add_figure_options(CLI::App& command, FigureOptions& options) {
    command
        .add_option(
            "TRACE|LESSON|FAILURE|DECISION|CHART", options.input,
            "A trace (.jsonl, .jsonl.gz, - for standard input), the folder of a lesson, or a .json file: a failure, a "
            "decision to map, or a chart")
        ->required();
    auto* step =
        command.add_option("--step", options.step, "The step to draw [the last; for a failure, the one that shows it]");
    auto* steps = command.add_option("--steps", options.steps, "A film strip: N,M,... or A..B or A..B:BY");
    command.add_option("--pin", options.pin, "For a lesson: the step of this pin")->excludes(step)->excludes(steps);
    steps->excludes(step);
    command
        .add_option("--show", options.show,
                    "Any of picture, windows (the scanline of the Z-buffer, the horizons of curves, the lists of "
                    "weiler-atherton), list (the APL, the AEL, or the current list), listing, history")
        ->capture_default_str();
    command.add_option("--pixel", options.pixel, "X,Y: the pixel whose history is shown");
    command.add_option("--language", options.language, "The language of the figure")
        ->check(CLI::IsMember(words(language_codes)))
        ->capture_default_str();
    command.add_option("--width", options.width, "In cm or mm [8cm; for a film strip 17cm, for a slide 14cm]");
    command.add_option("--kernel", options.kernel, "For a map: the arithmetic")
        ->check(a_kernel())
        ->capture_default_str();
    add_axes(command, options.axes, "For a chart: the horizontal axis [time]");
    command.add_option("--dpi", options.dots_an_inch, "For .png: dots per inch")
        ->check(CLI::Range(30, 2400))
        ->capture_default_str();
    command.add_flag("--greyscale", options.greyscale, "Darker textures instead of colours");
    command.add_flag("--beamer", options.beamer, "A slide with one overlay per step, .tex");
    command.add_flag("--film", options.film, "A film of --steps A..B, .svg; .gif and .mp4 need ffmpeg");
    command.add_option("--rate", options.rate, "For a film: steps per second")
        ->check(CLI::Range(0.1, 25.))
        ->capture_default_str();
    command.add_option("-o", options.output, "The figure, .svg, .pdf, .png or .tex; - writes SVG to standard output")
        ->required();
}

FigureOptions figure_options(const std::string& command) {
    CLI::App app("", "vidno");
    app.require_subcommand(1);
    FigureOptions options;
    add_figure_options(*app.add_subcommand("figure"), options);
    try {
        app.parse(command, true);
    } catch (const CLI::ParseError& error) {
        throw Refused(error.what());
    }
    return options;
}

std::string drawn_figure(const FigureOptions& options, Losses& losses) {
    if (!options.film) format_of(options.output);
    expect_no_mesh(options.input);
    if (!options.input.ends_with(".json")) return drawn_trace(options, losses);
    const std::string text = read_text(options.input);
    if (is_failure(text)) return drawn_trace(options, losses);
    if (is_surface(text))
        throw Refused(options.input + ": a surface; vidno render draws surfaces, and vidno figure draws their traces");
    const bool is_chart = are_of_one_kind(document_format(text), chart_format);
    return (is_chart ? drawn_chart : drawn_map)(options, text);
}

}  // namespace vidno::cli
