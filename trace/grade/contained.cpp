#include "grade/contained.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <string_view>

#include "refused.h"

namespace vidno {

namespace {

constexpr std::size_t kept_of_output = 4096;
constexpr int cannot_start = 127;

std::string system_reason() { return std::strerror(errno); }

/// A file descriptor of ours.
class Descriptor {
public:
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor() { close(); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    int number() const { return number_; }
    void close() {
        if (number_ >= 0) ::close(number_);
        number_ = -1;
    }

private:
    int number_;
};

void limit(int resource, std::uint64_t amount) {
    const rlimit both{amount, amount};
    setrlimit(__rlimit_resource_t(resource), &both);
}

/// In the child, between fork and exec: only what may be called there.
[[noreturn]] void become(const char* program, const char* folder, char* const* environment, int output,
                         const Limits& limits) {
    setpgid(0, 0);
    const int nothing = open("/dev/null", O_RDONLY);
    dup2(nothing, STDIN_FILENO);
    dup2(output, STDOUT_FILENO);
    dup2(output, STDERR_FILENO);
    limit(RLIMIT_CPU, std::uint64_t(limits.time.count()));
    limit(RLIMIT_AS, limits.memory);
    limit(RLIMIT_FSIZE, limits.file);
    limit(RLIMIT_CORE, 0);
    char* const words[] = {const_cast<char*>(program), nullptr};
    if (chdir(folder) == 0) execve(program, words, environment);
    _exit(cannot_start);
}

/// Reads what the program prints until it has closed its outputs or must be stopped; says why, if it must.
Ending drain(int pipe, const Limits& limits, std::string& kept) {
    const auto deadline = std::chrono::steady_clock::now() + 2 * limits.time;
    std::array<char, 1 << 16> block;
    for (std::uint64_t printed = 0; printed <= limits.file;) {
        const auto left =
            std::chrono::duration_cast<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now());
        if (left.count() <= 0) return Ending::out_of_time;
        pollfd waiting{pipe, POLLIN, 0};
        if (poll(&waiting, 1, int(left.count())) <= 0) continue;
        const ssize_t size = read(pipe, block.data(), block.size());
        if (size <= 0) return Ending::done;
        kept.append(block.data(), std::min(std::size_t(size), kept_of_output - kept.size()));
        printed += std::uint64_t(size);
    }
    return Ending::too_much_output;
}

/// Waits for the end until the deadline; whether it came.
bool ends_within(pid_t child, std::chrono::seconds time, int& status, rusage& used) {
    const auto deadline = std::chrono::steady_clock::now() + time;
    while (wait4(child, &status, WNOHANG, &used) == 0) {
        if (std::chrono::steady_clock::now() > deadline) return false;
        usleep(1000);
    }
    return true;
}

/// A list that grows by doubling fails when it and its copy do not fit: a third of the memory was in use.
bool used_much(const rusage& used, const Limits& limits) {
    return std::uint64_t(used.ru_maxrss) * 1024 > limits.memory / 3;
}

Ending ending_of(int status, const rusage& used, const std::string& said, const Limits& limits) {
    const bool failed = WIFSIGNALED(status) || WEXITSTATUS(status) != 0;
    if (!failed) return Ending::done;
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXFSZ) return Ending::too_much_output;
    const bool over_time = std::chrono::seconds(used.ru_utime.tv_sec + used.ru_stime.tv_sec + 1) >= limits.time;
    if (WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || (WTERMSIG(status) == SIGKILL && over_time))) {
        return Ending::out_of_time;
    }
    if (used_much(used, limits) || said.find("bad_alloc") != said.npos) return Ending::out_of_memory;
    return WIFSIGNALED(status) ? Ending::crashed : Ending::failed;
}

struct SignalWords {
    int signal;
    std::string_view name, cause;
};

constexpr std::array signal_words{
    SignalWords{SIGSEGV, "SIGSEGV", "it reached for memory that is not its own, or called itself without end"},
    SignalWords{SIGBUS, "SIGBUS", "it reached for memory that is not there"},
    SignalWords{SIGABRT, "SIGABRT", "it gave up, as after an exception that nobody catches or a failed assertion"},
    SignalWords{SIGFPE, "SIGFPE", "it divided a whole number by zero"},
    SignalWords{SIGILL, "SIGILL",
                "it reached an instruction that there is not, as at the end of a function without return"},
};

/// Null for a signal that has none.
const SignalWords* words_of_signal(int signal) {
    const auto* found = std::find_if(signal_words.begin(), signal_words.end(),
                                     [&](const SignalWords& words) { return words.signal == signal; });
    return found == signal_words.end() ? nullptr : found;
}

}  // namespace

std::string words_of(const Ended& ended, const Limits& limits) {
    const auto mebibytes = [](std::uint64_t bytes) { return std::to_string(bytes >> 20) + " MiB"; };
    switch (ended.ending) {
        case Ending::done: return "ended";
        case Ending::failed: return "ended with exit status " + std::to_string(ended.code);
        case Ending::crashed: {
            const auto* words = words_of_signal(ended.code);
            return "crashed (" + std::string(words ? words->name : strsignal(ended.code)) + ")";
        }
        case Ending::out_of_time: return "did not end within " + std::to_string(limits.time.count()) + " s";
        case Ending::out_of_memory: return "asked for more than " + mebibytes(limits.memory) + " of memory";
        case Ending::too_much_output: return "wrote more than " + mebibytes(limits.file);
    }
    return "";
}

std::string cause_of(const Ended& ended) {
    const auto* words = ended.ending == Ending::crashed ? words_of_signal(ended.code) : nullptr;
    return std::string(words ? words->cause : "");
}

TemporaryFolder::TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "vidno-XXXXXX").string();
    if (!mkdtemp(name.data())) throw Refused(name + ": " + system_reason());
    path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

Ended run_contained(const std::filesystem::path& program, const std::filesystem::path& folder,
                    const std::vector<std::pair<std::string, std::string>>& environment, const Limits& limits) {
    const std::string file = std::filesystem::absolute(program).string(), place = folder.string();
    if (access(file.c_str(), X_OK) != 0) throw Refused(program.string() + ": " + system_reason());
    std::vector<std::string> variables;
    for (char** each = environ; *each; ++each) variables.emplace_back(*each);
    for (const auto& [name, value] : environment) variables.emplace_back(name).append("=").append(value);
    std::vector<char*> words;
    for (auto& each : variables) words.push_back(each.data());
    words.push_back(nullptr);

    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw Refused(program.string() + ": " + system_reason());
    Descriptor in(ends[0]), out(ends[1]);
    const pid_t child = fork();
    if (child < 0) throw Refused(program.string() + ": " + system_reason());
    if (child == 0) become(file.c_str(), place.c_str(), words.data(), out.number(), limits);
    setpgid(child, child);  // in both processes: either may run first
    out.close();

    Ended ended;
    const Ending stopped = drain(in.number(), limits, ended.said);
    int status = 0;
    rusage used{};
    const bool over = stopped == Ending::done && ends_within(child, 2 * limits.time, status, used);
    kill(-child, SIGKILL);
    if (!over) {
        wait4(child, &status, 0, &used);
        ended.ending = stopped == Ending::done ? Ending::out_of_time : stopped;
        return ended;
    }
    ended.ending = ending_of(status, used, ended.said, limits);
    ended.code = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status);
    if (ended.code == cannot_start && ended.said.empty()) throw Refused(program.string() + ": cannot be started");
    return ended;
}

}  // namespace vidno
