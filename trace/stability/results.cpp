#include "stability/results.h"

#include <algorithm>
#include <charconv>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <queue>
#include <utility>

#include "json/document_format.h"
#include "refused.h"
#include "stability/journal.h"

namespace vidno {

namespace {

using Json = nlohmann::ordered_json;

Campaign campaign_from(const Json& object) {
    Campaign campaign;
    campaign.version = object.value("version", "");
    object.at("seed").get_to(campaign.seed);
    object.at("count").get_to(campaign.count);
    object.at("families").get_to(campaign.families);
    object.at("kernels").get_to(campaign.kernels);
    object.at("methods").get_to(campaign.methods);
    return campaign;
}

Tallies tallies_from(const Json& entries) {
    Tallies tallies;
    for (const auto& entry : entries) {
        Tally& tally = tallies.emplace_back();
        for (const auto& [name, value] : tally_fields) entry.at(std::string(name)).get_to(tally.*value);
        tally.skipped = entry.value("skipped", std::uint64_t{0});
        tally.failing = entry.value("failing", std::vector<std::uint64_t>());
    }
    return tallies;
}

[[noreturn]] void refuse_line(const std::string& place) {
    throw Refused(place + ": not a line of " + std::string(results_format) +
                  ", or a block that came out otherwise before");
}

/// Reads the campaign in the first line of a file. A line counts if it is the one that we would write.
Campaign read_campaign(LineReader& lines, const std::string& file) {
    std::string line;
    const bool has_one = lines.next(line);
    expect_format_in(line, results_format, file);
    try {
        if (has_one && !lines.cut()) {
            Campaign campaign = campaign_from(Json::parse(line));
            if (header_of(campaign) == line + "\n") return campaign;
        }
    } catch (const Json::exception&) {
    }
    refuse_line(file + ":1");
}

void expect_same(const Campaign& campaign, const Campaign& other, const std::string& file) {
    const auto version = [](const Campaign& of) {
        return of.version.empty() ? "one before files named it" : of.version;
    };
    Campaign same_version = other;
    same_version.version = campaign.version;
    if (same_version != campaign) throw Refused(file + ": belongs to another campaign");
    if (other.version != campaign.version) {
        throw Refused(file + ": was made by version " + version(other) + ", not " + version(campaign) +
                      "; results of different versions are not added");
    }
}

/// The lines of a file after the first, in the order of blocks.
class SortedLines {
public:
    /// Throws Refused if the file is not one of the campaign.
    SortedLines(std::string file, const Campaign& campaign) : file_(std::move(file)) {
        bool is_sorted = true;
        std::uint64_t before = 0;
        begin(campaign);
        for (std::string line; is_sorted && read(line);) {
            const std::uint64_t number = number_of(line);
            is_sorted = number >= before;
            before = number;
        }
        begin(campaign);
        if (is_sorted) return;
        auto& all = whole_.emplace();
        for (std::string line; read(line);) all.push_back({number_of(line), line_, line});
        std::stable_sort(all.begin(), all.end(), [](const Line& a, const Line& b) { return a.number > b.number; });
    }

    /// Goes to the next line; false at the end.
    bool next() {
        if (!whole_) return read(text);
        if (whole_->empty()) return false;
        text = std::move(whole_->back().text);
        line_ = whole_->back().line;
        whole_->pop_back();
        return true;
    }

    std::string text;
    /// The block's number with which the line begins. Whether the rest is right is seen when it is added.
    std::uint64_t number() const { return number_of(text); }
    std::string place() const { return file_ + ":" + std::to_string(line_); }

private:
    struct Line {
        std::uint64_t number, line;
        std::string text;
    };

    void begin(const Campaign& campaign) {
        lines_.emplace(file_);
        expect_same(campaign, read_campaign(*lines_, file_), file_);
        line_ = 1;
    }

    bool read(std::string& line) {
        if (!lines_->next(line) || lines_->cut()) return false;
        ++line_;
        return true;
    }

    std::uint64_t number_of(const std::string& line) const {
        constexpr std::string_view start = "{\"block\":";
        std::uint64_t number = 0;
        const char* begin = line.data() + std::min(start.size(), line.size());
        const auto [end, error] = std::from_chars(begin, line.data() + line.size(), number);
        if (!line.starts_with(start) || error != std::errc()) refuse_line(place());
        return number;
    }

    std::string file_;
    std::optional<LineReader> lines_;
    std::uint64_t line_ = 1;
    std::optional<std::vector<Line>> whole_;  // of a file in another order, the last block first
};

}  // namespace

Campaign campaign_in(const std::string& file) {
    LineReader lines(file);
    return read_campaign(lines, file);
}

std::string header_of(const Campaign& campaign) {
    Json object{{"format", results_format}};
    if (!campaign.version.empty()) object["version"] = campaign.version;
    object["seed"] = campaign.seed;
    object["count"] = campaign.count;
    object["families"] = campaign.families;
    object["kernels"] = campaign.kernels;
    object["methods"] = campaign.methods;
    return object.dump() + "\n";
}

std::string line_of(const Campaign& campaign, const Block& block, const Tallies& tallies) {
    Json object{{"block", block.number},
                {"family", block.family->name},
                {"experiment", kind_names[std::size_t(block.experiment->kind)]},
                {"how", block.experiment->how},
                {"first", block.first},
                {"end", block.end}};
    auto tally = tallies.begin();
    for (const auto& kernel : campaign.kernels) {
        for (const auto& method : campaign.methods) {
            Json entry{{"kernel", kernel}, {"method", method}};
            for (const auto& [name, value] : tally_fields) entry[std::string(name)] = *tally.*value;
            if (tally->skipped > 0) entry["skipped"] = tally->skipped;
            if (!tally->failing.empty() && !campaign.version.empty()) entry["failing"] = tally->failing;
            object["tallies"].push_back(std::move(entry));
            ++tally;
        }
    }
    return object.dump() + "\n";
}

Results::Results(Campaign campaign)
    : campaign_(std::move(campaign)),
      blocks_(campaign_),
      missing_(blocks_.all()),
      lines_(blocks_.size()),
      sums_(campaign_.families.size() * experiments.size(), Tallies(tallies_of(campaign_))) {}

bool Results::has(const Block& block) const { return block.first == block.end || lines_[block.number] != 0; }

std::size_t Results::place_of(std::string_view family, const Experiment& experiment) const {
    const auto found = std::find(campaign_.families.begin(), campaign_.families.end(), family);
    return std::size_t(found - campaign_.families.begin()) * experiments.size() +
           std::size_t(&experiment - experiments.data());
}

std::string Results::add(const Block& block, const Tallies& tallies) {
    std::string line = line_of(campaign_, block, tallies);
    add(block, tallies, line);
    return line;
}

void Results::add(const Block& block, const Tallies& tallies, const std::string& line) {
    const std::size_t hash = std::hash<std::string>()(line) | 1U;
    if (has(block)) {
        if (lines_[block.number] != hash) throw Refused("a block that came out otherwise before");
        return;
    }
    lines_[block.number] = hash;
    --missing_;
    add_to(sums_[place_of(block.family->name, *block.experiment)], tallies);
}

void Results::add_line(const std::string& line, const std::string& place) {
    try {
        const Json object = Json::parse(line);
        const auto number = object.at("block").get<std::uint64_t>();
        const Tallies tallies = tallies_from(object.at("tallies"));
        if (number < blocks_.size() && tallies.size() == tallies_of(campaign_)) {
            const Block block = blocks_.at(number);
            if (block.first < block.end && line_of(campaign_, block, tallies) == line + "\n") {
                add(block, tallies, line + "\n");
                return;
            }
        }
    } catch (const Json::exception&) {
    } catch (const Refused&) {
    }
    refuse_line(place);
}

void Results::add_file(const std::string& file) {
    LineReader lines(file);
    expect_same(campaign_, read_campaign(lines, file), file);
    std::string line;
    for (std::uint64_t number = 2; lines.next(line) && !lines.cut(); ++number) {
        add_line(line, file + ":" + std::to_string(number));
    }
}

const Tallies& Results::sum(std::string_view family, const Experiment& experiment) const {
    return sums_.at(place_of(family, experiment));
}

bool Results::as_promised() const {
    return std::all_of(sums_.begin(), sums_.end(), [&](const Tallies& tallies) {
        for (std::size_t i = 0; i < tallies.size(); ++i) {
            const NamedKernel kernel = *kernel_named(campaign_.kernels[i / campaign_.methods.size()]);
            if (kernel.is_always_right() && !tallies[i].all_right()) return false;
        }
        return true;
    });
}

Results merged(const std::vector<std::string>& files, OutputFile* output) {
    Results results(campaign_in(files.front()));
    std::vector<std::unique_ptr<SortedLines>> sorted;
    // The lines that come next, with their files, the least number first.
    using Next = std::pair<std::uint64_t, std::size_t>;
    std::priority_queue<Next, std::vector<Next>, std::greater<>> heads;
    const auto advance = [&](std::size_t file) {
        if (sorted[file]->next()) heads.emplace(sorted[file]->number(), file);
    };
    for (const auto& file : files) {
        sorted.push_back(std::make_unique<SortedLines>(file, results.campaign()));
        advance(sorted.size() - 1);
    }
    if (output != nullptr) output->write(header_of(results.campaign()));
    while (!heads.empty()) {
        const std::size_t file = heads.top().second;
        heads.pop();
        const std::uint64_t missing = results.missing();
        results.add_line(sorted[file]->text, sorted[file]->place());
        if (output != nullptr && results.missing() < missing) output->write(sorted[file]->text + "\n");
        advance(file);
    }
    return results;
}

void extend(const std::string& file, std::uint64_t count) {
    Campaign campaign = campaign_in(file);
    if (campaign.version.empty()) {
        throw Refused(file + ": was made by an earlier version, whose campaigns cannot be extended");
    }
    if (count <= campaign.count) {
        throw Refused(file + ": has " + std::to_string(campaign.count) + " trials of each experiment already");
    }
    const Journal locked(file, header_of(campaign));
    const Blocks before(campaign);
    SortedLines lines(file, campaign);
    campaign.count = count;
    const Blocks after(campaign);
    OutputFile extended(file);
    extended.write(header_of(campaign));
    while (lines.next()) {
        const std::uint64_t number = lines.number();
        if (number >= before.size() || before.at(number).end != after.at(number).end) break;
        extended.write(lines.text + "\n");
    }
    extended.commit();
}

}  // namespace vidno
