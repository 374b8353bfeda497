#include "format/trace_header.h"

#include "choice/read_choice.h"
#include "format/tree_event.h"
#include "scene/scene_json.h"

namespace vidno {

namespace {

/// The fields that headers of both kinds have.
void read_run(const JsonNode& object, auto& header) {
    expect_keys(object, {"format", "method", "edition", "kernel", "detail", "scene"});
    header.edition = read_edition(member(object, "edition"));
    const JsonNode kernel = member(object, "kernel");
    read_kernel(kernel);
    header.kernel = kernel.text();  // as written, which is what the page keeps
    header.detail = Detail(member(object, "detail").place_among(detail_names));
}

}  // namespace

void expect_keys(const JsonNode& object, std::initializer_list<std::string_view> keys) {
    for (const auto& key : object.keys()) {
        if (std::find(keys.begin(), keys.end(), key) == keys.end()) object.refuse("unknown key " + key);
    }
}

void expect_trace(const nlohmann::json& first_line) {
    if (!first_line.is_object()) throw Refused("not an object");
    if (!first_line.contains("format")) throw Refused("/format: not a trace of format vidno-trace/1");
    JsonNode(first_line).expect_format("vidno-trace/1");
}

bool is_of_curves(const nlohmann::json& first_line) {
    return first_line.contains("method") && first_line["method"] == floating_horizon_method;
}

AnyHeader read_header(std::string_view first_line) {
    const nlohmann::json object = parse_line(first_line);
    expect_trace(object);
    if (is_of_curves(object)) return read_floating_horizon_header(JsonNode(object));
    return read_trace_header(JsonNode(object));
}

TraceHeader read_trace_header(const JsonNode& object) {
    const JsonNode method = member(object, "method");
    if (method.value() == floating_horizon_method) method.refuse("floating-horizon, which this command does not take");
    TraceHeader header;
    header.method = Method(method.place_among(method_names));
    read_run(object, header);
    header.scene = read_whole_scene(member(object, "scene"));
    return header;
}

FloatingHorizonHeader read_floating_horizon_header(const JsonNode& object) {
    struct {
        Edition edition{};
        std::string kernel;
        Detail detail{};
    } run;
    read_run(object, run);
    if (!kernel_named(run.kernel)->choice->runs_floating_horizon(run.edition)) {
        object.at("kernel").refuse("floating-horizon does not run under this kernel and edition");
    }
    const JsonNode scene = member(object, "scene");
    if (scene.has("function")) scene.at("function").refuse("a trace has samples instead");
    return {run.edition, std::move(run.kernel), run.detail, read_whole_surface(scene)};
}

}  // namespace vidno
