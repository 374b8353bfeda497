#include "scene/snapped_scene.h"

#include <sstream>

#include "counted.h"
#include "json/unique_ids.h"
#include "refused.h"
#include "scene/exact_scene.h"

namespace vidno {

int finest_grid_of(const Scene& scene) {
    int bits = finest_grid;
    while (bits > 0 && !fits_grid(scene, bits)) --bits;
    return bits;
}

std::string SnappedScene::change() const {
    std::vector<std::string> changes;
    if (snapping.cut > 0) changes.push_back("cut " + counted(snapping.cut, "polygon", "polygons") + " into triangles");
    if (snapping.moved > 0) {
        std::ostringstream moved;
        moved << "moved " << snapping.moved << " of " << counted(snapping.vertices, "vertex", "vertices")
              << " by at most " << snapping.farthest_moved << " pixels and " << snapping.deepest_moved << " in z";
        changes.push_back(moved.str());
    }
    if (snapping.vanished > 0) {
        changes.push_back("left " + counted(snapping.vanished, "triangle", "triangles") + " without area");
    }
    std::string words;
    for (const auto& change : changes) words += (words.empty() ? "" : "; ") + change;
    return words;
}

SnappedScene snapped_scene(const AdmittedScene& admitted, int bits) {
    const Scene& scene = *admitted;
    if (!fits_grid(scene, bits)) {
        const int finest = finest_grid_of(scene);
        throw Refused("the scene is too wide for a grid of 1/2^" + std::to_string(bits) + " pixel; " +
                      (finest > 0 ? "grid:" + std::to_string(finest) + " is the finest that fits" : "none fits"));
    }
    Scene snapped{scene.name, scene.area, scene.background, {}};
    std::vector<std::size_t> sources;
    Snapping snapping;
    std::unordered_set<std::string> ids;
    for (const auto& polygon : scene.polygons) ids.insert(polygon.id);
    PartIds part_ids(std::move(ids));
    for (std::size_t i = 0; i < scene.polygons.size(); ++i) {
        auto parts = exact_scene::snapped(scene.polygons[i], {bits}, snapping);
        part_ids.name(parts);
        sources.insert(sources.end(), parts.size(), i);
        std::move(parts.begin(), parts.end(), std::back_inserter(snapped.polygons));
    }
    if (snapped.polygons.size() > most_polygons) throw Refused(too_many_parts());
    return {exact_scene::admit(std::move(snapped)), std::move(sources), snapping};
}

}  // namespace vidno
