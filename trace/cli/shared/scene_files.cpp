#include "cli/shared/scene_files.h"

#include <iostream>

#include "choice/method.h"
#include "cli/shared/progress.h"
#include "output.h"
#include "scene/scene_json.h"
#include "scene/snapped_scene.h"

namespace vidno::cli {

Scene scene_of(std::string_view text, const std::string& file) {
    Progress progress;
    progress.say("reading " + file);
    try {
        auto [scene, warnings] = read_scene(text, file);
        progress.clear();
        for (const auto& warning : warnings) std::cerr << warning << '\n';
        return scene;
    } catch (const Refused&) {
        if (!is_surface(text)) throw;
        throw Refused(file + ": a surface, and this command takes scenes of polygons, vidno-scene/1");
    }
}

Scene scene_from(const std::string& file) { return scene_of(read_file(file), file); }

AnyScene any_scene_from(const std::string& file, const std::optional<std::string>& method) {
    const std::string text = read_file(file);
    if (is_surface(text)) {
        if (method && *method != floating_horizon_method) {
            throw Refused(file + ": a surface, which only --method " + std::string(floating_horizon_method) + " draws");
        }
        return read_surface(text, file);
    }
    if (method == floating_horizon_method)
        throw Refused("--method " + *method + ": " + file + " is no surface, vidno-surface/1");
    return scene_of(text, file);
}

Scene scene_for(const NamedKernel& kernel, Scene scene, const std::string& file) {
    if (!kernel.snaps()) return scene;
    try {
        SnappedScene snapped = snapped_scene(scene, kernel.parameter);
        const std::string change = snapped.change();
        if (!change.empty()) std::cerr << file << ": " << kernel.name() << ' ' << change << '\n';
        return std::move(snapped.scene);
    } catch (const Refused& refused) {
        throw Refused(file + ": " + refused.what());
    }
}

}  // namespace vidno::cli
