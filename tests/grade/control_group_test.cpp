#include <doctest/doctest.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstring>

#include "grade/control_group.h"

using vidno::ControlGroup;

namespace {

constexpr std::size_t mebibyte = std::size_t{1} << 20;

/// Does something in a process of the group. Returns its status, as waitpid has it.
int status_in(const ControlGroup& group, int (*action)()) {
    const pid_t child = fork();
    if (child == 0) _exit(group.join() ? action() : 127);
    int status = -1;
    waitpid(child, &status, 0);
    return status;
}

int write_to_64_mebibytes() {
    void* const place = mmap(nullptr, 64 * mebibyte, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (place == MAP_FAILED) return 1;
    std::memset(place, 1, 64 * mebibyte);
    return 0;
}

/// How many processes it can start, up to 10.
int start_processes() {
    int started = 0;
    pid_t children[10];
    for (pid_t& child : children) {
        child = fork();
        if (child == 0) pause();
        if (child < 0) break;
        ++started;
    }
    for (int i = 0; i < started; ++i) {
        kill(children[i], SIGKILL);
        waitpid(children[i], nullptr, 0);
    }
    return started;
}

}  // namespace

TEST_CASE("A control group ends a process that writes to more memory than the group has, and says so") {
    const ControlGroup group(32 * mebibyte, 10);
    if (!group.limits_memory()) {
        MESSAGE("skipped: the system lets this user limit no memory");
        return;
    }
    const int status = status_in(group, write_to_64_mebibytes);
    CHECK(WIFSIGNALED(status));
    CHECK(WTERMSIG(status) == SIGKILL);
    CHECK(group.ran_out_of_memory());
}

TEST_CASE("A control group does not hinder a process that stays within its memory") {
    const ControlGroup group(128 * mebibyte, 10);
    CHECK(status_in(group, write_to_64_mebibytes) == 0);
    CHECK_FALSE(group.ran_out_of_memory());
}

TEST_CASE("A control group of four processes lets one of them start three more") {
    const ControlGroup group(32 * mebibyte, 4);
    if (!group.limits_processes()) {
        MESSAGE("skipped: the system lets this user limit no processes");
        return;
    }
    CHECK(WEXITSTATUS(status_in(group, start_processes)) == 3);
}

TEST_CASE("A control group is gone with its object, so that the next one of this process can be made") {
    bool limited[2]{};
    for (bool& each : limited) {
        const ControlGroup group(32 * mebibyte, 4);
        each = group.limits_memory();
        CHECK(status_in(group, [] { return 0; }) == 0);
    }
    CHECK(limited[0] == limited[1]);
}
