// The figure of a chart, as a program for gnuplot.

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>
#include <tuple>

#include "chart.h"

namespace vidno {

const ChartWords chart_in_english{
    .costs = {"time, times that of the fastest", "operations", "operations times bits"},
    .errors = {"wrong pixels, %", "area that differs, %", "wrong decisions, %", "depth error, ulps"},
    .series = {"Warnock, bits of arithmetic", "Warnock, grid", "Warnock, smallest window", "Warnock",
               "Warnock, printed", "Z-buffer, bits of arithmetic", "Z-buffer, grid", "Z-buffer, bits of depth",
               "Z-buffer", "Z-buffer, printed", "Warnock, simplest", "Warnock, three lists", "Warnock, angles",
               "Warnock, at vertices", "Warnock, edge-on shown", "Warnock, back faces removed", "Weiler-Atherton"},
    .front = "nothing is cheaper and as right",
    .ordinary = "ordinary",
    .degenerate = "degenerate",
    .no_number = "no number"};

const ChartWords chart_in_russian{
    .costs = {"время относительно самого быстрого прогона", "операции", "операции × биты"},
    .errors = {"неверные пиксели, %", "площадь расхождения, %", "неверные решения, %", "ошибка глубины, ulp"},
    .series = {"Варнок, биты арифметики", "Варнок, сетка", "Варнок, наименьшее окно", "Варнок",
               "Варнок, как напечатано", "Z-буфер, биты арифметики", "Z-буфер, сетка", "Z-буфер, биты глубины",
               "Z-буфер", "Z-буфер, как напечатано", "Варнок, простейший", "Варнок, три списка", "Варнок, углы",
               "Варнок, по вершинам", "Варнок, рёбра видны", "Варнок, без нелицевых граней", "Вейлер — Азертон"},
    .front = "дешевле и не хуже ничего нет",
    .ordinary = "обычная",
    .degenerate = "вырожденная",
    .no_number = "не число"};

namespace {

/// Runs that are drawn alike: along a knob with a line, else points.
struct Series {
    Method method;
    std::optional<Knob> knob;
    Edition edition;
    std::string_view color;  // of Okabe and Ito, whom colour-blind people can read
    int point;               // gnuplot's number for a shape

    bool has(const Way& way) const { return way.method == method && way.knob == knob && way.edition == edition; }
};

constexpr std::array<Series, 17> all_series{{
    {Method::warnock, Knob::bits, Edition::corrected, "#0072b2", 9},
    {Method::warnock, Knob::grid, Edition::corrected, "#56b4e9", 11},
    {Method::warnock, Knob::window, Edition::corrected, "#cc79a7", 13},
    {Method::warnock, std::nullopt, Edition::corrected, "#000000", 5},
    {Method::warnock, std::nullopt, Edition::printed, "#000000", 4},
    {Method::zbuffer, Knob::bits, Edition::corrected, "#d55e00", 8},
    {Method::zbuffer, Knob::grid, Edition::corrected, "#e69f00", 10},
    {Method::zbuffer, Knob::depth, Edition::corrected, "#009e73", 12},
    {Method::zbuffer, std::nullopt, Edition::corrected, "#000000", 7},
    {Method::zbuffer, std::nullopt, Edition::printed, "#000000", 6},
    {Method::warnock_simplest, std::nullopt, Edition::corrected, "#0072b2", 1},
    {Method::warnock_full, std::nullopt, Edition::corrected, "#0072b2", 2},
    {Method::warnock_angles, std::nullopt, Edition::corrected, "#0072b2", 3},
    {Method::warnock_vertex, std::nullopt, Edition::corrected, "#cc79a7", 1},
    {Method::warnock_edges, std::nullopt, Edition::corrected, "#cc79a7", 2},
    {Method::warnock_bodies, std::nullopt, Edition::corrected, "#cc79a7", 3},
    {Method::weiler_atherton, std::nullopt, Edition::corrected, "#009e73", 1},
}};

constexpr int most_panel_height = 520, legend_entry = 400, legend_line = 30;

std::string style_of(const Series& series) {
    return "lc '" + std::string(series.color) + "' pt " + std::to_string(series.point) + " ps 0.8 lw 2";
}

/// In single quotes gnuplot takes everything for itself, a quote excepted.
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

struct Mark {
    double x, y;
    std::string name;

    bool operator<(const Mark& other) const { return std::tie(x, y) < std::tie(other.x, other.y); }
};

/// A scene's runs in two of their measures. Errors go by decades; 0 has a place of its own below them, and an infinite one
/// above.
class Panel {
public:
    Panel(const SceneChart& scene, std::size_t cost, std::size_t error, const ChartWords& words)
        : scene_(scene), cost_(cost), error_(error), words_(words) {
        double least = infinity;
        double most = 0;
        for (const auto& run : scene.runs) {
            const double value = error_of(run);
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
        std::string text = "set title " +
                           in_quotes(scene_.name + " (" +
                                     std::string(scene_.degenerate() ? words_.degenerate : words_.ordinary) + ")") +
                           " noenhanced\nset xlabel " + in_quotes(words_.costs[cost_]) + "\nset ylabel " +
                           in_quotes(words_.errors[error_]) + "\nset yrange [" + power_of_ten(bottom) + ":" +
                           power_of_ten(top) + "]\nset ytics (" + ytics() + ")\nunset label\n" + labels();
        text += block("front", front());
        std::string plots =
            "$front with steps lc '#bbbbbb' lw 6 notitle, $front with points pt 7 ps 2.2 lc '#dddddd' notitle";
        for (std::size_t i = 0; i < all_series.size(); ++i) {
            const std::string name = "series" + std::to_string(i);
            text += block(name, marks_of(all_series[i]));
            plots += ", $" + name + (all_series[i].knob ? " with linespoints " : " with points ") +
                     style_of(all_series[i]) + " notitle";
        }
        return text + "plot " + plots + "\n";
    }

private:
    static constexpr double infinity = std::numeric_limits<double>::infinity();

    /// In per cent, or in ulps.
    double error_of(const ChartRun& run) const {
        const auto& axis = error_axes[error_];
        const double value = axis.of(run);
        if (axis.name == "depthUlps") return value;
        return 100 * (axis.name == "wrongDecisions" ? value : value / double(scene_.pixels));
    }

    double height_of(const ChartRun& run) const {
        const double error = error_of(run);
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

    std::vector<Mark> marks(const auto& belongs) const {
        std::vector<Mark> marks;
        for (const auto& run : scene_.runs) {
            const auto cost = cost_axes[cost_].of(run);
            if (cost && belongs(run))
                marks.push_back({*cost, height_of(run), std::string(run.way.kernel.choice->name)});
        }
        return marks;
    }
    std::vector<Mark> marks_of(const Series& series) const {
        return marks([&](const ChartRun& run) { return series.has(run.way); });
    }
    std::vector<Mark> front() const {
        auto front = marks([&](const ChartRun& run) { return run.on_front[cost_][error_]; });
        std::sort(front.begin(), front.end());
        return front;
    }

    static std::string block(const std::string& name, const std::vector<Mark>& marks) {
        std::string text = "$" + name + " << END\n";
        for (const auto& [x, y, label] : marks) text += number(x) + " " + number(y) + "\n";
        if (marks.empty()) text += "NaN NaN\n";
        return text + "END\n";
    }

    /// The kernels of the corrected text stand by their points, those of Warnock's algorithm above and those of the Z-buffer
    /// below; points that are close together have one label.
    std::string labels() const {
        constexpr double close = 2.5;
        std::string text;
        for (const auto& series : all_series) {
            if (series.knob || series.edition == Edition::printed) continue;
            auto named = marks_of(series);
            std::sort(named.begin(), named.end());
            std::vector<Mark> labels;
            for (const auto& mark : named) {
                if (!labels.empty() && mark.x < close * labels.back().x && mark.y == labels.back().y) {
                    labels.back().name += ", " + mark.name;
                } else {
                    labels.push_back(mark);
                }
            }
            const std::string offset = is_warnock(series.method) ? "-0.6,0.9" : "-0.6,-0.9";
            for (const auto& [x, y, name] : labels) {
                text += "set label " + in_quotes(name) + " at " + number(x) + "," + number(y) + " left offset " +
                        offset + " font ',13'\n";
            }
        }
        return text;
    }

    const SceneChart& scene_;
    std::size_t cost_, error_;
    const ChartWords& words_;
    bool has_zero_ = false, has_infinity_ = false;
    int lowest_ = 0, highest_ = 1;  // decades of what is neither
};

/// The names of the series, and of the front.
std::string legend(int rows, const ChartWords& words) {
    std::string text =
        "unset title\nunset xlabel\nunset ylabel\nunset tics\nunset border\nset key center center maxrows " +
        std::to_string(rows) +
        "\n"
        "set margins 0, 0, 0, 0\n"
        "set xrange [1:2]\nset yrange [1:2]\n"
        "plot NaN with lines lc '#bbbbbb' lw 6 title " +
        in_quotes(words.front);
    for (std::size_t i = 0; i < all_series.size(); ++i) {
        const auto& series = all_series[i];
        text += std::string(", NaN with ") + (series.knob ? "linespoints " : "points ") + style_of(series) + " title " +
                in_quotes(words.series[i]);
    }
    return text + "\n";
}

}  // namespace

std::string chart_script(const std::vector<SceneChart>& scenes, std::size_t cost, std::size_t error,
                         const ChartLayout& layout) {
    auto ordered = scenes;
    std::stable_partition(ordered.begin(), ordered.end(), [](const auto& scene) { return !scene.degenerate(); });
    const int columns = std::min(int(ordered.size()), layout.columns);
    const int rows = (int(ordered.size()) + columns - 1) / columns;
    const int width = columns * layout.panel_width;
    const int panel_height = std::min(most_panel_height, layout.panel_width * 3 / 4);
    const int entries = int(all_series.size()) + 1;
    const int entries_in_row = std::max(1, width / legend_entry);
    const int legend_rows = std::max(3, (entries + entries_in_row - 1) / entries_in_row);
    const int legend_height = (legend_rows + 1) * legend_line;
    const int height = rows * panel_height + legend_height;

    std::ostringstream out;
    out << "set encoding utf8\nset terminal svg size " << width << "," << height << " font "
        << in_quotes(std::string(layout.font) + ",15") << " background 'white'\n"
        << "set multiplot\nset logscale xy\nset format x '" << (cost_axes[cost].name == "time" ? "%g" : "10^{%T}")
        << "'\nset grid lc '#e5e5e5' lt 1\nunset key\n";
    const double panel_share = double(panel_height) / height;
    for (std::size_t i = 0; i < ordered.size(); ++i) {
        const int row = int(i) / columns;
        out << "set origin " << double(int(i) % columns) / columns << "," << 1 - (row + 1) * panel_share
            << "\nset size " << 1.0 / columns << "," << panel_share << '\n'
            << Panel(ordered[i], cost, error, layout.words).script();
    }
    out << "set origin 0,0\nset size 1," << double(legend_height) / height << '\n'
        << legend(legend_rows, layout.words) << "unset multiplot\n";
    return out.str();
}

}  // namespace vidno
