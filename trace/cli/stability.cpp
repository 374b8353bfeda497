#include "stability/stability.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <optional>
#include <sstream>

#include "choice/method.h"
#include "cli/commands.h"
#include "cli/shared/progress.h"
#include "cli/shared/run_options.h"
#include "counted.h"
#include "output.h"
#include "stability/journal.h"
#include "stability/witness.h"

namespace vidno::cli {

namespace {

struct StabilityOptions {
    Campaign campaign;
    std::string shard = "1/1", output, witnesses;
    std::vector<std::string> merged;
};

/// Shard `number` of `of` shards, from 1: it takes every `of`-th block.
struct Shard {
    std::uint64_t number, of;

    bool has(const Block& block) const { return block.number % of == number - 1; }
};

Shard shard_from(const std::string& text) {
    std::istringstream in(text);
    Shard shard{};
    char slash = 0;
    in >> shard.number >> slash >> shard.of;
    const bool two_numbers = text.find_first_not_of("0123456789/") == std::string::npos && in && in.eof();
    if (!two_numbers || slash != '/' || shard.number < 1 || shard.number > shard.of) {
        throw Refused("--shard " + text + ": not K/N, where 1 <= K <= N");
    }
    return shard;
}

void expect_runs(const NamedKernel& kernel, const std::vector<std::string>& methods) {
    for (const auto& method : methods) {
        if (method == floating_horizon_method) {
            expect_floating_horizon_run(kernel, Edition::corrected);
        } else {
            expect_run(kernel, Method(place_in(method_names, method)), Edition::corrected);
        }
    }
}

/// "all" stands for all methods, each under the kernels that run it, and for all families.
Campaign with_defaults(Campaign campaign) {
    const bool of_all = campaign.methods == std::vector<std::string>{"all"};
    if (campaign.families.empty() || campaign.families == std::vector<std::string>{"all"}) {
        const bool every_one = !campaign.families.empty();
        campaign.families.clear();
        for (std::size_t i = 0; i < (every_one ? families.size() : first_families); ++i) {
            campaign.families.emplace_back(families[i].name);
        }
        if (every_one) {
            for (const auto& family : curve_families) campaign.families.emplace_back(family.name);
        }
    }
    if (campaign.kernels.empty()) campaign.kernels = {"float", "double", "filtered"};
    if (campaign.methods.empty()) campaign.methods.assign(course_method_names.begin(), course_method_names.end());
    if (of_all) campaign.methods = all_methods();
    for (auto& kernel : campaign.kernels) {
        const NamedKernel named = *kernel_named(kernel);
        if (!of_all) expect_runs(named, campaign.methods);
        kernel = named.name();
    }
    return campaign;
}

// ------------------------------------------------------------------------------------- tables

std::string shortened(const char* format, double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), format, value);
    return text.data();
}

std::string per_cent(std::uint64_t part, std::uint64_t whole) {
    return whole == 0 ? "-" : shortened("%.2g", 100 * double(part) / double(whole));
}

/// The number, and its ratio to the previous one.
std::string windows_of(const Tally& tally, const Tally* before) {
    if (tally.runs == 0) return "-";
    const auto of_a_run = [](const Tally& each) { return double(each.windows) / double(each.runs); };
    std::string text = shortened("%.0f", of_a_run(tally));
    if (before && before->runs > 0) text += shortened(" x%.1f", of_a_run(tally) / of_a_run(*before));
    return text;
}

/// A column for each experiment of a kind; a row for each family, kernel and method that had runs. A cell shows a tally; it is also given
/// the tally to its left.
void print(const Results& results, Experiment::Kind kind, const std::string& title, auto&& cell) {
    std::size_t widest = 0;
    for (const auto& method : results.campaign().methods) widest = std::max(widest, method.size());
    const auto row = [widest](const std::string& family, const std::string& kernel, const std::string& method) {
        std::cout << std::left << std::setw(18) << family << std::setw(10) << kernel << std::setw(int(widest) + 1)
                  << method << std::right;
    };
    std::vector<const Experiment*> columns;
    const auto show = [&](std::size_t column, const auto& text) {
        std::cout << std::setw(int(std::max<std::size_t>(columns[column]->how.size(), 10) + 1)) << text;
    };

    std::cout << '\n' << title << '\n';
    row("family", "kernel", "method");
    for (const auto& experiment : experiments) {
        if (experiment.kind != kind) continue;
        columns.push_back(&experiment);
        show(columns.size() - 1, experiment.how);
    }
    std::cout << '\n';
    const Campaign& campaign = results.campaign();
    for (const auto& family : campaign.families) {
        std::vector<Tallies> sums;
        for (const auto* experiment : columns) sums.push_back(results.sum(family, *experiment));
        for (std::size_t i = 0; i < sums.front().size(); ++i) {
            const auto ran = [&](const Tallies& sum) { return sum[i].runs > 0; };
            if (std::none_of(sums.begin(), sums.end(), ran)) continue;
            row(family, campaign.kernels[i / campaign.methods.size()], campaign.methods[i % campaign.methods.size()]);
            for (std::size_t column = 0; column < columns.size(); ++column) {
                show(column, cell(sums[column][i], column > 0 ? &sums[column - 1][i] : nullptr));
            }
            std::cout << '\n';
        }
    }
}

/// How many trials each kernel could not take, for each method.
void print_skipped(const Results& results) {
    const Campaign& campaign = results.campaign();
    Tallies all(campaign.kernels.size() * campaign.methods.size());
    for (const auto& family : campaign.families) {
        for (const auto& experiment : experiments) {
            const Tallies sum = results.sum(family, experiment);
            for (std::size_t i = 0; i < all.size(); ++i) all[i] += sum[i];
        }
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all[i].skipped == 0) continue;
        std::cout << "\nskipped: " << counted(all[i].skipped, "trial", "trials") << " of "
                  << campaign.methods[i % campaign.methods.size()] << " with scenes that are too wide for "
                  << campaign.kernels[i / campaign.methods.size()] << '\n';
    }
}

void print(const Results& results) {
    using enum Experiment::Kind;
    const auto rate = [](std::uint64_t Tally::*part, std::uint64_t Tally::*whole) {
        return [=](const Tally& tally, const Tally*) { return per_cent(tally.*part, tally.*whole); };
    };
    print(results, moved, "wrong decisions in per cent, coordinates moved by up to N ulps",
          rate(&Tally::wrong_decisions, &Tally::decisions));
    print(results, moved, "wrong pixels in per cent", rate(&Tally::wrong_pixels, &Tally::pixels));
    print(results, moved, "pictures with a wrong pixel in per cent", rate(&Tally::wrong_runs, &Tally::runs));
    print(results, swept, "flicker in per cent, a polygon swept over 256 steps",
          rate(&Tally::flickers, &Tally::steady));
    print(results, changed, "pixels in per cent that are not invariant", rate(&Tally::flickers, &Tally::steady));
    print(results, grown, "windows of Warnock's algorithm, area and scene grown to N pixels a side", windows_of);
    print_skipped(results);
}

int verdict(const Results& results) {
    if (results.as_promised()) return 0;
    std::cerr << "a kernel that is always right was wrong\n";
    return 1;
}

/// Writes a file for each family, method and kernel that painted wrong pictures and may be wrong.
void write_witnesses(const Results& results, const std::string& folder) {
    const Campaign& campaign = results.campaign();
    std::filesystem::create_directories(folder);
    for (const auto& name : campaign.families) {
        const Family& family = family_of(name);
        std::vector<Tallies> sums;
        for (const auto& experiment : experiments) {
            if (experiment.kind == Experiment::Kind::moved) sums.push_back(results.sum(name, experiment));
        }
        for (std::size_t i = 0; i < sums.front().size(); ++i) {
            if (std::none_of(sums.begin(), sums.end(), [&](const Tallies& sum) { return sum[i].wrong_runs > 0; }))
                continue;
            const std::string& kernel = campaign.kernels[i / campaign.methods.size()];
            const std::string& method = campaign.methods[i % campaign.methods.size()];
            const NamedKernel named = *kernel_named(kernel);
            if (named.snaps()) continue;
            Progress progress("scenes tried for " + name + ", " + method + ", " + kernel);
            const auto failure =
                witness(campaign, family, method, kernel, [&, tried = 0ULL]() mutable { progress.show(++tried); });
            progress.clear();
            if (!failure) continue;
            const std::string file = folder + "/" + name + "." + method + "." + kernel + ".json";
            write_file(file, *failure);
            std::cerr << file << '\n';
        }
    }
}

int merge(const StabilityOptions& options) {
    const Results results = Results::merged(options.merged);
    if (!options.output.empty()) {
        OutputFile file(options.output);
        file.write(results.text());
        file.commit();
    }
    print(results);
    const int status = verdict(results);
    if (results.missing() == 0) return status;
    std::cerr << "blocks missing: " << results.missing() << " of " << results.blocks().size() << '\n';
    return 1;
}

/// The families and experiments of campaigns, for the help.
std::string footer() {
    std::ostringstream text;
    text << "Families, in an area of " << family_side << " x " << family_side << " pixels:\n";
    const auto list = [&](const auto& all) {
        for (const auto& family : all) {
            text << "  " << std::left << std::setw(18) << family.name << family.shows << '\n';
        }
    };
    list(families);
    text << "Families of curves, for the floating horizon and the experiment moved:\n";
    list(curve_families);
    text << R"(Experiments:
  moved             moves each coordinate by up to 0, 1, 2, 4, 16, 2^8, 2^16, 2^32 ulps and counts the decisions and
                    pixels that differ from exact arithmetic (under the kernel grid, on the snapped scene)
  swept             moves the last polygon to the right in 256 steps, of an ulp or of 1/256 pixel, and counts the pixels
                    that change from one step to the next but do not in the exact picture
  changed           starts outlines at other vertices or reverses them, reorders polygons, shifts everything by whole
                    pixels or doubles it, and counts the pixels that change but do not in the exact picture
  grown             enlarges scene and area from 8 to 256 pixels a side, and counts the windows relative to half the
                    side: a factor of 2 is the growth of a length, 4 that of an area
Exit status 1: filtered, grid or exact was wrong, or blocks are missing from --merge. Errors of the
other kernels are results, not failures.
Examples:
  vidno stability --count 1000 -o all.jsonl
  parallel vidno stability --count 1000 --shard {}/8 -o part{}.jsonl ::: 1 2 3 4 5 6 7 8
  vidno stability --merge part?.jsonl -o all.jsonl
  vidno stability --method all --family all --count 20 --witnesses found      (each opens in the page))";
    return text.str();
}

int stability(const StabilityOptions& options) {
    if (!options.merged.empty()) return merge(options);
    const Shard shard = shard_from(options.shard);
    Results results(with_defaults(options.campaign));
    std::optional<Journal> journal;
    if (!options.output.empty()) {
        journal.emplace(options.output, results.header());
        results.add(journal->text(), options.output);
    }
    std::vector<Block> blocks;
    for (const auto& block : results.blocks()) {
        if (shard.has(block) && !results.has(block)) blocks.push_back(block);
    }
    Progress progress("blocks");
    for (std::size_t done = 0; done < blocks.size(); ++done) {
        progress.show(done, blocks.size());
        results.add(blocks[done], run_block(results.campaign(), blocks[done]));
        if (journal) journal->append(results.line(blocks[done]));
    }
    progress.clear();
    print(results);
    if (!options.witnesses.empty()) write_witnesses(results, options.witnesses);
    return verdict(results);
}

}  // namespace

void add_stability(CLI::App& program, int& status) {
    auto& command = *program.add_subcommand("stability", "Run thousands of random scenes and count the errors");
    const auto options = std::make_shared<StabilityOptions>();
    auto& campaign = options->campaign;
    command.add_option("--family", campaign.families, "Families of scenes as listed below, or all [the first nine]");
    command.add_option("--kernel", campaign.kernels, "The kinds of arithmetic [float, double, filtered]")
        ->check(a_kernel());
    auto methods = all_methods();
    methods.emplace_back("all");
    command
        .add_option("--method", campaign.methods,
                    "The algorithms, or all, each under the kernels that run it [warnock, zbuffer]")
        ->check(CLI::IsMember(methods));
    command
        .add_option("--count", campaign.count,
                    "The trials of each experiment in each family; expensive experiments have fewer")
        ->check(CLI::Range(std::uint64_t{1}, most_trials))
        ->capture_default_str();
    command.add_option("--seed", campaign.seed, "The seed; another seed gives other scenes")->capture_default_str();
    command.add_option("--shard", options->shard, "K/N: run only every N-th block of trials, from the K-th");
    auto* merge = command.add_option("--merge", options->merged, "Merge result files instead of running a campaign");
    command.add_option("-o", options->output,
                       "Keep the results, .jsonl; an interrupted campaign continues where it stopped");
    command.add_option(
        "--witnesses", options->witnesses,
        "A folder for failures: the smallest scene of each family on which a method and kernel paint a wrong pixel");
    for (const char* of_run : {"--witnesses", "--family", "--kernel", "--method", "--count", "--seed", "--shard"}) {
        merge->excludes(of_run);
    }
    command.footer(footer());
    command.callback([options, &status] { status = stability(*options); });
}

}  // namespace vidno::cli
