#include "stability/campaign.h"

#include <algorithm>

#include "choice/method.h"
#include "refused.h"

namespace vidno {

namespace {

constexpr std::uint64_t runs_of_a_round = 128;

std::uint64_t divided(std::uint64_t whole, std::uint64_t by) { return (whole + by - 1) / by; }

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

RandomPolygons random_of(std::uint64_t seed, const Family& family, std::uint64_t trial) {
    const auto place =
        family.curves ? std::ptrdiff_t(families.size()) + (&family - curve_families.data()) : &family - families.data();
    std::seed_seq seeds{std::uint32_t(seed), std::uint32_t(seed >> 32), std::uint32_t(place), std::uint32_t(trial)};
    return RandomPolygons(std::mt19937(seeds));
}

bool has_scenes(const Family& family, const Experiment& experiment) {
    return !family.curves || experiment.kind == Experiment::Kind::moved;
}

}  // namespace

const Family& family_of(const std::string& name) {
    const auto is_named = [&](const Family& each) { return each.name == name; };
    const auto found = std::find_if(families.begin(), families.end(), is_named);
    if (found != families.end()) return *found;
    const auto of_curves = std::find_if(curve_families.begin(), curve_families.end(), is_named);
    if (of_curves == curve_families.end()) throw Refused("there is no family " + name);
    return *of_curves;
}

std::string name_of(const Experiment& experiment) {
    std::string name = std::string(kind_names[std::size_t(experiment.kind)]) + "-" + std::string(experiment.how);
    std::replace(name.begin(), name.end(), ' ', '-');
    return name;
}

const Experiment& experiment_of(const std::string& name) {
    std::string dashed = name;
    std::replace(dashed.begin(), dashed.end(), ' ', '-');
    const auto found = std::find_if(experiments.begin(), experiments.end(),
                                    [&](const Experiment& each) { return name_of(each) == dashed; });
    if (found == experiments.end()) throw Refused("there is no experiment " + name);
    return *found;
}

Blocks::Blocks(const Campaign& campaign)
    : count_(campaign.count),
      rounds_(divided(campaign.count, runs_of_a_round)),
      families_(all_named(campaign.families, [](const std::string& name) { return &family_of(name); })),
      are_by_family_(campaign.version.empty()) {
    if (count_ > most_trials) throw Refused("more than " + std::to_string(most_trials) + " trials");
    all_named(campaign.kernels, known_kernel);
    all_named(campaign.methods, known_method);
}

std::uint64_t Blocks::trials_of(const Experiment& experiment) const { return divided(count_, experiment.price); }

std::uint64_t Blocks::size() const { return are_by_family_ ? all() : rounds_ * families_.size() * experiments.size(); }

Block Blocks::at(std::uint64_t number) const {
    if (!are_by_family_) {
        const std::uint64_t place = number / experiments.size(), round = place / families_.size();
        const Experiment& experiment = experiments[number % experiments.size()];
        const std::uint64_t trials = trials_of(experiment);
        const auto begun = [&](std::uint64_t in) {
            return std::min(divided(in * runs_of_a_round, experiment.price), trials);
        };
        return {number, families_[place % families_.size()], &experiment, begun(round), begun(round + 1)};
    }
    const std::uint64_t of_a_family = all() / families_.size();
    std::uint64_t in_family = number % of_a_family;
    for (const Experiment& experiment : experiments) {
        const std::uint64_t trials = trials_of(experiment), at_once = divided(runs_of_a_round, experiment.price);
        const std::uint64_t blocks = divided(trials, at_once);
        if (in_family < blocks) {
            const std::uint64_t first = in_family * at_once;
            return {number, families_[number / of_a_family], &experiment, first, std::min(first + at_once, trials)};
        }
        in_family -= blocks;
    }
    throw Refused("there is no block " + std::to_string(number));
}

std::uint64_t Blocks::all() const {
    std::uint64_t of_a_family = 0;
    for (const Experiment& experiment : experiments) {
        of_a_family += divided(trials_of(experiment), divided(runs_of_a_round, experiment.price));
    }
    return of_a_family * families_.size();
}

TrialScenes scenes_of(std::uint64_t seed, const Family& family, const Experiment& experiment, std::uint64_t trial) {
    RandomPolygons random = random_of(seed, family, trial);
    if (!family.curves) return experiment.series(family, random, experiment.amount);
    if (!has_scenes(family, experiment)) {
        throw Refused("curves of " + std::string(family.name) + " are only moved, not " + name_of(experiment));
    }
    return moved_by_ulps(family.curves(random), experiment.amount, random);
}

Tallies run_trial(const Campaign& campaign, const Family& family, const Experiment& experiment, std::uint64_t trial) {
    const auto kernels = all_named(campaign.kernels, known_kernel);
    const auto methods = all_named(campaign.methods, known_method);
    const TrialScenes scenes = scenes_of(campaign.seed, family, experiment, trial);
    const auto* series = std::get_if<std::vector<AdmittedScene>>(&scenes);
    Tallies tallies = series != nullptr ? try_out(experiment, *series, kernels, methods)
                                        : try_out(std::get<AdmittedCurves>(scenes), kernels, methods);
    for (Tally& tally : tallies) {
        if (tally.wrong_pixels + tally.flickers > 0) tally.failing = {trial};
    }
    return tallies;
}

Tallies run_block(const Campaign& campaign, const Block& block) {
    Tallies sum(tallies_of(campaign));
    if (!has_scenes(*block.family, *block.experiment)) return sum;
    for (std::uint64_t trial = block.first; trial < block.end; ++trial) {
        add_to(sum, run_trial(campaign, *block.family, *block.experiment, trial));
    }
    return sum;
}

std::size_t tallies_of(const Campaign& campaign) { return campaign.kernels.size() * campaign.methods.size(); }

void add_to(Tallies& sum, const Tallies& tallies) {
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += tallies[i];
}

}  // namespace vidno
