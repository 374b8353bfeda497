#include <algorithm>
#include <iostream>

#include "check/checked_trace.h"
#include "choice/method.h"
#include "commands.h"
#include "figure/encoded.h"
#include "figure/floating_horizon_parts.h"
#include "figure/weiler_atherton_parts.h"
#include "output.h"
#include "picture/image.h"
#include "progress.h"
#include "regions/region_output.h"
#include "run/write_trace.h"
#include "scene/scene_json.h"
#include "scene/snapped_scene.h"

namespace vidno::cli {

void expect_run(const NamedKernel& kernel, Method method, Edition edition) {
    const std::string named_method = "--method " + std::string(method_names[std::size_t(method)]);
    if (is_warnock(method) && !kernel.choice->runs_warnock) {
        throw Refused(named_method + ": not under --kernel " + kernel.name() + ", for it has no Z-buffer");
    }
    const auto only = choice_of(edition).only;
    if (is_family(method) && edition != Edition::corrected && !only) {
        throw Refused(named_method + ": only --edition corrected, and mistakes of this method alone");
    }
    if (method == Method::weiler_atherton && edition != Edition::corrected) {
        throw Refused(named_method + ": only --edition corrected");
    }
    if (!is_of_course(method) && !kernel.choice->runs(method, Edition::corrected)) {
        throw Refused(named_method + ": not under --kernel " + kernel.name());
    }
    if (edition == Edition::printed && !kernel.choice->runs_printed) {
        throw Refused("--edition printed: not under --kernel " + kernel.name() + ", whose decisions are always right");
    }
    const std::string named = "--edition " + std::string(choice_of(edition).name);
    if (is_mistake(edition) && !kernel.choice->runs_mistakes) {
        throw Refused(named + ": not under --kernel " + kernel.name() + ", but under double and exact");
    }
    if (only && *only != method) {
        throw Refused(named + ": a mistake of --method " + std::string(method_names[std::size_t(*only)]) + " alone");
    }
}

void expect_floating_horizon_run(const NamedKernel& kernel, Edition edition) {
    if (kernel.choice->runs_floating_horizon(edition)) return;
    const std::string edition_name(choice_of(edition).name);
    if (is_mistake(edition)) {
        throw Refused("--edition " + edition_name + ": a mistake of methods that paint polygons");
    }
    if (kernel.choice->runs_floating_horizon(Edition::corrected)) {
        throw Refused("--edition printed: not under --kernel " + kernel.name() + ", whose decisions are always right");
    }
    throw Refused("--kernel " + kernel.name() + ": for polygons alone");
}

NamedKernel kernel_of(const RunOptions& options) {
    const NamedKernel kernel = *kernel_named(options.kernel);
    expect_run(kernel, method_of(options), edition_of(options));
    return kernel;
}

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

void expect_admitted(Method method, const Scene& scene, const std::string& file) {
    const auto reason = refusal_of(method, scene);
    if (!reason) return;
    throw Refused(file + ": --method " + std::string(method_names[std::size_t(method)]) + " takes " +
                  std::string(choice_of(method).rule.domain) + ": " + *reason);
}

namespace {

Detail detail_of(const RunOptions& options) { return Detail(place_in(detail_names, options.detail)); }

RunRequest request_of(const RunOptions& options, const NamedKernel& kernel, const Scene& scene) {
    return {method_of(options), kernel, edition_of(options), scene, detail_of(options)};
}

FloatingHorizonRequest request_of(const RunOptions& options, const Surface& surface) {
    const NamedKernel kernel = *kernel_named(options.kernel);
    expect_floating_horizon_run(kernel, edition_of(options));
    return {kernel, edition_of(options), surface.curves, detail_of(options)};
}

/// Of a run of either kind, with its header.
int write_traced(const auto& header, const auto& request, const RunOptions& options) {
    OutputFile file(options.output);
    Progress progress("events");
    TraceWriter* running = nullptr;
    const auto write = [&](std::string_view text) {
        file.write(text);
        if (running) progress.show(running->events());
    };
    TraceWriter writer(header, write, options.most_events);
    running = &writer;
    const bool whole = options.check ? write_checked_trace(request, writer) : write_trace(request, writer);
    if (!whole) {
        progress.clear();
        std::cerr << options.output << ": partial: stopped after " << writer.events() << " events (--max-events)\n";
    }
    file.commit();
    return whole ? 0 : 1;
}

int trace_scene(const RunOptions& options, const Scene& given) {
    const NamedKernel kernel = kernel_of(options);
    const Scene scene = scene_for(kernel, given, options.scene);
    expect_admitted(method_of(options), scene, options.scene);
    const RunRequest request = request_of(options, kernel, scene);
    return write_traced(TraceHeader{request.method, request.edition, kernel.name(), request.detail, scene}, request,
                        options);
}
int trace_scene(const RunOptions& options, const Surface& surface) {
    const FloatingHorizonRequest request = request_of(options, surface);
    return write_traced(FloatingHorizonHeader{request.edition, request.kernel.name(), request.detail, surface}, request,
                        options);
}

std::string paced_by(Method method) {
    if (method == Method::weiler_atherton) return "lists";
    return is_warnock(method) ? "windows" : "polygons";
}

/// Visible regions are polygons: JSON, or a drawing.
bool is_of_regions(const RunOptions& options) {
    const std::string& name = options.output;
    return method_of(options) == Method::weiler_atherton &&
           (name.ends_with(".json") || name.ends_with(".svg") || name.ends_with(".pdf") || name.ends_with(".tex"));
}

std::string encoded_regions(RunRequest request, const std::string& output) {
    std::vector<ShownRegion> regions;
    request.regions = &regions;
    run(request);
    if (output.ends_with(".json")) return regions_json(regions, request);
    return figures::encoded(figures::drawn_regions(regions, request.scene), {request.scene.name}, output);
}

std::string rendered(const RunOptions& options, const Scene& given) {
    const bool of_regions = is_of_regions(options);
    if (!of_regions) encode_image(Picture({0, 0, 1, 1}, {}), options.output);  // refuses a wrong name before the work
    const NamedKernel kernel = kernel_of(options);
    const Scene scene = scene_for(kernel, given, options.scene);
    expect_admitted(method_of(options), scene, options.scene);
    RunRequest request = request_of(options, kernel, scene);
    Progress progress(paced_by(request.method));
    request.progress = [&, done = 0ULL]() mutable { progress.show(++done); };
    return of_regions ? encoded_regions(request, options.output) : encode_image(run(request), options.output);
}
std::string rendered(const RunOptions& options, const Surface& surface) {
    figures::format_of(options.output);  // refuses a wrong name before the work
    FloatingHorizonRequest request = request_of(options, surface);
    Progress progress("curves");
    request.progress = [&, done = 0ULL]() mutable { progress.show(++done); };
    return figures::encoded(figures::drawn_lines(run(request), surface.curves.area), {surface.name}, options.output);
}

}  // namespace

int trace(const RunOptions& options) {
    const AnyScene any = any_scene_from(options.scene, options.method);
    return std::visit([&](const auto& scene) { return trace_scene(options, scene); }, any);
}

int render(const RunOptions& options) {
    const AnyScene any = any_scene_from(options.scene, options.method);
    OutputFile file(options.output);
    file.write(std::visit([&](const auto& scene) { return rendered(options, scene); }, any));
    file.commit();
    return 0;
}

}  // namespace vidno::cli
