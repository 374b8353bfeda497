/// Contained: a program of somebody else, run so that whatever it does is over soon.
///
/// It has a process group, a working folder, limits of time, memory and file size of its own, and no input. What it prints is
/// read to the end, of which the beginning is kept. That guards against mistakes. Against malice guards a sandbox, bubblewrap's:
/// there is no network in it, no other process, and of the files only those of the system, which it may not write, the program
/// itself and its working folder.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "grade/words.h"

namespace vidno {

struct Limits {
    std::chrono::seconds time{10};  // of the processor; by the clock twice as much
    std::uint64_t memory = std::uint64_t{1} << 29;
    std::uint64_t file = std::uint64_t{1} << 26;  // each file that it writes, and all that it prints
    std::string bubblewrap{};                     // the program of that name; empty: without a sandbox
};

enum class Ending : unsigned char {
    done,            // exit status 0
    failed,          // another one
    crashed,         // by a signal
    out_of_time,     // it did not end
    out_of_memory,   // it asked for more than it may have
    too_much_output  // it wrote or printed more than it may
};

struct Ended {
    Ending ending = Ending::done;
    int code = 0;      // the exit status, or the signal
    std::string said;  // the beginning of what it printed, on both outputs
};

/// In words, "crashed (SIGSEGV)".
std::string words_of(const Ended& ended, const Limits& limits, const Words& say);

/// What a crash like this comes from, as a rule; empty if that is not known, or there was none.
std::string cause_of(const Ended& ended, const Words& say);

/// A temporary folder, removed with the object. Throws Refused if it cannot be made.
class TemporaryFolder {
public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

/// Where bubblewrap is, if a sandbox can be made here; else why there is none.
struct Sandbox {
    std::string bubblewrap, missing;
};
Sandbox find_sandbox();

/// Runs a program without arguments in the folder. Throws Refused if it cannot be started.
Ended run_contained(const std::filesystem::path& program, const std::filesystem::path& folder,
                    const std::vector<std::pair<std::string, std::string>>& environment, const Limits& limits);

}  // namespace vidno
