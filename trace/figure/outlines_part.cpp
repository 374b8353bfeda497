#include <array>
#include <cmath>
#include <glm/vec2.hpp>
#include <set>
#include <string_view>
#include <tuple>

#include "parts.h"
#include "table.h"

namespace vidno::figures {

namespace {

constexpr std::size_t most_names = 26;
constexpr double name_size = 8;

glm::dvec2 middle_of(const ScenePolygon& polygon) {
    glm::dvec2 sum{0, 0};
    for (const auto& vertex : polygon.vertices) sum += glm::dvec2(vertex);
    return sum / double(polygon.vertices.size());
}

/// Whether the polygon is convex and the point lies inside; an approximate answer is enough for placing a name.
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

/// The places for a name: between the middle and the corners and edges, then anywhere, the nearest to the middle first.
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

/// Gives each name its box: in its polygon, if possible in no other, and clear of outlines and of the lines of the
/// first windows.
class NamePlaces {
public:
    NamePlaces(const Scene& scene, const Plane& plane) : scene_(scene), plane_(plane) {
        const Box area = plane.box(whole_area(plane.area));
        middle_row_ = {area.x, area.y + area.height / 2, area.width, 0};
        middle_column_ = {area.x + area.width / 2, area.y, 0, area.height};
    }

    /// None if there is no room.
    std::optional<Box> take(const ScenePolygon& polygon, double width, double height) {
        std::optional<Box> best;
        std::ptrdiff_t least = 0;
        for (const auto spot : spots_in(polygon, plane_.area)) {
            const Point at = plane_.at(spot.x, spot.y);
            const Box box{at.x - width / 2, at.y - height / 2, width, height};
            if (!is_free(box)) continue;
            const auto badness = badness_of(polygon, spot, box);
            if (best && badness >= least) continue;
            least = badness;
            best = box;
        }
        if (best) taken_.push_back(*best);
        return best;
    }

private:
    bool is_free(const Box& box) const {
        return plane_.shown.holds(box) &&
               std::none_of(taken_.begin(), taken_.end(), [&](const Box& each) { return each.overlaps(box); });
    }

    std::ptrdiff_t badness_of(const ScenePolygon& own, glm::dvec2 spot, const Box& box) const {
        const auto& polygons = scene_.polygons;
        const auto others = std::count_if(polygons.begin(), polygons.end(),
                                          [&](const ScenePolygon& each) { return &each != &own && holds(each, spot); });
        const auto outlines = std::count_if(polygons.begin(), polygons.end(), [&](const ScenePolygon& each) {
            return !clipped(plane_.outline(each), true, box).empty();
        });
        const bool on_window = box.overlaps(middle_row_) || box.overlaps(middle_column_);
        const auto outside = holds(own, spot) ? 0 : 16 * std::ptrdiff_t(polygons.size());
        return outside + 8 * others + 2 * outlines + on_window;
    }

    const Scene& scene_;
    const Plane& plane_;
    Box middle_row_, middle_column_;
    std::vector<Box> taken_;
};

/// The edges of the polygons that are parts of faces, each in its direction.
class EdgesOfFaces {
public:
    explicit EdgesOfFaces(const Scene& scene) {
        for (const auto& polygon : scene.polygons) {
            if (polygon.face.empty()) continue;
            for (std::size_t i = 0; i < polygon.vertices.size(); ++i) edges_.insert(edge(polygon, i, i + 1));
        }
    }

    /// Whether another part of the polygon's face has the edge from this vertex, in the opposite direction.
    bool meets_part(const ScenePolygon& polygon, std::size_t i) const {
        return !polygon.face.empty() && edges_.contains(edge(polygon, i + 1, i));
    }

private:
    using Edge = std::tuple<std::string_view, std::array<double, 6>>;

    static Edge edge(const ScenePolygon& polygon, std::size_t from, std::size_t to) {
        const auto &p = polygon.vertices[from % polygon.vertices.size()],
                   &q = polygon.vertices[to % polygon.vertices.size()];
        return {polygon.face, {p.x, p.y, p.z, q.x, q.y, q.z}};
    }

    std::set<Edge> edges_;
};

/// The outline of a polygon, without the edges inside its face.
std::vector<Polyline> drawn_outline(const ScenePolygon& polygon, const EdgesOfFaces& edges, const Plane& plane) {
    if (polygon.face.empty()) return clipped(plane.outline(polygon), true, plane.shown);
    std::vector<Polyline> lines;
    const Polyline outline = plane.outline(polygon);
    for (std::size_t i = 0; i < outline.size(); ++i) {
        if (edges.meets_part(polygon, i)) continue;
        for (auto& line : clipped({outline[i], outline[(i + 1) % outline.size()]}, false, plane.shown)) {
            lines.push_back(std::move(line));
        }
    }
    return lines;
}

}  // namespace

void draw_outlines(Drawing& to, const Moment& moment, const Plane& plane, const Style& style) {
    const auto& polygons = moment.scene().polygons;
    const EdgesOfFaces edges(moment.scene());
    const auto current = current_polygon(moment);
    const double usual = polygons.size() > most_outlines ? Stroke::hairline : 0.6;
    const auto draw = [&](const ScenePolygon& polygon, double width) {
        const Stroke stroke{deep(polygon.color, style.greyscale), width};
        to.add(Path{drawn_outline(polygon, edges, plane), false, {}, stroke});
    };
    for (const auto& polygon : polygons) draw(polygon, usual);
    if (current) draw(polygons[std::size_t(*current)], 1);
}

void draw_names(Drawing& to, const Scene& scene, const Plane& plane, const Style& style) {
    constexpr double around = 0.4, longest = 20;  // millimetres
    if (scene.polygons.size() > most_names) return;
    const double height = 0.72 * name_size / points_per_millimetre + 1;
    NamePlaces places(scene, plane);
    for (const auto& polygon : scene.polygons) {
        const std::string name = fitted(polygon.id, longest, name_size, true);
        const double width = style.letters * width_of(name, name_size, true) + 2 * around;
        const auto box = places.take(polygon, width, height);
        if (!box) continue;
        to.add(rectangle(*box, paper, Stroke{ink}));
        to.add(Label{name, {box->x + width / 2, box->bottom() - 0.5}, name_size, Anchor::middle, true, ink});
    }
}

}  // namespace vidno::figures
