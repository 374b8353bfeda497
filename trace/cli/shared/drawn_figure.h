/// A figure as the command line describes it, in `vidno figure` and in the stories of lessons.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>

#include "cli/shared/chart_axes.h"
#include "cli/shared/losses.h"

namespace vidno::cli {

struct FigureOptions {
    std::string input, output;
    std::optional<std::uint64_t> step;
    std::string steps, pin, pixel, width;  // empty: as usual
    std::string show = "picture,windows";
    std::string language = "en";
    std::string kernel = "double";  // of a map
    AxisOptions axes;               // of a chart
    int dots_an_inch = 300;
    bool greyscale = false, beamer = false, film = false;
    double rate = 2;  // of a film
};

void add_figure_options(CLI::App& command, FigureOptions& options);

/// Parses a command as for the shell, "vidno figure ...". Throws Refused.
FigureOptions figure_options(const std::string& command);

/// The bytes of the figure, in the format given by the output's name. Adds what it lacks to the losses.
std::string drawn_figure(const FigureOptions& options, Losses& losses);

}  // namespace vidno::cli
