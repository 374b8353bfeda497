#include <iostream>

#include "cli/commands.h"
#include "cli/shared/polygon_scene.h"
#include "cli/shared/progress.h"
#include "cli/shared/run_options.h"
#include "output.h"
#include "picture/image.h"
#include "proof/proof.h"
#include "proof/why.h"
#include "refused.h"
#include "scene/scene_json.h"

namespace vidno::cli {

namespace {

struct ProveOptions : RunOptions {
    std::string picture;  // empty: the run's
    std::string output;
    std::string plain_scene;  // empty: not written
};

Picture picture_to_prove(const ProveOptions& options, const AdmittedScene& given) {
    if (!options.picture.empty()) {
        return decode_image(read_file(options.picture), given->area, options.picture);
    }
    const NamedKernel kernel = kernel_of(options);
    const AdmittedScene scene = scene_for(kernel, given, options.scene);
    expect_admitted(method_of(options), scene, options.scene);
    return run(request_of(options, kernel, scene));
}

/// Prints a wrong pixel, what must show there, and why the polygons in the picture's colour do not.
void print_wrong(int x, int y, const Color& shown, const AdmittedScene& scene, const Reasons& reasons) {
    const auto owner = reasons.owner(x, y);
    std::cout << "pixel " << x << "," << y << " is " << hex_of(shown) << ", but ";
    if (owner) {
        std::cout << sentence(reasons.at(x, y, *owner, owner), scene, Language::english);
    } else {
        std::cout << "no polygon shows";
    }
    for (int i = 0; i < int(scene->polygons.size()); ++i) {
        if (scene->polygons[std::size_t(i)].color != shown || i == owner) continue;
        std::cout << ". " << sentence(reasons.at(x, y, i, owner), scene, Language::english);
    }
    std::cout << '\n';
}

/// Prints the pixels where the picture is wrong. Returns whether there are any.
bool print_wrong(const Picture& picture, const Picture& right, const AdmittedScene& scene) {
    if (picture == right) return false;
    const Reasons reasons(scene);
    const Area& area = picture.area();
    for (int y = area.y; y < area.bottom(); ++y) {
        for (int x = area.x; x < area.right(); ++x) {
            if (picture.at(x, y) != right.at(x, y)) print_wrong(x, y, picture.at(x, y), scene, reasons);
        }
    }
    return true;
}

/// Says where the checkers find the scene as they read it.
void say_plain_scene(const ProveOptions& options, const AdmittedScene& scene) {
    if (!options.plain_scene.empty()) {
        write_file(options.plain_scene, scene_json(scene) + "\n");
    } else if (options.scene != "-" && !is_plain(read_text(options.scene), scene)) {
        std::cerr << options.scene
                  << ": the checkers do not read a scene with a camera, defaults or polygons that are cut; "
                  << "--scene FILE writes one that they read\n";
    }
}

int prove_picture(ProveOptions options) {
    const AdmittedScene scene = polygon_scene_for(options);
    const Picture picture = picture_to_prove(options, scene);
    Text proof;
    proof += proof_header;
    Progress progress("rectangles");
    const Picture right = prove(scene, [&, count = 0ULL](const ProvedRectangle& rectangle) mutable {
        append_rectangle(proof, rectangle);
        progress.show(++count);
    });
    progress.clear();
    // A wrong picture has no proof, so nothing is written before it is compared.
    if (print_wrong(picture, right, scene)) return 1;
    write_file(options.output, proof.view());
    say_plain_scene(options, scene);
    return 0;
}

}  // namespace

void add_prove(CLI::App& program, int& status) {
    auto& command = *program.add_subcommand("prove", "Prove that a picture is right, for anyone to check");
    const auto options = std::make_shared<ProveOptions>();
    add_run_options(
        command, *options,
        "A scene file, vidno-scene/1; or a failure, vidno-failure/1, whose failing run is the default; - for "
        "standard input",
        "The algorithm [warnock]", words(method_names));
    command.add_option("--picture", options->picture, "Prove this picture instead of the run's, .png or .ppm");
    command
        .add_option(
            "--scene", options->plain_scene,
            "Also write the scene as the checkers read it: convex polygons on the screen, without defaults, .json")
        ->type_name("FILE");
    command.add_option("-o", options->output, "The proof, .jsonl or .jsonl.gz; - for standard output")->required();
    command.footer(
        "The proof divides the picture into rectangles of pixels. For each it names the polygon that shows there, and "
        "for\n"
        "every other polygon the reason why it does not. The checkers in lessons/proof read it; this program does "
        "not.\n"
        "Example: vidno render scene.json -o picture.png && vidno prove scene.json --picture picture.png -o "
        "proof.jsonl &&\n"
        "         python3 verify.py scene.json picture.png proof.jsonl\n"
        "Exit status 1: the picture is wrong, so there is no proof; each wrong pixel has a line with the reason.");
    command.callback([options, &status] { status = prove_picture(*options); });
}

}  // namespace vidno::cli
