/// The library in a page: WebAssembly that makes a trace of a scene, the same bytes as `vidno trace`.
///
/// A caller takes room for a request, writes it there, asks for the trace, and reads the bytes where they are. A request
/// is a line of JSON with the fields of a trace's header, but for the scene, and two more; then the scene's file:
///
///     {"method":"warnock","edition":"corrected","kernel":"double","detail":"signs","check":false,"most_events":1000}
///     {"format":"vidno-scene/1",...}

#include <string>
#include <string_view>

#include "check.h"
#include "json_node.h"
#include "scene_json.h"
#include "snapped_scene.h"

namespace vidno {
namespace {

/// One request after the other; no thread but the caller's.
struct Live {
    std::string request, trace, messages;
};

Live& live() {
    static Live only;
    return only;
}

struct Options {
    Method method{};
    bool printed = false;
    NamedKernel kernel{};
    Detail detail{};
    bool check = false;
    std::uint64_t most_events = 0;
};

constexpr std::array<std::string_view, 2> edition_names{"corrected", "printed"};

template <class Names>
std::size_t place_of(const JsonNode& node, const Names& names) {
    const auto found = std::find(names.begin(), names.end(), node.text());
    if (found == names.end()) node.refuse("no such name");
    return std::size_t(found - names.begin());
}

Options read_options(const JsonNode& root) {
    root.require_keys({"method", "edition", "kernel", "detail", "check", "most_events"});
    Options options;
    options.method = Method(place_of(root.at("method"), method_names));
    options.printed = place_of(root.at("edition"), edition_names) == 1;
    const auto kernel = kernel_named(root.at("kernel").text());
    if (!kernel) root.at("kernel").refuse("not one of " + kernel_names());
    if (!kernel->choice->runs(options.method, options.printed)) {
        root.at("kernel").refuse("does not run this method and edition");
    }
    options.kernel = *kernel;
    options.detail = Detail(place_of(root.at("detail"), detail_names));
    options.check = root.at("check").truth();
    options.most_events = std::uint64_t(root.at("most_events").whole_number(0, std::numeric_limits<int>::max()));
    return options;
}

Scene read_scene_for(const NamedKernel& kernel, std::string_view text, std::string& messages) {
    auto [scene, warnings] = read_scene(text, "scene");
    for (const auto& warning : warnings) messages += warning + '\n';
    if (!kernel.snaps()) return std::move(scene);
    SnappedScene snapped = snapped_scene(scene, kernel.parameter);
    const std::string change = snapped.change();
    if (!change.empty()) messages += kernel.name() + ' ' + change + '\n';
    return std::move(snapped.scene);
}

void make_trace(std::string_view request, Live& live) {
    const auto line = request.substr(0, request.find('\n'));
    const Options options = read_json(line, "request", read_options);
    const Scene scene =
        read_scene_for(options.kernel, request.substr(std::min(line.size() + 1, request.size())), live.messages);
    const auto write = [&](std::string_view text) { live.trace += text; };
    TraceWriter writer(
        {options.method, std::string(edition_names[options.printed]), options.kernel.name(), options.detail, scene},
        write, options.most_events);
    write_trace({options.method, options.kernel, options.printed, scene, options.detail}, writer, options.check);
}

}  // namespace
}  // namespace vidno

extern "C" {

/// Where the caller writes a request of so many bytes.
[[clang::export_name("request")]] char* vidno_request(std::size_t size) {
    vidno::live().request.resize(size);
    return vidno::live().request.data();
}

/// Runs the request. False if it was refused; then the messages say why, else what the caller should know (a line each).
[[clang::export_name("run")]] bool vidno_run() {
    auto& live = vidno::live();
    live.trace.clear();
    live.messages.clear();
    try {
        vidno::make_trace(live.request, live);
        return true;
    } catch (const std::exception& error) {
        live.messages = error.what();
        return false;
    }
}

[[clang::export_name("trace")]] const char* vidno_trace() { return vidno::live().trace.data(); }
[[clang::export_name("trace_size")]] std::size_t vidno_trace_size() { return vidno::live().trace.size(); }
[[clang::export_name("messages")]] const char* vidno_messages() { return vidno::live().messages.data(); }
[[clang::export_name("messages_size")]] std::size_t vidno_messages_size() { return vidno::live().messages.size(); }
}
