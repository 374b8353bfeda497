/// Plot: runs as points with a cost and an error, drawn by gnuplot; shared by the figures of all charts.
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

/// Runs that are drawn in the same style: as a line along a knob, otherwise as points.
struct PlotSeries {
    std::string name;
    std::string_view color;  // from Okabe and Ito's palette for colour-blind readers
    int point;               // gnuplot's number for a shape
    bool along_knob;
};

/// Names beside their marks, above or below them.
struct PlotLabels {
    std::vector<PlotMark> marks;
    bool above;
};

/// A panel of a figure. The error axis is logarithmic; 0 has a separate place below, an infinite error one above.
struct Plot {
    std::string title;
    std::vector<double> errors;                // of all runs, also those without this cost
    std::vector<std::vector<PlotMark>> marks;  // of each series
    std::vector<PlotMark> front;
    std::vector<PlotLabels> labels;
};

/// The settings that all panels of a figure share.
struct PlotWords {
    std::string_view cost, error, front, no_number;
    std::vector<PlotSeries> series;
    bool plain_costs;  // 1, 2, 5; else as powers of ten
};

/// The panels side by side, and the width of one, in units of 1/15 of the font size.
struct PlotLayout {
    int columns = 2, panel_width = 800;
    std::string_view font = "DejaVu Sans";
};

/// The gnuplot program that draws the panels as SVG.
std::string plot_script(const std::vector<Plot>& plots, const PlotWords& words, const PlotLayout& layout);

}  // namespace vidno
