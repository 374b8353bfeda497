#include "import/import.h"

#include <iostream>

#include "cli/commands.h"
#include "cli/shared/losses.h"
#include "cli/shared/progress.h"
#include "import/mesh_soup.h"
#include "output.h"
#include "scene/scene_json.h"

namespace vidno::cli {

namespace {

struct ImportedMesh {
    std::string mesh, output;
    ImportOptions import;
};

/// The option's three numbers, x y z, become a vector of the camera; naming any of them makes a camera.
void add_vector(CLI::App& command, ImportOptions& import, const std::string& name, glm::dvec3 Camera::*target,
                const std::string& help) {
    const auto set = [&import, target](const std::vector<double>& xyz) {
        if (!import.camera) import.camera.emplace();
        *import.camera.*target = {xyz[0], xyz[1], xyz[2]};
    };
    command.add_option_function<std::vector<double>>(name, set, help)->expected(3)->type_name("X Y Z");
}

void add_length(CLI::App& command, ImportOptions& import, const std::string& name, double Camera::*target,
                const std::string& help) {
    const auto set = [&import, target](double value) {
        if (!import.camera) import.camera.emplace();
        *import.camera.*target = value;
        if (target == &Camera::height) import.camera->projection = Projection::orthographic;
    };
    command.add_option_function<double>(name, set, help);
}

/// The options that place the camera.
void add_camera_options(CLI::App& command, ImportOptions& import) {
    command.add_option("--width", import.width, "The width of the picture, in pixels")
        ->check(CLI::Range(1, largest_side))
        ->capture_default_str();
    command.add_option("--height", import.height, "The height of the picture, in pixels")
        ->check(CLI::Range(1, largest_side))
        ->capture_default_str();
    auto& camera =
        *command.add_option_group("Camera", "Without --eye the camera sees the whole mesh, a little from above");
    add_vector(camera, import, "--eye", &Camera::eye, "The position of the camera");
    add_vector(camera, import, "--target", &Camera::target, "The point at which it looks [0 0 0]");
    add_vector(camera, import, "--up", &Camera::up, "The upward direction [0 1 0]");
    add_length(camera, import, "--fov", &Camera::field_of_view, "Perspective: the vertical angle in degrees [45]");
    add_length(camera, import, "--ortho", &Camera::height, "Parallel projection instead: the visible height");
    add_length(camera, import, "--near", &Camera::near_distance, "Cut off everything nearer [0.1]");
    add_length(camera, import, "--far", &Camera::far_distance, "Cut off everything farther [100]");
    for (auto* option : camera.get_options()) {
        if (option->get_name() != "--eye") option->needs("--eye");
    }
}

int import_scene(const ImportedMesh& options) {
    Progress progress;
    progress.say("reading " + options.mesh);
    const auto [scene, report, losses] = import_mesh_file(options.mesh, options.import);
    progress.clear();
    std::cerr << report << '\n';
    OutputFile file(options.output);
    file.write(scene_json(scene) + "\n");
    file.commit();
    Losses lost;
    lost.add(options.mesh, losses);
    return lost.report();
}

}  // namespace

void add_import(CLI::App& program, int& status) {
    auto& command = *program.add_subcommand("import", "Make a scene from a mesh as a camera sees it");
    const auto options = std::make_shared<ImportedMesh>();
    command.add_option("MESH", options->mesh, "A mesh: " + mesh_endings())->required();
    add_camera_options(command, options->import);
    command.add_option("-o", options->output, "The scene, .json; - for standard output")->required();
    command.footer(
        "Faces that are not planar and convex are cut into polygons that are. What the scene lacks, such as dropped "
        "faces, "
        "textures and lines, is reported with its line; the exit status is then 1.");
    command.callback([options, &status] { status = import_scene(*options); });
}

}  // namespace vidno::cli
