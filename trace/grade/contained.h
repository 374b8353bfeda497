/// Contained: runs an untrusted program under limits and, if possible, in a sandbox.
///
/// The limits hold for the whole run: for the program and all that it starts, together. docs/grading.md lists what is
/// guaranteed.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "grade/keeper.h"
#include "grade/words.h"

namespace vidno {

struct Limits {
    std::chrono::seconds time{10};                   // processor time; the limit of wall-clock time is twice that
    std::uint64_t memory = std::uint64_t{1} << 29;   // bytes; for each process also of address space
    std::uint64_t written = std::uint64_t{1} << 26;  // bytes that it writes and prints
    int processes = 64;                              // at the same time, their threads included
    std::string bubblewrap{};                        // path of bwrap; empty: run without a sandbox
};

enum class Ending : unsigned char {
    done,               // exit status 0
    failed,             // another exit status
    crashed,            // ended by a signal
    out_of_time,        // exceeded the limit of time
    out_of_memory,      // exceeded the limit of memory
    too_much_output,    // wrote or printed more than the limit
    too_many_processes  // exceeded the limit of processes
};

struct Ended {
    Ending ending = Ending::done;
    int code = 0;         // the exit status, or the signal
    std::string said;     // the beginning of what it printed, on both outputs
    std::string written;  // the text of the file that it was to write; empty if there is none
};

/// How the program ended, in words such as "crashed (SIGSEGV)".
std::string words_of(const Ended& ended, const Limits& limits, const Words& say);

/// The usual cause of such a crash, in words; empty if it is unknown or the program did not crash.
std::string cause_of(const Ended& ended, const Words& say);

/// The path of bubblewrap if it can create a sandbox here; otherwise the reason why not.
struct Sandbox {
    std::string bubblewrap, missing;
};
Sandbox find_sandbox();

/// What this machine lacks for these limits, in words; empty if nothing.
struct Lacking {
    std::string guarantees;     // what is not guaranteed
    std::string system_limits;  // what this program counts every 10 to 100 ms, because the system does not limit it
};
Lacking lacking_for(const Limits& limits, const Words& say);

/// A file of a run. The environment variable tells the program where it is.
struct FileOfRun {
    std::string variable, name, text{};
};

/// A program that runs without arguments, any number of times, each time under the limits.
class ContainedProgram {
public:
    /// Throws Refused if it is not an executable regular file.
    ContainedProgram(std::filesystem::path program, const Limits& limits);

    /// The program is given some files, and is to write another one. In a sandbox it sees only the variables of these
    /// files and PATH, HOME and TMPDIR. Throws Refused if it cannot be started.
    Ended run(const std::vector<FileOfRun>& given, const FileOfRun& wanted);

private:
    std::filesystem::path program_;
    Keeper keeper_;
};

}  // namespace vidno
