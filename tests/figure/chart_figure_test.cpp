// Figures of charts: which runs they show, and that their names can be read.

#include "figure/chart_figure.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>

#include "support/scenes.h"
#include "vidno/admission.h"

using namespace vidno;
using namespace vidno::test;
using namespace vidno::figures;

namespace {

std::vector<Label> labels_of(const Drawing& drawing) {
    std::vector<Label> labels;
    for (const auto& thing : drawing.things) {
        if (const auto* label = std::get_if<Label>(&thing)) labels.push_back(*label);
    }
    return labels;
}

/// From the top of its capitals to its base line.
figures::Box box_of(const Label& label) {
    const double width = width_of(label.text, label.size, label.bold),
                 height = 0.7 * label.size / points_per_millimetre;
    const double left = label.at.x - (label.anchor == Anchor::start ? 0
                                      : label.anchor == Anchor::end ? width
                                                                    : width / 2);
    return {left, label.at.y - height, width, height};
}

bool has(const Drawing& drawing, const std::string& text) {
    return std::ranges::any_of(labels_of(drawing),
                               [&](const Label& each) { return each.text.find(text) != text.npos; });
}

/// Up to twelve runs, many of them with equal errors.
ChartPanel random_panel(std::mt19937& random) {
    const auto upto = [&](int most) { return int(random() % unsigned(most + 1)); };
    const double decades = 1 + upto(4);
    ChartPanel panel{.title = "A scene with a name of some length (degenerate)",
                     .cost = "operations × bits, times the fewest",
                     .error = "wrong pixels, %"};
    const std::vector<std::string> ways{"Z-buffer", "Warnock", "Warnock, split at a vertex"},
        kernels{"float", "double", "filtered", "exact"};
    for (int count = 1 + upto(11); count > 0; --count) {
        ChartMark mark;
        mark.cost = std::pow(10, decades * upto(4000) / 4000.);
        mark.error = upto(2) == 0    ? 0
                     : upto(20) == 0 ? std::numeric_limits<double>::infinity()
                                     : std::pow(10, upto(60) / 20. - 2);
        mark.way = ways[std::size_t(upto(2))];
        mark.kernel = kernels[std::size_t(upto(3))];
        mark.shape = ChartMark::Shape(upto(2));
        panel.marks.push_back(std::move(mark));
    }
    const auto cheapest = std::ranges::min_element(
        panel.marks, {}, [](const ChartMark& mark) { return std::pair(mark.error, mark.cost); });
    cheapest->is_cheapest = cheapest->error == 0;
    return panel;
}

}  // namespace

TEST_CASE(
    "The figure of a chart shows the course's methods under four kernels, and the cheapest right one of the others") {
    // Its outline lies between pixel centres, so all runs are right.
    const SceneChart chart = chart_of(SceneBuilder(area_16).quad(-1, -1, 17, 17, 0).build(), [] {});
    const ChartPanel panel = panel_of(chart, 1, 0, Language::english);
    std::multiset<std::string> ways;
    for (const ChartMark& mark : panel.marks) {
        CHECK(mark.error == 0);
        ways.insert(mark.way);
    }
    REQUIRE(panel.marks.size() == 9);
    CHECK(ways.count("Z-buffer") == 4);
    CHECK(ways.count("Warnock") == 4);
    // The Z-buffer takes 16 rows and 256 depths under each kernel. One that is right for every scene counts as cheaper.
    const auto cheapest = std::ranges::find_if(panel.marks, &ChartMark::is_cheapest);
    REQUIRE(cheapest != panel.marks.end());
    for (const ChartMark& mark : panel.marks) CHECK(cheapest->cost <= mark.cost);
}

TEST_CASE("The figure of a chart: no name covers another or a mark, none is cut off, and none is left out") {
    std::mt19937 random(4);
    for (int turn = 0; turn < 500; ++turn) {
        CAPTURE(turn);
        ChartPanel panel = random_panel(random);
        if (turn % 2 == 1) panel.title = "В трёх миллионах пикселей от начала координат (обычная)";
        if (turn % 5 == 0) panel.least = 1.2345;
        const double width = turn % 3 == 0 ? 60 : turn % 3 == 1 ? 80 : 120;
        const Drawing figure = chart_figure({panel}, {turn % 2 == 0 ? Language::english : Language::russian}, width);
        const std::vector<Label> labels = labels_of(figure);
        for (std::size_t i = 0; i < labels.size(); ++i) {
            const figures::Box box = box_of(labels[i]);
            CAPTURE(labels[i].text);
            CHECK(figures::Box{-0.1, 0, width + 0.2, figure.height}.holds(box));
            for (std::size_t k = 0; k < i; ++k) {
                CAPTURE(labels[k].text);
                CHECK_FALSE(box.overlaps(box_of(labels[k])));
            }
        }
        for (const ChartMark& mark : panel.marks)
            CHECK_MESSAGE(has(figure, mark.kernel), mark.way << " under " << mark.kernel);
    }
}

TEST_CASE("The figure of a chart names a scene of the course in its language") {
    const ChartPanel panel{.title = "Пять треугольников одной плоскости (вырожденная)", .cost = {}, .error = {}};
    CHECK(has(chart_figure({panel}, {Language::russian}, 80), "Пять треугольников"));
    CHECK(has(chart_figure({panel}, {Language::russian}, 80), "неверно"));
}

TEST_CASE("The figure of a chart is drawn of any numbers that a file may have") {
    // Times and errors at both ends of the range of double.
    SceneChart chart{.name = "Ends", .pixels = 1, .polygons = 1};
    const double largest = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
    for (const double end : {least, 1., largest}) {
        ChartRun run{{Method::zbuffer, *kernel_named("float")}, {end, end, end, end}, {}};
        run.found.depth_ulps = end;
        chart.runs.push_back(run);
    }
    for (std::size_t error = 0; error < error_axes.size(); ++error) {
        const Drawing figure = chart_figure({panel_of(chart, 0, error, Language::english)}, {}, 80);
        CHECK(has(figure, "Z-buffer"));
        CHECK(figure.height < 250);
    }
}
