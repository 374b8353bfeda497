#include "cli/shared/processes.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <deque>
#include <iostream>

#include "refused.h"

namespace vidno::cli {

namespace {

[[noreturn]] void refuse() { throw Refused(std::string("a process: ") + std::strerror(errno)); }

std::string joined(const Parts& parts) {
    std::string text;
    for (const auto& part : parts) text += std::to_string(part.size()) + '\n' + part;
    return text;
}

Parts parted(const std::string& text) {
    Parts parts;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = text.find('\n', at), size = std::stoull(text.substr(at, end - at));
        parts.push_back(text.substr(end + 1, size));
        at = end + 1 + size;
    }
    return parts;
}

/// How the work ended, before its parts.
constexpr char is_done = 'd', is_refused = 'r', is_lost = 'l';

std::string text_of(const std::function<Parts()>& work) {
    try {
        return is_done + joined(work());
    } catch (const OutputLost& reason) {
        return is_lost + std::string(reason.what());
    } catch (const Refused& reason) {
        return is_refused + std::string(reason.what());
    }
}

/// A process that does a piece of the work.
class Worker {
public:
    explicit Worker(const std::function<Parts()>& work) {
        std::array<int, 2> ends{};
        if (pipe2(ends.data(), O_CLOEXEC) != 0) refuse();
        const pid_t parent = getpid();
        std::cout.flush();
        process_ = fork();
        if (process_ < 0) refuse();
        if (process_ == 0) {
            // With the parent ends what it waits for.
            if (prctl(PR_SET_PDEATHSIG, SIGTERM) != 0 || getppid() != parent) _exit(1);
            const std::string text = text_of(work);
            for (std::size_t at = 0; at < text.size();) {
                const ssize_t count = write(ends[1], text.data() + at, text.size() - at);
                if (count < 0 && errno != EINTR) _exit(1);
                if (count > 0) at += std::size_t(count);
            }
            _exit(0);
        }
        close(ends[1]);
        output_ = ends[0];
    }
    ~Worker() {
        close(output_);
        if (!has_ended_) {
            kill(process_, SIGTERM);
            waitpid(process_, nullptr, 0);
        }
    }
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    bool has_ended() const { return has_ended_; }
    pollfd awaited() const { return {has_ended_ ? -1 : output_, POLLIN, 0}; }

    void read_on() {
        std::array<char, 1 << 16> block;
        const ssize_t count = read(output_, block.data(), block.size());
        if (count > 0) text_.append(block.data(), std::size_t(count));
        if (count != 0) return;
        has_ended_ = true;
        waitpid(process_, nullptr, 0);
    }

    Parts parts() const {
        if (text_.empty()) throw Refused("a process ended without a result");
        const std::string rest = text_.substr(1);
        if (text_.front() == is_lost) throw OutputLost(rest);
        if (text_.front() == is_refused) throw Refused(rest);
        return parted(rest);
    }

private:
    pid_t process_ = 0;
    int output_ = -1;
    bool has_ended_ = false;
    std::string text_;
};

}  // namespace

void in_processes(std::size_t most, std::size_t count, const std::function<Parts(std::size_t)>& work,
                  const std::function<void(Parts)>& use) {
    std::deque<Worker> workers;  // those whose results were not used yet, in order
    std::size_t begun = 0;
    while (begun < count || !workers.empty()) {
        const auto run =
            std::size_t(std::ranges::count_if(workers, [](const Worker& each) { return !each.has_ended(); }));
        if (begun < count && run < most) {
            workers.emplace_back([&, item = begun] { return work(item); });
            ++begun;
            continue;
        }
        if (workers.front().has_ended()) {
            use(workers.front().parts());
            workers.pop_front();
            continue;
        }
        std::vector<pollfd> awaited;
        for (const Worker& worker : workers) awaited.push_back(worker.awaited());
        if (poll(awaited.data(), awaited.size(), -1) < 0) continue;
        for (std::size_t i = 0; i < workers.size(); ++i) {
            if (awaited[i].revents != 0) workers[i].read_on();
        }
    }
}

}  // namespace vidno::cli
