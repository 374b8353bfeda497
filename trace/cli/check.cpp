#include <iomanip>
#include <iostream>

#include "check/check.h"
#include "check/findings_text.h"
#include "cli/commands.h"
#include "cli/shared/losses.h"
#include "cli/shared/progress.h"
#include "cli/shared/run_options.h"
#include "cli/shared/scene_files.h"
#include "cli/shared/trace_files.h"
#include "counted.h"
#include "format/trace_reader.h"
#include "output.h"
#include "run/floating_horizon_run.h"
#include "scene/exact_scene.h"

namespace vidno::cli {

namespace {

/// A scene, or a trace whose scene is run again. Options that are not given are those of the trace, or the defaults.
struct CheckOptions {
    std::string input, list;
    std::optional<std::string> method, kernel, edition;
    std::size_t narrowest = 20;
};

/// The options of a trace's own run, or for a scene the defaults.
using AnyHeader = std::variant<TraceHeader, FloatingHorizonHeader>;

AnyHeader run_of(const CheckOptions& options, Losses& losses) {
    RunOptions run{options.input, options.method, options.kernel, options.edition};
    const auto of_scene = [&]<class S>(const S& scene) -> AnyHeader {
        if constexpr (std::same_as<S, Surface>) {
            return FloatingHorizonHeader{edition_of(run), run.kernel_name(), Detail::signs, scene};
        } else {
            return TraceHeader{method_of(run), edition_of(run), run.kernel_name(), Detail::signs, scene};
        }
    };
    if (!is_trace(options.input)) return std::visit(of_scene, any_scene_for(run, true));
    AnyTraceReader opened = open_trace(LineReader(options.input), options.input);
    const bool of_curves = std::holds_alternative<FloatingHorizonTraceReader>(opened);
    if (options.method && (options.method == floating_horizon_method) != of_curves) {
        throw Refused("--method " + *options.method + ": " + options.input + " is a trace of " +
                      (of_curves ? "curves" : "polygons"));
    }
    return std::visit(
        [&](auto& reader) -> AnyHeader {
            losses.add(reader);
            return reader.header();
        },
        opened);
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
        std::string first = each.first() ? std::to_string(*each.first()) : "-";
        if (each.first() && !each.first_wrong) first = '(' + first + ')';
        row(std::string(procedure_names[std::size_t(each.procedure)]), each.decisions, each.wrong_for_operands,
            each.wrong_for_scene, each.undefined, first);
    }
    const auto is_right_for_scene = [](const auto& each) { return each.first() && !each.first_wrong; };
    if (std::any_of(report.procedures.begin(), report.procedures.end(), is_right_for_scene)) {
        std::cout << "(step): wrong for its own numbers, right for the scene; a checked trace has no disagree there\n";
    }
    if (report.intersections > 0) {
        std::cout << "intersections: " << report.intersections << ", at most " << report.farthest_off
                  << " pixels from the exact ones";
        if (report.farthest_step > 0) std::cout << ", at step " << report.farthest_step;
        if (report.points_off > 0) {
            std::cout << "; " << report.points_off << " by more than half a pixel, which is an error";
        }
        std::cout << '\n';
    }
    if (std::any_of(report.decided_by.begin(), report.decided_by.end(), [](auto count) { return count > 0; })) {
        std::cout << "decided as given: " << report.decided_by[0] << ", by the scene's bound: " << report.decided_by[1]
                  << ", by the operands' bound: " << report.decided_by[2] << ", exactly: " << report.decided_by[3]
                  << '\n';
    }
}

struct CoincidenceTitle {
    std::string_view one, several;
};
constexpr std::array<CoincidenceTitle, coincidence_names.size()> coincidence_titles{{
    {"point on a line", "points on a line"},
    {"pair of equal depths", "pairs of equal depths"},
    {"pair of parallel lines", "pairs of parallel lines"},
    {"shared point", "shared points"},
    {"pixel centre met", "pixel centres met"},
    {"box touching a window", "boxes touching windows"},
    {"curve on a horizon", "curves on horizons"},
    {"pair of equal numbers", "pairs of equal numbers"},
}};

void print(const FindingList& findings) {
    std::string zeros;
    for (std::size_t i = 0; i < findings.zeros().size(); ++i) {
        const auto& [count, first] = findings.zeros()[i];
        if (count == 0) continue;
        const auto& [one, several] = coincidence_titles[i];
        zeros += (zeros.empty() ? "" : ", ") + counted(count, one, several) + " (step " + std::to_string(first) + ')';
    }
    std::cout << "exact zeros: " << (zeros.empty() ? "none" : zeros) << '\n';
}
void print_narrowest(const std::vector<Finding>& findings) {
    const Finding* narrowest = nullptr;
    for (const auto& each : findings) {
        const bool is_narrower = !narrowest || (each.gap && each.gap->ulps < narrowest->gap->ulps);
        if (each.kind == FindingKind::narrow && is_narrower) narrowest = &each;
    }
    if (!narrowest) return;
    std::cout << "narrowest decision: step " << narrowest->step << ", " << line_names[std::size_t(narrowest->at)]
              << ", " << narrowest->gap->ulps << " ulps from zero\n";
}

/// The report of a run and its findings. `progress` is called at each step.
auto checked(auto request, FindingList& findings, auto&&... right) {
    Progress progress("steps");
    request.progress = [&, steps = std::uint64_t{0}]() mutable { progress.show(++steps); };
    auto report = check_run(
        request, right..., [](const auto&) {}, &findings);
    progress.clear();
    return report;
}

void write_list(const CheckOptions& options, const FindingsHeader& header, const std::vector<Finding>& findings) {
    if (options.list.empty()) return;
    const bool is_csv = options.list.ends_with(".csv");
    write_file(options.list, is_csv ? findings_csv(header, findings) : findings_jsonl(header, findings));
}

/// Prints what was found, and writes the list.
void tell(const CheckOptions& options, const DecisionReport& report, FindingList& list, const FindingsHeader& header) {
    print(report);
    print(list);
    const auto findings = list.findings();
    print_narrowest(findings);
    write_list(options, header, findings);
}

int check_header(const CheckOptions& options, TraceHeader run) {
    if (options.method) run.method = method_named(*options.method);
    const NamedKernel kernel = *kernel_named(run.kernel);
    expect_run(kernel, run.method, run.edition);
    const AdmittedScene given = exact_scene::admit(std::move(run.scene));
    const AdmittedScene scene = scene_for(kernel, given, options.input);
    expect_admitted(run.method, scene, options.input);
    const RunRequest request{run.method, kernel, run.edition, scene};
    FindingList findings(choice_of(run.method).procedure, scene->area, options.narrowest);
    const CheckReport report = checked(request, findings, right_picture(given, run.method));
    tell(options, report, findings, findings_header(request));
    const auto pixels = std::int64_t(scene->area.width) * scene->area.height;
    std::cout << "wrong pixels: " << report.wrong_pixels << " of " << pixels << '\n';
    return report.found_something() ? 1 : 0;
}

int check_header(const CheckOptions& options, const FloatingHorizonHeader& run) {
    const NamedKernel kernel = *kernel_named(run.kernel);
    expect_floating_horizon_run(kernel, run.edition);
    const FloatingHorizonRequest request{kernel, run.edition, run.scene.curves};
    FindingList findings(Procedure::floating_horizon, run.scene.curves->area, options.narrowest);
    const FloatingHorizonCheckReport report = checked(request, findings);
    tell(options, report, findings, findings_header(request, run.scene.name));
    std::cout << "wrong columns of curves: " << report.wrong_columns << " of " << report.columns << '\n';
    return report.found_something() ? 1 : 0;
}

int check(const CheckOptions& options) {
    if (!options.list.empty() && !options.list.ends_with(".csv") && !options.list.ends_with(".jsonl")) {
        throw Refused(options.list + ": not .csv or .jsonl");
    }
    Losses losses;
    AnyHeader header = run_of(options, losses);
    const int found = std::visit(
        [&](auto& run) {
            if (options.edition) run.edition = *edition_named(*options.edition);
            run.kernel = options.kernel.value_or(run.kernel);
            return check_header(options, run);
        },
        header);
    return losses.report() != 0 ? 1 : found;
}

}  // namespace

void add_check(CLI::App& program, int& status) {
    auto& command = *program.add_subcommand("check", "Run a scene and compare every decision with exact arithmetic");
    const auto options = std::make_shared<CheckOptions>();
    command
        .add_option("SCENE|TRACE", options->input,
                    "A scene file, a failure, or a trace (.jsonl, .jsonl.gz) to run again")
        ->required();
    command
        .add_option("--method", options->method,
                    "The algorithm [warnock; for a surface floating-horizon; or the trace's]")
        ->check(CLI::IsMember(all_methods()));
    command.add_option("--kernel", options->kernel, "The arithmetic [double, or the trace's]")->check(a_kernel());
    command.add_option("--edition", options->edition, "The text of the procedures [corrected, or the trace's]")
        ->check(an_edition())
        ->type_name("EDITION");
    command
        .add_option("--list", options->list,
                    "A list of the decisions that are wrong, that rest on an exact coincidence, or that are narrow "
                    "(.csv, .jsonl; see FORMAT.md)")
        ->type_name("FILE");
    command.add_option("--narrowest", options->narrowest, "The number of narrowest decisions to list [20]")
        ->type_name("N");
    command.footer(
        "A decision is wrong because an operation rounded, or because its operands had drifted from the exact values.\n"
        "Steps are counted at level signs. Exit status 1: a decision or a pixel is wrong, or a constructed\n"
        "point lies more than half a pixel from the exact one.");
    command.callback([options, &status] { status = check(*options); });
}

}  // namespace vidno::cli
