#include "cli/commands.h"

#include <array>

namespace vidno::cli {

namespace {

/// Those that need neither threads nor other programs.
constexpr std::array all{add_trace, add_check,  add_need, add_map,    add_replay,
                         add_say,   add_figure, add_diff, add_methods};

}  // namespace

const std::span<void (*const)(CLI::App& program, int& status)> commands = all;

}  // namespace vidno::cli
