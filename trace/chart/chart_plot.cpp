#include "chart/chart_plot.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <map>
#include <sstream>
#include <utility>

namespace vidno {

namespace {

constexpr int most_panel_height = 520, legend_entry = 400, legend_line = 30;

std::string style_of(const PlotSeries& series) {
    return "lc '" + std::string(series.color) + "' pt " + std::to_string(series.point) + " ps 0.8 lw 2";
}

/// In single quotes gnuplot takes every character literally, except a quote.
std::string in_quotes(std::string_view text) {
    std::string quoted = "'";
    for (const char c : text) {
        if (c == '\'') quoted += '\'';
        quoted += std::iscntrl(static_cast<unsigned char>(c)) != 0 ? ' ' : c;
    }
    return quoted + "'";
}

std::string number(double value) {
    std::ostringstream text;
    text << std::setprecision(9) << value;
    return text.str();
}

std::string power_of_ten(int exponent) { return "1e" + std::to_string(exponent); }

class Panel {
public:
    Panel(const Plot& plot, const PlotWords& words, int width) : plot_(plot), words_(words), width_(width) {
        double least = infinity;
        double most = 0;
        for (const double value : plot.errors) {
            has_zero_ = has_zero_ || value == 0;
            has_infinity_ = has_infinity_ || value == infinity;
            if (value == 0 || value == infinity) continue;
            least = std::min(least, value);
            most = std::max(most, value);
        }
        if (least > most) return;
        lowest_ = int(std::floor(std::log10(least)));
        highest_ = std::max(int(std::ceil(std::log10(most))), lowest_ + 1);
    }

    std::string script() const {
        const int bottom = lowest_ - (has_zero_ ? 2 : 0);
        const int top = highest_ + (has_infinity_ ? 2 : 0);
        std::string text = "set title " + in_quotes(plot_.title) + " noenhanced\nset xlabel " + in_quotes(words_.cost) +
                           "\nset ylabel " + in_quotes(words_.error) + "\nset yrange [" + power_of_ten(bottom) + ":" +
                           power_of_ten(top) + "]\nset ytics (" + ytics() + ")\nunset label\n" + labels();
        auto front = plot_.front;
        std::sort(front.begin(), front.end());
        text += block("front", front);
        std::string plots =
            "$front with steps lc '#bbbbbb' lw 6 notitle, $front with points pt 7 ps 2.2 lc '#dddddd' notitle";
        for (std::size_t i = 0; i < words_.series.size(); ++i) {
            const std::string name = "series" + std::to_string(i);
            const auto& series = words_.series[i];
            text += block(name, plot_.marks[i]);
            plots += ", $" + name + (series.along_knob ? " with linespoints " : " with points ") + style_of(series) +
                     " notitle";
        }
        return text + "plot " + plots + "\n";
    }

private:
    static constexpr double infinity = std::numeric_limits<double>::infinity();

    double height_of(double error) const {
        if (error == 0) return std::pow(10, lowest_ - 1);
        return error == infinity ? std::pow(10, highest_ + 1) : error;
    }

    std::string ytics() const {
        std::string tics = has_zero_ ? "'0' " + power_of_ten(lowest_ - 1) : "";
        const int step = (highest_ - lowest_) / 8 + 1;
        for (int exponent = lowest_; exponent <= highest_; exponent += step) {
            const bool plain = -4 < exponent && exponent < 5;
            const std::string text = plain ? number(std::pow(10, exponent)) : "10^{" + std::to_string(exponent) + "}";
            tics += (tics.empty() ? "'" : ", '") + text + "' " + power_of_ten(exponent);
        }
        return tics + (has_infinity_ ? ", " + in_quotes(words_.no_number) + " " + power_of_ten(highest_ + 1) : "");
    }

    std::string block(const std::string& name, const std::vector<PlotMark>& marks) const {
        std::string text = "$" + name + " << END\n";
        for (const auto& [cost, error, label] : marks) text += number(cost) + " " + number(height_of(error)) + "\n";
        if (marks.empty()) text += "NaN NaN\n";
        return text + "END\n";
    }

    /// Marks that are close together have one label.
    static std::vector<PlotMark> joined(std::vector<PlotMark> marks) {
        constexpr double close = 2.5;
        std::sort(marks.begin(), marks.end());
        std::vector<PlotMark> labels;
        for (const auto& mark : marks) {
            if (!labels.empty() && mark.cost < close * labels.back().cost && mark.error == labels.back().error) {
                labels.back().name += ", " + mark.name;
            } else {
                labels.push_back(mark);
            }
        }
        return labels;
    }

    /// The decades of the cost axis that a character of a label takes.
    double character() const {
        constexpr double pixels = 8, beside_the_axis = 112;
        double least = infinity, most = 0;
        for (const auto& series : plot_.marks) {
            for (const auto& mark : series) {
                least = std::min(least, mark.cost);
                most = std::max(most, mark.cost);
            }
        }
        const double decades = std::ceil(std::log10(most)) - std::floor(std::log10(least));
        return decades * pixels / (width_ - beside_the_axis);
    }

    /// A label that would cover another one is a line farther from the marks.
    std::string labels() const {
        std::vector<std::pair<PlotMark, bool>> labels;
        for (const auto& [marks, above] : plot_.labels) {
            for (auto& label : joined(marks)) labels.emplace_back(std::move(label), above);
        }
        std::sort(labels.begin(), labels.end());
        const double wide = character();
        std::map<std::pair<double, bool>, std::vector<double>> ends;  // the ends of the lines above or below an error
        std::string text;
        for (const auto& [mark, above] : labels) {
            const double begin = std::log10(mark.cost);
            auto& lines = ends[{mark.error, above}];
            const auto free = std::find_if(lines.begin(), lines.end(), [&](double end) { return end <= begin; });
            const double line = 0.9 + double(free - lines.begin());
            (free == lines.end() ? lines.emplace_back() : *free) = begin + wide * double(mark.name.size());
            text += "set label " + in_quotes(mark.name) + " at " + number(mark.cost) + "," +
                    number(height_of(mark.error)) + " left offset -0.6," + number(above ? line : -line) +
                    " font ',13'\n";
        }
        return text;
    }

    const Plot& plot_;
    const PlotWords& words_;
    int width_;
    bool has_zero_ = false, has_infinity_ = false;
    int lowest_ = 0, highest_ = 1;  // decades of what is neither
};

/// The names of the series, and of the front.
std::string legend(int rows, const PlotWords& words) {
    std::string text =
        "unset title\nunset xlabel\nunset ylabel\nunset tics\nunset border\nset key center center maxrows " +
        std::to_string(rows) +
        "\n"
        "set margins 0, 0, 0, 0\n"
        "set xrange [1:2]\nset yrange [1:2]\n"
        "plot NaN with lines lc '#bbbbbb' lw 6 title " +
        in_quotes(words.front);
    for (const auto& series : words.series) {
        text += std::string(", NaN with ") + (series.along_knob ? "linespoints " : "points ") + style_of(series) +
                " title " + in_quotes(series.name);
    }
    return text + "\n";
}

}  // namespace

std::string plot_script(const std::vector<Plot>& plots, const PlotWords& words, const PlotLayout& layout) {
    const int columns = std::min(int(plots.size()), layout.columns);
    const int rows = (int(plots.size()) + columns - 1) / columns;
    const int width = columns * layout.panel_width;
    const int panel_height = std::min(most_panel_height, layout.panel_width * 3 / 4);
    const int entries = int(words.series.size()) + 1;
    const int entries_in_row = std::max(1, width / legend_entry);
    const int legend_rows = std::max(3, (entries + entries_in_row - 1) / entries_in_row);
    const int legend_height = (legend_rows + 1) * legend_line;
    const int height = rows * panel_height + legend_height;

    std::ostringstream out;
    out << "set encoding utf8\nset terminal svg size " << width << "," << height << " font "
        << in_quotes(std::string(layout.font) + ",15") << " background 'white'\n"
        << "set multiplot\nset logscale xy\nset format x '" << (words.plain_costs ? "%g" : "10^{%T}")
        << "'\nset grid lc '#e5e5e5' lt 1\nunset key\n";
    const double panel_share = double(panel_height) / height;
    for (std::size_t i = 0; i < plots.size(); ++i) {
        const int row = int(i) / columns;
        out << "set origin " << double(int(i) % columns) / columns << "," << 1 - (row + 1) * panel_share
            << "\nset size " << 1.0 / columns << "," << panel_share << '\n'
            << Panel(plots[i], words, layout.panel_width).script();
    }
    out << "set origin 0,0\nset size 1," << double(legend_height) / height << '\n'
        << legend(legend_rows, words) << "unset multiplot\n";
    return out.str();
}

}  // namespace vidno
