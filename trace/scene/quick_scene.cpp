#include "scene/quick_scene.h"

#include <algorithm>
#include <unordered_set>
#include <utility>

#include "choice/palette.h"
#include "json/json_scanner.h"
#include "json/unique_ids.h"
#include "scene/default_window.h"
#include "scene/exact_scene.h"

namespace vidno {

namespace {

/// Each function returns false for text that it leaves to the tree reader.
class SceneScanner : JsonScanner {
public:
    using JsonScanner::JsonScanner;

    bool scene(Scene& scene) {
        bool has_format = false, has_name = false, has_window = false, has_background = false, has_polygons = false;
        skip_space();
        const bool read = object([&](std::string_view key) {
            if (key == "format") return once(has_format) && string() == "vidno-scene/1";
            if (key == "window") return once(has_window) && area(scene.area);
            if (key == "polygons") return once(has_polygons) && polygons(scene.polygons);
            if (key == "name") return once(has_name) && string(scene.name);
            return key == "background" && once(has_background) && color(scene.background);
        });
        skip_space();
        return read && at_end() && has_polygons && (has_window || take(scene.area, default_window(scene.polygons)));
    }

private:
    /// Whether a key occurs for the first time.
    static bool once(bool& seen) { return !std::exchange(seen, true); }

    /// Calls `member` with each key, to read its value.
    bool object(auto&& member) {
        return items('{', '}', [&] {
            const auto key = string();
            skip_space();
            if (!key || !skip(":")) return false;
            skip_space();
            return member(*key);
        });
    }

    /// Calls `item` to read each item of a list.
    bool items(char open, char close, auto&& item) {
        if (!skip({&open, 1})) return false;
        skip_space();
        if (skip({&close, 1})) return true;
        do {
            skip_space();
            if (!item()) return false;
            skip_space();
        } while (skip(","));
        return skip({&close, 1});
    }

    bool area(Area& area) {
        std::optional<int> x, y, width, height;
        const auto whole = [this](std::optional<int>& target, int least, int greatest) {
            return !target && number(target.emplace()) && least <= *target && *target <= greatest;
        };
        const bool read = object([&](std::string_view key) {
            if (key == "x") return whole(x, -farthest_offset, farthest_offset);
            if (key == "y") return whole(y, -farthest_offset, farthest_offset);
            if (key == "width") return whole(width, 1, largest_side);
            return key == "height" && whole(height, 1, largest_side);
        });
        if (!read || !x || !y || !width || !height) return false;
        area = {*x, *y, *width, *height};
        return true;
    }

    bool polygons(std::vector<ScenePolygon>& polygons) {
        const bool read = items('[', ']', [&] {
            const std::size_t position = polygons.size();
            return position < most_polygons && polygon(polygons.emplace_back(), position);
        });
        if (!read) return false;
        std::unordered_set<std::string_view> ids;
        ids.reserve(polygons.size());
        return std::all_of(polygons.begin(), polygons.end(),
                           [&](const auto& each) { return ids.insert(each.id).second; });
    }

    bool polygon(ScenePolygon& polygon, std::size_t position) {
        bool has_id = false, has_color = false, has_face = false, has_vertices = false;
        const bool read = object([&](std::string_view key) {
            if (key == "id") return once(has_id) && string(polygon.id) && !polygon.id.empty();
            if (key == "color") return once(has_color) && color(polygon.color);
            if (key == "face") return once(has_face) && string(polygon.face) && !polygon.face.empty();
            return key == "vertices" && once(has_vertices) && vertices(polygon.vertices);
        });
        if (!read || polygon.id.size() > longest_id || polygon.face.size() > longest_id) return false;
        if (!has_id) polygon.id = std::to_string(position);
        if (!has_color) polygon.color = default_color(position);
        const PolygonAdmission admitted = exact_scene::admit_polygon(polygon);
        return admitted.admission == Admission::admitted && admitted.dropped == 0;
    }

    bool vertices(std::vector<glm::dvec3>& vertices) {
        vertices.reserve(4);
        return items('[', ']', [&] {
            double coordinates[3];
            int count = 0;
            if (!items('[', ']', [&] { return count < 3 && number(coordinates[count++]); }) || count != 3) return false;
            vertices.emplace_back(coordinates[0] + 0.0, coordinates[1] + 0.0, coordinates[2] + 0.0);  // no -0
            return true;
        });
    }
};

}  // namespace

std::optional<Scene> read_quickly(std::string_view text) {
    SceneScanner scanner(text);
    Scene scene;
    return scanner.scene(scene) ? std::optional(std::move(scene)) : std::nullopt;
}

}  // namespace vidno
