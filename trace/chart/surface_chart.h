/// SurfaceChart: the cost of each sampling of a surface, and the distance of its drawing from the function. Chart does
/// the same for scenes.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "chart/axes.h"
#include "format/floating_horizon_trace.h"
#include "run/run.h"
#include "scene/surface.h"

namespace vidno {

/// How a surface is sampled if not as its file says: evenly, with a number of samples per curve; or from the ends of
/// each curve, with one more sample halfway wherever the curve is farther than a tolerance, in pixels, from the line
/// between two.
enum class SamplingKnob : unsigned char { samples, tolerance };
inline constexpr std::array<std::string_view, 2> sampling_knob_names{"samples", "tolerance"};

/// A way to draw a surface.
struct SurfaceWay {
    NamedKernel kernel;
    Edition edition = Edition::corrected;
    std::optional<SamplingKnob> knob{};
    double value = 0;  // its setting
};

/// The elementary steps of the listings: columns compared with the horizons, columns covered by Horizon, columns
/// examined by Intersection, and crossings computed.
enum class FloatingHorizonOperation : unsigned char { visibilities, horizons, steps, crossings };
inline constexpr std::array<std::string_view, 4> floating_horizon_operation_names{"visibilities", "horizons", "steps",
                                                                                  "crossings"};
using FloatingHorizonOperationCounts = std::array<std::uint64_t, floating_horizon_operation_names.size()>;

struct SurfaceCost {
    double seconds = 0;  // of the lines without a trace, from given samples
    double time = 0;     // relative to the surface's fastest run
    double operations = 0;
    double samples = 0;  // of all curves together
};

struct SurfaceFindings {
    FloatingHorizonOperationCounts operations{};
    std::uint64_t wrong_columns = 0;  // of all curves: drawn but hidden by the function, or not drawn but visible
    double height = 0;                // the farthest that a curve is from the function over a column, in pixels
    std::uint64_t decisions = 0, wrong_decisions = 0;
    DrawnLines lines{};
};

struct SurfaceChartRun {
    SurfaceWay way;
    SurfaceCost cost;
    SurfaceFindings found;
    Fronts<3, 3> on_front{};
    std::size_t picture = 0;  // the index of what it draws

    bool is_complete() const { return true; }  // no text of the floating horizon has a fault
};

extern const CostAxes<SurfaceChartRun, 3> surface_cost_axes;
extern const ErrorAxes<SurfaceChartRun, 3> surface_error_axes;

struct SurfaceChart {
    std::string name;
    std::size_t curves = 0, columns = 0;  // of all curves together
    std::vector<SurfaceChartRun> runs{};
    std::string surface{};   // its file, as it samples it
    std::string pictures{};  // as SurfacePictures writes them
};

/// Runs the sampling of the file, and both knobs at each setting, under each kernel that runs curves, in each edition
/// that this kernel runs.
std::vector<SurfaceWay> ways_to_draw(const FunctionSurface& surface);

/// The total over all curves; a chart takes no more.
inline constexpr std::size_t most_charted_columns = std::size_t{1} << 16;

/// How often a chart of the surface calls its `progress`.
std::size_t turns_of(const Function& function);

SurfaceChart chart_of(const Function& function, const std::function<void()>& progress);

std::string chart_json(const std::vector<SurfaceChart>& surfaces);
std::string chart_csv(const std::vector<SurfaceChart>& surfaces);

}  // namespace vidno
