#include "scene/failure.h"

#include <utility>

#include "choice/method.h"
#include "choice/read_choice.h"
#include "choice/read_texts.h"
#include "json/document_format.h"
#include "json/json_node.h"
#include "scene/scene_json.h"
#include "vidno/line.h"

namespace vidno {

namespace {

constexpr std::string_view failure_format = "vidno-failure/1";

NamedRun read_run(const JsonNode& node, bool of_curves) {
    NamedRun run{node.at("method").text(), read_kernel(node.at("kernel")), read_edition(node.at("edition"))};
    if (of_curves != (run.method == floating_horizon_method)) {
        node.at("method").refuse(of_curves ? "draws no surface" : "draws a surface, and the scene is of polygons");
    }
    const KernelChoice& choice = *run.kernel.choice;
    const bool can_run =
        of_curves
            ? choice.runs_floating_horizon(run.edition)
            : choice.runs(Method(node.at("method").place_among(method_names, "no method of this name")), run.edition);
    if (!can_run) node.refuse("the kernel does not run this method and edition");
    return run;
}

std::pair<int, int> read_place(const JsonNode& node) {
    if (node.size() != 2) node.refuse("not two whole numbers");
    const auto whole = [&](std::size_t i) { return node.at(i).whole_number(-farthest_offset, farthest_offset); };
    return {whole(0), whole(1)};
}

std::string read_line(const JsonNode& node) {
    return std::string(line_names[node.place_among(line_names, "no line of this name")]);
}

Shows read_shows(const JsonNode& node, bool of_curves) {
    if (of_curves) {
        node.require_keys({}, {"column", "place", "fault", "missing", "present"});
    } else {
        node.require_keys({}, {"pixel", "wrong", "fault", "missing", "present", "more_windows", "off"});
    }
    if (node.keys().empty()) node.refuse("shows nothing");
    Shows shows;
    if (node.has("pixel")) shows.pixel = read_place(node.at("pixel"));
    if (node.has("column")) shows.column = read_place(node.at("column"));
    if (node.has("place")) {
        const JsonNode& place = node.at("place");
        if (place.size() != 2) place.refuse("not a curve and an x");
        shows.place = {place.at(0).whole_number(0, farthest_offset), place.at(1).number()};
    }
    if (node.has("wrong")) {
        shows.wrong = procedure_names[node.at("wrong").place_among(procedure_names, "no procedure of this name")];
    }
    if (node.has("fault")) shows.fault = read_line(node.at("fault"));
    if (node.has("missing")) shows.missing = read_line(node.at("missing"));
    if (node.has("present")) shows.present = read_line(node.at("present"));
    if (node.has("more_windows")) {
        shows.more_windows = node.at("more_windows").truth();
        if (!shows.more_windows) node.at("more_windows").refuse("not true");
    }
    if (node.has("off")) {
        shows.off = node.at("off").number();
        if (!(*shows.off > 0)) node.at("off").refuse("not positive");
    }
    return shows;
}

bool is_of_curves(const JsonNode& scene) { return scene.has("curves") || scene.has("function"); }

class FailureReader {
public:
    explicit FailureReader(std::string file) : file_(std::move(file)) {}

    Failure read(const JsonNode& root) {
        root.object();
        root.expect_format(failure_format);
        const bool has_scene = !root.has("test");
        faults_.attempt([&] {
            if (has_scene) {
                root.require_keys({"title", "why", "remedy", "scene", "fails", "holds", "shows"}, {"format", "source"});
            } else {
                root.require_keys({"title", "why", "remedy", "test"}, {"format", "source"});
            }
        });
        Failure failure;
        read_member(root, "title", [&](const JsonNode& node) { failure.title = read_texts(node); });
        read_member(root, "why", [&](const JsonNode& node) { failure.why = read_texts(node); });
        read_member(root, "remedy", [&](const JsonNode& node) { failure.remedy = read_texts(node); });
        read_member(root, "source", [&](const JsonNode& node) { failure.source = node.text(); });
        read_member(root, "test", [&](const JsonNode& node) { failure.test = node.text(); });
        if (has_scene) read_runs(root, failure);
        faults_.settle();
        return failure;
    }

private:
    void read_runs(const JsonNode& root, Failure& failure) {
        read_member(root, "scene", [&](const JsonNode& node) { failure.scene = read_any_scene(node, failure); });
        const bool of_curves = root.has("scene") && is_of_curves(root.at("scene"));
        read_member(root, "shows", [&](const JsonNode& node) { failure.shows = read_shows(node, of_curves); });
        read_member(root, "fails", [&](const JsonNode& node) {
            node.require_keys({"method", "kernel", "edition"});
            failure.fails = read_run(node, of_curves);
        });
        read_member(root, "holds", [&](const JsonNode& node) {
            node.require_keys({"method", "kernel", "edition"}, {"scene"});
            failure.holds = read_run(node, of_curves);
            if (node.has("scene")) failure.holds_scene = read_any_scene(node.at("scene"), failure);
        });
    }

    AnyScene read_any_scene(const JsonNode& node, Failure& failure) const {
        node.object();
        if (is_of_curves(node)) {
            Surface surface = read_surface(node);
            const std::string gaps = gaps_in_words(surface.curves);
            if (!gaps.empty()) failure.warnings.push_back(file_ + ": /scene: " + gaps);
            return surface;
        }
        auto [scene, warnings] = read_scene(node, file_);
        failure.warnings.insert(failure.warnings.end(), warnings.begin(), warnings.end());
        return scene;
    }

    void read_member(const JsonNode& object, std::string_view key, auto&& read) {
        if (object.has(key)) faults_.attempt([&] { read(object.at(key)); });
    }

    std::string file_;
    Faults faults_;
};

}  // namespace

bool is_failure(std::string_view text) { return are_of_one_kind(document_format(text), failure_format); }

Failure read_failure(std::string_view text, const std::string& file) {
    return read_json(text, file, [&](const JsonNode& root) { return read_failure(root, file); });
}
Failure read_failure(const JsonNode& root, const std::string& file) { return FailureReader(file).read(root); }

}  // namespace vidno
