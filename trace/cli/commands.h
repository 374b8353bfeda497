/// The commands of the program, one function each. They give the exit status (0 done, 1 done and something was found)
/// and throw Refused for what they do not take.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "import.h"
#include "run.h"

namespace CLI {
class App;
}

namespace vidno::cli {

struct RunOptions {
    std::string scene, output;
    std::string method = "warnock", kernel = "double", edition = "corrected", detail = "signs";
    std::uint64_t most_events = TraceWriter::no_limit;
};

struct ReplayOptions {
    std::string trace, output;
    std::optional<std::uint64_t> step;
};

struct DiffOptions {
    std::string first, second;
};

struct MeshOptions {
    std::string mesh, output;
    ImportOptions import;
};

/// The options of `import` that say who looks at the mesh from where.
void add_camera_options(CLI::App& command, ImportOptions& import);

int trace(const RunOptions& options);
int render(const RunOptions& options);
int replay(const ReplayOptions& options);
int diff(const DiffOptions& options);
int import(const MeshOptions& options);
int methods();

}  // namespace vidno::cli
