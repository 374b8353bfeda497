#include "grade/sandbox.h"

#include <fcntl.h>
#include <grp.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <filesystem>

#include "refused.h"

namespace vidno {

namespace {

#if defined(__x86_64__)
constexpr unsigned architecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr unsigned architecture = AUDIT_ARCH_AARCH64;
#else
constexpr unsigned architecture = 0;
#endif

/// They take memory that belongs to no process, reach other machines, or are seldom needed and often at fault.
constexpr int refused_calls[] = {
    SYS_memfd_create, SYS_shmget,  SYS_semget,          SYS_msgget,     SYS_mq_open,       SYS_socket,
    SYS_socketpair,   SYS_bpf,     SYS_perf_event_open, SYS_add_key,    SYS_request_key,   SYS_keyctl,
    SYS_ptrace,       SYS_unshare, SYS_setns,           SYS_mount,      SYS_userfaultfd,   SYS_io_uring_setup,
    SYS_fsopen,       SYS_fsmount, SYS_open_tree,       SYS_move_mount, SYS_fanotify_init,
#ifdef SYS_memfd_secret
    SYS_memfd_secret,
#endif
};

/// A program of another architecture is ended: its calls have other numbers.
std::vector<sock_filter> call_filter() {
    const auto load = [](std::size_t offset) {
        return sock_filter BPF_STMT(BPF_LD | BPF_W | BPF_ABS, unsigned(offset));
    };
    const auto give = [](unsigned value) { return sock_filter BPF_STMT(BPF_RET | BPF_K, value); };
    std::vector<sock_filter> filter{load(offsetof(seccomp_data, arch)),
                                    BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, architecture, 1, 0),
                                    give(SECCOMP_RET_KILL_PROCESS), load(offsetof(seccomp_data, nr))};
#ifdef __x86_64__
    constexpr unsigned numbers_of_x32 = 0x40000000;
    filter.push_back(BPF_JUMP(BPF_JMP | BPF_JGE | BPF_K, numbers_of_x32, 0, 1));
    filter.push_back(give(SECCOMP_RET_KILL_PROCESS));
#endif
    for (const int call : refused_calls) {
        filter.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, unsigned(call), 0, 1));
        filter.push_back(give(SECCOMP_RET_ERRNO | EPERM));
    }
    filter.push_back(give(SECCOMP_RET_ALLOW));
    return filter;
}

/// Moves a descriptor out of the shell's way, to a number of two digits or more.
Descriptor moved_up(Descriptor from) {
    constexpr int two_digits = 10;
    return Descriptor(fcntl(from.number(), F_DUPFD_CLOEXEC, two_digits));
}

Descriptor file_holding(const void* bytes, std::size_t size) {
    Descriptor file(memfd_create("given", MFD_CLOEXEC));
    if (pwrite(file.number(), bytes, size, 0) != ssize_t(size)) throw Refused("a file in memory: " + system_reason());
    return moved_up(std::move(file));
}

Descriptor opened_program(const std::string& program) {
    // A pipe would wait for a writer.
    Descriptor file(open(program.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    struct stat about {};
    if (file.number() < 0 || fstat(file.number(), &about) != 0) throw Refused(program + ": " + system_reason());
    return moved_up(std::move(file));
}

}  // namespace

SandboxCommand sandbox_command(const std::string& bubblewrap, const std::string& program,
                               const std::vector<std::pair<std::string, std::string>>& variables,
                               const std::vector<FileInside>& files, std::uint64_t folder_size, int handshake) {
    SandboxCommand command;
    const auto add = [&](std::initializer_list<std::string> more) { command.words.insert(command.words.end(), more); };
    const auto inherited = [&](Descriptor file) {
        command.inherited.push_back(std::move(file));
        return std::to_string(command.inherited.back().number());
    };
    add({bubblewrap, "--unshare-user", "--disable-userns", "--uid", "65534", "--gid", "65534", "--unshare-pid"});
    add({"--unshare-ipc", "--unshare-net", "--unshare-uts", "--hostname", "sandbox", "--unshare-cgroup-try"});
    add({"--die-with-parent", "--new-session", "--cap-drop", "ALL"});
    if (can_refuse_calls()) {
        const auto filter = call_filter();
        add({"--seccomp", inherited(file_holding(filter.data(), filter.size() * sizeof filter[0]))});
    }
    // System folders that are symbolic links remain links inside.
    for (const std::string place : {"/usr", "/bin", "/sbin", "/lib", "/lib32", "/lib64", "/libx32"}) {
        if (std::filesystem::is_symlink(place)) {
            add({"--symlink", std::filesystem::read_symlink(place).string(), place});
        } else {
            add({"--ro-bind-try", place, place});
        }
    }
    for (const std::string file : {"/etc/ld.so.cache", "/etc/alternatives"}) add({"--ro-bind-try", file, file});
    for (const std::string device : {"/dev/null", "/dev/zero", "/dev/full", "/dev/random", "/dev/urandom"})
        add({"--dev-bind", device, device});
    add({"--symlink", "/proc/self/fd", "/dev/fd", "--proc", "/proc", "--remount-ro", "/proc"});
    add({"--perms", "0555", "--ro-bind-data", inherited(opened_program(program)), program_inside});
    for (const auto& [name, text] : files)
        add({"--perms", "0444", "--ro-bind-data", inherited(file_holding(text.data(), text.size())), name});
    // Everything that the program writes counts together, wherever it writes.
    add({"--size", std::to_string(folder_size), "--tmpfs", folder_inside, "--symlink", folder_inside, "/tmp"});
    add({"--symlink", folder_inside, "/dev/shm", "--remount-ro", "/", "--chdir", folder_inside, "--clearenv"});
    for (const auto& [name, value] : variables) add({"--setenv", name, value});
    const std::string end = std::to_string(handshake);
    add({"--", "/bin/sh", "-c",
         "echo >&" + end + "; read go <&" + end + " && exec " + program_inside + " " + end + ">&-"});
    return command;
}

bool leave_root_for(unsigned user) {
    return setgroups(0, nullptr) == 0 && setresgid(user, user, user) == 0 && setresuid(user, user, user) == 0;
}

bool leave_root() {
    // systemd's list of numbers has no use for those from 1879048192 on. A container may only have numbers up to 65534,
    // which is `nobody`.
    constexpr unsigned unused = 1879048192, nobody = 65534;
    return geteuid() != 0 || leave_root_for(unused + unsigned(getpid())) || leave_root_for(nobody);
}

bool can_refuse_calls() { return architecture != 0; }

}  // namespace vidno
