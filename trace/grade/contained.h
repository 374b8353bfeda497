/// Contained: runs an untrusted program under limits and, if possible, in a sandbox.
///
/// The program gets its own process group and working folder, limits of time, memory and file size, and no input. All that it prints is
/// read, and the beginning is kept. This guards against mistakes. Bubblewrap's sandbox guards against malice: it has no network and no
/// other processes. It shows only the files of the system, which are read-only, the program itself and its working folder.
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
    std::chrono::seconds time{10};                  // processor time; the limit of wall-clock time is twice that
    std::uint64_t memory = std::uint64_t{1} << 29;  // bytes of address space
    std::uint64_t file = std::uint64_t{1} << 26;    // bytes of each file that it writes, and of all that it prints
    std::string bubblewrap{};                       // path of bwrap; empty: run without a sandbox
};

enum class Ending : unsigned char {
    done,            // exit status 0
    failed,          // another exit status
    crashed,         // ended by a signal
    out_of_time,     // exceeded the limit of time
    out_of_memory,   // exceeded the limit of memory
    too_much_output  // wrote or printed more than the limit
};

struct Ended {
    Ending ending = Ending::done;
    int code = 0;      // the exit status, or the signal
    std::string said;  // the beginning of what it printed, on both outputs
};

/// How the program ended, in words such as "crashed (SIGSEGV)".
std::string words_of(const Ended& ended, const Limits& limits, const Words& say);

/// The usual cause of such a crash, in words; empty if it is unknown or the program did not crash.
std::string cause_of(const Ended& ended, const Words& say);

/// A temporary folder; the destructor removes it. The constructor throws Refused if it cannot create one.
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

/// The path of bubblewrap if it can create a sandbox here; otherwise the reason why not.
struct Sandbox {
    std::string bubblewrap, missing;
};
Sandbox find_sandbox();

/// Runs a program without arguments in the folder, with variables added to the environment. In a sandbox the program sees only those and
/// PATH, HOME and TMPDIR. Throws Refused if the program cannot be started.
Ended run_contained(const std::filesystem::path& program, const std::filesystem::path& folder,
                    const std::vector<std::pair<std::string, std::string>>& environment, const Limits& limits);

}  // namespace vidno
