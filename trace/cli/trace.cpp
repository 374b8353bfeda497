#include <algorithm>
#include <iostream>

#include "check.h"
#include "commands.h"
#include "image.h"
#include "method.h"
#include "output.h"
#include "progress.h"
#include "scene_json.h"
#include "snapped_scene.h"

namespace vidno::cli {

void expect_run(const NamedKernel& kernel, Method method, Edition edition) {
    const std::string named_method = "--method " + std::string(method_names[std::size_t(method)]);
    if (is_warnock(method) && !kernel.choice->runs_warnock) {
        throw Refused(named_method + ": not under --kernel " + kernel.name() + ", for it has no Z-buffer");
    }
    if (is_family(method) && edition != Edition::corrected) {
        throw Refused(named_method + ": only --edition corrected");
    }
    if (is_family(method) && !kernel.choice->run_family) {
        throw Refused(named_method + ": not under --kernel " + kernel.name());
    }
    if (edition == Edition::printed && !kernel.choice->runs_printed) {
        throw Refused("--edition printed: not under --kernel " + kernel.name() + ", whose decisions are always right");
    }
    const std::string named = "--edition " + std::string(choice_of(edition).name);
    if (is_mistake(edition) && !kernel.choice->runs_mistakes) {
        throw Refused(named + ": not under --kernel " + kernel.name() + ", but under double and exact");
    }
    if (const auto only = choice_of(edition).only; only && *only != method) {
        throw Refused(named + ": a mistake of --method " + std::string(method_names[std::size_t(*only)]) + " alone");
    }
}

NamedKernel kernel_of(const RunOptions& options) {
    const NamedKernel kernel = *kernel_named(options.kernel);
    expect_run(kernel, method_of(options), edition_of(options));
    return kernel;
}

Scene scene_from(const std::string& file) {
    Progress progress;
    progress.say("reading " + file);
    auto [scene, warnings] = read_scene(read_file(file), file);
    progress.clear();
    for (const auto& warning : warnings) std::cerr << warning << '\n';
    return scene;
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

RunRequest request_of(const RunOptions& options, const NamedKernel& kernel, const Scene& scene) {
    return {method_of(options), kernel, edition_of(options), scene, Detail(place_in(detail_names, options.detail))};
}

}  // namespace

int trace(const RunOptions& options) {
    const NamedKernel kernel = kernel_of(options);
    const Scene scene = scene_for(kernel, scene_from(options.scene), options.scene);
    expect_admitted(method_of(options), scene, options.scene);
    const RunRequest request = request_of(options, kernel, scene);
    OutputFile file(options.output);
    Progress progress("events");
    TraceWriter* running = nullptr;
    const auto write = [&](std::string_view text) {
        file.write(text);
        if (running) progress.show(running->events());
    };
    TraceWriter writer({request.method, request.edition, kernel.name(), request.detail, scene}, write,
                       options.most_events);
    running = &writer;
    const bool whole = write_trace(request, writer, options.check);
    if (!whole) {
        progress.clear();
        std::cerr << options.output << ": partial: stopped after " << writer.events() << " events (--max-events)\n";
    }
    file.commit();
    return whole ? 0 : 1;
}

int render(const RunOptions& options) {
    encode_image(Picture({0, 0, 1, 1}, {}), options.output);  // refuses a wrong name before the work
    const NamedKernel kernel = kernel_of(options);
    const Scene scene = scene_for(kernel, scene_from(options.scene), options.scene);
    expect_admitted(method_of(options), scene, options.scene);
    OutputFile file(options.output);
    RunRequest request = request_of(options, kernel, scene);
    Progress progress(is_warnock(request.method) ? "windows" : "polygons");
    request.progress = [&, done = 0ULL]() mutable { progress.show(++done); };
    file.write(encode_image(run(request), options.output));
    file.commit();
    return 0;
}

}  // namespace vidno::cli
