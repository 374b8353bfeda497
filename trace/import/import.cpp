#include "import/import.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <nlohmann/json.hpp>
#include <unordered_set>
#include <utility>
#include <vector>

#include "counted.h"
#include "import/flat_parts.h"
#include "json/unique_ids.h"
#include "refused.h"
#include "scene/convex_parts.h"
#include "scene/exact_scene.h"
#include "vidno/admission.h"
#include "vidno/look.h"

namespace vidno {
namespace {

/// The smallest sphere about the centre of the box around the used vertices.
struct Sphere {
    glm::dvec3 middle;
    double radius;
};

Sphere sphere_around(const MeshSoup& mesh) {
    glm::dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
    for (const auto& face : mesh.faces) {
        for (const std::size_t i : face.corners) {
            low = glm::min(low, mesh.points[i]);
            high = glm::max(high, mesh.points[i]);
        }
    }
    return {low / 2.0 + high / 2.0, glm::length(high / 2.0 - low / 2.0)};
}

/// A camera that sees the whole sphere from the front, a little from above and from the right.
Camera camera_for(const Sphere& sphere, double aspect) {
    constexpr double room = 1.02;
    Camera camera;
    camera.field_of_view = 30;
    const double slope = std::tan(glm::radians(camera.field_of_view / 2)) * std::min(1.0, aspect);
    const double distance = room * sphere.radius * std::sqrt(1 + 1 / (slope * slope));
    camera.target = sphere.middle;
    camera.eye = sphere.middle + distance * glm::normalize(glm::dvec3(0.5, 0.45, 1.0));
    camera.near_distance = distance - room * sphere.radius;
    camera.far_distance = distance + room * sphere.radius;
    return camera;
}

/// From dark, edge-on, to light, facing the viewer.
Color tone(const Camera& camera, const ScenePolygon& face) {
    constexpr glm::dvec3 dark(38, 70, 83), light(214, 232, 240);
    const glm::dvec3 ray =
        camera.projection == Projection::perspective ? face.vertices.front() - camera.eye : camera.target - camera.eye;
    const double facing =
        std::abs(glm::dot(camera::direction_of(rough_normal(face.vertices)), camera::direction_of(ray)));
    const glm::dvec3 mixed = glm::mix(dark, light, facing <= 1 ? facing : 1.0);
    return {std::uint8_t(std::lround(mixed.x)), std::uint8_t(std::lround(mixed.y)), std::uint8_t(std::lround(mixed.z))};
}

std::string as_utf8(const std::string& text) {
    using nlohmann::json;
    return json::parse(json(text).dump(-1, ' ', false, json::error_handler_t::replace)).get<std::string>();
}

std::string scene_name(const std::string& file) {
    const std::string name = without_folders(file);
    return as_utf8(name.substr(0, name.rfind('.')));
}

class Importer {
public:
    Importer(MeshSoup& mesh, const Camera& camera, Scene& scene)
        : mesh_(mesh),
          colors_(face_colors(mesh)),
          flat_part_(flat_parts(mesh, colors_)),
          parts_(mesh.faces.size()),
          camera_(camera),
          view_(view_of(camera, scene.area)),
          scene_(scene) {
        for (const std::size_t first : flat_part_) ++parts_[first];
    }

    void import() {
        for (std::size_t i = 0; i < mesh_.faces.size(); ++i) import_face(i);
    }

    /// "992 faces read, 12 dropped: 10 have no area, 2 cross themselves; 5 cut into convex polygons; 40 not in view"
    std::string report() const {
        const std::size_t dropped = without_area_ + crossing_ + unclear_;
        std::string line =
            counted(mesh_.faces.size(), "face", "faces") + " read, " + std::to_string(dropped) + " dropped";
        std::string why;
        append(why, ", ", without_area_, "without area");
        append(why, ", ", crossing_, "crossing themselves");
        append(why, ", ", unclear_,
               "neither convex nor of at most " + std::to_string(most_corners_to_clip) + " corners");
        if (!why.empty()) line += ": " + why;
        append(line, "; ", cut_, "cut into convex polygons");
        append(line, "; ", out_of_view_, "not in view");
        append(line, "; ", vertices_, "vertices reflex by rounding, dropped");
        return line;
    }

private:
    static void append(std::string& line, std::string_view separator, std::size_t count, const std::string& what) {
        if (count == 0) return;
        if (!line.empty()) line += separator;
        line += std::to_string(count) + " " + what;
    }

    std::string name_of(std::size_t number) const {
        const auto group = mesh_.faces[number].group;
        if (!group) return std::to_string(number);
        constexpr std::size_t most = longest_id - 30;
        return std::string(first_bytes(as_utf8(mesh_.groups[*group]), most)) + ":" + std::to_string(number);
    }

    ScenePolygon polygon_of(std::size_t number) const {
        ScenePolygon polygon;
        polygon.id = name_of(number);
        for (const std::size_t i : mesh_.faces[number].corners) polygon.vertices.push_back(mesh_.points[i]);
        return polygon;
    }

    void import_face(std::size_t number) {
        ScenePolygon face = polygon_of(number);
        const std::size_t first = flat_part_[number];
        if (parts_[first] > 1) face.face = name_of(first);
        std::vector<ScenePolygon> shown;
        const std::vector<ScenePolygon> parts = parts_of(std::move(face), number);
        bool bent = false;
        for (const ScenePolygon& part : parts) {
            Seen seen = look(view_, part);
            vertices_ += seen.dropped;
            bent = bent || seen.polygons.size() > 1;
            for (ScenePolygon& polygon : seen.polygons) {
                if (!polygon.edge_on) shown.push_back(std::move(polygon));
            }
        }
        cut_ += parts.size() > 1 || bent;
        out_of_view_ += shown.empty() && !parts.empty();
        part_ids_.name(shown);
        for (ScenePolygon& polygon : shown) scene_.polygons.push_back(std::move(polygon));
        if (scene_.polygons.size() > most_polygons) throw Refused(too_many_parts());
    }

    /// The face itself, or the parts it is cut into; none if it is dropped.
    std::vector<ScenePolygon> parts_of(ScenePolygon face, std::size_t number) {
        const PolygonAdmission admitted = admit_in_world(face);
        if (admitted.admission == Admission::too_few_vertices || face.edge_on) {
            drop(without_area_, "without area", number);
            return {};
        }
        const std::size_t first = flat_part_[number];
        face.color = colors_[number].value_or(tone(camera_, first == number ? face : polygon_of(first)));
        if (admitted.admission == Admission::admitted) {
            vertices_ += admitted.dropped;
            return {std::move(face)};
        }
        std::vector<ScenePolygon> parts = exact_scene::cut_into_convex_parts_in_world(face);
        if (parts.empty() && face.vertices.size() > most_corners_to_clip) {
            drop(unclear_, "with too many corners to be cut", number);
        } else if (parts.empty()) {
            drop(crossing_, "that cross themselves", number);
        }
        return parts;
    }

    void drop(std::size_t& count, const std::string& why, std::size_t number) {
        ++count;
        mesh_.left_out.add("faces " + why, mesh_.place_of(number));
    }

    MeshSoup& mesh_;
    const std::vector<std::optional<Color>> colors_;
    const std::vector<std::size_t> flat_part_;  // of each face, by the part's first one
    std::vector<std::size_t> parts_;            // of each flat part, by its first face
    const Camera& camera_;
    const View view_;
    Scene& scene_;
    PartIds part_ids_{{}};  // "7.1" is no face's number
    std::size_t without_area_ = 0, crossing_ = 0, unclear_ = 0, cut_ = 0, out_of_view_ = 0, vertices_ = 0;
};

}  // namespace

ImportedScene import_mesh(std::string_view bytes, const std::string& file, const ImportOptions& options,
                          const Beside& beside) {
    const auto is_side = [](int side) { return 1 <= side && side <= largest_side; };
    if (!is_side(options.width) || !is_side(options.height)) {
        throw Refused(file + ": the size is not from 1 to " + std::to_string(largest_side) + " pixels a side");
    }
    MeshSoup mesh = read_mesh_soup(bytes, file, beside);
    Scene scene;
    scene.name = scene_name(file);
    scene.area = {0, 0, options.width, options.height};
    scene.background = options.background;
    const double aspect = double(options.width) / double(options.height);
    const Camera camera = options.camera ? *options.camera : camera_for(sphere_around(mesh), aspect);
    if (const auto defect = defect_of(camera, scene.area)) {
        if (options.camera) throw Refused(file + ": camera: " + std::string(*defect));
        throw Refused(file + ": no camera fits the mesh, which is a point or exceeds the range of doubles");
    }
    try {
        Importer importer(mesh, camera, scene);
        importer.import();
        return {admit(std::move(scene)), file + ": " + importer.report(), mesh.left_out.losses()};
    } catch (const Refused& refused) {
        throw Refused(file + ": " + refused.what());
    }
}

}  // namespace vidno
