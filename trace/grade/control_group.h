/// ControlGroup: a group of processes whose memory and number the system itself limits, where it lets this user make
/// one.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "grade/keeper.h"

namespace vidno {

/// A group in the hierarchies of control groups, of version 1 or 2. Source: cgroups(7).
class ControlGroup {
public:
    /// Makes a group at or above that of this process, with each limit that the system grants.
    ControlGroup(std::uint64_t memory, int processes);
    /// The processes of the group must have been ended.
    ~ControlGroup();
    ControlGroup(const ControlGroup&) = delete;
    ControlGroup& operator=(const ControlGroup&) = delete;

    bool limits_memory() const { return limits_memory_; }
    bool limits_processes() const { return limits_processes_; }

    /// Moves the calling process into the group. Only calls async-signal-safe functions.
    bool join() const;
    /// Whether the system ended a process because the group's memory was used up.
    bool ran_out_of_memory() const;

private:
    struct Part {
        std::string folder;
        Descriptor members;
    };
    bool add_part(const std::string& parent, std::uint64_t memory, int processes);

    std::vector<Part> parts_;  // in each hierarchy
    bool limits_memory_ = false, limits_processes_ = false;
};

}  // namespace vidno
