#include "grade/control_group.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>

namespace vidno {

namespace {

using Path = std::filesystem::path;

/// A mounted hierarchy, and the group of this process in it.
struct Hierarchy {
    Path mounted, own;
};

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::istringstream in(text);
    for (std::string part; std::getline(in, part, separator);) parts.push_back(part);
    return parts;
}

/// The path of this process's group in the hierarchy of a controller. Version 2 has one hierarchy, for which
/// `controller` is empty.
std::optional<Path> own_group(const std::string& controller) {
    std::ifstream in("/proc/self/cgroup");
    for (std::string line; std::getline(in, line);) {  // number:controllers:path
        const auto first = line.find(':'), second = line.find(':', first + 1);
        if (first == line.npos || second == line.npos) continue;
        const std::string controllers = line.substr(first + 1, second - first - 1);
        const auto all = split(controllers, ',');
        const bool found =
            controller.empty() ? controllers.empty() : std::find(all.begin(), all.end(), controller) != all.end();
        if (found) return line.substr(second + 1);
    }
    return std::nullopt;
}

std::optional<Hierarchy> hierarchy_of(const std::string& controller) {
    const auto group = own_group(controller);
    std::ifstream in("/proc/self/mountinfo");
    for (std::string line; group && std::getline(in, line);) {
        // Numbers, the mounted folder of the file system, where it is mounted, options; after a dash the type, the
        // source, and its options.
        const auto dash = line.find(" - ");
        if (dash == line.npos) continue;
        const auto before = split(line.substr(0, dash), ' '), after = split(line.substr(dash + 3), ' ');
        if (before.size() < 5 || after.size() < 3 || after[0] != (controller.empty() ? "cgroup2" : "cgroup")) continue;
        const auto options = split(after[2], ',');
        if (!controller.empty() && std::find(options.begin(), options.end(), controller) == options.end()) continue;
        const Path mounted = before[4], below = group->lexically_relative(before[3]);
        const bool is_below = !below.empty() && below != "." && *below.begin() != "..";
        return Hierarchy{mounted, is_below ? mounted / below : mounted};
    }
    return std::nullopt;
}

bool write_limit(const Path& file, std::uint64_t limit) {
    const Descriptor to(open(file.c_str(), O_WRONLY | O_CLOEXEC));
    const std::string text = std::to_string(limit);
    return to.number() >= 0 && write(to.number(), text.data(), text.size()) == ssize_t(text.size());
}

/// A user who may make a group below `parent` may not always move processes there. A process is started to try it once;
/// keepers inherit what their grader found.
bool can_join(const std::string& parent, const Descriptor& members) {
    static std::map<std::string, bool> known;
    const auto [entry, is_new] = known.try_emplace(parent, false);
    if (is_new) {
        const pid_t child = fork();
        if (child == 0) _exit(write(members.number(), "0", 1) == 1 ? 0 : 1);
        int status = -1;
        entry->second = child > 0 && waitpid(child, &status, 0) == child && status == 0;
    }
    return entry->second;
}

}  // namespace

ControlGroup::ControlGroup(std::uint64_t memory, int processes) {
    for (const std::string controller : {"", "memory", "pids"}) {
        const auto hierarchy = hierarchy_of(controller);
        if (!hierarchy) continue;
        // In version 2 a group that has processes cannot limit groups below it, but one above it may.
        Path at = hierarchy->own;
        while (!add_part(at.string(), memory, processes) && at != hierarchy->mounted) at = at.parent_path();
    }
}

bool ControlGroup::add_part(const std::string& parent, std::uint64_t memory, int processes) {
    const std::string folder = parent + "/vidno-" + std::to_string(getpid());
    if (mkdir(folder.c_str(), S_IRWXU) != 0) return false;
    const bool limits_memory = !limits_memory_ && (write_limit(folder + "/memory.max", memory) ||
                                                   write_limit(folder + "/memory.limit_in_bytes", memory));
    const bool limits_processes = !limits_processes_ && write_limit(folder + "/pids.max", std::uint64_t(processes));
    Descriptor members(open((folder + "/cgroup.procs").c_str(), O_WRONLY | O_CLOEXEC));
    if (!(limits_memory || limits_processes) || !can_join(parent, members)) {
        rmdir(folder.c_str());
        return false;
    }
    // A system that does not count swap space has none of these files.
    if (!write_limit(folder + "/memory.swap.max", 0)) write_limit(folder + "/memory.memsw.limit_in_bytes", memory);
    parts_.push_back({folder, std::move(members)});
    limits_memory_ |= limits_memory;
    limits_processes_ |= limits_processes;
    return true;
}

ControlGroup::~ControlGroup() {
    for (const Part& each : parts_) {
        // The system forgets an ended process a little later than its parent hears of the end.
        constexpr int tries = 1000, pause = 1000;
        for (int i = 0; i < tries && rmdir(each.folder.c_str()) != 0; ++i) usleep(pause);
    }
}

bool ControlGroup::join() const {
    return std::all_of(parts_.begin(), parts_.end(),
                       [](const Part& each) { return write(each.members.number(), "0", 1) == 1; });
}

bool ControlGroup::ran_out_of_memory() const {
    return std::any_of(parts_.begin(), parts_.end(), [](const Part& each) {
        for (const std::string file : {"memory.events", "memory.oom_control"}) {
            std::ifstream in(each.folder + "/" + file);
            std::string name;
            for (std::uint64_t count = 0; in >> name >> count;) {
                if (name == "oom_kill" && count > 0) return true;
            }
        }
        return false;
    });
}

}  // namespace vidno
