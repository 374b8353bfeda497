/// The commands of the program, each in a file with its name.
///
/// `add_...` adds a command with its options. If the command line names it, it runs and sets the exit status: 0 done, 1
/// done and something was found. It throws Refused for input that it does not take.
#pragma once

#include <CLI/CLI.hpp>
#include <span>

namespace vidno::cli {

void add_trace(CLI::App& program, int& status);
void add_render(CLI::App& program, int& status);
void add_check(CLI::App& program, int& status);
void add_find(CLI::App& program, int& status);
void add_shrink(CLI::App& program, int& status);
void add_need(CLI::App& program, int& status);
void add_choose(CLI::App& program, int& status);
void add_map(CLI::App& program, int& status);
void add_margin(CLI::App& program, int& status);
void add_prove(CLI::App& program, int& status);
void add_why(CLI::App& program, int& status);
void add_chart(CLI::App& program, int& status);
void add_replay(CLI::App& program, int& status);
void add_say(CLI::App& program, int& status);
void add_figure(CLI::App& program, int& status);
void add_diff(CLI::App& program, int& status);
void add_page(CLI::App& program, int& status);
void add_lesson(CLI::App& program, int& status);
void add_grade(CLI::App& program, int& status);
void add_homework(CLI::App& program, int& status);
void add_worksheet(CLI::App& program, int& status);
void add_import(CLI::App& program, int& status);
void add_stability(CLI::App& program, int& status);
void add_methods(CLI::App& program, int& status);
void add_describe(CLI::App& program, int& status);

/// The commands of this program, in the order of the help. commands.cpp lists all; node/commands.cpp lists those of
/// `npx vidno`.
extern const std::span<void (*const)(CLI::App& program, int& status)> commands;

}  // namespace vidno::cli
