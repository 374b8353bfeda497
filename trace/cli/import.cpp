#include "import/import.h"

#include <iostream>

#include "commands.h"
#include "output.h"
#include "progress.h"

namespace vidno::cli {

int import(const MeshOptions& options) {
    Progress progress;
    progress.say("reading " + options.mesh);
    const auto [scene, report] = import_mesh(read_file(options.mesh), options.mesh, options.import);
    progress.clear();
    for (const auto& line : report) std::cerr << line << '\n';
    OutputFile file(options.output);
    file.write(scene_json(scene) + "\n");
    file.commit();
    return 0;
}

}  // namespace vidno::cli
