#include <iomanip>
#include <iostream>

#include "check/check.h"
#include "cli/commands.h"
#include "cli/shared/progress.h"
#include "cli/shared/run_options.h"
#include "cli/shared/scene_files.h"
#include "cli/shared/trace_files.h"
#include "format/trace_reader.h"
#include "output.h"
#include "run/floating_horizon_run.h"

namespace vidno::cli {

namespace {

/// A scene, or a trace whose scene is run again; what is not given is the trace's own, or the default.
struct CheckOptions {
    std::string input;
    std::optional<std::string> method, kernel, edition;
};

/// What a trace says of its run, or for a scene the defaults.
using AnyHeader = std::variant<TraceHeader, FloatingHorizonHeader>;

AnyHeader run_of(const CheckOptions& options) {
    RunOptions run{options.input, options.method, options.kernel, options.edition};
    const auto of_scene = [&]<class S>(const S& scene) -> AnyHeader {
        if constexpr (std::same_as<S, Surface>) {
            return FloatingHorizonHeader{edition_of(run), run.kernel_name(), Detail::signs, scene};
        } else {
            return TraceHeader{method_of(run), edition_of(run), run.kernel_name(), Detail::signs, scene};
        }
    };
    if (!is_trace(options.input)) return std::visit(of_scene, any_scene_for(run, true));
    const AnyTraceReader opened = open_trace(LineReader(options.input), options.input);
    const bool of_curves = std::holds_alternative<FloatingHorizonTraceReader>(opened);
    if (options.method && (options.method == floating_horizon_method) != of_curves) {
        throw Refused("--method " + *options.method + ": " + options.input + " is a trace of " +
                      (of_curves ? "curves" : "polygons"));
    }
    return std::visit([](const auto& reader) -> AnyHeader { return reader.header(); }, opened);
}

void print(const DecisionReport& report) {
    constexpr int widths[]{14, 10, 24, 21, 11, 12};
    const auto row = [&](const std::string& name, const auto&... cells) {
        std::cout << std::left << std::setw(widths[0]) << name << std::right;
        int column = 0;
        ((std::cout << std::setw(widths[++column]) << cells), ...) << '\n';
    };
    row("procedure", "decisions", "wrong for its numbers", "wrong for the scene", "undefined", "first step");
    for (const auto& each : report.procedures) {
        const std::string first = each.first_wrong ? std::to_string(*each.first_wrong) : "-";
        row(std::string(procedure_names[std::size_t(each.procedure)]), each.decisions, each.wrong_for_operands,
            each.wrong_for_scene, each.undefined, first);
    }
    if (report.intersections > 0) {
        std::cout << "intersections: " << report.intersections << ", at most " << report.farthest_off
                  << " pixels from the exact ones\n";
    }
    if (std::any_of(report.decided_by.begin(), report.decided_by.end(), [](auto count) { return count > 0; })) {
        std::cout << "decided as given: " << report.decided_by[0] << ", by the scene's bound: " << report.decided_by[1]
                  << ", by the operands' bound: " << report.decided_by[2] << ", exactly: " << report.decided_by[3]
                  << '\n';
    }
}

/// The report of a run, which `progress` is told of.
auto checked(auto request, auto&&... right) {
    Progress progress("steps");
    request.progress = [&, steps = std::uint64_t{0}]() mutable { progress.show(++steps); };
    auto report = check_run(request, right...);
    progress.clear();
    return report;
}

int check_header(const CheckOptions& options, TraceHeader run) {
    if (options.method) run.method = Method(place_in(method_names, *options.method));
    const NamedKernel kernel = *kernel_named(run.kernel);
    expect_run(kernel, run.method, run.edition);
    const Scene scene = scene_for(kernel, run.scene, options.input);
    expect_admitted(run.method, scene, options.input);
    const CheckReport report =
        checked(RunRequest{run.method, kernel, run.edition, scene}, right_picture(run.scene, run.method));
    print(report);
    const auto pixels = std::int64_t(scene.area.width) * scene.area.height;
    std::cout << "wrong pixels: " << report.wrong_pixels << " of " << pixels << '\n';
    return report.found_something() ? 1 : 0;
}

int check_header(const CheckOptions&, const FloatingHorizonHeader& run) {
    const NamedKernel kernel = *kernel_named(run.kernel);
    expect_floating_horizon_run(kernel, run.edition);
    const FloatingHorizonCheckReport report = checked(FloatingHorizonRequest{kernel, run.edition, run.scene.curves});
    print(report);
    std::cout << "wrong columns of curves: " << report.wrong_columns << " of " << report.columns << '\n';
    return report.found_something() ? 1 : 0;
}

int check(const CheckOptions& options) {
    AnyHeader header = run_of(options);
    return std::visit(
        [&](auto& run) {
            if (options.edition) run.edition = Edition(place_in(edition_names, *options.edition));
            run.kernel = options.kernel.value_or(run.kernel);
            return check_header(options, run);
        },
        header);
}

}  // namespace

void add_check(CLI::App& program, int& status) {
    auto& command = *program.add_subcommand("check", "Run a scene and hold every decision against the truth");
    const auto options = std::make_shared<CheckOptions>();
    command
        .add_option("SCENE|TRACE", options->input,
                    "A scene file, a failure, or a trace (.jsonl, .jsonl.gz) to be run again")
        ->required();
    command
        .add_option("--method", options->method,
                    "Which algorithm [warnock, of a surface floating-horizon, or the trace's]")
        ->check(CLI::IsMember(all_methods()));
    command.add_option("--kernel", options->kernel, "Which arithmetic decides [double, or the trace's]")
        ->check(a_kernel());
    command.add_option("--edition", options->edition, "Which text of the procedures [corrected, or the trace's]")
        ->check(an_edition())
        ->type_name("EDITION");
    command.footer(
        "A decision is wrong because it rounded, or right for numbers that had drifted and wrong for the scene.\n"
        "The step is that of a trace of level signs. Exit status 1: a decision or a pixel is wrong.");
    command.callback([options, &status] { status = check(*options); });
}

}  // namespace vidno::cli
