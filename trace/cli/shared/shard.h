/// Shard: a part of the work of several runs of the program, which may be on several machines.
#pragma once

#include <cstdint>
#include <string>

namespace vidno::cli {

/// Shard `number` of `of` shards, from 1: it takes every `of`-th item.
struct Shard {
    std::uint64_t number, of;

    bool has(std::uint64_t item) const { return item % of == number - 1; }
};

/// Reads "K/N". Reads "auto" as the task of an array of Slurm, whose tasks must be 1 to N. Throws Refused.
Shard shard_from(std::string text);

}  // namespace vidno::cli
