#include "check.h"

#include <iomanip>
#include <iostream>

#include "commands.h"
#include "progress.h"
#include "trace_reader.h"

namespace vidno::cli {

namespace {

/// What a trace says of its run, or for a scene the defaults.
TraceHeader run_of(const std::string& file) {
    if (is_trace(file)) return TraceReader(LineReader(file), file).header();
    const RunOptions defaults;
    return {Method::warnock, edition_of(defaults), defaults.kernel, Detail::signs, scene_from(file)};
}

void print(const CheckReport& report, const Area& area) {
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
    std::cout << "wrong pixels: " << report.wrong_pixels << " of " << std::int64_t(area.width) * area.height << '\n';
}

}  // namespace

int check(const CheckOptions& options) {
    TraceHeader run = run_of(options.input);
    if (options.method) run.method = Method(place_in(method_names, *options.method));
    if (options.edition) run.edition = Edition(place_in(edition_names, *options.edition));
    run.kernel = options.kernel.value_or(run.kernel);
    const NamedKernel kernel = *kernel_named(run.kernel);
    expect_run(kernel, run.method, run.edition);
    const Scene scene = scene_for(kernel, run.scene, options.input);
    expect_admitted(run.method, scene, options.input);
    RunRequest request{run.method, kernel, run.edition, scene};
    Progress progress("steps");
    request.progress = [&, steps = std::uint64_t{0}]() mutable { progress.show(++steps); };
    const CheckReport report = check_run(request, right_picture(run.scene, run.method));
    progress.clear();
    print(report, scene.area);
    return report.found_something() ? 1 : 0;
}

}  // namespace vidno::cli
