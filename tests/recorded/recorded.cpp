/// Recorded hashes: compares every run of the scenes of a group with the hashes of an earlier commit.
///
///     vidno_recorded GROUP                    compares the hashes with those in GROUP.txt
///     vidno_recorded GROUP --every N          compares the hashes of every Nth scene only
///     vidno_recorded GROUP --write            writes GROUP.txt
///     vidno_recorded GROUP --runs             prints the hash of each run in a line, to compare two programs
///     vidno_recorded GROUP --scene NAME       prints the scene
///
/// A run is determined by a scene, a method with its edition and kernel, and a way to report it. A list of the hashes
/// of all runs would be too long. So the file has one hash for all runs of each scene, one for all runs of each method,
/// and one for all runs of each way. A run changed if the hashes of its scene, its method and its way changed.
///
/// To save time, the scenes take turns. Each runs at all levels, but it is checked at one level only, and under `exact`
/// only a third of the scenes are checked. Its states are taken at one level, under one kernel.
#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "check/check.h"
#include "check/checked_trace.h"
#include "choice/method.h"
#include "format/trace_reader.h"
#include "output.h"
#include "picture/image.h"
#include "random_scenes.h"
#include "regions/region_output.h"
#include "replay/floating_horizon_state.h"
#include "replay/state.h"
#include "run/floating_horizon_run.h"
#include "run/write_trace.h"
#include "scene/scene_json.h"
#include "scene/snapped_scene.h"
#include "scene/surface.h"

namespace vidno::recorded {

namespace {

/// Longer runs stop here. Their traces say so and are the same each time.
constexpr std::uint64_t most_events = 3000;
constexpr std::uint64_t most_events_checked = 20000;
constexpr std::uint64_t most_states = 500;

using Hash = std::string;  // in hexadecimal digits

Hash hash_of(std::string_view bytes) { return hash_text(bytes).substr(std::string_view("sha256:").size()); }

/// The hash of a sequence.
class Chain {
public:
    void add(std::string_view bytes) { hash_ = hash_of(hash_ + hash_of(bytes)); }
    const Hash& hash() const { return hash_; }

private:
    Hash hash_;
};

// Scenes

struct NamedScene {
    std::string name;
    std::string text;  // the text of its file
};

std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    for (const auto& file : std::filesystem::directory_iterator(folder)) files.push_back(file.path());
    std::sort(files.begin(), files.end());
    return files;
}

const std::filesystem::path lessons = VIDNO_ROOT "/lessons";

std::vector<NamedScene> lesson_scenes() {
    std::vector<NamedScene> scenes;
    for (const auto& folder : files_in(lessons)) {
        const std::string name = folder.filename();
        const bool has_scenes = std::isdigit(static_cast<unsigned char>(name[0])) || name == "surfaces";
        if (!has_scenes) continue;
        for (const auto& file : files_in(folder)) {
            if (file.extension() != ".json" || file.filename() == "lesson.json") continue;
            scenes.push_back({name + '/' + file.stem().string(), read_file(file)});
        }
    }
    return scenes;
}

std::vector<NamedScene> atlas_scenes() {
    std::vector<NamedScene> scenes;
    for (const auto& file : files_in(lessons / "failures")) {
        if (file.extension() != ".json") continue;
        const auto entry = nlohmann::json::parse(read_file(file));
        if (entry.contains("scene")) scenes.push_back({file.stem(), entry["scene"].dump()});
    }
    return scenes;
}

/// A third of the random scenes.
std::vector<NamedScene> random_third(std::uint64_t third) {
    std::vector<NamedScene> scenes;
    const auto add = [&](const std::string& kind, std::uint64_t count, auto&& made) {
        for (std::uint64_t i = third * count; i < (third + 1) * count; ++i) {
            scenes.push_back({kind + '-' + std::to_string(i), made(i)});
        }
    };
    add("random", 100, random_scene);
    add("surface", 20, random_surface);
    return scenes;
}

std::optional<std::vector<NamedScene>> scenes_of(const std::string& group) {
    if (group == "lessons") return lesson_scenes();
    if (group == "atlas") return atlas_scenes();
    if (group == "random-1") return random_third(0);
    if (group == "random-2") return random_third(1);
    if (group == "random-3") return random_third(2);
    return std::nullopt;
}

AnyScene scene_in(const NamedScene& scene) {
    if (is_surface(scene.text)) return read_surface(scene.text, scene.name);
    return read_scene(scene.text, scene.name).scene;
}

// Methods, each in the editions and under the kernels that run it

/// The parameters of a kernel, such as the bits of `bits:9`, to run.
std::vector<int> numbers_of(const KernelChoice& choice) {
    if (choice.kind == KernelKind::bits) return {4, 9, 24};
    if (choice.kind == KernelKind::depth) return {8};
    return {choice.parameter ? choice.parameter->if_not_said.value_or(choice.parameter->least) : 0};
}

struct PolygonMethod {
    Method method;
    Edition edition;
    NamedKernel kernel;
};
struct FloatingHorizonMethod {
    Edition edition;
    NamedKernel kernel;
};

/// The options of the program that select the method.
std::string options_of(std::string_view method, Edition edition, const NamedKernel& kernel) {
    return "--method " + std::string(method) + " --edition " + name_of(edition) + " --kernel " + kernel.name();
}
std::string options_of(const PolygonMethod& each) {
    return options_of(method_names[std::size_t(each.method)], each.edition, each.kernel);
}
std::string options_of(const FloatingHorizonMethod& each) {
    return options_of(floating_horizon_method, each.edition, each.kernel);
}

void for_each_choice(auto&& use) {
    for (const auto& named : named_editions) {
        for (const auto& choice : kernel_choices) {
            for (const int number : numbers_of(choice)) use(named.edition, NamedKernel{&choice, number});
        }
    }
}

std::vector<PolygonMethod> polygon_methods() {
    std::vector<PolygonMethod> methods;
    for (std::size_t i = 0; i < method_names.size(); ++i) {
        for_each_choice([&](Edition edition, const NamedKernel& kernel) {
            if (kernel.choice->runs(Method(i), edition)) methods.push_back({Method(i), edition, kernel});
        });
    }
    return methods;
}

std::vector<FloatingHorizonMethod> floating_horizon_methods() {
    std::vector<FloatingHorizonMethod> methods;
    for_each_choice([&](Edition edition, const NamedKernel& kernel) {
        if (kernel.choice->runs_floating_horizon(edition)) methods.push_back({edition, kernel});
    });
    return methods;
}

// Ways to report a run

/// The results of a run without a trace: the picture or the lines, the number of calls of `progress`, and the regions
/// if there are any.
std::string result_of(RunRequest request) {
    std::uint64_t steps = 0;
    request.progress = [&] { ++steps; };
    std::vector<ShownRegion> regions;
    const bool has_regions = request.method == Method::weiler_atherton;
    if (has_regions) request.regions = &regions;
    std::string result = rgb_rows(run(request));
    result += std::to_string(steps);
    if (has_regions) result += regions_json(regions, request);
    if (is_warnock(request.method)) {
        request.smallest_window = 2;
        result += rgb_rows(run(request));
    }
    return result;
}
std::string result_of(FloatingHorizonRequest request) {
    std::uint64_t steps = 0;
    request.progress = [&] { ++steps; };
    const DrawnLines lines = run(request);
    return lines_hash(lines) + std::to_string(steps);
}

TraceHeader header_of(const RunRequest& request, const AdmittedScene& scene) {
    return {request.method, request.edition, request.kernel.name(), request.detail, scene};
}
FloatingHorizonHeader header_of(const FloatingHorizonRequest& request, const Surface& surface) {
    return {request.edition, request.kernel.name(), request.detail, surface};
}

std::string trace_of(const auto& request, const auto& scene, bool checked) {
    std::string text;
    TraceWriter writer(
        header_of(request, scene), [&](std::string_view part) { text += part; }, most_events);
    checked ? write_checked_trace(request, writer) : write_trace(request, writer);
    return text;
}

State state_of(const TraceReader& reader) { return State(reader.header()); }
FloatingHorizonState state_of(const FloatingHorizonTraceReader& reader) {
    return FloatingHorizonState(reader.header());
}

/// The hash of the states that `vidno replay` writes.
Hash states_of(const std::string& trace) {
    AnyTraceReader opened = open_trace(LineReader::of_text(trace), "trace");
    return std::visit(
        [](auto& reader) {
            auto state = state_of(reader);
            Chain states;
            states.add(state_json(state));
            while (const auto event = reader.next()) {
                state.apply(*event);
                if (state.step() <= most_states) states.add(state_json(state));
            }
            states.add(state_json(state));
            return states.hash();
        },
        opened);
}

/// The findings of `vidno check`. A distance has six digits, in which the square roots of all machines agree.
std::string text_of(const DecisionReport& report) {
    std::ostringstream text;
    text << std::setprecision(6) << report.intersections << ' ' << report.farthest_off;
    for (const auto count : report.decided_by) text << ' ' << count;
    for (const auto& each : report.procedures) {
        text << '\n' << procedure_names[std::size_t(each.procedure)] << ' ' << each.decisions << ' ';
        text << each.wrong_for_operands << ' ' << each.wrong_for_scene << ' ' << each.undefined;
        if (each.first_wrong) text << ' ' << *each.first_wrong;
        if (each.first_wrong_for_operands) text << " (" << *each.first_wrong_for_operands << ')';
    }
    return text.str();
}
std::string findings_in(const RunRequest& request) {
    const CheckReport report = check_run(request, right_picture(request.scene, request.method));
    return text_of(report) + '\n' + std::to_string(report.wrong_pixels);
}
std::string findings_in(const FloatingHorizonRequest& request) {
    const FloatingHorizonCheckReport report = check_run(request);
    return text_of(report) + '\n' + std::to_string(report.wrong_columns);
}
/// Empty if the run is too long: with few bits the printed Z-buffer may step for a very long time.
std::string findings_of(auto request, const auto& scene) {
    request.detail = Detail::signs;
    TraceWriter writer(
        header_of(request, scene), [](std::string_view) {}, most_events_checked);
    return write_trace(request, writer) ? findings_in(request) : "";
}

/// The ways to run a scene. They depend on its name only, so a new scene does not change the turns of the others.
struct Turn {
    std::size_t number;
    bool all;

    Turn(const std::string& name, bool every_way)
        : number(std::stoul(hash_of(name).substr(0, 4), nullptr, 16)), all(every_way) {}

    bool checks(std::size_t detail, std::string_view kernel) const {
        return all || (number % 3 == detail && (kernel != "exact" || number / 3 % 3 == 0));
    }
    bool counts(std::string_view kernel) const { return all || (number % 6 == 5 && kernel != "exact"); }
    /// The effect of events on a state hardly depends on the kernel, so one kernel of doubles and one of fractions
    /// suffice.
    bool takes_states(std::size_t detail, std::string_view kernel) const {
        if (all) return kernel == "double" || kernel == "exact";
        return number / 3 % 3 == detail && kernel == (number / 9 % 2 == 0 ? "double" : "exact");
    }
};

/// Calls `hear` with each way and its hash: without a trace, at all levels, checked, and the states.
void tell_in_each_way(auto request, const auto& scene, const Turn& turn, auto&& hear) {
    const std::string kernel = request.kernel.name();
    hear("without a trace", hash_of(result_of(request)));
    if (turn.counts(kernel)) hear("by vidno check", hash_of(findings_of(request, scene)));
    for (std::size_t detail = 0; detail < detail_names.size(); ++detail) {
        request.detail = Detail(detail);
        const std::string level = "--detail " + std::string(detail_names[detail]);
        const std::string trace = trace_of(request, scene, false);
        hear(level, hash_of(trace));
        if (turn.checks(detail, kernel)) hear(level + " --check", hash_of(trace_of(request, scene, true)));
        if (turn.takes_states(detail, kernel)) hear(level + ", its states", states_of(trace));
    }
}

void tell(const PolygonMethod& each, const AdmittedScene& given, const Turn& turn, auto&& hear) {
    const auto& [method, edition, kernel] = each;
    AdmittedScene scene = given;
    try {
        if (kernel.snaps()) scene = snapped_scene(given, kernel.parameter).scene;
    } catch (const Refused&) {
        return hear("refused", {});
    }
    if (refusal_of(method, scene)) return hear("refused", {});
    tell_in_each_way(RunRequest{method, kernel, edition, scene}, scene, turn, hear);
}
void tell(const FloatingHorizonMethod& each, const Surface& surface, const Turn& turn, auto&& hear) {
    tell_in_each_way(FloatingHorizonRequest{each.kernel, each.edition, surface.curves}, surface, turn, hear);
}

// The table

/// The hashes of a group by key, in the order in which the keys first came.
class Hashes {
public:
    void add(const std::string& key, std::string_view bytes) {
        const auto [at, is_new] = chains_.try_emplace(key);
        if (is_new) keys_.push_back(key);
        at->second.add(bytes);
    }
    const std::vector<std::string>& keys() const { return keys_; }
    std::string of(const std::string& key) const { return chains_.at(key).hash(); }

private:
    std::vector<std::string> keys_;
    std::map<std::string, Chain> chains_;
};

struct Table {
    Hashes scenes, methods, ways;
    std::uint64_t runs = 0;
};

/// The printed Z-buffer would step through all rows and columns as far as the distant vertices of this scene, which
/// takes minutes.
bool never_ends(const NamedScene& scene, const PolygonMethod& each) {
    return scene.name == "12-ray-crossings/far" && each.method == Method::zbuffer && each.edition == Edition::printed;
}
bool never_ends(const NamedScene&, const FloatingHorizonMethod&) { return false; }

/// Adds the hashes of the runs of a scene to the table.
void add_runs(const NamedScene& named, bool all, Table& table, bool print) {
    const Turn turn(named.name, all);
    const auto add = [&](const auto& scene, const auto& methods) {
        for (const auto& method : methods) {
            if (never_ends(named, method)) continue;
            const std::string options = options_of(method);
            const auto hear = [&](const std::string& way, const Hash& hash) {
                ++table.runs;
                table.scenes.add(named.name, options + way + hash);
                table.methods.add(options, named.name + way + hash);
                table.ways.add(way, named.name + options + hash);
                if (print) std::cout << hash << ' ' << named.name << ' ' << options << ' ' << way << '\n';
            };
            try {
                tell(method, scene, turn, hear);
            } catch (const std::exception& failure) {
                throw std::runtime_error(named.name + ' ' + options + ": " + failure.what());
            }
        }
    };
    static const auto for_polygons = polygon_methods();
    static const auto for_curves = floating_horizon_methods();
    const AnyScene scene = scene_in(named);
    if (const auto* polygons = std::get_if<AdmittedScene>(&scene)) {
        add(*polygons, for_polygons);
    } else {
        add(std::get<Surface>(scene), for_curves);
    }
}

std::string hashes_file(const std::string& group) { return VIDNO_ROOT "/tests/recorded/" + group + ".txt"; }

struct Kind {
    std::string_view name;
    Hashes Table::*hashes;
};
constexpr Kind kinds[]{{"scene", &Table::scenes}, {"method", &Table::methods}, {"way", &Table::ways}};

std::string line_of(const Kind& kind, const Hashes& hashes, const std::string& key) {
    return std::string(kind.name) + ' ' + hashes.of(key) + ' ' + key;
}

void write(const std::string& group, const Table& table) {
    std::string text = "# Hashes of runs, written by vidno_recorded " + group +
                       " --write. docs/building.md says under \"Recorded hashes\" when that may be done again.\n";
    for (const auto& kind : kinds) {
        const Hashes& hashes = table.*kind.hashes;
        for (const auto& key : hashes.keys()) text += line_of(kind, hashes, key) + '\n';
    }
    write_file(hashes_file(group), text);
}

/// The lines of a file that are of `kind`.
std::vector<std::string> recorded_lines(const std::string& file, const Kind& kind) {
    std::vector<std::string> lines;
    LineReader reader(file);
    std::string line;
    while (reader.next(line)) {
        if (line.starts_with(std::string(kind.name) + ' ')) lines.push_back(line);
    }
    return lines;
}

/// The part of a line after the kind and the hash.
std::string key_of(const std::string& line) { return line.substr(line.find(' ', line.find(' ') + 1) + 1); }

/// Prints which hashes differ from the recorded ones. Returns their number.
std::size_t differences(const std::string& file, const Table& table, bool whole) {
    std::size_t different = 0;
    const auto say = [&](const std::string& what) {
        ++different;
        std::cout << what << '\n';
    };
    for (const auto& kind : kinds) {
        if (!whole && kind.hashes != &Table::scenes) continue;
        const Hashes& hashes = table.*kind.hashes;
        std::map<std::string, std::string> recorded;
        for (const auto& line : recorded_lines(file, kind)) recorded[key_of(line)] = line;
        for (const auto& key : hashes.keys()) {
            const std::string now = line_of(kind, hashes, key);
            const auto then = recorded.extract(key);
            if (then.empty()) {
                say("not recorded: " + now);
            } else if (then.mapped() != now) {
                say("changed: " + now);
            }
        }
        if (!whole) continue;
        for (const auto& [key, line] : recorded) say("no longer there: " + line);
    }
    return different;
}

void say_what_to_do(const std::string& group) {
    std::cout << "\nA run that changed is where a changed scene, method and way meet; `vidno_recorded " << group
              << " --runs`, of a program of before and of this one, says which.\nTo see one:\n  vidno_recorded "
              << group << " --scene NAME >scene.json\n  vidno trace scene.json METHOD WAY --max-events " << most_events
              << " -o trace.jsonl\ndocs/building.md says when other hashes may be recorded.\n";
}

/// The table of the runs of every `step`th scene of a group.
Table table_of(const std::vector<NamedScene>& scenes, bool all, std::size_t step = 1, bool print = false) {
    Table table;
    for (std::size_t i = 0; i < scenes.size(); i += step) add_runs(scenes[i], all, table, print);
    return table;
}

int compare(const std::string& group, const std::vector<NamedScene>& scenes, std::size_t step) {
    const Table table = table_of(scenes, false, step);
    const std::size_t different = differences(hashes_file(group), table, step == 1);
    if (different > 0) say_what_to_do(group);
    std::cout << table.scenes.keys().size() << " scenes, " << table.methods.keys().size() << " methods, "
              << table.ways.keys().size() << " ways, " << table.runs << " runs: " << different << " hashes differ\n";
    return different > 0 ? 1 : 0;
}

int usage() {
    std::cerr << "vidno_recorded lessons|atlas|random-1|random-2|random-3 "
                 "[--every N | --write | --runs | --scene NAME]\n";
    return 2;
}

int main(const std::vector<std::string>& arguments) {
    const auto scenes = arguments.empty() ? std::nullopt : scenes_of(arguments[0]);
    if (!scenes) return usage();
    const std::string group = arguments[0];
    const auto has = [&](std::size_t place, std::string_view option) {
        return place < arguments.size() && arguments[place] == option;
    };
    if (arguments.size() == 3 && has(1, "--every")) {
        return compare(group, *scenes, std::stoul(arguments[2]));
    }
    if (arguments.size() == 3 && has(1, "--scene")) {
        for (const auto& [name, text] : *scenes) std::cout << (name == arguments[2] ? text : "");
        return 0;
    }
    if (arguments.size() == 2 && has(1, "--runs")) {
        table_of(*scenes, true, 1, true);
        return 0;
    }
    const bool writes = has(1, "--write");
    if (arguments.size() != std::size_t(1 + writes)) return usage();
    if (!writes) return compare(group, *scenes, 1);
    write(group, table_of(*scenes, false));
    return 0;
}

}  // namespace

}  // namespace vidno::recorded

int main(int count, char** arguments) {
    try {
        return vidno::recorded::main({arguments + 1, arguments + count});
    } catch (const std::exception& failure) {
        std::cerr << failure.what() << '\n';
        return 2;
    }
}
