/// Contained: a program of somebody else, run so that whatever it does is over soon.
///
/// It has a process group, a working folder, limits of time, memory and file size of its own, no input, and two variables of
/// its environment more than ours. What it prints is read to the end, of which the beginning is kept. This is no sandbox: it
/// guards against mistakes and not against malice.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace vidno {

struct Limits {
    std::chrono::seconds time{10};  // of the processor; by the clock twice as much
    std::uint64_t memory = std::uint64_t{1} << 29;
    std::uint64_t file = std::uint64_t{1} << 26;  // each file that it writes, and all that it prints
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
std::string words_of(const Ended& ended, const Limits& limits);

/// What a crash like this comes from, as a rule; empty if that is not known, or there was none.
std::string cause_of(const Ended& ended);

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

/// Runs a program without arguments in the folder. Throws Refused if it cannot be started.
Ended run_contained(const std::filesystem::path& program, const std::filesystem::path& folder,
                    const std::vector<std::pair<std::string, std::string>>& environment, const Limits& limits);

}  // namespace vidno
