/// The program vidno.

#include <csignal>
#include <iostream>
#include <new>
#include <string>
#include <string_view>

#include "characters.h"
#include "cli/commands.h"
#include "output.h"

namespace {

/// Whether a command was given in full: `lesson`, for example, needs a subcommand.
bool names_command(const CLI::App& app) {
    const auto named = app.get_subcommands();
    if (!named.empty()) return names_command(*named.front());
    return app.get_subcommands([](const CLI::App* each) { return !each->get_name().empty(); }).empty();
}

/// Help is printed in CLI11's form; every error is one line and status 2.
int refuse(const CLI::App& app, const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    std::cerr << "vidno: " << vidno::escaped_for_terminal(error.what()) << " (vidno --help)\n";
    return 2;
}

/// An empty argument is nearly always an unset variable of a shell. CLI11 would take it for a missing one, or never
/// end.
void expect_no_empty(int argc, char** argv) {
    for (int i = 1; i < argc; ++i) {
        const std::string_view argument = argv[i];
        if (!argument.empty() && !(argument.starts_with("--") && argument.ends_with('='))) continue;
        throw vidno::Refused("argument " + std::to_string(i) + " is empty" +
                             (i > 1 ? ", after " + std::string(argv[i - 1]) : ""));
    }
}

/// Runs the command that the arguments name, or prints help. Returns the exit status.
int parsed(CLI::App& program, const int& status, int argc, char** argv) {
    try {
        program.parse(argc, argv);
        if (!names_command(program)) throw CLI::RequiredError::Subcommand(1);
        return status;
    } catch (const CLI::ParseError& error) {
        return refuse(program, error);
    }
}

int run(CLI::App& program, const int& status, int argc, char** argv) {
    try {
        expect_no_empty(argc, argv);
        const int ended = parsed(program, status, argc, argv);
        vidno::flush_standard_output();
        return ended;
    } catch (const vidno::OutputLost& lost) {
        std::cerr << "vidno: " << lost.what() << '\n';
        return 1;
    } catch (const vidno::Refused& refused) {
        std::cerr << "vidno: " << vidno::escaped_for_terminal(refused.what(), "\n") << '\n';
    } catch (const std::bad_alloc&) {
        std::cerr << "vidno: not enough memory\n";
    }
    return 2;
}

/// If a signal stops the program, it leaves no partial file behind and ends by this signal.
void stop(int signal) {
    vidno::remove_unfinished_files();
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

/// The signals that end a program that does not handle them, except SIGKILL, which nobody can handle.
constexpr int ending_signals[]{SIGHUP,    SIGINT,  SIGQUIT, SIGILL,  SIGTRAP, SIGABRT, SIGBUS,
                               SIGFPE,    SIGUSR1, SIGSEGV, SIGUSR2, SIGPIPE, SIGALRM, SIGTERM,
                               SIGVTALRM, SIGPROF, SIGXCPU, SIGXFSZ, SIGSYS};

/// `nohup` ignores some signals, and a sanitizer reports others; these are left alone.
void stop_at(int signal) {
    if (const auto before = std::signal(signal, stop); before != SIG_DFL) std::signal(signal, before);
}

}  // namespace

int main(int argc, char** argv) {
    for (const int signal : ending_signals) stop_at(signal);
    CLI::App program{"vidno runs the textbook hidden-surface procedures one small step at a time.", "vidno"};
    program.require_subcommand(0, 1);  // one; 0 so that a wrong name is reported before a missing one
    program.set_version_flag("--version", "vidno " VIDNO_VERSION);
    program.get_formatter()->column_width(28);
    program.footer("See vidno COMMAND --help. Exit status: 0 done; 1 done, and something was found; 2 refused.");
    int status = 0;
    for (const auto& add : vidno::cli::commands) add(program, status);

    return run(program, status, argc, argv);
}
