/// What a right picture costs: the few runs of a chart that answer this, as a figure of a paper.
#pragma once

#include <string>
#include <vector>

#include "chart/chart.h"
#include "chart/surface_chart.h"
#include "parts.h"

namespace vidno::figures {

/// A run in the figure.
struct ChartMark {
    enum class Shape : unsigned char { circle, square, triangle };

    double cost = 1;   // relative to the least in the panel
    double error = 0;  // in per cent, ulps or pixels; infinite where a depth is no number
    std::string way;   // "Warnock", "as given"
    std::string kernel;
    Shape shape = Shape::circle;
    bool is_cheapest = false;  // of those that get every pixel or column right
};

/// A scene or a surface with the runs that its figure shows, at most twelve.
struct ChartPanel {
    std::string title, cost, error;  // the words of the axes
    double least = 0;                // the error of the right picture: what has no greater one is right
    std::vector<ChartMark> marks{};
};

/// The runs without a fault of the corrected text under float, double, filtered and exact: those of the course's
/// methods without a knob, and the cheapest right one of the others. The axes are given by index.
ChartPanel panel_of(const SceneChart& scene, std::size_t cost, std::size_t error, Language language);
/// Under these kernels: the samples of the file, one on each column, and the cheapest right run with fewer, by each
/// knob.
ChartPanel panel_of(const SurfaceChart& surface, std::size_t cost, std::size_t error, Language language);

/// Wrong runs stand above a line, right ones below it, each with its name. Panels stand side by side where each has
/// 80 mm.
Drawing chart_figure(const std::vector<ChartPanel>& panels, const Style& style, double width);

}  // namespace vidno::figures
