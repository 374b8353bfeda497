#include "cli/shared/scene_files.h"

#include <algorithm>
#include <cctype>
#include <iostream>

#include "check/seen_failure.h"
#include "choice/method.h"
#include "cli/shared/progress.h"
#include "import/mesh_soup.h"
#include "json/json_node.h"
#include "output.h"
#include "scene/failure.h"
#include "scene/scene_json.h"
#include "scene/snapped_scene.h"

namespace vidno::cli {

namespace {

struct Read {
    AnyScene scene;
    std::optional<Failure> failure;
};

/// Says where the failure is seen when it is run as it fails.
void say_step(const Failure& failure, const std::string& file) {
    const SeenFailure found = seen(failure);
    std::cerr << file << ": " << (found.step ? "step " + std::to_string(*found.step) + ": " : "") << found.there.english
              << '\n';
}

/// On standard error, if there are any.
void say_gaps(const CurveScene& curves, const std::string& file) {
    const std::string gaps = gaps_in_words(curves);
    if (!gaps.empty()) std::cerr << file << ": " << gaps << '\n';
}

/// On standard error, with the warnings of its scene.
void describe(const Failure& failure, const std::string& file) {
    for (const auto& warning : failure.warnings) std::cerr << warning << '\n';
    say(failure, file);
}

Read read(std::string_view text, const std::string& file) {
    expect_no_mesh(file);
    if (is_surface(text)) {
        Surface surface = read_surface(text, file);
        say_gaps(surface.curves, file);
        return {std::move(surface), {}};
    }
    if (is_failure(text)) {
        Failure failure = read_failure(text, file);
        describe(failure, file);
        AnyScene scene = *failure.scene;
        return {std::move(scene), std::move(failure)};
    }
    Progress progress;
    progress.say("reading " + file);
    auto [scene, warnings] = read_scene(text, file);
    progress.clear();
    for (const auto& warning : warnings) std::cerr << warning << '\n';
    return {std::move(scene), {}};
}

/// Whether no option makes a failure run differently from how it fails.
bool are_of(const RunOptions& options, const NamedRun& run) {
    return options.method == run.method && options.kernel == run.kernel.name() && edition_of(options) == run.edition;
}

}  // namespace

void expect_no_mesh(const std::string& file) {
    std::string ending = file.substr(file.rfind('.') + 1);
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    const auto is_this = [&](const MeshFormat& format) { return format.ending == ending; };
    if (std::none_of(mesh_formats.begin(), mesh_formats.end(), is_this)) return;
    throw Refused(file + ": a mesh: make a scene of it first: vidno import " + file + " -o scene.json");
}

void say(const Failure& failure, const std::string& file) {
    std::cerr << file << ": " << failure.title.english << '\n'
              << file << ": remedy: " << failure.remedy.english << '\n';
    if (!failure.scene) throw Refused(file + ": no scene shows it: see the test \"" + failure.test + '"');
}

AdmittedScene scene_from(const std::string& file) {
    AnyScene any = any_scene_from(file);
    if (auto* scene = std::get_if<AdmittedScene>(&any)) return std::move(*scene);
    throw Refused(file + ": a surface, but this command takes scenes of polygons, vidno-scene/1");
}

AnyScene any_scene_from(const std::string& file) { return read(read_text(file), file).scene; }

AnyScene any_scene_for(RunOptions& options, bool says_step) {
    const std::string& file = options.scene;
    auto [scene, failure] = read(read_text(file), file);
    if (failure) {
        const NamedRun& run = failure->fails;
        if (!options.method) options.method = run.method;
        if (!options.kernel) options.kernel = run.kernel.name();
        if (!options.edition) options.edition = name_of(run.edition);
        if (says_step && are_of(options, run)) say_step(*failure, file);
    }
    const bool is_of_curves = std::holds_alternative<Surface>(scene);
    const std::string curves(floating_horizon_method);
    if (is_of_curves && options.method && *options.method != curves) {
        throw Refused(file + ": a surface, which only --method " + curves + " draws");
    }
    if (!is_of_curves && options.method == curves) {
        throw Refused("--method " + curves + ": " + file + " is not a surface, vidno-surface/1");
    }
    return std::move(scene);
}

std::variant<AdmittedScene, Function> charted_scene_from(const std::string& file) {
    const std::string text = read_text(file);
    if (is_surface(text)) {
        Function function = read_function(text, file);
        say_gaps(read_surface(text, file).curves, file);
        return function;
    }
    if (!is_failure(text)) return std::get<AdmittedScene>(read(text, file).scene);
    std::optional<Function> function;
    Failure failure = read_json(text, file, [&](const JsonNode& root) {
        Failure found = read_failure(root, file);
        if (found.scene && std::holds_alternative<Surface>(*found.scene)) function = read_function(root.at("scene"));
        return found;
    });
    describe(failure, file);
    if (function) return std::move(*function);
    return std::get<AdmittedScene>(std::move(*failure.scene));
}

AdmittedScene scene_for(const NamedKernel& kernel, AdmittedScene scene, const std::string& file) {
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
