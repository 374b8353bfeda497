#include "figure/worksheet.h"

#include "choice/method.h"
#include "cli/commands.h"
#include "cli/shared/losses.h"
#include "cli/shared/progress.h"
#include "cli/shared/read_numbers.h"
#include "cli/shared/run_options.h"
#include "cli/shared/scene_files.h"
#include "cli/shared/trace_files.h"
#include "figure/figure_words.h"
#include "figure/writers.h"
#include "output.h"
#include "page/page.h"
#include "page/program.h"
#include "scene/scene_names.h"

namespace vidno::cli {

namespace {

struct WorksheetOptions {
    std::vector<std::string> files;  // scenes for sheets, one trace for questions
    std::string language = "en", output;
    std::optional<std::string> method, key, rows, steps;  // of sheets
    std::optional<int> count;                             // of questions
};

void expect_pdf(const std::string& name) {
    if (!name.ends_with(".pdf")) throw Refused(name + ": not .pdf or .xml");
}

/// The scenes in order, each on its own pages.
class Sheets {
public:
    Sheets(bool answered, Language language, const std::optional<figures::ChosenRows>& chosen)
        : answered_(answered), language_(language), chosen_(chosen) {}

    void add(const auto& run, const std::string& name) {
        const figures::About about{name_in(language_, name), language_};
        if (pages_.empty()) about_ = about;
        for (const auto& page : figures::worksheet(run, language_, answered_, chosen_)) {
            pages_.push_back(figures::svg_of(page, about));
        }
    }
    std::string pdf() const { return figures::pdf_of(pages_, about_); }

private:
    bool answered_;
    Language language_;
    std::optional<figures::ChosenRows> chosen_;
    figures::About about_{};
    std::vector<std::string> pages_;
};

/// `12` is 1 to 12, `5..16` both ends included.
figures::ChosenRows chosen_from(const std::string& text, bool are_steps) {
    const std::string option = std::string(are_steps ? "--steps " : "--rows ") + text;
    figures::ChosenRows chosen{.are_steps = are_steps};
    const auto read = [&](std::string_view part, std::uint64_t& to) {
        if (!is_read(part, to)) throw Refused(option + ": not N or A..B");
    };
    const auto dots = text.find("..");
    if (dots != text.npos) read(std::string_view(text).substr(0, dots), chosen.first);
    read(std::string_view(text).substr(dots == text.npos ? 0 : dots + 2), chosen.last);
    if (chosen.first > chosen.last || chosen.last == 0) throw Refused(option + ": this range contains no row");
    return chosen;
}

std::optional<figures::ChosenRows> chosen_rows(const WorksheetOptions& options) {
    if (options.rows) return chosen_from(*options.rows, false);
    if (options.steps) return chosen_from(*options.steps, true);
    return std::nullopt;
}

/// The questions that the page asks about a trace, as Moodle XML.
std::string asked_about(const std::string& trace, const WorksheetOptions& options) {
    const std::string count = std::to_string(options.count.value_or(20));
    const std::string bytes = read_file(trace);
    try {
        return output_of({"node", questions_script(), "--language", options.language, "--count", count}, bytes);
    } catch (const Refused& refused) {
        throw Refused(trace + ": " + refused.what());
    }
}

/// Questions about the next step of a trace's run, made by Node.
int moodle_questions(const WorksheetOptions& options) {
    if (options.files.size() > 1) throw Refused(options.files[1] + ": an .xml file has the questions about one trace");
    if (options.method || options.key) throw Refused("--method and --key are for sheets, which are .pdf");
    if (options.rows || options.steps) throw Refused("--rows and --steps are for sheets, which are .pdf");
    const std::string& trace = options.files[0];
    if (!is_trace(trace)) throw Refused(trace + ": not .jsonl or .jsonl.gz");
    TraceReader reader(LineReader(trace), trace);
    while (reader.next()) {
    }
    write_file(options.output, asked_about(trace, options));
    Losses losses;
    losses.add(reader);
    return losses.report();
}

/// Runs a scene of the options and hands on what is worked by hand.
void work(const AdmittedScene& scene, const RunOptions& options, const auto& add) {
    figures::expect_room(scene, options.scene);
    expect_admitted(method_of(options), scene, options.scene);
    add(figures::WorkedRun(scene, method_of(options)), scene->name);
}
void work(const Surface& surface, const RunOptions& options, const auto& add) {
    figures::expect_room(surface.curves, options.scene);
    add(figures::WorkedCurves(surface), surface.name);
}

int worksheet(const WorksheetOptions& options) {
    if (options.output.ends_with(".xml")) return moodle_questions(options);
    expect_pdf(options.output);
    if (options.key) expect_pdf(*options.key);
    if (options.key == options.output) throw Refused("--key " + *options.key + ": this file gets the blank sheets");
    if (options.count) throw Refused("--count: " + options.output + " gets sheets, not questions");
    const auto language = Language(place_in(language_codes, options.language));
    const auto chosen = chosen_rows(options);
    Sheets blank(false, language, chosen), key(true, language, chosen);
    Progress progress("scenes");
    for (std::size_t i = 0; i < options.files.size(); ++i) {
        RunOptions run{options.files[i], options.method, {}, {}};
        const AnyScene any = any_scene_for(run);
        const auto add = [&](const auto& worked, const std::string& name) {
            blank.add(worked, name);
            if (options.key) key.add(worked, name);
        };
        std::visit([&](const auto& scene) { work(scene, run, add); }, any);
        progress.show(i + 1, options.files.size());
    }
    progress.clear();
    if (options.key) write_file(*options.key, key.pdf());
    write_file(options.output, blank.pdf());
    return 0;
}

}  // namespace

void add_worksheet(CLI::App& program, int& status) {
    auto& command = *program.add_subcommand(
        "worksheet", "Print scenes with tables to fill in by hand, or write questions about a run");
    const auto options = std::make_shared<WorksheetOptions>();
    command
        .add_option("SCENE|TRACE", options->files,
                    "For .pdf, scene files, vidno-scene/1 or vidno-surface/1; for .xml, one trace")
        ->required();
    command.add_option("--language", options->language, "The language of the sheets or questions")
        ->check(CLI::IsMember(words(language_codes)))
        ->capture_default_str();
    command
        .add_option("--method", options->method,
                    "For .pdf: the algorithm to work through [warnock; for a surface floating-horizon]")
        ->check(CLI::IsMember(all_methods()));
    auto* rows = command.add_option(
        "--rows", options->rows, "For .pdf: the rows of the table, for a surface its curves, N or A..B [all that fit]");
    command.add_option("--steps", options->steps, "For .pdf: the rows that begin at the steps A..B of the exact run")
        ->excludes(rows);
    command.add_option("--key", options->key, "For .pdf: the same sheets filled in, .pdf");
    command
        .add_option("--count", options->count, "For .xml: the greatest number of questions, spread over the kinds [20]")
        ->check(CLI::Range(1, 9999));
    command
        .add_option("-o", options->output,
                    "Blank sheets for the scenes, in order, .pdf; or questions about the next steps of the run, for "
                    "Moodle, .xml")
        ->required();
    command.footer(
        "Examples: vidno worksheet homework/*.json -o sheets.pdf --key keys.pdf\n"
        "          vidno worksheet homework/*.json --rows 13..24 -o sheets.pdf   (row 12 is filled in)\n"
        "          vidno worksheet surface.json -o sheets.pdf --key keys.pdf   (the floating horizon)\n"
        "          vidno worksheet run.jsonl.gz --language ru -o questions.xml   (needs Node)");
    command.callback([options, &status] { status = worksheet(*options); });
}

}  // namespace vidno::cli
