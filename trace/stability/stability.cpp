#include "stability/stability.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "choice/method.h"
#include "json/document_format.h"
#include "output.h"
#include "refused.h"

namespace vidno {

namespace {

constexpr std::string_view results_format = "vidno-stability/1";

using Json = nlohmann::ordered_json;

// ------------------------------------------------------------------------------------- what the names stand for

NamedKernel known_kernel(const std::string& name) {
    const auto kernel = kernel_named(name);
    if (!kernel) throw Refused("there is no kernel " + name);
    return *kernel;
}

TriedMethod known_method(const std::string& name) {
    if (name == floating_horizon_method) return std::nullopt;
    const auto found = std::find(method_names.begin(), method_names.end(), name);
    if (found == method_names.end()) throw Refused("there is no method " + name);
    return Method(found - method_names.begin());
}

template <class Named>
auto all_named(const std::vector<std::string>& names, Named named) {
    std::vector<decltype(named(names.front()))> all;
    for (const auto& name : names) all.push_back(named(name));
    return all;
}

std::vector<Block> blocks_of(const Campaign& campaign) {
    constexpr std::uint64_t runs_at_once = 128;
    const auto divided = [](std::uint64_t whole, std::uint64_t by) { return (whole + by - 1) / by; };
    std::vector<Block> blocks;
    for (const auto& family : campaign.families) {
        for (const auto& experiment : experiments) {
            const std::uint64_t trials = divided(campaign.count, experiment.price);
            const std::uint64_t at_once = divided(runs_at_once, experiment.price);
            for (std::uint64_t first = 0; first < trials; first += at_once) {
                const std::uint64_t end = std::min(first + at_once, trials);
                blocks.push_back({blocks.size(), &family_of(family), &experiment, first, end});
            }
        }
    }
    return blocks;
}

RandomPolygons random_of(const Campaign& campaign, const Family& family, std::uint64_t trial) {
    const auto place =
        family.curves ? std::ptrdiff_t(families.size()) + (&family - curve_families.data()) : &family - families.data();
    std::seed_seq seeds{std::uint32_t(campaign.seed), std::uint32_t(campaign.seed >> 32), std::uint32_t(place),
                        std::uint32_t(trial)};
    return RandomPolygons(std::mt19937(seeds));
}

std::size_t tallies_of(const Campaign& campaign) { return campaign.kernels.size() * campaign.methods.size(); }

void add_to(Tallies& sum, const Tallies& tallies) {
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += tallies[i];
}

// ------------------------------------------------------------------------------------- as text

Json json_of(const Campaign& campaign) {
    return {{"format", results_format},      {"seed", campaign.seed},       {"count", campaign.count},
            {"families", campaign.families}, {"kernels", campaign.kernels}, {"methods", campaign.methods}};
}

Campaign campaign_from(const Json& object) {
    Campaign campaign;
    object.at("seed").get_to(campaign.seed);
    object.at("count").get_to(campaign.count);
    object.at("families").get_to(campaign.families);
    object.at("kernels").get_to(campaign.kernels);
    object.at("methods").get_to(campaign.methods);
    return campaign;
}

Json json_of(const Campaign& campaign, const Block& block, const Tallies& tallies) {
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
            object["tallies"].push_back(std::move(entry));
            ++tally;
        }
    }
    return object;
}

Tallies tallies_from(const Json& entries) {
    Tallies tallies;
    for (const auto& entry : entries) {
        tallies.emplace_back();
        for (const auto& [name, value] : tally_fields) entry.at(std::string(name)).get_to(tallies.back().*value);
        tallies.back().skipped = entry.value("skipped", std::uint64_t{0});
    }
    return tallies;
}

/// Calls `read` with a line's object. A line counts if it is the one that we would write, which `read` returns.
void read_line(const std::string& line, const std::string& place, auto&& read) {
    try {
        if (read(Json::parse(line)) == line + "\n") return;
    } catch (const Json::exception&) {
    }
    throw Refused(place + ": not a line of " + std::string(results_format) +
                  ", or a block that came out otherwise before");
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

}  // namespace

const Family& family_of(const std::string& name) {
    const auto is_named = [&](const Family& each) { return each.name == name; };
    const auto found = std::find_if(families.begin(), families.end(), is_named);
    if (found != families.end()) return *found;
    const auto of_curves = std::find_if(curve_families.begin(), curve_families.end(), is_named);
    if (of_curves == curve_families.end()) throw Refused("there is no family " + name);
    return *of_curves;
}

Tallies run_block(const Campaign& campaign, const Block& block) {
    const auto kernels = all_named(campaign.kernels, known_kernel);
    const auto methods = all_named(campaign.methods, known_method);
    Tallies sum(tallies_of(campaign));
    for (std::uint64_t trial = block.first; trial < block.end; ++trial) {
        RandomPolygons random = random_of(campaign, *block.family, trial);
        const auto& [kind, how, amount, price, series_of] = *block.experiment;
        if (block.family->curves) {
            // Curves have no other experiments.
            if (kind != Experiment::Kind::moved) continue;
            const AdmittedCurves curves = moved_by_ulps(block.family->curves(random), amount, random);
            add_to(sum, try_out(curves, kernels, methods));
        } else {
            add_to(sum, try_out(*block.experiment, series_of(*block.family, random, amount), kernels, methods));
        }
    }
    return sum;
}

void for_each_moved(const Campaign& campaign, const Family& family, const std::function<bool(const AnyMoved&)>& use) {
    for (const auto& experiment : experiments) {
        if (experiment.kind != Experiment::Kind::moved) continue;
        for (std::uint64_t trial = 0; trial < campaign.count; ++trial) {
            RandomPolygons random = random_of(campaign, family, trial);
            const AnyMoved scene = family.curves
                                       ? AnyMoved(moved_by_ulps(family.curves(random), experiment.amount, random))
                                       : AnyMoved(experiment.series(family, random, experiment.amount).front());
            if (use(scene)) return;
        }
    }
}

Results::Results(Campaign campaign) : campaign_(std::move(campaign)) {
    if (campaign_.count > most_trials) throw Refused("more than " + std::to_string(most_trials) + " trials");
    all_named(campaign_.kernels, known_kernel);
    all_named(campaign_.methods, known_method);
    blocks_ = blocks_of(campaign_);
}

Results Results::merged(const std::vector<std::string>& files) {
    std::optional<Results> results;
    for (const auto& file : files) {
        const std::string text = read_text(file);
        expect_format_in(text, results_format, file);
        if (!results) {
            read_line(first_line(text), file + ":1", [&](const Json& object) {
                results.emplace(campaign_from(object));
                return results->header();
            });
        }
        results->add(text, file);
    }
    return std::move(*results);
}

void Results::add(const Block& block, const Tallies& tallies) { finished_.emplace(block.number, tallies); }

void Results::add(const std::string& text, const std::string& file) {
    LineReader lines = LineReader::of_text(text);
    std::string line;
    if (!lines.next(line) || line + "\n" != header()) throw Refused(file + ": belongs to another campaign");
    for (int number = 2; lines.next(line) && !lines.cut(); ++number) {
        read_line(line, file + ":" + std::to_string(number), [&](const Json& object) -> std::string {
            const auto place = object.at("block").get<std::uint64_t>();
            const Tallies tallies = tallies_from(object.at("tallies"));
            if (place >= blocks_.size() || tallies.size() != tallies_of(campaign_)) return {};
            add(blocks_[place], tallies);
            return this->line(blocks_[place]);
        });
    }
}

std::string Results::header() const { return json_of(campaign_).dump() + "\n"; }

std::string Results::line(const Block& block) const {
    return json_of(campaign_, block, finished_.at(block.number)).dump() + "\n";
}

std::string Results::text() const {
    std::string text = header();
    for (const auto& [number, tallies] : finished_) text += line(blocks_[number]);
    return text;
}

Tallies Results::sum(std::string_view family, const Experiment& experiment) const {
    Tallies sum(tallies_of(campaign_));
    for (const auto& [number, tallies] : finished_) {
        const Block& block = blocks_[number];
        if (block.family->name == family && block.experiment == &experiment) add_to(sum, tallies);
    }
    return sum;
}

bool Results::as_promised() const {
    const auto kernels = all_named(campaign_.kernels, known_kernel);
    for (const auto& [number, tallies] : finished_) {
        for (std::size_t i = 0; i < tallies.size(); ++i) {
            if (kernels[i / campaign_.methods.size()].is_always_right() && !tallies[i].all_right()) return false;
        }
    }
    return true;
}

}  // namespace vidno
