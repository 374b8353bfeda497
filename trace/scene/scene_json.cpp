/// Reading checks in this order: the text as JSON (depth and repeated keys during parsing), the keys and types, the
/// values, and finally the polygons' shapes, exactly. An error in the text ends it; all other errors are reported
/// together.
#include "scene/scene_json.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <unordered_set>
#include <utility>

#include "choice/palette.h"
#include "json/json_node.h"
#include "json/json_text.h"
#include "json/unique_ids.h"
#include "scene/default_window.h"
#include "scene/exact_scene.h"
#include "scene/quick_scene.h"
#include "vidno/camera.h"

namespace vidno {
namespace {

constexpr std::string_view scene_format = "vidno-scene/1";

/// The camera; none if it has errors, which are added to the faults.
std::optional<Camera> read_camera(const JsonNode& node, const Area& area, Faults& faults) {
    Camera camera;
    bool is_right = true;
    const auto part = [&](auto&& read) { is_right = faults.attempt(read) && is_right; };
    const auto number = [&](std::string_view key, double& target) {
        if (node.has(key)) part([&] { target = node.at(key).number(); });
    };
    const auto triple = [&](std::string_view key, glm::dvec3& target) {
        if (node.has(key)) part([&] { target = node.at(key).triple(); });
    };
    const JsonNode projection = node.has("projection") ? node.at("projection") : node;
    if (projection.value() == "orthographic") {
        part([&] { node.require_keys({"eye", "target", "projection", "height", "near", "far"}, {"up"}); });
        camera.projection = Projection::orthographic;
        number("height", camera.height);
    } else {
        part([&] { node.require_keys({"eye", "target", "projection", "fov", "near", "far"}, {"up"}); });
        if (node.has("projection") && projection.value() != "perspective") {
            part([&] { projection.refuse("neither \"perspective\" nor \"orthographic\""); });
        }
        number("fov", camera.field_of_view);
    }
    triple("eye", camera.eye);
    triple("target", camera.target);
    triple("up", camera.up);
    number("near", camera.near_distance);
    number("far", camera.far_distance);
    if (!is_right) return std::nullopt;
    if (const auto defect = defect_of(camera, area)) part([&] { node.refuse(*defect); });
    return is_right ? std::optional(camera) : std::nullopt;
}

std::string read_name(const JsonNode& node) {
    if (node.text().empty()) node.refuse("empty");
    if (node.text().size() > longest_id) node.refuse("longer than " + std::to_string(longest_id) + " bytes");
    return node.text();
}

/// Names the vertex, or the z, for which a polygon is refused.
[[noreturn]] void refuse_shape(const JsonNode& node, const ScenePolygon& polygon, Admission admission, bool in_world) {
    const JsonNode vertices = node.at("vertices");
    if (admission == Admission::out_of_depth_range) {
        for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
            if (!(std::abs(polygon.vertices[i].z) <= 1)) vertices.at(i).at(2u).refuse(reason_of(admission));
        }
    }
    const auto [vertex, reason] = exact_scene::fault_of_shape(polygon, admission, in_world);
    if (vertex) vertices.at(*vertex).refuse(reason);
    vertices.refuse(reason);
}

class SceneReader {
public:
    explicit SceneReader(std::string file, Defaults defaults = Defaults::taken)
        : file_(std::move(file)), defaults_(defaults) {}

    SceneWithWarnings read(const JsonNode& root) {
        root.object();
        root.expect_format(scene_format);
        expect_keys(root);
        read_member(root, "name", [&](const JsonNode& node) { scene_.name = node.text(); });
        const bool has_window = read_member(root, "window", [&](const JsonNode& node) { scene_.area = node.window(); });
        read_member(root, "background", [&](const JsonNode& node) { scene_.background = node.color(); });
        if (has_window || !root.has("window")) {
            read_member(root, "camera", [&](const JsonNode& node) {
                if (!has_window) root.refuse("\"window\" is missing, which a camera needs");
                const auto camera = read_camera(node, scene_.area, faults_);
                if (camera) view_ = view_of(*camera, scene_.area);
            });
        }
        read_member(root, "polygons", [&](const JsonNode& node) { read_polygons(node, root.has("camera")); });
        faults_.settle();
        if (!has_window) take_default_window(root);
        return {exact_scene::admit(std::move(scene_)), std::move(warnings_)};
    }

private:
    void expect_keys(const JsonNode& root) {
        faults_.attempt([&] {
            if (defaults_ == Defaults::taken) {
                root.require_keys({"polygons"}, {"format", "name", "window", "background", "camera"});
            } else {
                root.require_keys({"format", "window", "polygons"}, {"name", "background"});
            }
        });
    }

    /// Reads a member if it is present. False if it is not, or was refused.
    bool read_member(const JsonNode& object, std::string_view key, auto&& read) {
        return object.has(key) && faults_.attempt([&] { read(object.at(key)); });
    }

    void take_default_window(const JsonNode& root) {
        const auto window = default_window(scene_.polygons);
        if (!window) {
            root.refuse(scene_.polygons.empty() ? "\"window\" is missing, and there are no vertices to derive it from"
                                                : "\"window\" is missing, and the vertices extend too far for one");
        }
        scene_.area = *window;
    }

    /// The polygon without a check of its shape; none if it has errors.
    std::optional<ScenePolygon> read_polygon(const JsonNode& node, std::size_t position) {
        ScenePolygon polygon;
        polygon.color = default_color(position);
        bool is_right = faults_.attempt([&] {
            if (defaults_ == Defaults::taken) {
                node.require_keys({"vertices"}, {"id", "color", "face"});
            } else {
                node.require_keys({"color", "vertices"}, {"id", "face"});
            }
        });
        if (!node.value().is_object()) return std::nullopt;
        const auto part = [&](auto&& read) { is_right = faults_.attempt(read) && is_right; };
        part([&] { polygon.id = node.has("id") ? read_name(node.at("id")) : std::to_string(position); });
        if (node.has("color")) part([&] { polygon.color = node.at("color").color(); });
        if (node.has("face")) part([&] { polygon.face = read_name(node.at("face")); });
        if (node.has("vertices")) {
            part([&] {
                const JsonNode vertices = node.at("vertices");
                const std::size_t count = vertices.size();
                polygon.vertices.reserve(count);
                for (std::size_t i = 0; i < count; ++i) {
                    part([&] { polygon.vertices.push_back(vertices.at(i).triple()); });
                }
            });
        }
        return is_right ? std::optional(std::move(polygon)) : std::nullopt;
    }

    /// The vertices are in the world if there is a camera, which may itself be at fault.
    void read_polygons(const JsonNode& node, bool in_world) {
        if (node.size() > most_polygons) node.refuse("more than " + std::to_string(most_polygons) + " polygons");
        std::vector<std::optional<ScenePolygon>> polygons;
        std::unordered_set<std::string> ids;
        polygons.reserve(node.size());
        for (std::size_t i = 0; i < node.size(); ++i) {
            polygons.push_back(read_polygon(node.at(i), i));
            if (!polygons.back() || ids.insert(polygons.back()->id).second) continue;
            faults_.attempt([&] {
                const JsonNode polygon = node.at(i);
                if (polygon.has("id")) polygon.at("id").refuse("the id occurs twice");
                polygon.refuse("the id occurs twice; a polygon without an id gets its position");
            });
        }
        PartIds part_ids(std::move(ids));
        for (std::size_t i = 0; i < polygons.size(); ++i) {
            if (!polygons[i]) continue;
            faults_.attempt([&] {
                if (in_world) {
                    add_seen(node.at(i), std::move(*polygons[i]), i, part_ids);
                } else {
                    add(node.at(i), std::move(*polygons[i]), i, part_ids);
                }
            });
        }
        if (scene_.polygons.size() > most_polygons) node.refuse(too_many_parts());
    }

    void add(const JsonNode& node, ScenePolygon polygon, std::size_t position, PartIds& part_ids) {
        const PolygonAdmission admitted = exact_scene::admit_polygon(polygon);
        warn_of_dropped(position, admitted.dropped);
        if (admitted.admission == Admission::admitted) {
            scene_.polygons.push_back(std::move(polygon));
            return;
        }
        std::vector<ScenePolygon> parts;
        if (admitted.admission == Admission::not_convex) parts = exact_scene::cut_into_convex_parts(polygon);
        if (parts.empty()) refuse_shape(node, polygon, admitted.admission, false);
        warn_of_parts(position, parts.size());
        add_parts(std::move(parts), part_ids);
    }

    void add_seen(const JsonNode& node, ScenePolygon polygon, std::size_t position, PartIds& part_ids) {
        const PolygonAdmission admitted = exact_scene::admit_in_world(polygon);
        std::vector<ScenePolygon> parts;
        if (admitted.admission == Admission::not_convex) {
            parts = exact_scene::cut_into_convex_parts_in_world(polygon);
            warn_of_parts(position, parts.size());
        } else if (admitted.admission == Admission::admitted) {
            parts.push_back(polygon);
        }
        if (parts.empty()) refuse_shape(node, polygon, admitted.admission, true);
        if (!view_) return;
        std::vector<ScenePolygon> seen_parts;
        std::size_t dropped = admitted.dropped;
        bool is_bent = false;
        for (const ScenePolygon& part : parts) {
            Seen seen = exact_scene::look(*view_, part);
            dropped += seen.dropped;
            is_bent = is_bent || seen.polygons.size() > 1;
            std::move(seen.polygons.begin(), seen.polygons.end(), std::back_inserter(seen_parts));
        }
        warn_of_dropped(position, dropped);
        if (polygon.edge_on) {
            warn(position, "no area, left out");
            return;
        }
        if (seen_parts.empty()) warn(position, "not in view, left out");
        if (is_bent) {
            warn(position, "cut into " + std::to_string(seen_parts.size()) + " polygons, for rounding bent it");
        }
        add_parts(std::move(seen_parts), part_ids);
    }

    void add_parts(std::vector<ScenePolygon> parts, PartIds& part_ids) {
        part_ids.name(parts);
        for (auto& part : parts) scene_.polygons.push_back(std::move(part));
    }

    void warn_of_parts(std::size_t position, std::size_t count) {
        if (count == 1) warn(position, "the outline runs back along itself, where it encloses nothing");
        if (count > 1) warn(position, "not convex, cut into " + std::to_string(count) + " convex polygons");
    }

    void warn_of_dropped(std::size_t position, std::size_t count) {
        if (count == 0) return;
        warn(position, std::to_string(count) + (count == 1 ? " vertex" : " vertices") + " reflex by rounding, dropped");
    }

    void warn(std::size_t position, const std::string& what) {
        warnings_.push_back(file_ + ": /polygons/" + std::to_string(position) + ": " + what);
    }

    std::string file_;
    Defaults defaults_;
    Faults faults_;
    std::optional<View> view_;
    Scene scene_;
    std::vector<std::string> warnings_;
};

void append_vertex(Text& out, const glm::dvec3& vertex) {
    out += '[';
    append_number(out, vertex.x);
    out += ',';
    append_number(out, vertex.y);
    out += ',';
    append_number(out, vertex.z);
    out += ']';
}

void append_polygon(Text& out, const ScenePolygon& polygon) {
    out += "{\"id\":";
    append_string(out, polygon.id);
    out += ",\"color\":";
    append_color(out, polygon.color);
    if (!polygon.face.empty()) {
        out += ",\"face\":";
        append_string(out, polygon.face);
    }
    out += ",\"vertices\":[";
    for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
        if (i > 0) out += ',';
        append_vertex(out, polygon.vertices[i]);
    }
    out += "]}";
}

}  // namespace

SceneWithWarnings read_scene(std::string_view text, const std::string& file) {
    if (auto scene = read_quickly(text)) return {exact_scene::admit(std::move(*scene)), {}};
    return read_json(text, file, [&](const JsonNode& root) { return SceneReader(file).read(root); });
}

SceneWithWarnings read_scene(const JsonNode& node, const std::string& file) { return SceneReader(file).read(node); }

AdmittedScene read_whole_scene(const JsonNode& node) { return SceneReader("", Defaults::none).read(node).scene; }

std::string scene_json(const Scene& scene) {
    Text out;
    out += "{\"format\":\"";
    out += scene_format;
    out += "\",\"name\":";
    append_string(out, scene.name);
    out += ",\"window\":";
    append_area(out, scene.area);
    out += ",\"background\":";
    append_color(out, scene.background);
    out += ",\"polygons\":[";
    for (std::size_t i = 0; i < scene.polygons.size(); ++i) {
        if (i > 0) out += ',';
        append_polygon(out, scene.polygons[i]);
    }
    out += "]}";
    return out.string();
}

}  // namespace vidno
