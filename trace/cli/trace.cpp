#include <algorithm>
#include <iostream>

#include "check.h"
#include "commands.h"
#include "image.h"
#include "output.h"
#include "progress.h"
#include "scene_json.h"

namespace vidno::cli {

void expect_edition(const NamedKernel& kernel, const std::string& edition) {
    if (edition == "corrected" || kernel.choice->runs_printed) return;
    throw Refused("--edition " + edition + ": not under --kernel " + kernel.name() +
                  ", whose decisions are always right");
}

Scene scene_from(const std::string& file) {
    Progress progress;
    progress.say("reading " + file);
    auto [scene, warnings] = read_scene(read_file(file), file);
    progress.clear();
    for (const auto& warning : warnings) std::cerr << warning << '\n';
    return scene;
}

namespace {

RunRequest request_of(const RunOptions& options, const Scene& scene) {
    const NamedKernel kernel = *kernel_named(options.kernel);
    expect_edition(kernel, options.edition);
    return {Method(place_in(method_names, options.method)), kernel, options.edition == "printed", scene,
            Detail(place_in(detail_names, options.detail))};
}

}  // namespace

int trace(const RunOptions& options) {
    const Scene scene = scene_from(options.scene);
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
        writer.finish(options.check ? trace_checked(request) : run(request));
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
    const Scene scene = scene_from(options.scene);
    OutputFile file(options.output);
    RunRequest request = request_of(options, scene);
    Progress progress(request.method == Method::warnock ? "windows" : "polygons");
    request.progress = [&, done = 0ULL]() mutable { progress.show(++done); };
    file.write(encode_image(run(request), options.output));
    file.commit();
    return 0;
}

}  // namespace vidno::cli
