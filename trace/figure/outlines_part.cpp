#include <cmath>
#include <glm/vec2.hpp>
#include <limits>

#include "parts.h"

namespace vidno::figures {

namespace {

constexpr std::size_t most_names = 26;
constexpr double name_size = 8;

glm::dvec2 middle_of(const ScenePolygon& polygon) {
    glm::dvec2 sum{0, 0};
    for (const auto& vertex : polygon.vertices) sum += glm::dvec2(vertex);
    return sum / double(polygon.vertices.size());
}

/// Whether it is convex and the point lies inside: roughly is enough for the place of a name.
bool holds(const ScenePolygon& polygon, glm::dvec2 point) {
    bool left = false, right = false;
    for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
        const glm::dvec2 a(polygon.vertices[i]);
        const glm::dvec2 b(polygon.vertices[(i + 1) % polygon.vertices.size()]);
        const double side = (b.x - a.x) * (point.y - a.y) - (b.y - a.y) * (point.x - a.x);
        left = left || side > 0;
        right = right || side < 0;
    }
    return !(left && right);
}

/// Where a name may stand: between the middle and the corners and edges, then anywhere, the nearest to the middle first.
std::vector<glm::dvec2> spots_in(const ScenePolygon& polygon, const Area& area) {
    const glm::dvec2 middle = middle_of(polygon);
    std::vector<glm::dvec2> spots{middle};
    const auto& vertices = polygon.vertices;
    for (const double share : {0.4, 0.6, 0.75}) {
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            const glm::dvec2 a(vertices[i]);
            const glm::dvec2 b(vertices[(i + 1) % vertices.size()]);
            spots.push_back(middle + (a - middle) * share);
            spots.push_back(middle + ((a + b) / 2. - middle) * share);
        }
    }
    constexpr int cells = 24;
    std::vector<glm::dvec2> elsewhere;
    for (int i = 0; i < cells; ++i) {
        for (int j = 0; j < cells; ++j) {
            elsewhere.emplace_back(area.x + (i + 0.5) * area.width / cells, area.y + (j + 0.5) * area.height / cells);
        }
    }
    const auto distance = [&](glm::dvec2 spot) { return std::hypot(spot.x - middle.x, spot.y - middle.y); };
    std::stable_sort(elsewhere.begin(), elsewhere.end(), [&](auto a, auto b) { return distance(a) < distance(b); });
    spots.insert(spots.end(), elsewhere.begin(), elsewhere.end());
    return spots;
}

}  // namespace

void draw_outlines(Drawing& to, const Moment& moment, const Plane& plane, const Style& style) {
    const auto& polygons = moment.scene().polygons;
    const auto in_hand = polygon_in_hand(moment);
    const double usual = polygons.size() > most_outlines ? Stroke::hairline : 0.6;
    const auto draw = [&](const ScenePolygon& polygon, double width) {
        const Stroke stroke{deep(polygon.color, style.greyscale), width};
        to.add(Path{clipped(plane.outline(polygon), true, plane.shown), false, {}, stroke});
    };
    for (const auto& polygon : polygons) draw(polygon, usual);
    if (in_hand) draw(polygons[std::size_t(*in_hand)], 1);
}

void draw_names(Drawing& to, const Scene& scene, const Plane& plane, const Style& style) {
    if (scene.polygons.size() > most_names) return;
    const Box area = plane.box(whole_area(plane.area));
    const Box middle_row{area.x, area.y + area.height / 2, area.width, 0};
    const Box middle_column{area.x + area.width / 2, area.y, 0, area.height};
    std::vector<Box> taken;
    for (const auto& polygon : scene.polygons) {
        const double width = style.letters * width_of(polygon.id, name_size, true) + 0.8;
        const double height = 0.72 * name_size / points_per_millimetre + 1;
        const auto box_at = [&](glm::dvec2 spot) {
            const Point at = plane.at(spot.x, spot.y);
            return Box{at.x - width / 2, at.y - height / 2, width, height};
        };
        const auto others_at = [&](glm::dvec2 spot) {
            return std::count_if(scene.polygons.begin(), scene.polygons.end(),
                                 [&](const auto& other) { return &other != &polygon && holds(other, spot); });
        };
        const auto outlines_at = [&](const Box& box) {
            return std::count_if(scene.polygons.begin(), scene.polygons.end(),
                                 [&](const auto& each) { return !clipped(plane.outline(each), true, box).empty(); });
        };
        // An id stands in its polygon, if it can be in no other, off outlines, and off the lines of the first windows.
        const auto far = 16 * std::ptrdiff_t(scene.polygons.size());
        std::optional<Box> best;
        auto least = std::numeric_limits<std::ptrdiff_t>::max();
        for (const auto spot : spots_in(polygon, plane.area)) {
            const Box box = box_at(spot);
            const bool free = plane.shown.holds(box) &&
                              std::none_of(taken.begin(), taken.end(), [&](const Box& t) { return t.overlaps(box); });
            if (!free) continue;
            const bool cuts = box.overlaps(middle_row) || box.overlaps(middle_column);
            const auto badness = 8 * others_at(spot) + (holds(polygon, spot) ? 0 : far) + 2 * outlines_at(box) + cuts;
            if (badness >= least) continue;
            least = badness;
            best = box;
        }
        if (!best) continue;
        taken.push_back(*best);
        to.add(rectangle(*best, paper, Stroke{ink}));
        to.add(Label{polygon.id, {best->x + width / 2, best->bottom() - 0.5}, name_size, Anchor::middle, true, ink});
    }
}

}  // namespace vidno::figures
