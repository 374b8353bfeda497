/// The cost and the error that a drawing of a chart shows.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "chart/chart_input.h"
#include "figure/chart_figure.h"

namespace vidno::cli {

/// None: the first one.
struct AxisOptions {
    std::optional<std::string> cost, error;
};

/// Adds the options for the axes of charts of scenes and of surfaces; `cost` is the help for the cost axis.
void add_axes(CLI::App& command, AxisOptions& axes, const std::string& cost);

/// Refuses axes that a chart of this kind does not have.
void expect_axes(const AxisOptions& axes, bool of_surfaces);

/// A panel of the figure for each scene, ordinary ones first, on the named axes. Refuses axes that a chart of this kind
/// does not have.
std::vector<figures::ChartPanel> panels_of(const AnyChart& chart, const AxisOptions& axes, Language language);

/// The usual width of the figure, in millimetres: that of a column, or of a page for several panels.
double usual_width_of(const std::vector<figures::ChartPanel>& panels);

}  // namespace vidno::cli
