// A hostile program. The scene's name is "ATTACK@NAME": which attack to try, and how its processes are called. It
// prints "held", or "reached: " and what.
//
// It does no harm where nothing contains it. It opens forbidden places and writes nothing there, sends signals only to
// its own processes, asks for little more than limits that the test lowers, and all that it starts ends within a
// minute.
#include <dirent.h>
#include <fcntl.h>
#include <linux/capability.h>
#include <netinet/in.h>
#include <sched.h>
#include <signal.h>
#include <sys/ipc.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/shm.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <string>
#include <thread>
#include <vector>

using std::string;
using std::to_string;

const string held;
const std::size_t mebibyte = std::size_t(1) << 20;

string opens(const char* file, int flags) {
    const int number = open(file, flags | O_NONBLOCK | O_CLOEXEC);
    return number < 0 ? held : file;
}
string reads(const char* file) { return opens(file, O_RDONLY); }
string may_write(const char* file) { return opens(file, O_WRONLY); }

string trace_file() { return std::getenv("VIDNO_TRACE"); }
string own_folder() { return trace_file().substr(0, trace_file().rfind('/')); }

/// The names in a folder that satisfy the condition.
std::vector<string> names_in(const string& folder, bool (*wanted)(const string&)) {
    std::vector<string> names;
    DIR* const opened = opendir(folder.c_str());
    while (const dirent* each = opened ? readdir(opened) : nullptr) {
        if (each->d_name[0] != '.' && wanted(folder + "/" + each->d_name)) names.push_back(each->d_name);
    }
    return names;
}

bool is_any(const string&) { return true; }
bool is_block_device(const string& name) {
    struct stat about {};
    return stat(name.c_str(), &about) == 0 && S_ISBLK(about.st_mode);
}

/// The result of a system call that must be refused.
string refused(long result, const char* what) { return result < 0 ? held : what; }

void use(std::size_t bytes, int flags) {
    void* const place = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_ANONYMOUS | flags, -1, 0);
    if (place != MAP_FAILED) std::memset(place, 1, bytes);
}

/// Writes files of a MiB into a folder, and keeps them open. Returns how many MiB it wrote.
int fill(const string& folder, bool removes) {
    const std::vector<char> block(mebibyte, 'x');
    for (int i = 0; i < 20; ++i) {
        const string name = folder + "/" + to_string(i);
        const int file = open(name.c_str(), O_CREAT | O_WRONLY, 0600);
        if (file < 0 || write(file, block.data(), block.size()) < long(block.size())) return i;
        if (removes) unlink(name.c_str());
    }
    return 20;
}
string filled(const string& folder, bool removes) {
    const int written = fill(folder, removes);
    usleep(300000);
    return "MiB written: " + to_string(written);
}

/// Starts processes that do something and then sleep. Returns how many it could start.
int start(int count, const std::function<void()>& what) {
    for (int i = 0; i < count; ++i) {
        const pid_t child = fork();
        if (child < 0) return i;
        if (child > 0) continue;
        what();
        sleep(20);
        _exit(0);
    }
    return count;
}

/// Starts processes that do something, and gives the grader time to see what they use then.
string started(int count, const std::function<void()>& what) {
    int done[2];
    const bool can_wait = pipe(done) == 0;
    const int number = start(count, [&] {
        what();
        if (write(done[1], "", 1) != 1) _exit(1);
    });
    char end = 0;
    for (int i = 0; can_wait && i < number && read(done[0], &end, 1) == 1; ++i) {
    }
    usleep(500000);
    return "processes: " + to_string(number);
}

/// Leaves a process that the grader has to find.
string leaves(const std::function<void()>& what) {
    start(1, [&] {
        setsid();
        start(1, what);
        _exit(0);
    });
    usleep(100000);
    return held;
}

string runs(double seconds) {
    const clock_t end = clock() + clock_t(seconds * CLOCKS_PER_SEC);
    while (clock() < end) {
    }
    return "seconds: " + to_string(seconds);
}

string ends_by(int signal) {
    kill(getpid(), signal);
    return "its own end by a signal";
}

using Attack = std::function<string()>;

std::map<string, Attack> attacks() {
    std::map<string, Attack> all{
        // ways out: files
        {"read the users", [] { return reads("/etc/passwd"); }},
        {"read the passwords", [] { return reads("/etc/shadow"); }},
        {"read root's home", [] { return opens("/root", O_RDONLY | O_DIRECTORY); }},
        {"read the homes", [] { return opens("/home", O_RDONLY | O_DIRECTORY); }},
        {"read another program's file", [] { return reads("/tmp/vidno-attacks-secret"); }},
        {"read through the first process", [] { return reads("/proc/1/root/etc/passwd"); }},
        {"read the kernel's memory", [] { return reads("/proc/kcore") + reads("/dev/mem"); }},
        {"read the devices", [] { return opens("/sys", O_RDONLY | O_DIRECTORY); }},
        {"read a disk", [] { return names_in("/dev", is_block_device).empty() ? held : "a disk"; }},
        {"read a terminal", [] { return reads("/dev/tty"); }},
        {"read inherited files",
         [] {
             string found;
             for (const string& each : names_in("/proc/self/fd", is_any))
                 if (std::stoi(each) > 3) found += each + " ";  // the folder itself is 3
             return found;
         }},
        {"read the environment", [] { return std::getenv("VIDNO_ATTACKS_SECRET") ? "a variable" : held; }},
        {"write core_pattern", [] { return may_write("/proc/sys/kernel/core_pattern"); }},
        {"write drop_caches", [] { return may_write("/proc/sys/vm/drop_caches"); }},
        {"write panic", [] { return may_write("/proc/sys/kernel/panic"); }},
        {"write sysrq-trigger", [] { return may_write("/proc/sysrq-trigger"); }},
        {"write a program", [] { return may_write("/usr/bin/env"); }},
        {"write the scene", [] { return may_write(std::getenv("VIDNO_SCENE")); }},
        {"write into the root", [] { return refused(access("/", W_OK), "/"); }},
        // ways out: rights
        {"become root", [] { return refused(getuid() == 0 ? 0 : setuid(0), "root"); }},
        {"have capabilities",
         [] {
             __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
             __user_cap_data_struct data[2]{};
             syscall(SYS_capget, &header, data);
             return (data[0].permitted | data[1].permitted) == 0 ? held : "capabilities";
         }},
        {"change the root", [] { return refused(chroot("."), "another root"); }},
        {"make a user namespace", [] { return refused(unshare(CLONE_NEWUSER), "a namespace"); }},
        {"make a mount namespace", [] { return refused(unshare(CLONE_NEWNS), "a namespace"); }},
        {"make a device",
         [] { return refused(mknod((own_folder() + "/null").c_str(), S_IFCHR | 0600, 0x103), "a device"); }},
        {"make a set-user-ID program",
         [] {
             const string name = own_folder() + "/id";
             std::ofstream(name) << "x";
             struct stat about {};
             stat(name.c_str(), &about);
             chmod(name.c_str(), 04755);
             return about.st_uid == 0 ? "a file of root" : held;
         }},
        // ways out: processes and networks
        {"see other processes",
         [] {
             const auto is_process = [](const string& name) { return std::isdigit(name[name.rfind('/') + 1]) != 0; };
             const std::size_t count = names_in("/proc", is_process).size();
             return count <= 3 ? held : to_string(count) + " processes";
         }},
        {"signal other processes",
         [] {
             int reached = 0;
             for (int other = 3; other < 10000; ++other) reached += int(other != getpid() && kill(other, 0) == 0);
             return reached == 0 ? held : to_string(reached) + " processes";
         }},
        {"reach the loopback address",
         [] {
             const int number = socket(AF_INET, SOCK_DGRAM, 0);
             sockaddr_in address{};
             address.sin_family = AF_INET;
             address.sin_port = htons(9);
             address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
             return refused(connect(number, reinterpret_cast<const sockaddr*>(&address), sizeof address), "a network");
         }},
        {"open a local socket", [] { return refused(socket(AF_UNIX, SOCK_STREAM, 0), "a socket"); }},
        {"open a socket of the machine", [] { return refused(socket(AF_VSOCK, SOCK_STREAM, 0), "a socket"); }},
        // memory that belongs to no process
        {"memory of a segment",
         [] {
             const int segment = shmget(IPC_PRIVATE, 4096, 0600);
             if (segment >= 0) shmctl(segment, IPC_RMID, nullptr);
             return refused(segment, "a segment");
         }},
        {"memory of a nameless file", [] { return refused(syscall(SYS_memfd_create, "x", 0), "a file"); }},
        {"memory of a socket pair",
         [] {
             int both[2];
             return refused(socketpair(AF_UNIX, SOCK_STREAM, 0, both), "sockets");
         }},
        {"memory of a queue",
         [] { return refused(syscall(SYS_mq_open, "x", O_CREAT | O_RDWR, 0600, nullptr), "a queue"); }},
        {"calls of another table",
         [] {
             syscall(0x40000000 + 39);
             return string("an answer");
         }},
        // limits
        {"memory of one process",
         [] {
             int reached = 0;
             for (;
                  reached < 200 && mmap(nullptr, mebibyte, PROT_READ, MAP_ANONYMOUS | MAP_PRIVATE, -1, 0) != MAP_FAILED;
                  ++reached) {
             }
             return "MiB: " + to_string(reached);
         }},
        {"memory of children", [] { return started(4, [] { use(40 * mebibyte, MAP_PRIVATE); }); }},
        {"shared memory of children", [] { return started(4, [] { use(40 * mebibyte, MAP_SHARED); }); }},
        {"fill its folder", [] { return filled(own_folder(), false); }},
        {"fill /tmp", [] { return filled(std::getenv("TMPDIR") ? std::getenv("TMPDIR") : "/tmp/none", false); }},
        {"fill /dev/shm", [] { return filled(own_folder() == "/work" ? "/dev/shm" : own_folder(), false); }},
        {"fill with removed files", [] { return filled(own_folder(), true); }},
        {"make many files",
         [] {
             int reached = 0;
             for (; reached < 10000; ++reached) {
                 const int file = open((own_folder() + "/" + to_string(reached)).c_str(), O_CREAT | O_WRONLY, 0600);
                 if (file < 0) break;
                 close(file);
             }
             usleep(300000);
             return "files: " + to_string(reached);
         }},
        {"write one large file",
         [] {
             return to_string(truncate(trace_file().c_str(), 0) +
                              ftruncate(open(trace_file().c_str(), O_CREAT | O_WRONLY, 0600), 1 << 30));
         }},
        {"print much",
         [] {
             for (int i = 0; i < 5000; ++i) std::cout << string(1023, 'x') << '\n';
             std::cout.flush();
             return string("5000 KiB");
         }},
        {"start processes", [] { return started(30, [] {}); }},
        {"start threads",
         [] {
             int reached = 0;
             try {
                 for (; reached < 30; ++reached) std::thread([] { sleep(20); }).detach();
             } catch (const std::exception&) {
             }
             usleep(300000);
             return "threads: " + to_string(reached);
         }},
        {"open many files",
         [] {
             int reached = 0;
             while (reached < 2000 && open("/dev/null", O_RDONLY) >= 0) ++reached;
             return "open files: " + to_string(reached);
         }},
        {"run long", [] { return runs(20); }},
        {"run long in children",
         [] {
             start(3, [] { runs(20); });
             sleep(20);
             return string("20 s");
         }},
        {"run long one child after another",
         [] {
             for (int i = 0; i < 40; ++i) {
                 start(1, [] {
                     runs(0.3);
                     _exit(0);
                 });
                 wait(nullptr);
             }
             return string("12 s");
         }},
        {"run on after the signal",
         [] {
             signal(SIGXCPU, SIG_IGN);
             return runs(20);
         }},
        {"sleep", [] { return to_string(sleep(20)); }},
        // what remains
        {"leave a process", [] { return leaves([] {}); }},
        {"leave a process with its output closed",
         [] {
             return leaves([] {
                 for (int i = 0; i < 3; ++i) close(i);
             });
         }},
        {"leave a process that ignores signals",
         [] {
             return leaves([] {
                 for (int i = 1; i < 65; ++i) signal(i, SIG_IGN);
                 prctl(PR_SET_PDEATHSIG, 0);
             });
         }},
        {"leave a stopped process", [] { return leaves([] { kill(getpid(), SIGSTOP); }); }},
        {"leave and wait",
         [] { return leaves([] {}) + to_string(mkdir((own_folder() + "/shut").c_str(), 0)) + to_string(sleep(20)); }},
        {"shut a folder",
         [] {
             const string inner = own_folder() + "/shut/inner";
             mkdir((own_folder() + "/shut").c_str(), 0700);
             mkdir(inner.c_str(), 0700);
             std::ofstream(inner + "/file") << "x";
             chmod(inner.c_str(), 0);
             chmod((own_folder() + "/shut").c_str(), 0);
             chmod(own_folder().c_str(), 0);
             return held;
         }},
        {"make a deep folder",
         [] {
             // The whole path is longer than the system accepts.
             const string name(100, 'd');
             for (int depth = 0; depth < 100; ++depth) {
                 if (mkdir(name.c_str(), 0700) != 0 || chdir(name.c_str()) != 0) break;
             }
             return held;
         }},
        {"kill its group", [] { return to_string(kill(0, SIGKILL)); }},
        // a trace of every kind
        {"trace: a pipe", [] { return mkfifo(trace_file().c_str(), 0600) == 0 ? held : "no pipe"; }},
        {"trace: a link", [] { return symlink("/etc/passwd", trace_file().c_str()) == 0 ? held : "no link"; }},
        {"trace: a loop", [] { return symlink("trace.jsonl", trace_file().c_str()) == 0 ? held : "no link"; }},
        {"trace: a folder", [] { return mkdir(trace_file().c_str(), 0700) == 0 ? held : "no folder"; }},
        {"trace: a socket", [] { return mknod(trace_file().c_str(), S_IFSOCK | 0600, 0) == 0 ? held : "no socket"; }},
        {"trace: not to be read",
         [] { return close(open(trace_file().c_str(), O_CREAT | O_WRONLY, 0)) == 0 ? held : "no file"; }},
        {"print escapes",
         [] {
             std::cout << "\x1b]0;title\x07\x1b[2J\xc2\x9b\xff\xe2\x80\xae\n";
             return held;
         }},
    };
    for (const int signal :
         {SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGKILL, SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGPIPE, SIGUSR1})
        all["end by " + to_string(signal)] = [signal] { return ends_by(signal); };
    return all;
}

int main() {
    string name;
    std::getline(std::ifstream(std::getenv("VIDNO_SCENE")), name);
    const auto at = name.find('@');
    prctl(PR_SET_NAME, name.substr(at + 1).c_str());
    const auto all = attacks();
    const auto attack = all.find(name.substr(1, at - 1));
    if (attack == all.end()) return 4;
    const string reached = attack->second();
    std::cout << (reached.empty() ? "held" : "reached: " + reached) << std::endl;
    return 3;  // the grader prints what a program said if it failed
}
