#include "cli/commands.h"

#include <array>

namespace vidno::cli {

namespace {

constexpr std::array all{add_trace,  add_render,    add_check,   add_prove,   add_why,   add_find,     add_shrink,
                         add_need,   add_choose,    add_map,     add_margin,  add_chart, add_replay,   add_say,
                         add_figure, add_diff,      add_page,    add_lesson,  add_grade, add_homework, add_worksheet,
                         add_import, add_stability, add_methods, add_describe};

}  // namespace

const std::span<void (*const)(CLI::App& program, int& status)> commands = all;

}  // namespace vidno::cli
