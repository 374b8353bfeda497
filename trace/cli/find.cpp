#include <array>
#include <iomanip>
#include <iostream>
#include <sstream>

#include "choice/method.h"
#include "cli/commands.h"
#include "cli/shared/progress.h"
#include "cli/shared/run_options.h"
#include "counted.h"
#include "find/measures.h"
#include "find/search.h"
#include "output.h"
#include "scene/scene_json.h"
#include "scene/surface.h"
#include "stability/shrink.h"

namespace vidno::cli {

namespace {

struct FindOptions {
    std::string condition, output;
    std::optional<std::string> method;
    std::uint64_t seed = 1;
    double seconds = 60;
    bool list = false;
};

// ------------------------------------------------------------------------------------- the names

/// Prints text from a column on, in lines that end before column 110.
void print_wrapped(const std::string& text, std::size_t column) {
    constexpr std::size_t end = 110;
    std::istringstream words(text);
    std::size_t at = column;
    for (std::string word; words >> word;) {
        if (at > column && at + 1 + word.size() > end) {
            std::cout << '\n' << std::string(column, ' ');
            at = column;
        }
        if (at > column) std::cout << ' ';
        std::cout << word;
        at += word.size() + 1;
    }
    std::cout << '\n';
}

int print_names() {
    std::cout << "Names of a condition:\n";
    constexpr std::size_t column = 18;
    for (const auto& [name, says, of, argument, grows, of_scene] : quantities) {
        const std::string form = std::string(name) + (argument.empty() ? "" : "(" + std::string(argument) + ")");
        std::cout << "  " << std::left << std::setw(int(column) - 2) << form;
        print_wrapped(std::string(says), column);
    }
    std::cout
        << "Operators: && || ! == != < <= > >= + - * / ^ ?: and parentheses; functions: min, max, abs.\n"
           "Labels, the lines and the methods that have them; no step is reported at the lines without a colon:\n";
    for (std::size_t i = 0; i < line_names.size(); ++i) {
        const Line line = Line(i);
        const auto methods = methods_with(line);
        std::cout << "  " << line_names[i] << (is_counted(line) ? ": " : "  ") << text_of(line) << "  [";
        for (std::size_t method = 0; method < methods.size(); ++method) {
            std::cout << (method > 0 ? ", " : "") << methods[method];
        }
        std::cout << "]\n";
    }
    return 0;
}

// ------------------------------------------------------------------------------------- what was found

std::string values_of(const Condition& condition, const std::vector<double>& values) {
    std::ostringstream text;
    for (std::size_t i = 0; i < values.size(); ++i) {
        text << (i > 0 ? ", " : "") << condition.names()[i].text() << " = " << std::setprecision(15) << values[i];
    }
    return text.str();
}

/// How much was searched, and which parts of the condition were not met.
void say_not_found(const Condition& condition, std::string_view method, const SearchReport& report) {
    const bool of_curves = method == floating_horizon_method;
    std::cerr << "not found: " << counted(report.scenes, "scene", "scenes") << " tried, with up to "
              << (of_curves ? counted(report.most_parts_drawn, "curve", "curves")
                            : counted(report.most_parts_drawn, "polygon", "polygons"))
              << " in areas of up to " << report.widest << " x " << report.widest << " pixels\n";
    const auto& parts = condition.parts();
    bool all_alone = true;
    for (std::size_t part = 0; part < parts.size(); ++part) {
        if (report.met[part] > 0) continue;
        all_alone = false;
        std::cerr << "never met: " << parts[part] << '\n';
    }
    if (!all_alone) return;
    std::cerr << "each part was met, but at most " << report.most_parts << " of " << parts.size()
              << " at once; the best scene does not meet:";
    for (std::size_t part = 0; part < parts.size(); ++part) {
        if (!report.met_by_best[part]) std::cerr << ' ' << parts[part];
    }
    std::cerr << '\n';
}

/// What is written, and how large it is, in words.
struct Found {
    std::string json, size;
};

std::string size_of(const Area& area) {
    return ", " + std::to_string(area.width) + " x " + std::to_string(area.height) + " pixels";
}

Found found_from(const std::string& name, const AdmittedScene& scene) {
    Scene named = scene;
    named.name = name;
    return {scene_json(named), counted(named.polygons.size(), "polygon", "polygons") + ", " +
                                   counted(vertices_of(named), "vertex", "vertices") + size_of(named.area)};
}

Found found_from(const std::string& name, const Surface& surface) {
    const AdmittedCurves& curves = surface.curves;
    return {surface_json({name, curves}), counted(curves->curves.size(), "curve", "curves") + ", " +
                                              counted(sample_count(curves), "sample", "samples") +
                                              size_of(curves->area)};
}

int find(const FindOptions& options) {
    if (options.list) return print_names();
    if (options.condition.empty()) throw Refused("CONDITION is required (vidno find --help)");
    if (options.output.empty()) throw Refused("-o is required: say where to write the scene");
    const Condition condition(options.condition);
    const std::string method(options.method ? *options.method : method_for(condition));
    expect_suits(condition, method);
    OutputFile file(options.output);
    Progress progress("scenes tried");
    SearchRequest request{condition, method, options.seed, options.seconds};
    request.progress = [&](std::uint64_t scenes) { progress.show(scenes); };
    SearchReport report = search(request);
    progress.clear();
    if (!report.found) {
        say_not_found(condition, method, report);
        return 1;
    }
    const auto values = measured(condition, *report.found, method, kernel_of(KernelKind::exact));
    if (!condition.is_met(values)) {
        std::cerr << "the run in exact arithmetic does not meet the condition: " << values_of(condition, values)
                  << '\n';
        return 1;
    }
    const Found found =
        std::visit([&](const auto& scene) { return found_from(options.condition, scene); }, *report.found);
    file.write(found.json + '\n');
    file.commit();
    std::cerr << values_of(condition, values) << '\n'
              << "--method " << method << ": " << found.size << "; " << counted(report.scenes, "scene", "scenes")
              << " tried\n";
    return 0;
}

}  // namespace

void add_find(CLI::App& program, int& status) {
    auto& command = *program.add_subcommand("find", "Find the smallest scene whose run satisfies a condition");
    const auto options = std::make_shared<FindOptions>();
    command.add_option("CONDITION", options->condition, "An expression, such as 'PW7 > 0 && windows <= 13'");
    command.add_flag("--list", options->list, "Explain all names of a condition");
    command
        .add_option("--method", options->method, "The algorithm [the first one that has the names of the condition]")
        ->check(CLI::IsMember(all_methods()));
    command.add_option("--seed", options->seed, "The seed; another seed may find another scene")->capture_default_str();
    command.add_option("--seconds", options->seconds, "Search no longer than this")
        ->check(CLI::Range(0.1, 86400.0))
        ->capture_default_str();
    command.add_option("-o", options->output, "The scene, .json; - for standard output");
    command.footer(
        "The smallest scene has the fewest polygons or curves, then the fewest vertices or samples, then the smallest\n"
        "area, then the smallest numbers. A found scene is run again in exact arithmetic, and the values of the names\n"
        "are printed.\n"
        "Examples:\n"
        "  vidno find 'PW7 > 0 && windows <= 13' -o scene.json\n"
        "  vidno find 'wrong(float) > 0 && polygons <= 2 && coordinates <= 64' -o scene.json\n"
        "  vidno find 'FH8 > 0 && curves == 2' -o surface.json\n"
        "Exit status 1: nothing was found; standard error says how much was searched, and what was never met.");
    command.callback([options, &status] { status = find(*options); });
}

}  // namespace vidno::cli
