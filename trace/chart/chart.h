/// Chart: the cost and the error of each way to draw a scene. CHART.md explains the numbers.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "chart/axes.h"
#include "check/examiner.h"

namespace vidno {

inline constexpr std::string_view chart_format = "vidno-chart/1";

/// The setting that is reduced in a run; none in a run of a plain kernel and edition.
enum class Knob : unsigned char { bits, depth, grid, window };
inline constexpr std::array<std::string_view, 4> knob_names{"bits", "depth", "grid", "window"};

/// A way to draw a scene.
struct Way {
    Method method;
    NamedKernel kernel;
    Edition edition = Edition::corrected;
    int smallest_window = 1;
    std::optional<Knob> knob{};
    int value = 0;  // its setting
};

struct Cost {
    double seconds = 0;  // the time of a run without a trace
    double time = 0;     // relative to the scene's fastest run
    double operations = 0;
    std::optional<double> bits{};  // operations by the bits of their numbers
};

struct ChartRun {
    Way way;
    Cost cost;
    Findings found;
    Fronts<3, 4> on_front{};
    std::size_t picture = 0;  // the index of what it shows

    bool is_complete() const { return found.complete; }
};

extern const CostAxes<ChartRun, 3> cost_axes;
extern const ErrorAxes<ChartRun, 4> error_axes;

struct SceneChart {
    std::string name;
    std::size_t unsteady = 0;  // pixels that an ulp can change
    std::size_t pixels = 0, polygons = 0;
    double area = 0;  // in pixels: the area that even the right picture shows in a wrong colour
    std::vector<ChartRun> runs{};
    std::string scene{};     // the scene itself, as scene_json writes it
    std::string pictures{};  // as ScenePictures writes them

    bool degenerate() const { return unsteady > 0; }
};

/// Runs each method of the course under each kernel in each edition, and with each knob at each setting. Runs the other
/// methods that take the scene under each kernel that runs them, with one `bits` and one `grid`.
std::vector<Way> ways_to_draw(const Scene& scene);

inline constexpr int chart_rounds = 5;
inline constexpr int largest_charted_side = 512;  // in pixels; a chart of a larger area would take minutes

/// How often a chart of the scene calls its `progress`.
std::size_t turns_of(const Scene& scene);

SceneChart chart_of(const AdmittedScene& scene, const std::function<void()>& progress);

std::string chart_json(const std::vector<SceneChart>& scenes);
std::string chart_csv(const std::vector<SceneChart>& scenes);

}  // namespace vidno
