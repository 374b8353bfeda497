/// Results: the finished blocks of a campaign, and the sums of their errors.
///
/// A file of results, `vidno-stability/1`, is the campaign in its first line and a finished block in each other one.
/// A last line does not count if it was cut short when the run was killed.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "output.h"
#include "stability/campaign.h"

namespace vidno {

inline constexpr std::string_view results_format = "vidno-stability/1";

/// The campaign in the first line of a file. Throws Refused if the file is none of results.
Campaign campaign_in(const std::string& file);

/// The first line of a campaign's file, and a line for a finished block.
std::string header_of(const Campaign& campaign);
std::string line_of(const Campaign& campaign, const Block& block, const Tallies& tallies);

class Results {
public:
    /// Throws Refused for an unknown name, or too many trials.
    explicit Results(Campaign campaign);

    const Campaign& campaign() const { return campaign_; }
    const Blocks& blocks() const { return blocks_; }
    /// Whether a block is finished, or has no trials.
    bool has(const Block& block) const;
    std::uint64_t missing() const { return missing_; }

    /// Adds a finished block, and gives its line for a file; it counts once, however often it is added. Throws Refused
    /// if it came out otherwise before.
    std::string add(const Block& block, const Tallies& tallies);
    /// Adds what the line of a file holds.
    void add_line(const std::string& line, const std::string& place);
    /// Adds what the lines of a file of this campaign hold.
    void add_file(const std::string& file);

    /// The sum over the blocks of an experiment in a family.
    const Tallies& sum(std::string_view family, const Experiment& experiment) const;
    /// Whether every kernel that should always be right was right.
    bool as_promised() const;

private:
    void add(const Block& block, const Tallies& tallies, const std::string& line);
    std::size_t place_of(std::string_view family, const Experiment& experiment) const;  // in sums_

    Campaign campaign_;
    Blocks blocks_;
    std::uint64_t missing_;
    std::vector<std::size_t> lines_;  // a hash of each finished block's line, by number; otherwise 0
    std::vector<Tallies> sums_;       // by family and, within it, experiment
};

/// Merges the files of one campaign, and writes the merged file if there is an output. A file in the order of blocks is
/// read line by line, another as a whole. Throws Refused, also if files have different results for a block, or were
/// made by different versions.
Results merged(const std::vector<std::string>& files, OutputFile* output);

/// Gives a file of results more trials, by its first line. The first block that will have more of them is dropped with
/// those after it, at most a round, so that a run continues the file in order. Throws Refused if the file has as many
/// trials already.
void extend(const std::string& file, std::uint64_t count);

}  // namespace vidno
