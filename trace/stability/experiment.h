/// Experiment: the changes made to a family's scenes, and the results of the runs.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "run/run.h"
#include "scene/families.h"

namespace vidno {

/// The results of runs. "Wrong" is relative to exact arithmetic on the scene; under `grid`, on the snapped one.
struct Tally {
    std::uint64_t runs = 0, wrong_runs = 0;            // wrong: with a wrong pixel
    std::uint64_t pixels = 0, wrong_pixels = 0;        // of all runs
    std::uint64_t decisions = 0, wrong_decisions = 0;  // those with a truth; after a wrong decision some have none
    std::uint64_t steady = 0, flickers = 0;  // pixels that should not change from one scene to the next; that do
    std::uint64_t windows = 0;               // of Warnock's algorithm
    std::uint64_t skipped = 0;               // trials with a scene that the kernel cannot take
    std::vector<std::uint64_t>
        failing;  // the first trials with a wrong pixel, or one that flickers: at most `most_failing`

    Tally& operator+=(const Tally& other);
    bool all_right() const { return wrong_pixels + wrong_decisions + flickers == 0; }
    bool operator==(const Tally&) const = default;
};

inline constexpr std::size_t most_failing = 4;

/// By the names used in files, which have `skipped` only where it is not 0, and `failing` where there are some.
struct TallyField {
    std::string_view name;
    std::uint64_t Tally::*value;
};
inline constexpr std::array tally_fields{
    TallyField{"runs", &Tally::runs},           TallyField{"wrong_runs", &Tally::wrong_runs},
    TallyField{"pixels", &Tally::pixels},       TallyField{"wrong_pixels", &Tally::wrong_pixels},
    TallyField{"decisions", &Tally::decisions}, TallyField{"wrong_decisions", &Tally::wrong_decisions},
    TallyField{"steady", &Tally::steady},       TallyField{"flickers", &Tally::flickers},
    TallyField{"windows", &Tally::windows},
};

/// A tally for each kernel and method.
using Tallies = std::vector<Tally>;

struct Experiment {
    /// The kind of an experiment, which determines what is counted: decisions and pixels; pixels from scene to scene,
    /// twice; windows.
    enum class Kind : unsigned char { moved, swept, changed, grown };

    Kind kind;
    std::string_view how;  // different for each of a kind
    std::int64_t amount;   // in ulps, or in pixels of a side
    std::uint64_t price;   // the cost of a trial, in runs: there are fewer trials of expensive ones
    std::vector<AdmittedScene> (*series)(const Family&, RandomPolygons&, std::int64_t amount);  // the scenes of a trial
};

inline constexpr std::array<std::string_view, 4> kind_names{"moved", "swept", "changed", "grown"};

extern const std::array<Experiment, 21> experiments;

/// A method for polygons, or none for the floating horizon.
using TriedMethod = std::optional<Method>;

/// Runs a trial. A method counts nothing under a kernel that does not run it, or for a scene that it does not take. A
/// trial with a scene that is too wide for `grid` is skipped, and counted as such.
Tallies try_out(const Experiment& experiment, const std::vector<AdmittedScene>& series,
                const std::vector<NamedKernel>& kernels, const std::vector<TriedMethod>& methods);

/// Tries curves, whose columns count as pixels.
Tallies try_out(const AdmittedCurves& scene, const std::vector<NamedKernel>& kernels,
                const std::vector<TriedMethod>& methods);

}  // namespace vidno
