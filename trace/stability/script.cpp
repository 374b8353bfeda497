#include "stability/script.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "counted.h"

namespace vidno {

namespace {

/// A word that the shell takes as it is.
std::string quoted(const std::string& word) {
    const auto is_plain = [](char c) {
        return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') ||
               std::string_view("-_./:").find(c) != std::string_view::npos;
    };
    if (!word.empty() && std::all_of(word.begin(), word.end(), is_plain)) return word;
    std::string text = "'";
    for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

std::string option(const std::string& name, const std::vector<std::string>& values) {
    std::string text = " " + name;
    for (const auto& value : values) text += " " + quoted(value);
    return text;
}

std::string command_of(const Campaign& campaign) {
    return "\"$vidno\" stability --seed " + std::to_string(campaign.seed) + " --count " +
           std::to_string(campaign.count) + option("--family", campaign.families) +
           option("--kernel", campaign.kernels) + option("--method", campaign.methods);
}

/// What both scripts begin with: what they are, and the names that they use.
std::string beginning(const Distribution& of, const std::string& how, const std::string& options) {
    const auto minutes = std::max<std::uint64_t>(1, std::uint64_t(std::lround(of.seconds / 60)));
    return "#!/bin/bash\n# A campaign of vidno in " + counted(of.tasks, "task", "tasks") + " of about " +
           counted(minutes, "minute", "minutes") + ". " + how + "\n" +
           "# A task that is killed continues where it stopped when it runs again.\n" + options +
           "set -euo pipefail\n" + "vidno=${VIDNO:-vidno}\nresults=" + quoted(of.output) + "\n";
}

}  // namespace

double seconds_of(const Campaign& campaign) {
    using Clock = std::chrono::steady_clock;
    const Family& family = family_of(campaign.families.front());
    double seconds = 0;
    for (const Experiment& experiment : experiments) {
        if (family.curves && experiment.kind != Experiment::Kind::moved) continue;
        const auto begin = Clock::now();
        run_trial(campaign, family, experiment, 0);
        const std::chrono::duration<double> passed = Clock::now() - begin;
        seconds += passed.count() * std::ceil(double(campaign.count) / double(experiment.price));
    }
    return seconds * double(campaign.families.size());
}

std::string slurm_script(const Distribution& of) {
    const std::string tasks = std::to_string(of.tasks);
    // Other machines may be slower, and a task that reaches the limit has to be queued again.
    const auto limit = std::max<std::uint64_t>(10, std::uint64_t(std::ceil(of.seconds * 4 / 60)));
    return beginning(of, "`bash FILE` submits them, and the job that merges their results.",
                     "#SBATCH --job-name=vidno\n#SBATCH --array=1-" + tasks +
                         "\n#SBATCH --ntasks=1\n#SBATCH --cpus-per-task=1\n#SBATCH --time=" + std::to_string(limit) +
                         "\n#SBATCH --requeue\n#SBATCH --open-mode=append\n") +
           R"(if [[ -z ${SLURM_ARRAY_TASK_ID:-} ]]; then
    mkdir -p "$results.parts"
    tasks=$(sbatch --parsable --output="$results.parts/%a.log" "$0")
    export vidno results
    sbatch --job-name=vidno-merge --dependency="afterany:${tasks%%;*}" --output="$results.parts/merge.log" \
        --wrap '"$vidno" stability --merge "$results".parts/*.jsonl -o "$results"'
    exit
fi
mkdir -p "$results.parts"
status=0
)" + command_of(of.campaign) +
           " \\\n    --jobs 1 --shard \"$SLURM_ARRAY_TASK_ID/" + tasks +
           R"(" -o "$results.parts/$SLURM_ARRAY_TASK_ID.jsonl" || status=$?
# What was killed runs again, but not for ever.
if ((status > 128 && ${SLURM_RESTART_COUNT:-0} < 5)); then
    scontrol requeue "${SLURM_ARRAY_JOB_ID}_$SLURM_ARRAY_TASK_ID"
fi
exit "$status"
)";
}

std::string parallel_script(const Distribution& of) {
    const std::string tasks = std::to_string(of.tasks);
    return beginning(of,
                     "`bash FILE` runs them on this host; `bash FILE HOSTS` on those in a file for --sshloginfile,\n"
                     "# which must have this folder under the same path.",
                     "") +
           R"(mkdir -p "$results.parts"
export vidno results
parallel ${1:+--sshloginfile "$1" --env vidno --env results --workdir "$PWD"} --retries 5 \
    )" + quoted(command_of(of.campaign) + " --jobs 1 --shard {}/" + tasks + " -o \"$results.parts/{}.jsonl\"") +
           " ::: {1.." + tasks + R"(}
"$vidno" stability --merge "$results".parts/*.jsonl -o "$results"
)";
}

}  // namespace vidno
