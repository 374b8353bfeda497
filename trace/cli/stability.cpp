#include <algorithm>
#include <array>
#include <cstdio>
#include <deque>
#include <filesystem>
#include <functional>
#include <future>
#include <iomanip>
#include <iostream>
#include <optional>
#include <sstream>
#include <thread>

#include "check/check.h"
#include "choice/method.h"
#include "cli/commands.h"
#include "cli/shared/progress.h"
#include "cli/shared/run_options.h"
#include "cli/shared/shard.h"
#include "counted.h"
#include "find/measures.h"
#include "output.h"
#include "scene/scene_json.h"
#include "scene/surface.h"
#include "stability/journal.h"
#include "stability/results.h"
#include "stability/script.h"
#include "stability/witness.h"

namespace vidno::cli {

namespace {

struct StabilityOptions {
    Campaign campaign;
    std::string shard = "1/1", output, witnesses, where, trial, script;
    std::uint64_t jobs = std::max(1U, std::thread::hardware_concurrency()), tasks = 0, extended = 0;
    std::vector<std::string> merged;
};

void expect_runs(const NamedKernel& kernel, const std::vector<std::string>& methods) {
    for (const auto& method : methods) {
        if (method == floating_horizon_method) {
            expect_floating_horizon_run(kernel, Edition::corrected);
        } else {
            expect_run(kernel, method_named(method), Edition::corrected);
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
    campaign.version = VIDNO_VERSION;
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

/// A column for each experiment of a kind; a row for each family, kernel and method that had runs. A cell shows a
/// tally; it is also given the tally to its left.
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
            const Tallies& sum = results.sum(family, experiment);
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

/// The first failing trial of each family, kernel and method.
void print_failing(const Results& results) {
    const Campaign& campaign = results.campaign();
    std::ostringstream text;
    for (const auto& family : campaign.families) {
        for (std::size_t i = 0; i < tallies_of(campaign); ++i) {
            const auto fails = [&](const Experiment& each) { return !results.sum(family, each)[i].failing.empty(); };
            const auto* first = std::find_if(experiments.begin(), experiments.end(), fails);
            if (first == experiments.end()) continue;
            text << "  --kernel " << std::left << std::setw(10) << campaign.kernels[i / campaign.methods.size()]
                 << "--method " << std::setw(17) << campaign.methods[i % campaign.methods.size()] << "--trial "
                 << family << ':' << name_of(*first) << ':' << results.sum(family, *first)[i].failing.front() << '\n';
        }
    }
    if (text.str().empty()) return;
    std::cout << "\nfirst failing trials (vidno stability --seed " << campaign.seed << " ... runs one again)\n"
              << text.str();
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
    print_failing(results);
}

int verdict(const Results& results) {
    if (results.as_promised()) return 0;
    std::cerr << "a kernel that is always right was wrong\n";
    return 1;
}

/// Whether the right run of a scene by the method meets the condition; empty without one.
Where meets(const std::string& text, const std::string& method) {
    if (text.empty()) return {};
    const auto condition = std::make_shared<const Condition>(text);
    const NamedKernel right = kernel_of(KernelKind::filtered);
    return [=](const AnyScene& scene) { return condition->is_met(measured(*condition, scene, method, right)); };
}

/// Refuses what is no condition, or does not suit a method.
void expect_condition(const std::string& text, const std::vector<std::string>& methods) {
    if (text.empty()) return;
    const Condition condition(text);
    for (const auto& method : methods) expect_suits(condition, method);
}

/// Writes a file for each family, method and kernel that painted wrong pictures and may be wrong.
void write_witnesses(const Results& results, const std::string& folder, const std::string& where) {
    const Campaign& campaign = results.campaign();
    std::filesystem::create_directories(folder);
    for (const auto& name : campaign.families) {
        for (std::size_t i = 0; i < tallies_of(campaign); ++i) {
            const auto is_wrong = [&](const Experiment& each) {
                return each.kind == Experiment::Kind::moved && results.sum(name, each)[i].wrong_runs > 0;
            };
            const auto* experiment = std::find_if(experiments.begin(), experiments.end(), is_wrong);
            const std::string& kernel = campaign.kernels[i / campaign.methods.size()];
            const std::string& method = campaign.methods[i % campaign.methods.size()];
            if (experiment == experiments.end() || kernel_named(kernel)->snaps()) continue;
            const auto& failing = results.sum(name, *experiment)[i].failing;
            Progress progress("scenes tried for " + name + ", " + method + ", " + kernel);
            const auto failure =
                witness(campaign, family_of(name), *experiment, failing.empty() ? 0 : failing.front(), method, kernel,
                        meets(where, method), [&, tried = 0ULL]() mutable { progress.show(++tried); });
            progress.clear();
            if (!failure) continue;
            const std::string file = folder + "/" + name + "." + method + "." + kernel + ".json";
            write_file(file, *failure);
            std::cerr << file << '\n';
        }
    }
}

int merge(const StabilityOptions& options) {
    std::optional<OutputFile> file;
    if (!options.output.empty()) file.emplace(options.output);
    const Results results = merged(options.merged, file ? &*file : nullptr);
    expect_condition(options.where, results.campaign().methods);
    if (file) file->commit();
    print(results);
    if (!options.witnesses.empty()) write_witnesses(results, options.witnesses, options.where);
    const int status = verdict(results);
    if (results.missing() == 0) return status;
    std::cerr << "blocks missing: " << results.missing() << " of " << results.blocks().all() << '\n';
    return 1;
}

// ------------------------------------------------------------------------------------- one trial

/// A trial by its name, FAMILY:EXPERIMENT:N.
struct NamedTrial {
    const Family* family;
    const Experiment* experiment;
    std::uint64_t number;
};

NamedTrial trial_from(const std::string& text) {
    std::istringstream in(text);
    std::string family, experiment, number;
    std::getline(in, family, ':');
    std::getline(in, experiment, ':');
    std::getline(in, number);
    if (number.empty() || number.size() > 9 || number.find_first_not_of("0123456789") != std::string::npos) {
        throw Refused("--trial " + text + ": not FAMILY:EXPERIMENT:N, such as slivers:moved-1:42");
    }
    return {&family_of(family), &experiment_of(experiment), std::stoull(number)};
}

/// The scene of a series that shows the failure: the first that a kernel and method of the campaign paint wrong,
/// otherwise the first.
std::size_t shown_of(const std::vector<AdmittedScene>& series, const Campaign& campaign, const Tallies& tallies) {
    for (std::size_t i = 0; i < tallies.size(); ++i) {
        if (tallies[i].wrong_pixels == 0) continue;
        const Method method = method_named(campaign.methods[i % campaign.methods.size()]);
        const NamedKernel kernel = *kernel_named(campaign.kernels[i / campaign.methods.size()]);
        for (std::size_t scene = 0; scene < series.size(); ++scene) {
            const Picture painted = run({method, kernel, Edition::corrected, series[scene]});
            if (different_pixels(painted, right_picture(series[scene], method)) > 0) return scene;
        }
    }
    return 0;
}

/// Runs a trial again, says what each kernel and method made of it, and writes its scene.
int run_again(const StabilityOptions& options) {
    const NamedTrial trial = trial_from(options.trial);
    const Campaign campaign =
        options.merged.empty() ? with_defaults(options.campaign) : campaign_in(options.merged.front());
    const TrialScenes scenes = scenes_of(campaign.seed, *trial.family, *trial.experiment, trial.number);
    const Tallies tallies = run_trial(campaign, *trial.family, *trial.experiment, trial.number);
    for (std::size_t i = 0; i < tallies.size(); ++i) {
        const Tally& tally = tallies[i];
        if (tally.runs == 0) continue;
        std::cout << std::left << std::setw(10) << campaign.kernels[i / campaign.methods.size()] << std::setw(17)
                  << campaign.methods[i % campaign.methods.size()] << std::right;
        if (trial.experiment->kind == Experiment::Kind::grown) {
            std::cout << counted(tally.windows, "window", "windows") << '\n';
            continue;
        }
        std::cout << "wrong pixels " << tally.wrong_pixels << " of " << tally.pixels;
        if (tally.decisions > 0)
            std::cout << ", wrong decisions " << tally.wrong_decisions << " of " << tally.decisions;
        if (tally.steady > 0) std::cout << ", pixels that flicker " << tally.flickers << " of " << tally.steady;
        std::cout << '\n';
    }
    if (options.output.empty()) return 0;
    if (const auto* curves = std::get_if<AdmittedCurves>(&scenes)) {
        write_file(options.output, surface_json({options.trial, *curves}));
        return 0;
    }
    const auto& series = std::get<std::vector<AdmittedScene>>(scenes);
    const std::size_t shown = shown_of(series, campaign, tallies);
    write_file(options.output, scene_json(series[shown]));
    if (series.size() > 1) std::cout << options.output << ": scene " << shown + 1 << " of " << series.size() << '\n';
    return 0;
}

// ------------------------------------------------------------------------------------- a campaign

int write_script(const StabilityOptions& options) {
    if (options.output.empty()) throw Refused("--script: say by -o where the results shall be");
    Distribution of{with_defaults(options.campaign), options.output, options.tasks, 0};
    const double seconds = seconds_of(of.campaign);
    // A site of Slurm allows arrays of 1000 tasks unless it says otherwise.
    constexpr double most_tasks = 1000, seconds_of_a_task = 300;
    if (of.tasks == 0) of.tasks = std::uint64_t(std::clamp(std::ceil(seconds / seconds_of_a_task), 1., most_tasks));
    of.seconds = seconds / double(of.tasks);
    std::cout << (options.script == "slurm" ? slurm_script(of) : parallel_script(of));
    return 0;
}

/// The campaign of a file that is continued, or else a new one.
Campaign campaign_of(const StabilityOptions& options) {
    if (options.extended > 0) {
        if (options.output.empty()) throw Refused("--extend: say by -o which file to extend");
        extend(options.output, options.extended);
        return campaign_in(options.output);
    }
    Campaign campaign = with_defaults(options.campaign);
    // A file from before files named the version is continued as it began.
    Campaign of_before = campaign;
    of_before.version.clear();
    if (!options.output.empty() && std::filesystem::is_regular_file(options.output)) {
        LineReader lines(options.output);
        std::string first;
        if (lines.next(first) && first + "\n" == header_of(of_before)) return of_before;
    }
    return campaign;
}

/// Runs blocks, several at once, and calls `use(block, tallies)` for each in their order.
void run_blocks(const Campaign& campaign, const std::vector<Block>& blocks, std::size_t jobs, const auto& use) {
    std::deque<std::future<Tallies>> running;
    std::size_t begun = 0;
    for (const Block& block : blocks) {
        while (begun < blocks.size() && running.size() < jobs) {
            running.push_back(std::async(std::launch::async, run_block, std::cref(campaign), blocks[begun++]));
        }
        use(block, running.front().get());
        running.pop_front();
    }
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
  vidno stability --count 1000000 --script slurm -o all.jsonl > campaign.sh   (bash campaign.sh on the cluster)
  vidno stability --merge all.jsonl.parts/*.jsonl -o all.jsonl
  vidno stability --extend 2000 -o all.jsonl
  vidno stability --trial slivers:moved-1:42 --kernel float -o scene.json
  vidno stability --method all --family all --count 20 --witnesses found      (each opens in the page))";
    return text.str();
}

int stability(const StabilityOptions& options) {
    if (!options.trial.empty()) return run_again(options);
    if (!options.merged.empty()) return merge(options);
    if (!options.script.empty()) return write_script(options);
    const Shard shard = shard_from(options.shard);
    Results results(campaign_of(options));
    expect_condition(options.where, results.campaign().methods);
    std::optional<Journal> journal;
    if (!options.output.empty()) {
        journal.emplace(options.output, header_of(results.campaign()));
        results.add_file(options.output);
    }
    std::vector<Block> blocks;
    for (std::uint64_t number = 0; number < results.blocks().size(); ++number) {
        const Block block = results.blocks().at(number);
        if (shard.has(number) && !results.has(block)) blocks.push_back(block);
    }
    Progress progress("blocks");
    std::size_t done = 0;
    run_blocks(results.campaign(), blocks, options.jobs, [&](const Block& block, const Tallies& tallies) {
        const std::string line = results.add(block, tallies);
        if (journal) journal->append(line);
        progress.show(++done, blocks.size());
    });
    progress.clear();
    print(results);
    if (!options.witnesses.empty()) write_witnesses(results, options.witnesses, options.where);
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
    auto* shard = command.add_option("--shard", options->shard,
                                     "K/N: run only every N-th block of trials, from the K-th; auto: as the task of "
                                     "an array of Slurm says");
    auto* jobs = command.add_option("--jobs", options->jobs, "How many blocks to run at a time [one for each core]")
                     ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1024}));
    auto* extend = command
                       .add_option("--extend", options->extended,
                                   "Continue the campaign in the file of -o with more trials: this many in all")
                       ->check(CLI::Range(std::uint64_t{1}, most_trials));
    auto* trial = command.add_option("--trial", options->trial,
                                     "FAMILY:EXPERIMENT:N, such as slivers:moved-2^8:42: run this trial alone, and "
                                     "write its scene to the file of -o");
    auto* script = command
                       .add_option("--script", options->script,
                                   "Print a script that runs the campaign on many machines and merges it into the "
                                   "file of -o: slurm or parallel")
                       ->check(CLI::IsMember({"slurm", "parallel"}));
    command.add_option("--tasks", options->tasks, "The tasks of the script [as many as take five minutes each]")
        ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{100'000}))
        ->needs(script);
    auto* merge = command.add_option("--merge", options->merged, "Merge result files instead of running a campaign");
    command.add_option("-o", options->output,
                       "Keep the results, .jsonl; an interrupted campaign continues where it stopped");
    auto* witnesses = command.add_option(
        "--witnesses", options->witnesses,
        "A folder for failures: the smallest scene of each family on which a method and kernel paint a wrong pixel");
    command
        .add_option("--where", options->where,
                    "Only witnesses whose right run meets this condition, such as 'polygons <= 2' (vidno find --list)")
        ->needs(witnesses);
    for (const char* of_run : {"--family", "--kernel", "--method", "--count", "--seed"}) {
        merge->excludes(of_run);
        extend->excludes(of_run);
    }
    for (auto* of_run : {shard, jobs, extend, script}) {
        merge->excludes(of_run);
        trial->excludes(of_run);
    }
    for (auto* of_run : {shard, jobs, extend}) script->excludes(of_run);
    command.footer(footer());
    command.callback([options, &status] { status = stability(*options); });
}

}  // namespace vidno::cli
