/// The cost and the error that a drawing of a chart shows.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "chart/chart_input.h"
#include "figure/figure_words.h"

namespace vidno::cli {

/// None: the first one.
struct AxisOptions {
    std::optional<std::string> cost, error;
};

/// Adds the options for the axes of charts of scenes and of surfaces; `cost` is the help for the cost axis.
void add_axes(CLI::App& command, AxisOptions& axes, const std::string& cost);

/// Refuses axes that a chart of this kind does not have.
void expect_axes(const AxisOptions& axes, bool of_surfaces);

/// The gnuplot program that draws a chart on the named axes, with words in the language. Refuses axes that a chart of
/// this kind does not have.
std::string script_of(const std::vector<SceneChart>& scenes, const AxisOptions& axes, const PlotLayout& layout = {},
                      Language language = Language::english);
std::string script_of(const std::vector<SurfaceChart>& surfaces, const AxisOptions& axes, const PlotLayout& layout = {},
                      Language language = Language::english);

}  // namespace vidno::cli
