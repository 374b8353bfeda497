// The points and numbers that Weiler and Atherton's algorithm finds equal, against a count in rationals that uses the scene and the picture
// rule. The zeros with a meaning in geometry are counted in region_coincidences_test.cpp.

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "support/in_rationals.h"
#include "support/outlines.h"
#include "support/scenes.h"
#include "support/zeros.h"

using namespace vidno;
using namespace vidno::test;

namespace {

struct EqualNumbers {
    /// Ends of two edges, or vertices of two regions.
    std::set<Place> common;
    /// Sides of two boxes that touch.
    std::set<Rational> of_boxes;
    /// The y of a vertex, and of the middle of a piece of an edge.
    std::set<Rational> on_rays;
    /// Such sides, too; the y of a vertex on a row of centres, and the x at which two edges meet there.
    std::set<Rational> at_painting;
};

struct BoxOf {
    Rational xmin, ymin, xmax, ymax;
};

BoxOf box_of(const std::vector<Places>& outlines) {
    const Place& first = outlines.at(0).at(0);
    BoxOf box{first.first, first.second, first.first, first.second};
    for (const auto& outline : outlines) {
        for (const auto& [x, y] : outline) {
            box = {std::min<Rational>(box.xmin, x), std::min<Rational>(box.ymin, y), std::max<Rational>(box.xmax, x),
                   std::max<Rational>(box.ymax, y)};
        }
    }
    return box;
}

/// Adds the sides that touch, up to the first by which the boxes lie apart. Returns whether they do.
bool lie_apart(const BoxOf& p, const BoxOf& q, std::set<Rational>& touching) {
    for (const auto& [low, high] :
         {std::pair(p.xmin, q.xmax), std::pair(q.xmin, p.xmax), std::pair(p.ymin, q.ymax), std::pair(q.ymin, p.ymax)}) {
        if (low == high) touching.insert(low);
        if (low >= high) return true;
    }
    return false;
}

bool has_area(const Places& outline) {
    return std::any_of(outline.begin(), outline.end(),
                       [&](const Place& v) { return cross(outline[0], outline[1], v) != 0; });
}

/// The convex parts of a convex outline outside another one.
std::vector<Places> difference(Places subject, const Places& clip) {
    std::vector<Places> parts;
    const Rational turn = cross(clip[0], clip[1], clip[2]);
    for_each_edge_of(clip, [&](const Place& from, const Place& to) {
        Places part = cut_off(subject, [&](const Place& place) -> Rational { return cross(from, to, place) * turn; });
        if (part.size() > 2 && has_area(part)) parts.push_back(std::move(part));
        subject = part_inside(subject, from, to, turn);
    });
    return parts;
}

/// Where two edges cross between their ends.
std::optional<Place> crossing(const EdgeOf& e, const EdgeOf& f) {
    const Rational from = over(f.line(), e.from), to = over(f.line(), e.to);
    const Rational of_from = over(e.line(), f.from), of_to = over(e.line(), f.to);
    if (from * to >= 0 || of_from * of_to >= 0) return std::nullopt;
    const Rational part = from / (from - to);
    return Place{e.from.first + (e.to.first - e.from.first) * part,
                 e.from.second + (e.to.second - e.from.second) * part};
}

bool is_on(const EdgeOf& edge, const Place& place) {
    const auto& [low, high] = std::minmax(edge.from, edge.to);
    return cross(edge.from, edge.to, place) == 0 && low <= place && place <= high;
}

/// The vertices of one region on the rays from the middles of the pieces into which it cuts the edges of another one. Pieces on its
/// outline have no ray.
void add_vertices_on_rays(const Outlines& cut, const Outlines& cutting, std::set<Rational>& on_rays) {
    const auto cutting_edges = edges_of(cutting);
    for (const auto& edge : edges_of(cut)) {
        std::set<Place> ends{edge.from, edge.to};
        for (const auto& other : cutting_edges) {
            if (is_on(edge, other.from)) ends.insert(other.from);
            if (const auto at = crossing(edge, other)) ends.insert(*at);
        }
        for (auto from = ends.begin(), to = std::next(from); to != ends.end(); ++from, ++to) {
            const Place middle{(from->first + to->first) / 2, (from->second + to->second) / 2};
            const auto holds_middle = [&](const EdgeOf& other) { return is_on(other, middle); };
            if (std::any_of(cutting_edges.begin(), cutting_edges.end(), holds_middle)) continue;
            for (const auto& other : cutting_edges) {
                if (other.from.second == middle.second) on_rays.insert(middle.second);
            }
        }
    }
}

void add_clip(const Places& subject, const Places& clip, EqualNumbers& found) {
    add_vertices_on_rays({subject}, {clip}, found.on_rays);
    add_vertices_on_rays({clip}, {subject}, found.on_rays);
    found.common.merge(coincidences({subject}, {clip}).common);
}

bool is_centre_of_row(const Area& area, const Rational& y) {
    for (int row = area.y; row < area.bottom(); ++row) {
        if (y == Rational(row) + half) return true;
    }
    return false;
}

/// The vertices of a difference on the centre lines of rows. They are crossings, since the polygons' corners are between rows.
void add_vertices_on_rows(const Area& area, const Places& subject, const Places& clip, std::set<Rational>& on_rows) {
    const auto is_inside = [](const Places& outline, const EdgeOf& edge, const Place& place) {
        return cross(edge.from, edge.to, place) * cross(outline[0], outline[1], outline[2]) > 0;
    };
    for (const auto& edge : edges_of({subject})) {
        for (const auto& other : edges_of({clip})) {
            const auto at = crossing(edge, other);
            if (!at || !is_centre_of_row(area, at->second)) continue;
            on_rows.insert(at->second);
            // The outline follows the subject's edge outside the clip polygon, and that polygon's edge inside the subject.
            const Place& outer = is_inside(clip, other, edge.from) ? edge.to : edge.from;
            const Place& inner = is_inside(subject, edge, other.from) ? other.from : other.to;
            if ((outer.second < at->second) == (inner.second < at->second)) on_rows.insert(at->first);
        }
    }
}

/// Of two level polygons strictly inside the area, with corners at whole numbers.
EqualNumbers equal_numbers(const Scene& scene) {
    EqualNumbers found;
    const std::array outlines{outline_of(scene.polygons[0]), outline_of(scene.polygons[1])};
    const Area& area = scene.area;
    const Places whole{
        {area.x, area.y}, {area.right(), area.y}, {area.right(), area.bottom()}, {area.x, area.bottom()}};

    // Edges are sorted by their lesser ends and then by the others, each edge once.
    std::map<Place, std::set<Place>> sorted;
    for (const auto& edge : edges_of({whole, outlines[0], outlines[1]})) {
        const auto& [lesser, greater] = std::minmax(edge.from, edge.to);
        auto& ends = sorted[lesser];
        if (!ends.empty()) found.common.insert(lesser);
        if (!ends.insert(greater).second) found.common.insert(greater);
    }
    for (const auto& outline : outlines) add_clip(outline, whole, found);

    const std::array boxes{box_of({outlines[0]}), box_of({outlines[1]})};
    lie_apart(boxes[1], boxes[0], found.of_boxes);

    // The nearer one clips the other.
    const auto nearer = std::size_t(scene.polygons[0].vertices[0].z < scene.polygons[1].vertices[0].z);
    const std::size_t farther = 1 - nearer;
    std::vector<Places> visible{outlines[farther]};
    if (!lie_apart(boxes[farther], boxes[nearer], found.of_boxes)) {
        add_clip(outlines[farther], outlines[nearer], found);
        add_vertices_on_rows(area, outlines[farther], outlines[nearer], found.at_painting);
        visible = difference(outlines[farther], outlines[nearer]);
    }
    // What is visible of the second is compared with the first, which may be equally near.
    if (farther == 0) {
        lie_apart(boxes[0], boxes[1], found.at_painting);
    } else if (!visible.empty()) {
        lie_apart(boxes[0], box_of(visible), found.at_painting);
    }
    return found;
}

EqualNumbers listed_numbers(const std::vector<Finding>& zeros) {
    EqualNumbers listed;
    for (const auto& each : zeros) {
        CHECK_FALSE(has_operand(each, "pivot.x"));  // where the two outlines touch, no other edge goes straight on
        if (each.gap->if_zero == Coincidence::shared_points) {
            listed.common.emplace(exact_operand(each, "p.x"), exact_operand(each, "p.y"));
        }
        if (each.gap->if_zero != Coincidence::equal_numbers) continue;
        const Rational number = exact_operand(each, "a");
        switch (each.procedure) {
            case Procedure::weiler_atherton:
            case Procedure::split_piercing: listed.of_boxes.insert(number); break;
            case Procedure::region_clip: listed.on_rays.insert(number); break;
            case Procedure::paint_regions: listed.at_painting.insert(number); break;
            case Procedure::depth_sort: break;  // depths
            default: FAIL("equal numbers at step " << each.step);
        }
    }
    return listed;
}

}  // namespace

TEST_CASE("On 1,000 scenes of two level polygons the equal points and numbers are those of their outlines") {
    RandomScenes random(53);
    std::size_t common = 0, boxes = 0, on_rays = 0, at_painting = 0;
    for (int i = 0; i < 1000 / thinning; ++i) {
        CAPTURE(i);
        const AdmittedScene scene = two_level_polygons(random);
        const EqualNumbers expected = equal_numbers(*scene);
        const EqualNumbers listed =
            listed_numbers(of_kind(checked(scene, Method::weiler_atherton, "filtered", 0), FindingKind::zero));
        CHECK(listed.common == expected.common);
        CHECK(listed.of_boxes == expected.of_boxes);
        CHECK(listed.on_rays == expected.on_rays);
        CHECK(listed.at_painting == expected.at_painting);
        common += expected.common.size();
        boxes += expected.of_boxes.size();
        on_rays += expected.on_rays.size();
        at_painting += expected.at_painting.size();
    }
    CHECK(common > 1000 / thinning);
    CHECK(boxes > 100 / thinning);
    CHECK(on_rays > 300 / thinning);
    CHECK(at_painting > 300 / thinning);
}
