#include "cli/shared/shard.h"

#include <cstdlib>
#include <sstream>

#include "refused.h"

namespace vidno::cli {

namespace {

std::string slurm_variable(const std::string& name) {
    const char* value = std::getenv(("SLURM_ARRAY_TASK_" + name).c_str());
    if (value == nullptr) throw Refused("--shard auto: not in an array of tasks of Slurm");
    return value;
}

}  // namespace

Shard shard_from(std::string text) {
    if (text == "auto") {
        // A part of an array would leave items out.
        if (slurm_variable("MIN") != "1" || slurm_variable("COUNT") != slurm_variable("MAX")) {
            throw Refused("--shard auto: the tasks of the array are not 1 to N: say --shard $SLURM_ARRAY_TASK_ID/N");
        }
        text = slurm_variable("ID") + "/" + slurm_variable("MAX");
    }
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

}  // namespace vidno::cli
