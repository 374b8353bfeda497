#include "page.h"

#include <filesystem>

#include "commands.h"
#include "output.h"
#include "progress.h"
#include "scene_json.h"

namespace vidno::cli {

namespace {

std::string base_name(const std::string& file) { return std::filesystem::path(file).filename().string(); }

PageFile page_file_of(const std::string& file, const Scene& scene, const RunOptions& run) {
    const std::string title = scene.name.empty() ? base_name(file) : scene.name;
    const std::string method(method_names[std::size_t(method_of(run))]);
    return {title, method, run.kernel, run.edition, run.detail, {}, false};
}

/// A scene as it was admitted, to be run with the defaults.
PageFile scene_file(const std::string& file) {
    const Scene scene = scene_from(file);
    PageFile made = page_file_of(file, scene, RunOptions{});
    made.is_scene = true;
    made.bytes = scene_json(scene);
    return made;
}

/// A trace, every event of which could be read.
PageFile trace_file(const std::string& file, bool& whole) {
    Progress progress("events");
    TraceReader reader(LineReader(file), file);
    while (reader.next()) progress.show(reader.events());
    progress.clear();
    if (!is_whole(reader)) whole = false;
    const TraceHeader& header = reader.header();
    RunOptions run;
    run.method = method_names[std::size_t(header.method)];
    run.kernel = header.kernel;
    run.edition = edition_names[std::size_t(header.edition)];
    run.detail = detail_names[std::size_t(header.detail)];
    PageFile made = page_file_of(file, header.scene, run);
    made.bytes = read_file(file);
    if (!made.bytes.starts_with("\x1f\x8b")) made.bytes = gzipped(made.bytes);
    return made;
}

}  // namespace

int page(const PageOptions& options) {
    if (options.output != "-" && !options.output.ends_with(".html")) throw Refused(options.output + ": not .html");
    trace_page({});  // refuses what would be missing in the end before the work
    OutputFile output(options.output);
    bool whole = true;
    PageContent content;
    for (const auto& file : options.files) {
        if (std::filesystem::is_directory(file)) {
            whole = add_lesson(file, content) && whole;
        } else {
            content.add(is_trace(file) ? trace_file(file, whole) : scene_file(file));
        }
    }
    output.write(trace_page(content));
    output.commit();
    return whole ? 0 : 1;
}

}  // namespace vidno::cli
