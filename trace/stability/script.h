/// Script: a campaign on many machines, as a text for a shell.
#pragma once

#include <cstdint>
#include <string>

#include "stability/campaign.h"

namespace vidno {

/// A campaign in tasks. Each may be killed at any time, and run again or twice.
struct Distribution {
    Campaign campaign;
    std::string output;   // the file of all results; those of a task are beside it, in the folder output.parts
    std::uint64_t tasks;  // at least 1
    double seconds;       // that a task takes, about
};

/// How long a campaign takes on this machine, in seconds: an estimate from a trial of each experiment.
double seconds_of(const Campaign& campaign);

/// A script for Slurm. `bash FILE` submits an array of tasks and a job that merges their results when all have ended.
std::string slurm_script(const Distribution& distribution);

/// A script for GNU parallel on this host, or on several with a common file system. It merges the results, too.
std::string parallel_script(const Distribution& distribution);

}  // namespace vidno
