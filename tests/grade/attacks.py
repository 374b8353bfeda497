"""Grades the program hostile.cpp, as root and as an ordinary user, in the sandbox and without one, and looks for what remains of it.

attacks.py VIDNO HOSTILE: prints what each attack reached. Root runs everything twice, once as `nobody`.
"""
import concurrent.futures
import itertools
import json
import os
import pathlib
import re
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time

MEMORY, WRITTEN, PROCESSES, SECONDS = 128, 2, 8, 2
LIMITS = ["--memory", MEMORY, "--written", WRITTEN, "--processes", PROCESSES]

HELD = r"\| held"
TOO_LONG = rf"The program did not end within {SECONDS} s"
TOO_LARGE = rf"The program asked for more than {MEMORY} MiB of memory"
TOO_MUCH = rf"The program wrote more than {WRITTEN} MiB"
TOO_MANY = rf"The program ran more than {PROCESSES} processes at once"
NO_TRACE = r"Not judged: no trace was written"

# What is not guaranteed without the sandbox.
FILES, PLACES, BYTES = "which files it reads", "where it writes", "how much it writes in all"
RIGHTS, OTHERS = "that it has no rights of yours", "that it reaches no network and no other process"
KERNEL, COUNT = "that it takes no memory of the system besides", "how many processes it runs"
NOT_GUARANTEED = [FILES, PLACES, BYTES, "that no file of it remains", RIGHTS, OTHERS, COUNT, KERNEL]


def most(limit, words):
    """The report must say that the program reached no more than this."""
    return lambda report: any(int(number) <= limit for number in re.findall(rf"\| reached: {words}: (\d+)", report))


def few_processes(report):
    """A control group refuses more of them. Without one, the run is stopped."""
    return re.search(TOO_MANY, report) if COUNT in report else most(PROCESSES, "(?:processes|threads)")(report)


# An attack, what the report says of it in the sandbox, and what it says without: a word that is missing then, or another report.
ATTACKS = [
    *[(f"read {what}", HELD, FILES) for what in [
        "the users", "the passwords", "root's home", "the homes", "another program's file", "through the first process",
        "the kernel's memory", "the devices", "a disk", "a terminal", "the environment"]],
    ("read inherited files", HELD, HELD),
    *[(f"write {what}", HELD, PLACES) for what in [
        "core_pattern", "drop_caches", "panic", "sysrq-trigger", "a program", "the scene", "into the root"]],
    *[(what, HELD, RIGHTS) for what in [
        "become root", "have capabilities", "change the root", "make a user namespace", "make a mount namespace",
        "make a device", "make a set-user-ID program"]],
    *[(what, HELD, OTHERS) for what in [
        "signal other processes", "see other processes", "reach the loopback address", "open a local socket",
        "open a socket of the machine"]],
    *[(f"memory of {what}", HELD, KERNEL) for what in ["a segment", "a nameless file", "a socket pair", "a queue"]],
    ("memory of one process", most(MEMORY, "MiB"), most(MEMORY, "MiB")),
    ("memory of children", TOO_LARGE, TOO_LARGE),
    ("shared memory of children", TOO_LARGE, TOO_LARGE),
    ("fill its folder", TOO_MUCH, TOO_MUCH),
    ("fill /tmp", TOO_MUCH, BYTES),
    ("fill /dev/shm", TOO_MUCH, BYTES),
    ("fill with removed files", TOO_MUCH, BYTES),
    ("make many files", TOO_MUCH, BYTES),
    ("write one large file", TOO_MUCH, TOO_MUCH),
    ("print much", TOO_MUCH, TOO_MUCH),
    ("start processes", most(PROCESSES, "processes"), few_processes),
    ("start threads", most(PROCESSES, "threads"), few_processes),
    ("open many files", most(256, "open files"), most(256, "open files")),
    *[(what, TOO_LONG, TOO_LONG) for what in [
        "run long", "run long in children", "run long one child after another", "run on after the signal", "sleep"]],
    *[(f"leave a {what}", HELD, HELD) for what in [
        "process", "process with its output closed", "process that ignores signals", "stopped process"]],
    ("shut a folder", HELD, HELD),
    ("make a deep folder", HELD, HELD),
    ("kill its group", r"crashed \(Killed\)", r"crashed \(Killed\)"),
    *[(f"trace: {kind}", NO_TRACE, NO_TRACE) for kind in ["a pipe", "a link", "a loop", "a folder", "a socket"]],
    ("trace: not to be read", HELD, HELD),
    ("print escapes", r"\| \\x1b\]0;title\\x07\\x1b\[2J\\u009b\\xff\\u202e\n", r"\| \\x1b\]0;title"),
    *[(f"end by {int(each)}", r"The program crashed \(", r"The program crashed \(") for each in [
        signal.SIGHUP, signal.SIGINT, signal.SIGQUIT, signal.SIGTERM, signal.SIGKILL, signal.SIGSEGV, signal.SIGABRT,
        signal.SIGFPE, signal.SIGBUS, signal.SIGPIPE, signal.SIGUSR1]],
]
if os.uname().machine == "x86_64":
    ATTACKS.append(("calls of another table", r"The program crashed \(Bad system call\)", KERNEL))

SIGNALS = [signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT, signal.SIGKILL]  # to `vidno grade`

PLACE = pathlib.Path(tempfile.mkdtemp(prefix="vidno-attacks-"))
failures = []


def check(holds, *words):
    if not holds:
        failures.append(": ".join(words))
        print("FAILED", *words, sep=": ")


class Grader:
    """One attack's grader, with its own name for the hostile processes and its own folder for temporary files."""
    numbers = itertools.count()

    def __init__(self, user, sandbox):
        self.user, self.sandbox = user, sandbox
        self.name = f"v{os.getpid()}-{next(self.numbers)}"
        self.temporary = PLACE / self.name
        self.temporary.mkdir()
        if user:
            os.chown(self.temporary, user, user)

    def command(self, *words):
        path = os.environ["PATH"] if self.sandbox else str(PLACE / "empty")
        environment = {"PATH": path, "TMPDIR": str(self.temporary), "VIDNO_ATTACKS_SECRET": "1"}
        identity = {"user": self.user, "group": self.user, "extra_groups": []} if self.user else {}
        words = [PLACE / "vidno", "grade", *map(str, words)]
        return dict(args=words, cwd=PLACE, env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                    stderr=subprocess.STDOUT, **identity)

    def grade(self, *words):
        done = subprocess.run(timeout=60, check=False, **self.command(*words))
        return done.returncode, done.stdout

    def attack(self, name, seconds):
        return self.grade(PLACE / "hostile", "--scenes", self.scene(name), *LIMITS, "--seconds", seconds)[1].decode()

    def scene(self, attack):
        scene = {"name": f"{attack}@{self.name}", "window": {"x": 0, "y": 0, "width": 2, "height": 2},
                 "polygons": [{"id": "A", "vertices": [[0, 0, 0], [2, 0, 0], [0, 2, 0]]}]}
        file = PLACE / f"{self.name}.json"
        file.write_text(json.dumps(scene))
        return file

    def alive(self):
        """How many hostile processes there are."""
        count = 0
        for process in filter(str.isdigit, os.listdir("/proc")):
            try:
                count += pathlib.Path("/proc", process, "comm").read_bytes().strip() == self.name.encode()
            except OSError:  # it has just ended
                pass
        return count

    def check_nothing_remains(self, *words):
        check(within(5, lambda: self.alive() == 0), str(self), *words, "a process survives")
        check(within(5, lambda: not list(self.temporary.iterdir())), str(self), *words, "a file remains")

    def __str__(self):
        return ("as nobody" if self.user else "as root" if os.geteuid() == 0 else "as this user") + \
            (", in the sandbox" if self.sandbox else ", without a sandbox")


def within(seconds, condition):
    end = time.monotonic() + seconds
    while not condition() and time.monotonic() < end:
        time.sleep(0.01)
    return condition()


def left_groups():
    """The control groups whose keepers have ended. Other tests have theirs at the same time."""
    return [f"{folder}/{name}" for folder, names, _ in os.walk("/sys/fs/cgroup") for name in names
            if name.startswith("vidno-") and not pathlib.Path("/proc", name.split("-")[1]).exists()]


def try_attack(user, sandbox, name, inside, outside):
    """Returns what the attack reached."""
    grader = Grader(user, sandbox)
    expected = inside if sandbox else outside
    # On a busy machine an attack needs seconds to reach another limit.
    report = grader.attack(name, SECONDS if expected == TOO_LONG else 20)
    if expected in NOT_GUARANTEED:
        check(expected in report.split("Not guaranteed here: ")[-1].split("\n")[0], str(grader), name, report)
    else:
        found = expected(report) if callable(expected) else re.search(expected, report)
        check(found, str(grader), name, report)
    check(("Not guaranteed here" in report) != sandbox, str(grader), name, report)
    if expected == BYTES:
        shutil.rmtree(grader.temporary)
        grader.temporary.mkdir()
    grader.check_nothing_remains(name)
    what = re.search(r"\| (held|reached: .*)", report), re.search(r"  The program (.*)\.\n", report)
    return name + ": " + "; ".join(each.group(1) for each in what if each)


def interrupt(user, sandbox, number):
    grader = Grader(user, sandbox)
    command = grader.command(PLACE / "hostile", "--scenes", grader.scene("leave and wait"), "--seconds", "30")
    with subprocess.Popen(**command) as started:
        check(within(10, lambda: grader.alive() >= 2), str(grader), "the attack does not begin")
        started.send_signal(number)
        check(started.wait(timeout=10) == -number, str(grader), f"another end than by {number}")
    grader.check_nothing_remains(f"grade ended by {number}")
    return f"grade ended by {number}: nothing remains"


def grade_folder(user, sandbox):
    """Only regular files are graded, and names are printed so that they cannot control the terminal."""
    grader = Grader(user, sandbox)
    folder = grader.temporary / "homework"
    folder.mkdir()
    raw = [b"esc\x1b]0;title\x07", b"new\nline: right", b"invalid\xff", "direction\u202e".encode(), b"c1\xc2\x9b"]
    for name in [b"plain", b"=1+1", *raw]:
        shutil.copy(PLACE / "hostile", os.fsencode(folder) + b"/" + name)
    os.mkfifo(folder / "pipe", 0o777)
    (folder / "link").symlink_to("plain")
    (folder / "loop").symlink_to(".")
    if os.geteuid() == 0:
        os.mknod(folder / "device", 0o20777, os.makedev(1, 3))
    with socket.socket(socket.AF_UNIX) as listener:
        listener.bind(str(folder / "socket"))
    (grader.temporary / "table").mkdir()
    os.mkfifo(grader.temporary / "table" / "plain.txt")  # in the place of a report
    for each in [folder, *folder.iterdir(), grader.temporary / "table"]:
        if grader.user:
            os.chown(each, grader.user, grader.user, follow_symlinks=False)
    arguments = [folder, "--scenes", grader.scene("read the users"), "-o", grader.temporary / "table.csv"]
    status, report = grader.grade(*arguments)
    check(status == 2 and b"plain.txt: not a regular file" in report, str(grader), "a pipe as a report", str(report))
    (grader.temporary / "table" / "plain.txt").unlink()
    status, report = grader.grade(*arguments)
    for shown in [rb"plain: wrong on 1 of 1", rb"esc\x1b]0;title\x07: wrong", rb"new\nline: right: wrong",
                  rb"invalid\xff: wrong", rb"direction\u202e: wrong", rb"c1\u009b: wrong", b"pipe: a pipe: only regular",
                  b"link: a symbolic link: only regular", b"loop: a symbolic link: only regular",
                  b"socket: a socket: only regular", *([b"device: a device: only regular"] if os.geteuid() == 0 else [])]:
        check(shown in report, str(grader), "folder", str(shown), str(report))
    table = (grader.temporary / "table.csv").read_bytes()
    check(b'"\'=1+1"' in table, str(grader), "a formula in the table", str(table))
    for text in [report, table]:
        check(not re.search(rb"[\x00-\x08\x0b-\x1f\x7f\xff]|\xc2[\x80-\x9f]|\xe2\x80\xae|new\nline", text), str(grader),
              "raw bytes", str(text))
    for file in [folder / "pipe", folder / "none\x1b"]:
        status, report = grader.grade(file)
        check(status == 2 and b"\x1b" not in report, str(grader), str(report))
    shutil.rmtree(folder)
    shutil.rmtree(grader.temporary / "table")
    (grader.temporary / "table.csv").unlink()
    grader.check_nothing_remains("folder")
    return "folder: only regular files are graded"


def main():
    vidno, hostile = sys.argv[1:]
    secret = pathlib.Path("/tmp/vidno-attacks-secret")
    try:
        PLACE.chmod(0o755)
        (PLACE / "empty").mkdir()
        shutil.copy(vidno, PLACE / "vidno")
        shutil.copy(hostile, PLACE / "hostile")
        secret.write_text("secret")
        for user, sandbox in itertools.product([0, 65534] if os.geteuid() == 0 else [0], [True, False]):
            grader = Grader(user, sandbox)
            print(grader)
            if sandbox and "No sandbox: " in grader.attack("read the users", SECONDS):
                print("  cannot be created here")
                continue
            begin = time.monotonic()
            # Most attacks wait for the grader to stop them.
            with concurrent.futures.ThreadPoolExecutor(8) as pool:
                tried = [pool.submit(try_attack, user, sandbox, *each) for each in ATTACKS]
                tried += [pool.submit(interrupt, user, sandbox, number) for number in SIGNALS]
                tried.append(pool.submit(grade_folder, user, sandbox))
            for each in tried:
                print("  " + each.result())
            print(f"  {time.monotonic() - begin:.1f} s")
        check(within(5, lambda: not left_groups()), "a control group remains", *left_groups())
    finally:
        secret.unlink(missing_ok=True)
        shutil.rmtree(PLACE)
    print(f"{len(failures)} failures, {len(ATTACKS)} attacks")
    return 1 if failures else 0


sys.exit(main())
