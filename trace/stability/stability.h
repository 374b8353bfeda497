/// Stability: campaigns of many small runs, and the sums of their errors.
///
/// A campaign runs experiments on families of scenes. The seed, the family and a trial's number determine its scenes, so trials may run
/// anywhere and in any order. They run in blocks, and tallies add.
///
/// A file of results, `vidno-stability/1`, is the campaign in its first line and a finished block in each other one.
/// A last line does not count if it was cut short when the run was killed.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "stability/experiment.h"

namespace vidno {

struct Campaign {
    std::uint64_t seed = 1;
    std::uint64_t count = 100;  // trials of an experiment in each family; expensive experiments have fewer
    std::vector<std::string> families, kernels, methods;
    bool operator==(const Campaign&) const = default;
};

inline constexpr std::uint64_t most_trials = 10'000'000;

/// The trials first <= trial < end of an experiment in a family.
struct Block {
    std::uint64_t number;
    const Family* family;
    const Experiment* experiment;
    std::uint64_t first, end;
};

/// The family with this name. Throws Refused if there is none.
const Family& family_of(const std::string& name);

Tallies run_block(const Campaign& campaign, const Block& block);

/// A scene of polygons, or of curves.
using AnyMoved = std::variant<AdmittedScene, AdmittedCurves>;

/// Passes the scenes of a family's trials that move coordinates to `use`, in order, until it returns that it has seen enough.
void for_each_moved(const Campaign& campaign, const Family& family, const std::function<bool(const AnyMoved&)>& use);

/// The finished blocks of a campaign.
class Results {
public:
    /// Throws Refused for an unknown name, or too many trials.
    explicit Results(Campaign campaign);
    /// Merges the files of one campaign. Throws Refused, also if they have different results for a block.
    static Results merged(const std::vector<std::string>& files);

    const Campaign& campaign() const { return campaign_; }
    const std::vector<Block>& blocks() const { return blocks_; }
    bool has(const Block& block) const { return finished_.count(block.number) > 0; }
    std::size_t missing() const { return blocks_.size() - finished_.size(); }

    void add(const Block& block, const Tallies& tallies);
    /// Adds the results in a file of this campaign. Throws Refused.
    void add(const std::string& text, const std::string& file);

    /// The first line of a file, another line, and the whole file with its blocks in order.
    std::string header() const;
    std::string line(const Block& block) const;
    std::string text() const;

    /// The sum over the blocks of an experiment in a family.
    Tallies sum(std::string_view family, const Experiment& experiment) const;
    /// Whether every kernel that should always be right was right.
    bool as_promised() const;

private:
    Campaign campaign_;
    std::vector<Block> blocks_;
    std::map<std::uint64_t, Tallies> finished_;  // by the block's number
};

}  // namespace vidno
