#include "cli/commands.h"
#include "cli/shared/drawn_figure.h"
#include "output.h"

namespace vidno::cli {

void add_figure(CLI::App& program, int& status) {
    auto& command = *program.add_subcommand("figure", "Draw steps of a trace, a map or a chart for a paper or a slide");
    const auto options = std::make_shared<FigureOptions>();
    add_figure_options(command, *options);
    command.footer(
        "Example: vidno figure run.jsonl.gz --step 40 --show picture,windows,list,listing -o figure.pdf\n"
        "pdfLaTeX typesets the .tex file on its own. A document can also \\input it and then sets it in its own font.\n"
        "Exit status 1: the trace was cut short or is partial, or its run lost something up to the last step drawn.");
    command.callback([options, &status] {
        Losses losses;
        write_file(options->output, drawn_figure(*options, losses));
        status = losses.report();
    });
}

}  // namespace vidno::cli
