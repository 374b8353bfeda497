#include "check/check.h"
#include "cli/commands.h"
#include "cli/shared/losses.h"
#include "cli/shared/progress.h"
#include "cli/shared/run_options.h"
#include "cli/shared/scene_files.h"
#include "figure/encoded.h"
#include "figure/floating_horizon_parts.h"
#include "figure/weiler_atherton_parts.h"
#include "output.h"
#include "picture/image.h"
#include "refused.h"
#include "regions/region_output.h"
#include "regions/scene_lines.h"

namespace vidno::cli {

namespace {

struct RenderOptions : RunOptions {
    std::string output;
    std::string lines;  // what becomes of hidden lines; empty: the picture has areas
};

std::string paced_by(Method method) {
    switch (algorithm_of(method)) {
        case Algorithm::warnock: return "windows";
        case Algorithm::z_buffer: return "polygons";
        case Algorithm::weiler_atherton: return "lists";
    }
    std::abort();
}

/// Visible regions are polygons: JSON, or a drawing.
bool is_of_regions(const RenderOptions& options) {
    const std::string& name = options.output;
    return method_of(options) == Method::weiler_atherton &&
           (name.ends_with(".json") || name.ends_with(".svg") || name.ends_with(".pdf") || name.ends_with(".tex"));
}

void expect_no_lines(const RenderOptions& options) {
    if (!options.lines.empty()) throw Refused("--lines: only for --method weiler-atherton, as .svg, .pdf or .tex");
}

figures::Drawing drawn(const std::vector<ShownRegion>& regions, const RunRequest& request, const std::string& lines) {
    if (lines.empty()) return figures::drawn_regions(regions, request.scene);
    const auto hidden = lines == "dashed" ? figures::HiddenLines::dashed : figures::HiddenLines::omitted;
    return figures::drawn_lines(scene_lines(regions, request.scene), hidden, request.scene);
}

std::string encoded_regions(RunRequest request, const RenderOptions& options) {
    std::vector<ShownRegion> regions;
    request.regions = &regions;
    run(request);
    if (options.output.ends_with(".json")) return regions_json(regions, request);
    return figures::encoded(drawn(regions, request, options.lines), {request.scene->name}, options.output);
}

std::string rendered(const RenderOptions& options, const AdmittedScene& given, Losses& losses) {
    const bool of_regions = is_of_regions(options);
    if (!of_regions || options.output.ends_with(".json")) expect_no_lines(options);
    if (!of_regions) encode_image(Picture({0, 0, 1, 1}, {}), options.output);  // refuses a wrong name before the work
    const NamedKernel kernel = kernel_of(options);
    const AdmittedScene scene = scene_for(kernel, given, options.scene);
    expect_admitted(method_of(options), scene, options.scene);
    RunRequest request = request_of(options, kernel, scene);
    Progress progress(paced_by(request.method));
    request.progress = [&, done = 0ULL]() mutable { progress.show(++done); };
    bool loses = false;
    request.loses = &loses;
    if (of_regions) {
        std::string regions = encoded_regions(request, options);
        progress.clear();
        if (loses) losses.add(options.scene, losses_of(request));
        return regions;
    }
    const Picture picture = run(request);
    progress.clear();
    if (loses) {
        const auto lost = losses_of(request);
        if (picture == right_picture(scene, request.method)) {
            losses.note(options.scene, lost, "every pixel is right nevertheless");
        } else {
            losses.add(options.scene, lost);
        }
    }
    return encode_image(picture, options.output);
}

std::string rendered(const RenderOptions& options, const Surface& surface, Losses& losses) {
    expect_no_lines(options);
    figures::format_of(options.output);  // refuses a wrong name before the work
    FloatingHorizonRequest request = request_of(options, surface);
    Progress progress("curves");
    request.progress = [&, done = 0ULL]() mutable { progress.show(++done); };
    const DrawnLines lines = run(request);
    progress.clear();
    const Area& area = surface.curves->area;
    losses.add(options.scene, losses_of(request, lines));
    losses.add(options.scene, figures::cut_curves(lines, figures::plane_without_frame(area)));
    return figures::encoded(figures::drawn_lines(lines, area), {surface.name}, options.output);
}

int render(RenderOptions options) {
    const AnyScene any = any_scene_for(options);
    Losses losses;
    OutputFile file(options.output);
    file.write(std::visit([&](const auto& scene) { return rendered(options, scene, losses); }, any));
    file.commit();
    return losses.report();
}

}  // namespace

void add_render(CLI::App& program, int& status) {
    auto& command = *program.add_subcommand("render", "Run a method and write only the picture");
    const auto options = std::make_shared<RenderOptions>();
    add_any_run_options(command, *options);
    command
        .add_option("-o", options->output,
                    "The picture, .png or .ppm; for a surface its lines, .svg, .pdf, .png or .tex; for weiler-atherton "
                    "also its regions, .json, .svg, .pdf or .tex; - writes PPM or SVG to standard output")
        ->required();
    command
        .add_option("--lines", options->lines,
                    "Only the outlines: visible lines solid, hidden lines dashed or omitted; for weiler-atherton, as "
                    ".svg, .pdf or .tex")
        ->check(CLI::IsMember({"dashed", "omitted"}));
    command.footer(
        "Example: vidno render scene.json --method zbuffer --kernel exact -o picture.png\n"
        "Exit status 1: the run lost something; standard error says what and where, the picture shows the rest.");
    command.callback([options, &status] { status = render(*options); });
}

}  // namespace vidno::cli
