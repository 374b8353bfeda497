// Charts of surfaces: the cost of sampling and what it misses, on a surface small enough to be counted by hand.

#include "chart/surface_chart.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "chart/chart_input.h"
#include "figure/chart_figure.h"
#include "figure/writers.h"
#include "refused.h"
#include "run/floating_horizon_run.h"
#include "support/places.h"

using namespace vidno;
using nlohmann::json;
using test::without_places;

namespace {

/// Three level curves over 33 columns, in rows from below at 14, 10 and 6. The middle one has a peak at column 10, two
/// columns to each side and 6 rows high. It hides the last curve where 10 - 6 + 3 |x - 10| < 6, which is over column 10
/// alone.
const std::string peak = R"({"format":"vidno-surface/1","name":"Peak","window":{"x":0,"y":0,"width":33,"height":16},)"
                         R"("function":"z == 1 ? max(0, 6 - 3 * abs(x - 10)) : 0","x":[0,32],"z":[2,0],"curves":3,)"
                         R"("samples":9,"view":{"origin":[0,14],"across":[32,0],"back":[0,-4],"up":1}})";

Function function_of(const std::string& text) { return read_function(text, "s.json"); }

SurfaceChart charted(const std::string& text) {
    return chart_of(function_of(text), [] {});
}

SurfaceChartRun run_in(const SurfaceChart& chart, const std::string& kernel, Edition edition,
                       std::optional<SamplingKnob> knob, double value = 0) {
    const auto found = std::find_if(chart.runs.begin(), chart.runs.end(), [&](const SurfaceChartRun& run) {
        const SurfaceWay& way = run.way;
        return way.kernel.name() == kernel && way.edition == edition && way.knob == knob && way.value == value;
    });
    REQUIRE(found != chart.runs.end());
    return *found;
}

FloatingHorizonOperationCounts counted(std::uint64_t visibilities, std::uint64_t horizons, std::uint64_t steps,
                                       std::uint64_t crossings) {
    return {visibilities, horizons, steps, crossings};
}

}  // namespace

TEST_CASE("Chart of a surface: each kernel in each edition that it runs, on the file's sampling and each other") {
    const auto ways = ways_to_draw(function_of(peak).surface);
    // 2, 3, 5, 9, 17, 33 samples; 16, 8, ..., 1/16 pixel; and as they are: under float, double, filtered, exact, and as
    // printed under all of these but filtered.
    CHECK(ways.size() == (6 + 9 + 1) * (4 + 3));
    CHECK(turns_of(function_of(peak)) == ways.size() * 6);
    std::vector<double> samples;
    for (const auto& [kernel, edition, knob, value] : ways) {
        if (kernel.name() == "exact" && edition == Edition::printed && knob == SamplingKnob::samples) {
            samples.push_back(value);
        }
    }
    CHECK(samples == std::vector<double>{2, 3, 5, 9, 17, 33});
}

TEST_CASE("Chart of a surface: a peak that falls between two samples") {
    const SurfaceChart chart = charted(peak);
    CHECK(chart.curves == 3);
    CHECK(chart.columns == 3 * 33);
    for (const std::string kernel : {"float", "double", "filtered", "exact"}) {
        CAPTURE(kernel);
        const auto missed = run_in(chart, kernel, Edition::corrected, std::nullopt);
        CHECK(missed.cost.samples == 3 * 9);
        CHECK(missed.found.height == 6);
        CHECK_MESSAGE(missed.found.wrong_columns == 1, "the last curve over column 10");
        CHECK_MESSAGE(missed.found.wrong_decisions == 0, "every decision is right for these samples");
        // Everything is visible: each curve has 33 columns and 32 steps between them, and Horizon covers both columns
        // of each step.
        CHECK(missed.found.operations == counted(3 * 33, 3 * 32 * 2, 0, 0));

        const auto found = run_in(chart, kernel, Edition::corrected, SamplingKnob::samples, 33);
        CHECK(found.cost.samples == 3 * 33);
        CHECK(found.found.height == 0);
        CHECK(found.found.wrong_columns == 0);
        // 30 steps of the last curve are visible. On each of the two beside column 10 it meets the horizon: Horizon
        // covers one column, Intersection examines one and computes a crossing.
        CHECK(found.found.operations == counted(3 * 33, 2 * 64 + 30 * 2 + 2, 2, 2));
        CHECK(found.cost.operations == 99 + 190 + 2 + 2);
    }
}

TEST_CASE("Chart of a surface: a tolerance takes the samples that the function needs") {
    const SurfaceChart chart = charted(peak);
    // Intervals that contain the peak are halved: 0, 8, 10, 12, 16, 32. The level curves have only their ends.
    for (const double tolerance : {4., 1., 1 / 16.}) {
        CAPTURE(tolerance);
        const auto found = run_in(chart, "double", Edition::corrected, SamplingKnob::tolerance, tolerance);
        CHECK(found.cost.samples == 6 + 2 + 2);
        CHECK(found.found.height == 0);
        CHECK(found.found.wrong_columns == 0);
    }
    const auto missed = run_in(chart, "double", Edition::corrected, SamplingKnob::tolerance, 8);
    CHECK_MESSAGE(missed.cost.samples == 3 * 2, "no column is farther off than 8 pixels");
    CHECK(missed.found.height == 6);
}

TEST_CASE("Chart of a surface: as printed, only columns with samples are examined") {
    const SurfaceChart chart = charted(peak);
    // Each curve has 9 columns, and 8 steps of 4 columns, each covering 5; both side edges of the second and third
    // curve cover one column each.
    const auto missed = run_in(chart, "exact", Edition::printed, std::nullopt);
    CHECK(missed.found.operations == counted(3 * 9, 3 * 8 * 5 + 4, 0, 0));
    CHECK(missed.found.wrong_columns == 1);
}

TEST_CASE("Chart of a surface: no run is better than one on the front, and the first of equal runs counts") {
    const SurfaceChart chart = charted(peak);
    std::vector<std::pair<double, double>> front;  // samples, wrong columns
    for (const auto& run : chart.runs) {
        if (run.on_front[2][0]) front.emplace_back(run.cost.samples, double(run.found.wrong_columns));
    }
    std::sort(front.begin(), front.end());
    CHECK(front == std::vector<std::pair<double, double>>{{6, 1}, {10, 0}});
}

TEST_CASE("Chart of a surface: JSON, CSV, and JSON read again") {
    const std::vector<SurfaceChart> charts{charted(peak)};
    const std::string text = chart_json(charts);
    const json reported = json::parse(text);
    CHECK(reported["format"] == "vidno-chart/1");
    const json& surface = reported["surfaces"][0];
    CHECK(surface["name"] == "Peak");
    CHECK(surface["columns"] == 99);
    CHECK(surface["surface"] == json::parse(peak));
    const json& first = surface["runs"][0];
    CHECK(first["kernel"] == "float");
    CHECK(first["knob"].is_null());
    CHECK(first["samples"] == 27);
    CHECK(first["counts"]["visibilities"] == 99);
    CHECK(first["wrongColumns"] == 1);
    CHECK(first["height"] == 6);
    // The three curves are level but for the peak, so the right drawing has few points; the first run misses the peak.
    const json& shown = surface["pictures"]["shown"];
    CHECK(shown[0].size() == 4);
    CHECK(shown[std::size_t(first["picture"])].size() == 3);

    std::istringstream csv(chart_csv(charts));
    std::string head, row;
    std::getline(csv, head);
    CHECK(head.starts_with("surface.name,surface.curves,surface.columns,method,kernel,edition,knob,value,seconds,"));
    std::getline(csv, row);
    CHECK(row.starts_with("\"Peak\",3,99,\"floating-horizon\",\"float\",\"corrected\",,,"));

    const AnyChart again = read_chart(text, "chart.json");
    REQUIRE(std::holds_alternative<std::vector<SurfaceChart>>(again));
    const auto& surfaces = std::get<std::vector<SurfaceChart>>(again);
    const auto figure = [](const SurfaceChart& chart) {
        return figures::svg_of(figures::chart_figure({figures::panel_of(chart, 2, 0, Language::english)}, {}, 80), {});
    };
    CHECK_MESSAGE(figure(surfaces.front()) == figure(charts.front()), "all that a figure needs is read");
}

TEST_CASE("Chart of a surface: samples alone have no function, and a function is finite somewhere") {
    const auto refusal = [](const std::string& text) -> std::string {
        try {
            function_of(text);
        } catch (const Refused& refused) {
            return refused.what();
        }
        return "taken";
    };
    CHECK(without_places(
              refusal(R"({"format":"vidno-surface/1","window":{"x":0,"y":0,"width":9,"height":9},"curves":[]})")) ==
          "s.json: has no function that could be sampled in other ways");
    // Between the samples 0, 4, 8, ...; column 5 is where x is 5.
    std::string text = peak;
    const std::string level = "z == 1 ? max(0, 6 - 3 * abs(x - 10)) : 0";
    const auto with = [&](const std::string& function) {
        return std::string(text).replace(text.find(level), level.size(), function);
    };
    CHECK(without_places(refusal(with("sqrt(-1 - x^2)"))) == "s.json: /function: not finite at any sample");
    const SurfaceChart chart = charted(with("x == 5 ? 1 / 0 : 0"));
    CHECK_MESSAGE(chart.columns == 3 * 32, "of 33, one is the gap");
    for (const auto& run : chart.runs) {
        if (run.way.kernel.name() != "filtered" || run.way.knob != SamplingKnob::tolerance) continue;
        CHECK(run.found.wrong_columns == 0);
        CHECK(run.found.height == 0);
    }
}
