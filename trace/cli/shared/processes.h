/// Processes: work that several copies of this process do at a time.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace vidno::cli {

/// What a piece of work comes to, as texts.
using Parts = std::vector<std::string>;

/// Calls `work` with 0 to count - 1, each in a process of its own, at most `most` of them at a time, and calls `use`
/// here with what comes of them, in order. Rethrows what the work refuses or loses. The processes end with this one.
void in_processes(std::size_t most, std::size_t count, const std::function<Parts(std::size_t)>& work,
                  const std::function<void(Parts)>& use);

}  // namespace vidno::cli
