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
#include <sstream>
#include <string_view>

#include "refused.h"

namespace vidno {

namespace {

constexpr std::size_t kept_of_output = 4096;
constexpr int cannot_start = 127;

std::string system_reason() { return std::strerror(errno); }

/// Owns a file descriptor.
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

/// Runs in the child between fork and exec, so it calls only async-signal-safe functions.
[[noreturn]] void become(char* const* words, const char* folder, char* const* environment, int output,
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
    if (chdir(folder) == 0) execve(words[0], words, environment);
    _exit(cannot_start);
}

/// Reads what the program prints and keeps the beginning. Returns `done` when the program has closed its outputs, otherwise why it must be
/// stopped.
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

/// Waits for the child to end, at most that long. Returns whether it ended.
bool ends_within(pid_t child, std::chrono::seconds time, int& status, rusage& used) {
    const auto deadline = std::chrono::steady_clock::now() + time;
    while (wait4(child, &status, WNOHANG, &used) == 0) {
        if (std::chrono::steady_clock::now() > deadline) return false;
        usleep(1000);
    }
    return true;
}

/// A vector that doubles its capacity fails when old and new storage together exceed the limit: a third of it was in use before.
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
    std::string_view name;
    Bilingual cause;
};

constexpr std::array signal_words{
    SignalWords{SIGSEGV,
                "SIGSEGV",
                {"it accessed memory outside its own, or called itself without end",
                 "обращение к чужой памяти или бесконечная рекурсия"}},
    SignalWords{SIGBUS, "SIGBUS", {"it accessed memory that does not exist", "обращение к памяти, которой нет"}},
    SignalWords{SIGABRT,
                "SIGABRT",
                {"it aborted, as after an uncaught exception or a failed assertion",
                 "неперехваченное исключение или не выполненное утверждение assert"}},
    SignalWords{SIGFPE, "SIGFPE", {"it divided a whole number by zero", "целое число разделено на ноль"}},
    SignalWords{SIGILL,
                "SIGILL",
                {"it reached an invalid instruction, as at the end of a function without return",
                 "недопустимая инструкция, как в конце функции без return"}},
};

/// Null for a signal that is not in the table.
const SignalWords* words_of_signal(int signal) {
    const auto* found = std::find_if(signal_words.begin(), signal_words.end(),
                                     [&](const SignalWords& words) { return words.signal == signal; });
    return found == signal_words.end() ? nullptr : found;
}

using Variables = std::vector<std::pair<std::string, std::string>>;

constexpr const char* program_inside = "/program";

/// The command that runs the program in a sandbox. System folders that are symbolic links remain links inside.
std::vector<std::string> in_sandbox(const std::string& bubblewrap, const std::string& program,
                                    const std::string& folder, const Variables& variables) {
    std::vector<std::string> words{bubblewrap,      "--unshare-all", "--die-with-parent",
                                   "--new-session", "--cap-drop",    "ALL"};
    const auto add = [&](std::initializer_list<std::string> more) { words.insert(words.end(), more); };
    for (const std::string place : {"/usr", "/bin", "/sbin", "/lib", "/lib32", "/lib64", "/libx32"}) {
        if (std::filesystem::is_symlink(place)) {
            add({"--symlink", std::filesystem::read_symlink(place).string(), place});
        } else {
            add({"--ro-bind-try", place, place});
        }
    }
    for (const std::string file : {"/etc/ld.so.cache", "/etc/alternatives"}) add({"--ro-bind-try", file, file});
    add({"--proc", "/proc", "--dev", "/dev", "--bind", folder, folder, "--ro-bind", program, program_inside});
    add({"--remount-ro", "/", "--chdir", folder, "--clearenv"});
    add({"--setenv", "PATH", "/usr/local/bin:/usr/bin:/bin", "--setenv", "HOME", folder, "--setenv", "TMPDIR", folder});
    for (const auto& [name, value] : variables) add({"--setenv", name, value});
    add({"--", program_inside});
    return words;
}

/// If a signal ends its program, bubblewrap exits with 128 + the signal, as a shell does. This recovers the signal.
void name_signal(Ended& ended) {
    constexpr int signalled = 128, signals = 64;
    if (ended.code <= signalled || ended.code > signalled + signals) return;
    ended.code -= signalled;
    if (ended.code == SIGXFSZ)
        ended.ending = Ending::too_much_output;
    else if (ended.code == SIGXCPU || ended.code == SIGKILL)
        ended.ending = Ending::out_of_time;
    else if (ended.ending == Ending::failed)
        ended.ending = Ending::crashed;
}

/// The words as exec takes them: pointers, then null.
std::vector<char*> pointers_to(std::vector<std::string>& words) {
    std::vector<char*> pointers;
    for (auto& each : words) pointers.push_back(each.data());
    pointers.push_back(nullptr);
    return pointers;
}

}  // namespace

Sandbox find_sandbox() {
    const char* const path = std::getenv("PATH");
    std::istringstream places(path ? path : "");
    Sandbox found{{}, "bubblewrap is not installed"};
    for (std::string place; std::getline(places, place, ':');) {
        const std::string file = place + "/bwrap";
        if (access(file.c_str(), X_OK) != 0) continue;
        // Where user namespaces are forbidden, as in many containers, bwrap exists but cannot create a sandbox.
        const TemporaryFolder folder;
        Limits limits;
        limits.bubblewrap = file;
        try {
            const Ended ended = run_contained("/bin/true", folder.path(), {}, limits);
            if (ended.ending == Ending::done) return {file, {}};
            found.missing = ended.said.substr(0, ended.said.find('\n'));
        } catch (const Refused& refused) {
            found.missing = refused.what();
        }
        return found;
    }
    return found;
}

std::string words_of(const Ended& ended, const Limits& limits, const Words& say) {
    const auto mebibytes = [](std::uint64_t bytes) { return int(bytes >> 20); };
    switch (ended.ending) {
        case Ending::done: return say({"ended", "завершилась"});
        case Ending::failed: return say({"ended with exit status {}", "завершилась с кодом {}"}, ended.code);
        case Ending::crashed: {
            const auto* words = words_of_signal(ended.code);
            return say({"crashed ({})", "аварийно завершилась ({})"},
                       std::string(words ? words->name : strsignal(ended.code)));
        }
        case Ending::out_of_time:
            return say({"did not end within {} s", "не завершилась за {} с"}, int(limits.time.count()));
        case Ending::out_of_memory:
            return say({"asked for more than {} MiB of memory", "запросила больше {} МиБ памяти"},
                       mebibytes(limits.memory));
        case Ending::too_much_output:
            return say({"wrote more than {} MiB", "записала больше {} МиБ"}, mebibytes(limits.file));
    }
    return "";
}

std::string cause_of(const Ended& ended, const Words& say) {
    const auto* words = ended.ending == Ending::crashed ? words_of_signal(ended.code) : nullptr;
    return words ? say(words->cause) : "";
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
    if (access(file.c_str(), X_OK) != 0) {
        const bool is_there = errno == EACCES;
        throw Refused(program.string() + ": " +
                      (is_there ? "not executable: compile the source first, or set the permission by chmod +x"
                                : system_reason()));
    }
    const bool in_a_sandbox = !limits.bubblewrap.empty();
    std::vector<std::string> words{file}, variables;
    if (in_a_sandbox) words = in_sandbox(limits.bubblewrap, file, place, environment);
    for (char** each = environ; *each; ++each) variables.emplace_back(*each);
    for (const auto& [name, value] : environment) variables.emplace_back(name).append("=").append(value);
    const std::vector<char*> argv = pointers_to(words), envp = pointers_to(variables);

    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw Refused(program.string() + ": " + system_reason());
    Descriptor in(ends[0]), out(ends[1]);
    const pid_t child = fork();
    if (child < 0) throw Refused(program.string() + ": " + system_reason());
    if (child == 0) become(argv.data(), place.c_str(), envp.data(), out.number(), limits);
    setpgid(child, child);  // the child does the same: either may run first
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
    if (in_a_sandbox) name_signal(ended);
    if (in_a_sandbox && ended.ending == Ending::failed && ended.said.starts_with("bwrap: "))
        throw Refused(program.string() + ": " + ended.said.substr(0, ended.said.find('\n')) + "; see --no-sandbox");
    if (ended.code == cannot_start && ended.said.empty()) throw Refused(program.string() + ": cannot be started");
    return ended;
}

}  // namespace vidno
