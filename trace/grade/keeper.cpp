#include "grade/keeper.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <vector>

#include "refused.h"

namespace vidno {

namespace {

/// The last text of what a keeper hands over.
constexpr const char *is_result = "result", *is_refusal = "refusal";

/// Reads `size` bytes; false if the other end is closed before.
bool read_all(int line, char* to, std::size_t size) {
    while (size > 0) {
        const ssize_t part = read(line, to, size);
        if (part < 0 && errno == EINTR) continue;
        if (part <= 0) return false;
        to += part;
        size -= std::size_t(part);
    }
    return true;
}

bool send_all(int line, const char* from, std::size_t size) {
    while (size > 0) {
        const ssize_t part = send(line, from, size, MSG_NOSIGNAL);
        if (part < 0 && errno == EINTR) continue;
        if (part <= 0) return false;
        from += part;
        size -= std::size_t(part);
    }
    return true;
}

/// A message is the number of its texts, then the size and the bytes of each.
bool send_message(int line, const Keeper::Texts& texts) {
    const auto send_number = [&](std::uint64_t number) {
        return send_all(line, reinterpret_cast<const char*>(&number), sizeof number);
    };
    return send_number(texts.size()) && std::ranges::all_of(texts, [&](const std::string& text) {
               return send_number(text.size()) && send_all(line, text.data(), text.size());
           });
}

/// The next message; none if the other end is closed before.
std::optional<Keeper::Texts> next_message(int line) {
    const auto has_read = [&](std::uint64_t& number) {
        return read_all(line, reinterpret_cast<char*>(&number), sizeof number);
    };
    std::uint64_t count = 0, size = 0;
    if (!has_read(count)) return std::nullopt;
    Keeper::Texts texts;
    while (texts.size() < count) {
        if (!has_read(size)) return std::nullopt;
        std::string& text = texts.emplace_back(size, '\0');
        if (!read_all(line, text.data(), size)) return std::nullopt;
    }
    return texts;
}

[[noreturn]] void serve(const Keeper::Work& work, int grader) {
    // A signal to the grader's terminal or service must not keep this process from its duty.
    setsid();
    sigset_t all;
    sigfillset(&all);
    sigprocmask(SIG_BLOCK, &all, nullptr);
    prctl(PR_SET_CHILD_SUBREAPER, 1);
    while (const auto request = next_message(grader)) {
        Keeper::Texts answer;
        try {
            answer = work(*request, grader);
            answer.emplace_back(is_result);
        } catch (const std::exception& error) {
            answer = {error.what(), is_refusal};
        }
        if (!send_message(grader, answer)) break;
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

Keeper::Keeper(const Work& work) {
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) throw Refused("a socket: " + system_reason());
    line_ = Descriptor(ends[0]);
    const Descriptor grader(ends[1]);
    process_ = fork();
    if (process_ < 0) throw Refused("a process: " + system_reason());
    if (process_ == 0) {
        line_.close();
        serve(work, grader.number());
    }
}

Keeper::~Keeper() {
    line_.close();
    while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
}

Keeper::Texts Keeper::answer_to(const Texts& request) {
    auto answer = send_message(line_.number(), request) ? next_message(line_.number()) : std::nullopt;
    if (!answer) throw Refused("the process that keeps the program was ended");
    const bool is_refused = answer->back() == is_refusal;
    answer->pop_back();
    if (is_refused) throw Refused(answer->front());
    return std::move(*answer);
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
