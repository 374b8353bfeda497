#include "grade/contained.h"

#include <dirent.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/signalfd.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <sstream>
#include <string_view>

#include "grade/control_group.h"
#include "grade/sandbox.h"
#include "output.h"
#include "refused.h"

namespace vidno {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kept_of_output = 4096;
constexpr int cannot_start = 127, handshake_number = 3;
constexpr std::uint64_t mebibyte = std::uint64_t{1} << 20;

/// Removes all that is in a folder, however deep it is and whatever its permissions are. It leaves this process in some
/// other folder.
void remove_all_in(const std::string& folder) {
    if (chdir(folder.c_str()) != 0) return;
    for (int depth = 0; depth >= 0;) {
        chmod(".", S_IRWXU);
        std::string below;
        DIR* const here = opendir(".");
        while (const dirent* each = here ? readdir(here) : nullptr) {
            const std::string name = each->d_name;
            if (name == "." || name == "..") continue;
            if (unlink(each->d_name) != 0 && rmdir(each->d_name) != 0) below = name;
        }
        if (here) closedir(here);
        if (below.empty()) {
            --depth;
            if (chdir("..") != 0) return;
        } else {
            ++depth;
            chmod(below.c_str(), S_IRWXU);
            if (chdir(below.c_str()) != 0) return;
        }
    }
}

/// A folder of this machine for a run without a sandbox.
class TemporaryFolder {
public:
    TemporaryFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "vidno-XXXXXX").string();
        if (!mkdtemp(name.data())) throw Refused(name + ": " + system_reason());
        path_ = name;
    }
    ~TemporaryFolder() {
        const Descriptor before(open(".", O_RDONLY | O_DIRECTORY | O_CLOEXEC));
        remove_all_in(path_);
        if (before.number() < 0 || fchdir(before.number()) != 0) return;
        rmdir(path_.c_str());
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::string& path() const { return path_; }

private:
    std::string path_;
};

struct EndsDescendants {
    EndsDescendants() = default;
    ~EndsDescendants() { end_descendants(); }
    EndsDescendants(const EndsDescendants&) = delete;
    EndsDescendants& operator=(const EndsDescendants&) = delete;
};

/// Limits the process; 0 is this one. Only calls async-signal-safe functions.
bool limit_process(pid_t process, const Limits& limits, bool in_a_sandbox) {
    bool holds = true;
    const auto set = [&](__rlimit_resource resource, std::uint64_t amount, std::uint64_t more = 0) {
        rlimit now{};
        holds = holds && prlimit(process, resource, nullptr, &now) == 0;
        const rlimit both{std::min<rlim_t>(amount, now.rlim_max), std::min<rlim_t>(amount + more, now.rlim_max)};
        holds = holds && prlimit(process, resource, &both, nullptr) == 0;
    };
    constexpr std::uint64_t open_files = 256;
    set(RLIMIT_CPU, std::uint64_t(limits.time.count()), 1);
    set(RLIMIT_AS, limits.memory);
    set(RLIMIT_FSIZE, limits.written);
    set(RLIMIT_CORE, 0);
    set(RLIMIT_NOFILE, open_files);
    set(RLIMIT_MSGQUEUE, 0);
    // Outside the sandbox's user namespace this would count all processes of the user. Inside, bubblewrap has one.
    if (in_a_sandbox) set(RLIMIT_NPROC, std::uint64_t(limits.processes) + 1);
    return holds;
}

/// Limits a process in the sandbox. The system lets a user limit the own processes, but not always root those of
/// others.
bool limit_process_as(unsigned user, pid_t process, const Limits& limits) {
    if (limit_process(process, limits, true)) return true;
    const pid_t helper = fork();
    if (helper == 0) _exit((geteuid() != 0 || leave_root_for(user)) && limit_process(process, limits, true) ? 0 : 1);
    int status = -1;
    return helper > 0 && waitpid(helper, &status, 0) == helper && status == 0;
}

/// The words as exec takes them: pointers, then null.
std::vector<char*> pointers_to(std::vector<std::string>& words) {
    std::vector<char*> pointers;
    for (auto& each : words) pointers.push_back(each.data());
    pointers.push_back(nullptr);
    return pointers;
}

/// What the program becomes after fork.
struct ProgramStart {
    std::vector<std::string> words, variables;
    std::vector<Descriptor> inherited;  // by the sandbox
    std::string folder;                 // where the program begins; empty in a sandbox
    int output = -1, handshake = -1;    // without a sandbox, the end of the handshake is closed when the program begins
    const ControlGroup* group = nullptr;
};

/// Runs in the child between fork and exec, so it calls only async-signal-safe functions.
[[noreturn]] void become(const ProgramStart& start, char* const* words, char* const* variables, const Limits& limits) {
    const bool in_a_sandbox = start.folder.empty();
    setpgid(0, 0);
    const int nothing = open("/dev/null", O_RDONLY);
    dup2(nothing, STDIN_FILENO);
    dup2(start.output, STDOUT_FILENO);
    dup2(start.output, STDERR_FILENO);
    close_range(STDERR_FILENO + 1, ~0U, CLOSE_RANGE_CLOEXEC);
    for (const Descriptor& each : start.inherited) fcntl(each.number(), F_SETFD, 0);
    bool can_start = start.group->join();
    if (in_a_sandbox) {
        can_start = can_start && dup2(start.handshake, handshake_number) >= 0 &&
                    fcntl(handshake_number, F_SETFD, 0) == 0 && leave_root();
    } else {
        prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
        can_start = can_start && limit_process(0, limits, false) && chdir(start.folder.c_str()) == 0;
    }
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
    if (can_start) execve(words[0], words, variables);
    _exit(cannot_start);
}

std::uint64_t written_in(int folder, const std::string& on_this_machine) {
    if (on_this_machine.empty()) {
        struct statvfs about {};
        constexpr std::uint64_t cost_of_file = 1024;
        if (fstatvfs(folder, &about) != 0) return 0;
        return (about.f_blocks - about.f_bfree) * about.f_frsize + (about.f_files - about.f_ffree) * cost_of_file;
    }
    std::uint64_t bytes = 0;
    std::error_code error;
    std::filesystem::recursive_directory_iterator each(on_this_machine, error), end;
    for (; !error && each != end; each.increment(error)) {
        struct stat about {};
        constexpr std::uint64_t block = 512;
        if (lstat(each->path().c_str(), &about) == 0) bytes += std::uint64_t(about.st_blocks) * block;
    }
    return bytes;
}

/// The text of a file that the program was to write. Only a regular file in its own folder is read: a link could lead
/// elsewhere, and a pipe would wait for a writer.
std::string text_written(int folder, const std::string& name, std::uint64_t most) {
    fchmod(folder, S_IRWXU);
    const Descriptor file(openat(folder, name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    struct stat about {};
    if (file.number() < 0 || fstat(file.number(), &about) != 0 || !S_ISREG(about.st_mode)) return "";
    std::string text(std::min(std::uint64_t(about.st_size), most), '\0');
    std::size_t size = 0;
    while (size < text.size()) {
        const ssize_t part = read(file.number(), text.data() + size, text.size() - size);
        if (part <= 0) break;
        size += std::size_t(part);
    }
    text.resize(size);
    return text;
}

/// A vector that doubles its capacity fails when old and new storage together exceed the limit: a third of it was in
/// use before.
bool used_much(std::uint64_t memory, const Limits& limits) { return memory > limits.memory / 3; }

Ending ending_of(int status, const rusage& used, const std::string& said, const Limits& limits) {
    const bool failed = WIFSIGNALED(status) || WEXITSTATUS(status) != 0;
    if (!failed) return Ending::done;
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXFSZ) return Ending::too_much_output;
    const auto seconds = std::chrono::seconds(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
                         std::chrono::microseconds(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
    const bool over_time = seconds >= limits.time;
    if (WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || (WTERMSIG(status) == SIGKILL && over_time))) {
        return Ending::out_of_time;
    }
    if (used_much(std::uint64_t(used.ru_maxrss) * 1024, limits) || said.find("bad_alloc") != said.npos)
        return Ending::out_of_memory;
    return WIFSIGNALED(status) ? Ending::crashed : Ending::failed;
}

/// If a signal ends its program, bubblewrap exits with 128 + the signal, as a shell does. This recovers the status.
int without_bubblewrap(int status) {
    constexpr int signalled = 128, signals = 64;
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
    return code > signalled && code <= signalled + signals ? code - signalled : status;
}

constexpr int of_bubblewrap = 2;  // processes

/// The system counts the files in memory and the sandbox's own processes, too.
ControlGroup group_for(const Limits& limits) {
    constexpr std::uint64_t memory_of_bubblewrap = 16 * mebibyte;
    return {limits.memory + limits.written + memory_of_bubblewrap,
            limits.processes + (limits.bubblewrap.empty() ? 0 : of_bubblewrap)};
}

/// A run under supervision, in the keeper.
class WatchedRun {
public:
    WatchedRun(const ProgramStart& start, Descriptor output, Descriptor handshake, Descriptor folder,
               const Limits& limits)
        : limits_(limits),
          group_(*start.group),
          output_(std::move(output)),
          handshake_(std::move(handshake)),
          folder_(std::move(folder)),
          on_this_machine_(start.folder),
          in_a_sandbox_(start.folder.empty()) {
        sigset_t child_ended;
        sigemptyset(&child_ended);
        sigaddset(&child_ended, SIGCHLD);
        signals_ = Descriptor(signalfd(-1, &child_ended, SFD_CLOEXEC | SFD_NONBLOCK));
        fcntl(output_.number(), F_SETFL, O_NONBLOCK);
        std::vector<std::string> words = start.words, variables = start.variables;
        const auto argv = pointers_to(words), envp = pointers_to(variables);
        child_ = fork();
        if (child_ < 0) throw Refused("a process: " + system_reason());
        if (child_ == 0) become(start, argv.data(), envp.data(), limits);
    }

    /// Returns when the program has ended, or has to be stopped.
    void watch(int grader) {
        while (!status_ && !stopped_) {
            wait_for_news(grader);
            int status = 0;
            rusage used{};
            for (pid_t ended = 0; (ended = wait4(-1, &status, WNOHANG, &used)) > 0;) {
                if (ended != child_) continue;
                status_ = status;
                used_ = used;
            }
            if (!status_ && Clock::now() >= next_look_) look();
        }
    }

    /// After the end of all descendants.
    Ended result(const std::string& wanted) {
        read_output();
        // Without a sandbox there is nothing to wait for: the program may have ended before that was seen.
        if (in_a_sandbox_ && !is_ready_)
            throw Refused(said_.empty() ? "the sandbox cannot be created" : said_.substr(0, said_.find('\n')));
        const bool wrote_much = printed_ + written_in(folder_.number(), on_this_machine_) > limits_.written;
        if (!stopped_ && wrote_much) stopped_ = Ending::too_much_output;
        if (!stopped_ && group_.ran_out_of_memory()) stopped_ = Ending::out_of_memory;
        Ended ended{Ending::done, 0, said_, text_written(folder_.number(), wanted, limits_.written)};
        if (stopped_) {
            ended.ending = *stopped_;
            return ended;
        }
        const int status = in_a_sandbox_ ? without_bubblewrap(*status_) : *status_;
        ended.ending = ending_of(status, used_, said_, limits_);
        ended.code = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status);
        if (ended.code == cannot_start && said_.empty()) throw Refused("cannot be started");
        return ended;
    }

private:
    void wait_for_news(int grader) {
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(next_look_ - Clock::now());
        std::array<pollfd, 4> all{pollfd{grader, POLLIN, 0},
                                  {signals_.number(), POLLIN, 0},
                                  {output_.number(), POLLIN, 0},
                                  {handshake_.number(), POLLIN, 0}};
        if (poll(all.data(), all.size(), std::max(int(left.count()), 0)) <= 0) return;
        if (all[0].revents != 0) throw Refused("the grader has ended");
        signalfd_siginfo which{};
        while (read(signals_.number(), &which, sizeof which) > 0) {
        }
        if (all[2].revents != 0) read_output();
        if (all[3].revents != 0) begin();
    }

    void read_output() {
        std::array<char, 1 << 16> block;
        for (int blocks = 0; output_.number() >= 0 && blocks < 16; ++blocks) {
            const ssize_t size = read(output_.number(), block.data(), block.size());
            if (size < 0) return;
            if (size == 0) output_.close();
            said_.append(block.data(), std::min(std::size_t(size), kept_of_output - said_.size()));
            printed_ += std::uint64_t(size);
        }
        if (printed_ > limits_.written) stopped_ = Ending::too_much_output;
    }

    /// The sandbox is ready, or, if the other end was closed, it cannot be created or the program runs without one.
    void begin() {
        char line = 0;
        if (read(handshake_.number(), &line, 1) == 1) {
            const int first = first_child_of(child_), program = first_child_of(first);
            const std::string inside = "/proc/" + std::to_string(first) + "/root" + folder_inside;
            struct stat about {};
            if (program == 0 || stat(("/proc/" + std::to_string(program)).c_str(), &about) != 0)
                throw Refused("the sandbox's processes cannot be seen");
            if (about.st_uid == 0) throw Refused("the sandbox would have the rights of root");
            // This keeps the folder after the sandbox has ended.
            folder_ = Descriptor(open(inside.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
            if (folder_.number() < 0) throw Refused("the sandbox's folder: " + system_reason());
            if (!limit_process_as(about.st_uid, program, limits_)) throw Refused("the sandbox cannot be limited");
            is_ready_ = write(handshake_.number(), "\n", 1) == 1;
        } else {
            is_ready_ = !in_a_sandbox_;
        }
        begun_ = next_look_ = Clock::now();
        handshake_.close();
    }

    /// Compares what the run uses with the limits. The more a look takes, the longer until the next one.
    void look() {
        const auto now = Clock::now();
        // Before it begins, a process still has the memory of the grader.
        const Used used = is_ready_ ? used_by_descendants() : Used{};
        if (printed_ + written_in(folder_.number(), on_this_machine_) > limits_.written)
            stopped_ = Ending::too_much_output;
        if (used.memory > limits_.memory || group_.ran_out_of_memory()) stopped_ = Ending::out_of_memory;
        if (used.processes > limits_.processes + (in_a_sandbox_ ? of_bubblewrap : 0))
            stopped_ = Ending::too_many_processes;
        if (now > begun_ + 2 * limits_.time || used.time - time_before_ > limits_.time + std::chrono::seconds(1))
            stopped_ = Ending::out_of_time;
        constexpr int share = 10;
        constexpr std::chrono::milliseconds least(10), most(100);
        next_look_ = Clock::now() + std::clamp<Clock::duration>(share * (Clock::now() - now), least, most);
    }

    const Limits& limits_;
    const ControlGroup& group_;
    Descriptor output_, handshake_, folder_, signals_;
    std::string on_this_machine_;
    bool in_a_sandbox_, is_ready_ = false;
    pid_t child_ = -1;
    Clock::time_point begun_ = Clock::now(), next_look_ = begun_;
    const std::chrono::duration<double> time_before_ = used_by_descendants().time;  // of earlier runs
    std::optional<int> status_;
    rusage used_{};
    std::optional<Ending> stopped_;
    std::string said_;
    std::uint64_t printed_ = 0;
};

using Variables = std::vector<std::pair<std::string, std::string>>;

/// In the keeper: starts the program, watches it, and leaves nothing of it.
Ended kept(const std::string& program, const std::vector<FileOfRun>& given, const FileOfRun& wanted,
           const Limits& limits, int grader) {
    const bool in_a_sandbox = !limits.bubblewrap.empty();
    std::optional<TemporaryFolder> folder;
    if (!in_a_sandbox) folder.emplace();
    const ControlGroup group = group_for(limits);
    const EndsDescendants always;  // before its folder and its group are removed
    const std::string place = in_a_sandbox ? folder_inside : folder->path();
    Variables variables{{wanted.variable, place + "/" + wanted.name}};
    std::vector<FileInside> inside;
    for (const FileOfRun& each : given) {
        const std::string name = (in_a_sandbox ? "" : place) + "/" + each.name;
        variables.emplace_back(each.variable, name);
        if (in_a_sandbox) {
            inside.emplace_back(name, each.text);
        } else {
            write_file(name, each.text);
        }
    }
    int ends[2], line[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw Refused("a pipe: " + system_reason());
    Descriptor in(ends[0]), out(ends[1]);
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, line) != 0) throw Refused("a socket: " + system_reason());
    Descriptor near(line[0]), far(line[1]);
    ProgramStart start;
    start.output = out.number();
    start.handshake = far.number();
    start.group = &group;
    Descriptor own_folder;
    if (in_a_sandbox) {
        variables.insert(variables.end(),
                         {{"PATH", "/usr/local/bin:/usr/bin:/bin"}, {"HOME", place}, {"TMPDIR", place}});
        SandboxCommand command =
            sandbox_command(limits.bubblewrap, program, variables, inside, limits.written + mebibyte, handshake_number);
        start.words = std::move(command.words);
        start.inherited = std::move(command.inherited);
    } else {
        start.words = {program};
        for (char** each = environ; *each; ++each) start.variables.emplace_back(*each);
        for (const auto& [name, value] : variables) start.variables.emplace_back(name).append("=").append(value);
        start.folder = place;
        own_folder = Descriptor(open(place.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    }
    WatchedRun run(start, std::move(in), std::move(near), std::move(own_folder), limits);
    out.close();
    far.close();
    run.watch(grader);
    end_descendants();
    return run.result(wanted.name);
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

/// In the keeper: a run whose files come and go as texts. The wanted file is the last.
Keeper::Texts run_once(const std::string& program, const Keeper::Texts& request, const Limits& limits, int grader) {
    std::vector<FileOfRun> files;
    for (std::size_t i = 0; i < request.size(); i += 3) files.push_back({request[i], request[i + 1], request[i + 2]});
    const FileOfRun wanted = std::move(files.back());
    files.pop_back();
    Ended ended = kept(program, files, wanted, limits, grader);
    return {std::to_string(int(ended.ending)), std::to_string(ended.code), std::move(ended.said),
            std::move(ended.written)};
}

std::filesystem::path checked(std::filesystem::path program) {
    if (access(program.c_str(), X_OK) != 0) {
        const bool is_there = errno == EACCES;
        throw Refused(program.string() + ": " +
                      (is_there ? "not executable: compile the source first, or set the permission by chmod +x"
                                : system_reason()));
    }
    if (!std::filesystem::is_regular_file(program)) throw Refused(program.string() + ": not a regular file");
    return program;
}

/// What this machine has to contain a run.
struct Here {
    bool sandbox, filter, descendants, memory_limit, process_limit;
};

enum class Assurance : unsigned char { no, by_counting, yes };

struct Guarantee {
    Bilingual what;
    Assurance (*assurance)(const Here&);
};

constexpr auto in_the_sandbox = [](const Here& here) { return here.sandbox ? Assurance::yes : Assurance::no; };

/// docs/grading.md describes them, and what always holds.
const Guarantee guarantees[] = {
    {{"which files it reads", "какие файлы она читает"}, in_the_sandbox},
    {{"where it writes", "куда она пишет"}, in_the_sandbox},
    {{"how much it writes in all", "сколько она пишет всего"}, in_the_sandbox},
    {{"that no file of it remains", "что от неё не останется файлов"}, in_the_sandbox},
    {{"that it has no rights of yours", "что у неё нет ваших прав"}, in_the_sandbox},
    {{"that it reaches no network and no other process", "что ей недоступны сеть и другие процессы"}, in_the_sandbox},
    {{"how many processes it runs", "сколько процессов она запускает"},
     [](const Here& here) {
         return here.process_limit || (here.sandbox && here.descendants) ? Assurance::yes : Assurance::no;
     }},
    {{"that no process of it survives", "что её процессы не переживут её"},
     [](const Here& here) { return here.descendants ? Assurance::yes : Assurance::no; }},
    {{"how much memory its processes take together", "сколько памяти занимают её процессы вместе"},
     [](const Here& here) {
         if (here.memory_limit) return Assurance::yes;
         return here.descendants ? Assurance::by_counting : Assurance::no;
     }},
    {{"that it takes no memory of the system besides", "что она не займёт ещё и память системы"},
     [](const Here& here) { return here.sandbox && here.filter ? Assurance::yes : Assurance::no; }},
};

}  // namespace

Sandbox find_sandbox() {
    const char* const path = std::getenv("PATH");
    std::istringstream places(path ? path : "");
    for (std::string place; std::getline(places, place, ':');) {
        Limits limits;
        limits.bubblewrap = place + "/bwrap";
        if (access(limits.bubblewrap.c_str(), X_OK) != 0) continue;
        // Where user namespaces are forbidden, as in many containers, bwrap exists but cannot create a sandbox.
        try {
            const Ended ended = ContainedProgram("/bin/true", limits).run({}, {"VIDNO_TRACE", "trace.jsonl"});
            if (ended.ending == Ending::done) return {limits.bubblewrap, {}};
            return {{}, ended.said.substr(0, ended.said.find('\n'))};
        } catch (const Refused& refused) {
            return {{}, refused.what()};
        }
    }
    return {{}, "bubblewrap is not installed"};
}

Lacking lacking_for(const Limits& limits, const Words& say) {
    const ControlGroup group = group_for(limits);
    const Here here{!limits.bubblewrap.empty(), can_refuse_calls(), can_find_descendants(), group.limits_memory(),
                    group.limits_processes()};
    Lacking lacking;
    for (const Guarantee& each : guarantees) {
        const Assurance assurance = each.assurance(here);
        if (assurance == Assurance::yes) continue;
        std::string& list = assurance == Assurance::no ? lacking.guarantees : lacking.system_limits;
        list.append(list.empty() ? "" : "; ").append(say(each.what));
    }
    return lacking;
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
            return say({"wrote more than {} MiB", "записала больше {} МиБ"}, mebibytes(limits.written));
        case Ending::too_many_processes:
            return say({"ran more than {} processes at once", "запустила больше {} процессов сразу"}, limits.processes);
    }
    return "";
}

std::string cause_of(const Ended& ended, const Words& say) {
    const auto* words = ended.ending == Ending::crashed ? words_of_signal(ended.code) : nullptr;
    return words ? say(words->cause) : "";
}

ContainedProgram::ContainedProgram(std::filesystem::path program, const Limits& limits)
    : program_(checked(std::move(program))),
      keeper_([file = std::filesystem::absolute(program_).string(), limits](const Keeper::Texts& request, int grader) {
          return run_once(file, request, limits, grader);
      }) {}

Ended ContainedProgram::run(const std::vector<FileOfRun>& given, const FileOfRun& wanted) {
    Keeper::Texts request;
    for (const FileOfRun& each : given) request.insert(request.end(), {each.variable, each.name, each.text});
    request.insert(request.end(), {wanted.variable, wanted.name, wanted.text});
    try {
        Keeper::Texts answer = keeper_.answer_to(request);
        return {Ending(std::stoi(answer[0])), std::stoi(answer[1]), std::move(answer[2]), std::move(answer[3])};
    } catch (const Refused& refused) {
        throw Refused(program_.string() + ": " + refused.what());
    }
}

}  // namespace vidno
