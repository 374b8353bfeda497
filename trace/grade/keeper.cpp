#include "grade/keeper.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

#include "refused.h"

namespace vidno {

namespace {

/// The first character of what a keeper hands over.
constexpr char is_result = '+', is_refusal = '-';

[[noreturn]] void keep_watch(const std::function<std::string(int)>& work, int grader, int result) {
    // A signal to the grader's terminal or service must not keep this process from its duty.
    setsid();
    sigset_t all;
    sigfillset(&all);
    sigprocmask(SIG_BLOCK, &all, nullptr);
    prctl(PR_SET_CHILD_SUBREAPER, 1);
    std::string text;
    try {
        text = is_result + work(grader);
    } catch (const std::exception& error) {
        text = is_refusal + std::string(error.what());
    }
    for (std::size_t written = 0; written < text.size();) {
        const ssize_t size = write(result, text.data() + written, text.size() - written);
        if (size <= 0) break;
        written += std::size_t(size);
    }
    _exit(0);
}

std::vector<int> numbers_in(const std::string& file) {
    std::ifstream in(file);
    std::vector<int> numbers;
    for (int each = 0; in >> each;) numbers.push_back(each);
    return numbers;
}

std::string folder_of(int process) { return "/proc/" + std::to_string(process); }

/// The numbers of the threads of a process.
std::vector<std::string> threads_of(int process) {
    std::vector<std::string> threads;
    std::error_code gone;
    std::filesystem::directory_iterator each(folder_of(process) + "/task", gone), end;
    for (; !gone && each != end; each.increment(gone)) threads.push_back(each->path().string());
    return threads;
}

/// Calls `visit` with each descendant of this process and the number of its threads.
void for_each_descendant(const std::function<void(int process, int threads)>& visit) {
    std::vector<int> left{getpid()};
    while (!left.empty()) {
        const int process = left.back();
        left.pop_back();
        const auto threads = threads_of(process);
        for (const auto& thread : threads) {
            const auto children = numbers_in(thread + "/children");
            left.insert(left.end(), children.begin(), children.end());
        }
        if (process != getpid()) visit(process, int(threads.size()));
    }
}

std::uint64_t memory_of(int process) {
    std::ifstream in(folder_of(process) + "/status");
    std::uint64_t kibibytes = 0;
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line);
        std::string name;
        std::uint64_t amount = 0;
        words >> name;
        if ((name == "RssAnon:" || name == "RssShmem:" || name == "VmSwap:") && words >> amount) kibibytes += amount;
    }
    return kibibytes << 10;
}

/// The processor time of the process and of those that it has waited for, in clock ticks.
std::uint64_t ticks_of(int process) {
    std::ifstream in(folder_of(process) + "/stat");
    std::string line;
    std::getline(in, line);
    // The name of the program stands in parentheses and may contain anything.
    std::istringstream fields(line.substr(std::min(line.rfind(')'), line.size() - 1) + 1));
    constexpr int skipped = 11;
    std::string field;
    for (int i = 0; i < skipped; ++i) fields >> field;
    std::uint64_t ticks = 0, each = 0;
    for (int i = 0; i < 4 && fields >> each; ++i) ticks += each;
    return ticks;
}

}  // namespace

std::string system_reason() { return std::strerror(errno); }

void Descriptor::close() {
    if (number_ >= 0) ::close(number_);
    number_ = -1;
}

std::string in_keeper(const std::function<std::string(int grader)>& work) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw Refused("a pipe: " + system_reason());
    Descriptor grader(ends[0]), life(ends[1]);
    const Descriptor result(memfd_create("result", MFD_CLOEXEC));
    const pid_t keeper = result.number() < 0 ? -1 : fork();
    if (keeper < 0) throw Refused("a process: " + system_reason());
    if (keeper == 0) {
        life.close();
        keep_watch(work, grader.number(), result.number());
    }
    int status = 0;
    while (waitpid(keeper, &status, 0) < 0 && errno == EINTR) {
    }
    struct stat about {};
    fstat(result.number(), &about);
    std::string text(std::size_t(about.st_size), '\0');
    text.resize(std::size_t(std::max<ssize_t>(pread(result.number(), text.data(), text.size(), 0), 0)));
    if (text.empty()) throw Refused("the process that keeps the program was ended");
    if (text.front() == is_refusal) throw Refused(text.substr(1));
    return text.substr(1);
}

Used used_by_descendants() {
    Used used;
    std::uint64_t ticks = 0;
    for_each_descendant([&](int process, int threads) {
        used.memory += memory_of(process);
        used.processes += threads;
        ticks += ticks_of(process);
    });
    rusage ended{};
    getrusage(RUSAGE_CHILDREN, &ended);
    const auto seconds = [](const timeval& time) { return double(time.tv_sec) + double(time.tv_usec) * 1e-6; };
    used.time = std::chrono::duration<double>(double(ticks) / double(sysconf(_SC_CLK_TCK)) + seconds(ended.ru_utime) +
                                              seconds(ended.ru_stime));
    return used;
}

bool can_find_descendants() {
    const std::string self = std::to_string(getpid());
    return access(("/proc/self/task/" + self + "/children").c_str(), R_OK) == 0;
}

int first_child_of(int process) {
    const auto children = numbers_in(folder_of(process) + "/task/" + std::to_string(process) + "/children");
    return children.empty() ? 0 : children.front();
}

void end_descendants() noexcept {
    // A process that ends gives its children to this one, so none can hide behind another. One that the system does not
    // let go, for example because a disk does not answer, is given up.
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    for (;;) {
        for_each_descendant([](int process, int) { kill(process, SIGKILL); });
        while (waitpid(-1, nullptr, WNOHANG) > 0) {
        }
        if (waitpid(-1, nullptr, WNOHANG) < 0 && errno == ECHILD) return;
        if (std::chrono::steady_clock::now() > deadline) return;
        usleep(500);
    }
}

}  // namespace vidno
