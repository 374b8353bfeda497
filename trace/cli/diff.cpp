#include <iostream>

#include "cli/commands.h"
#include "cli/shared/losses.h"
#include "cli/shared/progress.h"
#include "format/trace_reader.h"

namespace vidno::cli {

namespace {

struct DiffOptions {
    std::string first, second;
};

/// A trace, reduced to its events.
struct ComparedTrace {
    AnyTraceReader reader;
    EventText text;

    explicit ComparedTrace(const std::string& file)
        : reader(open_trace(LineReader(file), file)),
          text(std::visit([](const auto& each) { return polygon_names(each.header().scene); }, reader)) {}

    TraceFile& trace() {
        return std::visit([](auto& each) -> TraceFile& { return each; }, reader);
    }

    /// None at the end.
    std::optional<std::string> next_line() {
        const auto event = std::visit([](auto& each) { return each.next(); }, reader);
        if (!event) return std::nullopt;
        Text line;
        text.line(line, *event);
        return line.string();
    }
};

/// The status after the last step that was compared: both traces may have been cut. What both runs lost is no
/// difference.
int status_of_comparison(ComparedTrace& first, ComparedTrace& second, bool differ) {
    Losses losses;
    for (ComparedTrace* each : {&first, &second}) {
        each->trace().skip_rest();
        if (const auto lack = each->trace().lacks()) losses.add(each->trace().place(), {*lack});
    }
    return losses.report() != 0 || differ ? 1 : 0;
}

int diff(const DiffOptions& options) {
    ComparedTrace first(options.first);
    ComparedTrace second(options.second);
    Progress progress("steps");
    for (std::uint64_t step = 1;; ++step) {
        progress.show(step);
        const auto a = first.next_line();
        const auto b = second.next_line();
        if (a && a == b) continue;
        progress.clear();
        if (a || b) {
            std::cout << "the traces differ from step " << step << " on\n- " << a.value_or("(the end)\n") << "+ "
                      << b.value_or("(the end)\n");
        }
        return status_of_comparison(first, second, a || b);
    }
}

}  // namespace

void add_diff(CLI::App& program, int& status) {
    auto& command = *program.add_subcommand("diff", "Find the first step at which two traces differ");
    const auto options = std::make_shared<DiffOptions>();
    command.add_option("A", options->first, "A trace")->required();
    command.add_option("B", options->second, "Another trace, for example under another kernel")->required();
    command.footer("The headers are not compared. Exit status 1: the traces differ, or one was cut short.");
    command.callback([options, &status] { status = diff(*options); });
}

}  // namespace vidno::cli
