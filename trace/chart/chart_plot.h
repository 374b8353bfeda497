/// Plot: runs as points with a cost and an error, drawn by gnuplot; what the figures of all charts are made of.
#pragma once

#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace vidno {

struct PlotMark {
    double cost, error;
    std::string name{};

    bool operator<(const PlotMark& other) const { return std::tie(cost, error) < std::tie(other.cost, other.error); }
};

/// Runs that are drawn alike: along a knob with a line, else points.
struct PlotSeries {
    std::string name;
    std::string_view color;  // of Okabe and Ito, whom colour-blind people can read
    int point;               // gnuplot's number for a shape
    bool along_knob;
};

/// Names that stand by their marks, above or below them.
struct PlotLabels {
    std::vector<PlotMark> marks;
    bool above;
};

/// A panel of a figure. Errors go by decades; 0 has a place of its own below them, and an infinite one above.
struct Plot {
    std::string title;
    std::vector<double> errors;                // of all runs, also of those that have no such cost
    std::vector<std::vector<PlotMark>> marks;  // of each series
    std::vector<PlotMark> front;
    std::vector<PlotLabels> labels;
};

/// What the panels of a figure have in common.
struct PlotWords {
    std::string_view cost, error, front, no_number;
    std::vector<PlotSeries> series;
    bool plain_costs;  // 1, 2, 5; else as powers of ten
};

/// The panels side by side, and the width of one in units of which 15 are the size of its letters.
struct PlotLayout {
    int columns = 2, panel_width = 800;
    std::string_view font = "DejaVu Sans";
};

/// The program by which gnuplot draws the panels, as SVG.
std::string plot_script(const std::vector<Plot>& plots, const PlotWords& words, const PlotLayout& layout);

}  // namespace vidno
