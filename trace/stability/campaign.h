/// Campaign: experiments on families of random scenes, in blocks of trials.
///
/// The seed, the family and a trial's number determine its scenes, so trials may run anywhere and in any order.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "stability/experiment.h"

namespace vidno {

struct Campaign {
    std::string version;  // of the program that runs it; empty in a file from before files named it
    std::uint64_t seed = 1;
    std::uint64_t count = 100;  // trials of an experiment in each family; expensive experiments have fewer
    std::vector<std::string> families, kernels, methods;
    bool operator==(const Campaign&) const = default;
};

inline constexpr std::uint64_t most_trials = 10'000'000;

/// The family with this name. Throws Refused if there is none.
const Family& family_of(const std::string& name);
/// The experiment with this name, "moved-2^8"; its spaces may be dashes. Throws Refused if there is none.
const Experiment& experiment_of(const std::string& name);
std::string name_of(const Experiment& experiment);

/// The trials first <= trial < end of an experiment in a family.
struct Block {
    std::uint64_t number;
    const Family* family;
    const Experiment* experiment;
    std::uint64_t first, end;
};

/// The blocks of a campaign by number. They come in rounds: in each, every experiment in every family has trials of
/// about the same cost. So a campaign with more trials has the same blocks, those of the last round perhaps with more
/// trials, and then others.
class Blocks {
public:
    /// Throws Refused for an unknown name, or too many trials.
    explicit Blocks(const Campaign& campaign);

    /// One more than the highest number.
    std::uint64_t size() const;
    /// The block with a number below size(). It may have no trials; then it is none of the campaign's.
    Block at(std::uint64_t number) const;
    /// How many have trials.
    std::uint64_t all() const;

private:
    std::uint64_t trials_of(const Experiment& experiment) const;

    std::uint64_t count_, rounds_;
    std::vector<const Family*> families_;
    bool are_by_family_;  // in a file that names no version: the rounds of an experiment follow each other
};

/// A scene of curves, or the series of scenes of polygons that a trial runs.
using TrialScenes = std::variant<AdmittedCurves, std::vector<AdmittedScene>>;

/// The scenes of a trial. Throws Refused for a family of curves and an experiment that does not move coordinates.
TrialScenes scenes_of(std::uint64_t seed, const Family& family, const Experiment& experiment, std::uint64_t trial);

/// A tally for each kernel and, within it, each method of the campaign.
Tallies run_trial(const Campaign& campaign, const Family& family, const Experiment& experiment, std::uint64_t trial);
Tallies run_block(const Campaign& campaign, const Block& block);

/// The number of tallies of a block.
std::size_t tallies_of(const Campaign& campaign);

/// Adds tallies to others of the same campaign.
void add_to(Tallies& sum, const Tallies& tallies);

}  // namespace vidno
