#include <algorithm>
#include <iostream>

#include "commands.h"
#include "image.h"
#include "output.h"
#include "progress.h"
#include "scene_json.h"

namespace vidno::cli {

namespace {

Scene scene_of(const RunOptions& options) {
    Progress progress;
    progress.say("reading " + options.scene);
    auto [scene, warnings] = read_scene(read_file(options.scene), options.scene);
    progress.clear();
    for (const auto& warning : warnings) std::cerr << warning << '\n';
    return scene;
}

const KernelChoice& kernel_named(const std::string& name) {
    return *std::find_if(kernel_choices.begin(), kernel_choices.end(),
                         [&](auto& kernel) { return kernel.name == name; });
}

/// The place of a name that the command line has checked.
std::size_t place_in(const auto& names, const std::string& name) {
    return std::size_t(std::find(names.begin(), names.end(), name) - names.begin());
}

RunRequest request_of(const RunOptions& options, const Scene& scene) {
    if (options.edition == "printed" && !kernel_named(options.kernel).runs_printed) {
        throw Refused("--edition printed: not under --kernel " + options.kernel + ", whose decisions are always right");
    }
    return {Method(place_in(method_names, options.method)), options.edition == "printed", scene,
            Detail(place_in(detail_names, options.detail))};
}

}  // namespace

int trace(const RunOptions& options) {
    const Scene scene = scene_of(options);
    RunRequest request = request_of(options, scene);
    OutputFile file(options.output);
    Progress progress("events");
    TraceWriter* running = nullptr;
    const auto write = [&](std::string_view text) {
        file.write(text);
        if (running) progress.show(running->events());
    };
    TraceWriter writer({request.method, options.edition, options.kernel, request.detail, scene}, write,
                       options.most_events);
    running = request.writer = &writer;
    int status = 0;
    try {
        writer.finish(kernel_named(options.kernel).run(request));
    } catch (const EventLimitReached&) {
        writer.finish_partial();
        progress.clear();
        std::cerr << options.output << ": partial: stopped after " << writer.events() << " events (--max-events)\n";
        status = 1;
    }
    file.commit();
    return status;
}

int render(const RunOptions& options) {
    encode_image(Picture({0, 0, 1, 1}, {}), options.output);  // refuses a wrong name before the work
    const Scene scene = scene_of(options);
    OutputFile file(options.output);
    RunRequest request = request_of(options, scene);
    Progress progress(request.method == Method::warnock ? "windows" : "polygons");
    request.progress = [&, done = 0ULL]() mutable { progress.show(++done); };
    file.write(encode_image(kernel_named(options.kernel).run(request), options.output));
    file.commit();
    return 0;
}

}  // namespace vidno::cli
