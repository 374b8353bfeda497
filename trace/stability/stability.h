/// Stability: campaigns of many small runs, and the sums of what went wrong in them.
///
/// A campaign puts families of scenes to experiments. The seed, the family and a trial's number determine its scenes, so
/// that trials may be made anywhere and in any order: they are made in blocks, and tallies add.
///
/// A file of results, `vidno-stability/1`, is the campaign in its first line and a finished block in each other one.
/// A last line that was cut short, by a kill, does not count.
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
    std::uint64_t count = 100;  // trials of an experiment in each family; of dear ones fewer
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

/// The family of that name. Throws Refused if there is none.
const Family& family_of(const std::string& name);

/// Throws Refused if a scene is too wide for `grid`.
Tallies run_block(const Campaign& campaign, const Block& block);

/// A scene of polygons, or of curves.
using AnyMoved = std::variant<Scene, CurveScene>;

/// The scenes of a family's trials that move coordinates, in their order, until `use` says that it has seen enough.
void for_each_moved(const Campaign& campaign, const Family& family, const std::function<bool(const AnyMoved&)>& use);

/// The finished blocks of a campaign.
class Results {
public:
    /// Throws Refused for a name that there is not, or too many trials.
    explicit Results(Campaign campaign);
    /// Of the files of one campaign. Throws Refused, also if they tell a block in different ways.
    static Results merged(const std::vector<std::string>& files);

    const Campaign& campaign() const { return campaign_; }
    const std::vector<Block>& blocks() const { return blocks_; }
    bool has(const Block& block) const { return finished_.count(block.number) > 0; }
    std::size_t missing() const { return blocks_.size() - finished_.size(); }

    void add(const Block& block, const Tallies& tallies);
    /// What a file of this campaign tells. Throws Refused.
    void add(const std::string& text, const std::string& file);

    /// A file's first line, another one, and the whole with its blocks in order.
    std::string header() const;
    std::string line(const Block& block) const;
    std::string text() const;

    /// Over the blocks of an experiment in a family.
    Tallies sum(std::string_view family, const Experiment& experiment) const;
    /// Whether no kernel that should always be right was wrong.
    bool as_promised() const;

private:
    Campaign campaign_;
    std::vector<Block> blocks_;
    std::map<std::uint64_t, Tallies> finished_;  // by the block's number
};

}  // namespace vidno
