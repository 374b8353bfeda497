/// vidno.wasm: makes a trace of a scene for a page, with the same bytes as `vidno trace`, and what it shows about runs.
/// replay.wasm reads traces.
///
/// exchange.h says how a page asks. A request is a line of JSON, followed by a file. For a trace: the fields of its
/// header except the scene, and two more; and the scene's file:
///
///     {"method":"warnock","edition":"corrected","kernel":"double","detail":"signs","check":false,"most_events":1000}
///     {"format":"vidno-scene/1",...}
///
/// For a map: the kernel and the number of places in a row; and the file of a decision:
///
///     {"kernel":"double","side":48}
///     {"format":"vidno-question/1",...}
///
/// For the list of a run's decisions: the same as for a trace. For a margin: the run, a step of level signs and a
/// vertex; and the scene's file:
///
///     {"method":"warnock","edition":"corrected","kernel":"double","step":12,"polygon":"A","vertex":2}
///     {"format":"vidno-scene/1",...}
///
/// For the scene of a mesh: its file and the files that it may name, by name and size in bytes; and their contents. The
/// messages are what the scene lacks, with its place, one per line:
///
///     {"files":[{"name":"cube.obj","size":412},{"name":"cube.mtl","size":98}]}
///
/// For a failure: its file alone. The result is a line of JSON:
///
///     {"title":{"en":T,"ru":T},"why":W,"remedy":R,"source":S,"step":N|null,"there":A,"fails":RUN,"holds":RUN,
///      "pixel":[x,y]|null}
///
/// with texts in both languages, `source` empty if nothing was published, RUN {"method":M,"kernel":K,"edition":E}, and
/// a description of what is seen at the step in `there`.

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "check/checked_trace.h"
#include "check/findings_text.h"
#include "check/seen_failure.h"
#include "choice/method.h"
#include "choice/read_choice.h"
#include "import/import.h"
#include "json/json_node.h"
#include "margin/margin.h"
#include "run/write_trace.h"
#include "scene/failure.h"
#include "scene/scene_json.h"
#include "scene/snapped_scene.h"
#include "sign_map/map.h"
#include "sign_map/mapped_decision_json.h"
#include "wasm/exchange.h"

namespace vidno {
namespace {

struct Options {
    Method method{};  // of polygons
    Edition edition{};
    NamedKernel kernel{};
    Detail detail{};
    bool check = false;
    std::uint64_t most_events = 0;
};

enum class Kind { polygons, curves };

Options read_options(const JsonNode& root, Kind kind) {
    root.require_keys({"method", "edition", "kernel", "detail", "check", "most_events"});
    Options options;
    if (kind == Kind::polygons) {
        options.method = Method(root.at("method").place_among(method_names));
    } else if (root.at("method").text() != floating_horizon_method) {
        root.at("method").refuse("draws no surface");
    }
    options.edition = read_edition(root.at("edition"));
    options.kernel = read_kernel(root.at("kernel"));
    const KernelChoice& choice = *options.kernel.choice;
    const bool runs = kind == Kind::curves ? choice.runs_floating_horizon(options.edition)
                                           : choice.runs(options.method, options.edition);
    if (!runs) root.at("kernel").refuse("does not run this method and edition");
    options.detail = Detail(root.at("detail").place_among(detail_names));
    options.check = root.at("check").truth();
    options.most_events = std::uint64_t(root.at("most_events").whole_number(0, std::numeric_limits<int>::max()));
    return options;
}

AdmittedScene read_scene_for(const NamedKernel& kernel, std::string_view text, std::string& messages) {
    auto [scene, warnings] = read_scene(text, "scene");
    for (const auto& warning : warnings) messages += warning + '\n';
    if (!kernel.snaps()) return std::move(scene);
    SnappedScene snapped = snapped_scene(scene, kernel.parameter);
    const std::string change = snapped.change();
    if (!change.empty()) messages += kernel.name() + ' ' + change + '\n';
    return std::move(snapped.scene);
}

/// The first line of a request, and the file after it.
std::pair<std::string_view, std::string_view> parts(std::string_view request) {
    const auto line = request.substr(0, request.find('\n'));
    return {line, request.substr(std::min(line.size() + 1, request.size()))};
}

void write_run(Exchange& page, const Options& options, const auto& header, const auto& request) {
    const auto write = [&](std::string_view text) { page.made += text; };
    TraceWriter writer(header, write, options.most_events);
    options.check ? write_checked_trace(request, writer) : write_trace(request, writer);
}

void make_trace(Exchange& page) {
    const auto [line, file] = parts(page.request);
    const Kind kind = is_surface(file) ? Kind::curves : Kind::polygons;
    const Options options = read_json(line, "request", [&](const JsonNode& root) { return read_options(root, kind); });
    const auto& [method, edition, kernel, detail, check, most_events] = options;
    if (kind == Kind::curves) {
        const Surface surface = read_surface(file, "scene");
        const std::string gaps = gaps_in_words(surface.curves);
        if (!gaps.empty()) page.messages += gaps + '\n';
        write_run(page, options, FloatingHorizonHeader{edition, kernel.name(), detail, surface},
                  FloatingHorizonRequest{kernel, edition, surface.curves, detail});
    } else {
        const AdmittedScene scene = read_scene_for(kernel, file, page.messages);
        if (const auto reason = refusal_of(method, scene)) throw Refused("scene: " + *reason);
        write_run(page, options, TraceHeader{method, edition, kernel.name(), detail, scene},
                  RunRequest{method, kernel, edition, scene, detail});
    }
}

/// A page holds no larger file.
constexpr int most_bytes = std::numeric_limits<int>::max();

/// A page does not show more zeros, and a run with more events takes too long.
constexpr std::size_t most_zeros = 2000;
constexpr std::size_t most_narrow = 20;

/// Ends a run after this many events; 0: no limit.
std::function<void()> limit(std::uint64_t most_events) {
    return [most_events, events = std::uint64_t{0}]() mutable {
        if (most_events > 0 && ++events > most_events) throw EventLimitReached{};
    };
}

void make_findings(Exchange& page) {
    const auto [line, file] = parts(page.request);
    const Kind kind = is_surface(file) ? Kind::curves : Kind::polygons;
    const Options options = read_json(line, "request", [&](const JsonNode& root) { return read_options(root, kind); });
    const auto find = [&](auto request, Procedure method, const Area& area, const FindingsHeader& header) {
        FindingList findings(method, area, most_narrow, most_zeros, options.detail);
        request.progress = limit(options.most_events);
        try {
            find_in(request, findings);
        } catch (const EventLimitReached&) {
            page.messages += "the run is too long: the list ends before it\n";
        }
        page.made += findings_jsonl(header, findings.findings());
    };
    if (kind == Kind::curves) {
        const Surface surface = read_surface(file, "scene");
        const FloatingHorizonRequest request{options.kernel, options.edition, surface.curves};
        find(request, Procedure::floating_horizon, surface.curves->area, findings_header(request, surface.name));
    } else {
        const AdmittedScene scene = read_scene_for(options.kernel, file, page.messages);
        if (const auto reason = refusal_of(options.method, scene)) throw Refused("scene: " + *reason);
        const RunRequest request{options.method, options.kernel, options.edition, scene};
        find(request, choice_of(options.method).procedure, scene->area, findings_header(request));
    }
}

struct MarginOptions {
    Method method;
    Edition edition;
    NamedKernel kernel;
    std::uint64_t step;
    std::string polygon;
    int vertex;
};

MarginOptions read_margin_options(const JsonNode& root) {
    root.require_keys({"method", "edition", "kernel", "step", "polygon", "vertex"});
    constexpr int most = std::numeric_limits<int>::max();
    return {Method(root.at("method").place_among(method_names)),
            read_edition(root.at("edition")),
            read_kernel(root.at("kernel")),
            std::uint64_t(root.at("step").whole_number(0, most)),
            root.at("polygon").text(),
            root.at("vertex").whole_number(0, most)};
}

void make_margin(Exchange& page) {
    const auto [line, file] = parts(page.request);
    const MarginOptions options = read_json(line, "request", read_margin_options);
    const AdmittedScene scene = read_scene_for(options.kernel, file, page.messages);
    const auto polygon = std::find_if(scene->polygons.begin(), scene->polygons.end(),
                                      [&](const auto& each) { return each.id == options.polygon; });
    if (polygon == scene->polygons.end() || options.vertex >= int(polygon->vertices.size())) {
        throw Refused("no such vertex");
    }
    const RunRequest request{options.method, options.kernel, options.edition, scene};
    const PolygonPlace place{int(polygon - scene->polygons.begin())};
    page.made += margin_json(margin_of(request, options.step, place, options.vertex), scene);
}

void make_map(Exchange& page) {
    const auto [line, file] = parts(page.request);
    const auto [kernel, side] = read_json(line, "request", [](const JsonNode& root) {
        root.require_keys({"kernel", "side"});
        const NamedKernel named = read_kernel(root.at("kernel"));
        if (named.snaps()) root.at("kernel").refuse("the places of a map do not lie on a grid");
        return std::pair(named, root.at("side").whole_number(1, MappedDecision::side));
    });
    for (const auto& [computed, exact] :
         sign_map(read_mapped_decision(std::string(file), "decision"), kernel, side).cells) {
        page.made += char('0' + 3 * place_of(computed) + place_of(exact));
    }
}

struct GivenFile {
    std::string name;
    std::size_t size;
};

std::vector<GivenFile> read_given_files(const JsonNode& root) {
    root.require_keys({"files"});
    const JsonNode list = root.at("files");
    std::vector<GivenFile> files;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const JsonNode each = list.at(i);
        each.require_keys({"name", "size"});
        files.push_back({each.at("name").text(), std::size_t(each.at("size").whole_number(0, most_bytes))});
    }
    if (files.empty()) list.refuse("no file");
    return files;
}

void make_scene(Exchange& page) {
    auto [line, bytes] = parts(page.request);
    const std::vector<GivenFile> files = read_json(line, "request", read_given_files);
    std::map<std::string, std::string_view> contents;
    for (const auto& [name, size] : files) {
        contents.emplace(name, bytes.substr(0, size));
        bytes.remove_prefix(std::min(size, bytes.size()));
    }
    const Beside beside = [&](const std::string& name) -> std::optional<std::string> {
        const auto found = contents.find(name);
        return found == contents.end() ? std::nullopt : std::optional(std::string(found->second));
    };
    const std::string& mesh = files.front().name;
    const ImportedScene made = import_mesh(contents.at(mesh), mesh, {}, beside);
    page.made += scene_json(made.scene);
    for (const auto& [what, where] : made.losses) page.messages += where + ": " + what + '\n';
}

void append_words(Text& out, std::string_view key, const Failure::Words& words) {
    out += '"';
    out += key;
    out += "\":{";
    for (const Language language : languages) {
        append_string(out, code_of(language));
        out += ':';
        append_string(out, words.in(language));
        out += language == languages.back() ? "}," : ",";
    }
}

void append_run(Text& out, std::string_view key, const NamedRun& run) {
    out += '"';
    out += key;
    out += "\":{\"method\":";
    append_string(out, run.method);
    out += ",\"kernel\":";
    append_string(out, run.kernel.name());
    out += ",\"edition\":";
    append_string(out, name_of(run.edition));
    out += "},";
}

/// The description of a failure, and the step where it is seen.
void make_failure(Exchange& page) {
    const Failure failure = read_failure(page.request, "scene");
    if (!failure.scene) throw Refused("scene: no scene shows it");
    const SeenFailure found = seen(failure);
    Text& out = page.made;
    out += '{';
    append_words(out, "title", failure.title);
    append_words(out, "why", failure.why);
    append_words(out, "remedy", failure.remedy);
    append_words(out, "there", found.there);
    append_run(out, "fails", failure.fails);
    append_run(out, "holds", failure.holds);
    out += "\"source\":";
    append_string(out, failure.source);
    out += ",\"step\":";
    if (found.step) {
        append_integer(out, *found.step);
    } else {
        out += "null";
    }
    out += ",\"pixel\":";
    if (const auto& pixel = failure.shows.pixel) {
        out += '[';
        append_integer(out, pixel->first);
        out += ',';
        append_integer(out, pixel->second);
        out += ']';
    } else {
        out += "null";
    }
    out += '}';
}

}  // namespace
}  // namespace vidno

extern "C" {

/// Makes the requested trace. False if it was refused; the messages then give the reason, otherwise warnings, one per
/// line.
[[clang::export_name("run")]] bool vidno_run() { return vidno::attempt(vidno::make_trace); }

/// Makes the requested map, or is refused in the same way: one character per place, '0' to '8', the row of p first. The
/// digit is three times the computed sign plus the exact one, where 0 is negative, 1 is zero, and 2 is positive.
[[clang::export_name("map")]] bool vidno_map() { return vidno::attempt(vidno::make_map); }

/// Makes the requested list of decisions, `vidno-decisions/1`, or is refused in the same way. The steps are those of
/// the requested level; a decision whose event that level lacks has `"isShown":false`, and the step that contains it.
[[clang::export_name("findings")]] bool vidno_findings() { return vidno::attempt(vidno::make_findings); }

/// Makes the requested margin, `vidno-margin/1`, or is refused in the same way.
[[clang::export_name("margin")]] bool vidno_margin() { return vidno::attempt(vidno::make_margin); }

/// Makes the scene of a mesh, as `vidno import` does without options, or is refused in the same way.
[[clang::export_name("scene")]] bool vidno_scene() { return vidno::attempt(vidno::make_scene); }

/// Makes the description of a failure, as JSON, or is refused in the same way.
[[clang::export_name("failure")]] bool vidno_failure() { return vidno::attempt(vidno::make_failure); }
}
