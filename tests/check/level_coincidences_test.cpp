// All exact zeros that the list of decisions has for Weiler and Atherton's algorithm in scenes of two level polygons, against a count in
// rationals that uses the scene and the picture rule. region_coincidences_test.cpp counts those of other scenes, kind by kind.

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "support/in_rationals.h"
#include "support/outlines.h"
#include "support/scenes.h"
#include "support/zeros.h"

using namespace vidno;
using namespace vidno::test;

namespace {

/// Two level polygons strictly inside the area, with corners on few whole numbers.
AdmittedScene two_level_polygons(RandomScenes& random) {
    SceneBuilder builder({0, 0, 8, 8});
    for (int i = 0; i < 2; ++i) {
        const double z = random.whole(0, 1) / 4.;
        const auto at = [&] { return double(random.whole(1, 7)); };
        if (random.whole(0, 2) == 0) {
            const int left = random.whole(1, 5), top = random.whole(1, 5);
            // Not as arguments, which each compiler evaluates in its own order.
            const int width = random.whole(1, 7 - left), height = random.whole(1, 7 - top);
            builder.quad(left, top, left + width, top + height, z);
            continue;
        }
        Corners corners;
        do {
            corners = {{at(), at(), z}, {at(), at(), z}, {at(), at(), z}};
        } while (cross(place_of(corners[0]), place_of(corners[1]), place_of(corners[2])) == 0);
        builder.polygon(corners);
    }
    return builder.build();
}

using Pixels = std::set<std::pair<int, int>>;

struct Zeros {
    /// Vertices on lines of the other polygon.
    std::set<PointOnLine> on_lines;
    /// Ends of two edges, or vertices of two regions.
    std::set<Place> common;
    /// Sides of two boxes that touch.
    std::set<Rational> of_boxes;
    /// The y of a vertex, and of the middle of a piece of an edge.
    std::set<Rational> on_rays;
    /// Sides of boxes, too; the y of a vertex on a row of centres, and the x at which two edges meet there.
    std::set<Rational> at_painting;
    /// Centres at the end of a visible region on its row.
    Pixels at_ends;
    /// Centres of the second polygon's region, in the box of the first, where both are equally near; and those on the first one's outline.
    Pixels equally_near, on_outlines;
    /// Equal depths in DepthSort and in RemoveBehind, and parallel planes.
    int of_sort = 0, of_planes = 0, parallel = 0;
};

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

/// The vertices of one region on the rays from the middles of the pieces into which it cuts the edges of another one. Pieces on its
/// outline have no ray.
void add_vertices_on_rays(const Outlines& cut, const Outlines& cutting, std::set<Rational>& on_rays) {
    const auto cutting_edges = edges_of(cutting);
    for (const auto& edge : edges_of(cut)) {
        std::set<Place> ends{edge.from, edge.to};
        for (const auto& other : cutting_edges) {
            if (edge.holds(other.from)) ends.insert(other.from);
            if (const auto at = crossing(edge, other)) ends.insert(*at);
        }
        for (auto from = ends.begin(), to = std::next(from); to != ends.end(); ++from, ++to) {
            const Place middle{(from->first + to->first) / 2, (from->second + to->second) / 2};
            const auto holds_middle = [&](const EdgeOf& other) { return other.holds(middle); };
            if (std::any_of(cutting_edges.begin(), cutting_edges.end(), holds_middle)) continue;
            for (const auto& other : cutting_edges) {
                if (other.from.second == middle.second) on_rays.insert(middle.second);
            }
        }
    }
}

void add_clip(const Places& subject, const Places& clip, Zeros& found) {
    add_vertices_on_rays({subject}, {clip}, found.on_rays);
    add_vertices_on_rays({clip}, {subject}, found.on_rays);
    Coincidences coincident = coincidences({subject}, {clip});
    found.on_lines.merge(coincident.on_lines);
    found.common.merge(coincident.common);
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

bool is_on_outline(const Places& outline, const Place& place) {
    const auto edges = edges_of({outline});
    return std::any_of(edges.begin(), edges.end(), [&](const EdgeOf& edge) { return edge.holds(place); });
}

/// Whether a closed convex outline holds a place.
bool holds(const Places& outline, const Place& place) {
    const Rational turn = cross(outline[0], outline[1], outline[2]);
    const auto edges = edges_of({outline});
    return std::all_of(edges.begin(), edges.end(),
                       [&](const EdgeOf& edge) { return cross(edge.from, edge.to, place) * turn >= 0; });
}

/// The scene has two level polygons strictly inside the area, with corners at whole numbers.
Zeros expected_zeros(const Scene& scene) {
    Zeros found;
    const std::array outlines{outline_of(scene.polygons[0]), outline_of(scene.polygons[1])};
    const std::array boxes{box_of({outlines[0]}), box_of({outlines[1]})};
    const double z = scene.polygons[0].vertices[0].z, other_z = scene.polygons[1].vertices[0].z;
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

    if (!lie_apart(boxes[1], boxes[0], found.of_boxes)) found.parallel = 1;
    // All vertices of a polygon are as deep as its first one.
    found.of_sort = int(outlines[0].size() - 1 + outlines[1].size() - 1) + (z == other_z ? 1 : 0);

    // The nearer one clips the other.
    const auto nearer = std::size_t(z < other_z), farther = 1 - nearer;
    std::vector<Places> visible{outlines[farther]};
    if (!lie_apart(boxes[farther], boxes[nearer], found.of_boxes)) {
        add_clip(outlines[farther], outlines[nearer], found);
        add_vertices_on_rows(area, outlines[farther], outlines[nearer], found.at_painting);
        visible = difference(outlines[farther], outlines[nearer]);
        if (z == other_z && overlap(outlines[0], outlines[1])) found.of_planes = 1;
    }
    // What is visible of the second is compared with the first, which may be equally near.
    if (farther == 0) {
        lie_apart(boxes[0], boxes[1], found.at_painting);
    } else if (!visible.empty()) {
        lie_apart(boxes[0], box_of(visible), found.at_painting);
    }
    for (int y = area.y; y < area.bottom(); ++y) {
        for (int x = area.x; x < area.right(); ++x) {
            const Place centre{Rational(x) + half, Rational(y) + half};
            const bool is_visible =
                std::any_of(visible.begin(), visible.end(), [&](const Places& part) { return holds(part, centre); });
            const bool is_on_first = is_on_outline(outlines[0], centre),
                       is_on_second = is_on_outline(outlines[1], centre);
            if (is_visible && (is_on_first || is_on_second)) found.at_ends.emplace(x, y);
            if (nearer == 0 ? is_on_first : is_on_second) found.at_ends.emplace(x, y);
            const auto& [xmin, ymin, xmax, ymax] = boxes[0];
            const bool is_in_box =
                xmin <= centre.first && centre.first <= xmax && ymin <= centre.second && centre.second <= ymax;
            if (z != other_z || !is_visible || !is_in_box) continue;
            found.equally_near.emplace(x, y);
            if (is_on_first) found.on_outlines.emplace(x, y);
        }
    }
    return found;
}

Zeros listed_zeros(const std::vector<Finding>& zeros) {
    using enum Procedure;
    using enum Coincidence;
    Zeros listed;
    for (const auto& each : zeros) {
        const auto is = [&](Procedure procedure, Coincidence coincidence) {
            return each.procedure == procedure && each.gap->if_zero == coincidence;
        };
        const std::pair pixel{each.pixels.x, each.pixels.y};
        if (each.gap->if_zero == shared_points) {
            listed.common.emplace(exact_operand(each, "p.x"), exact_operand(each, "p.y"));
        } else if (is(region_clip, point_on_line)) {
            listed.on_lines.insert(point_on_line_of(each));
        } else if (is(weiler_atherton, equal_numbers) || is(split_piercing, equal_numbers)) {
            listed.of_boxes.insert(exact_operand(each, "a"));
        } else if (is(region_clip, equal_numbers)) {
            listed.on_rays.insert(exact_operand(each, "a"));
        } else if (is(paint_regions, equal_numbers)) {
            listed.at_painting.insert(exact_operand(each, "a"));
        } else if (is(paint_regions, on_pixel_centre)) {
            listed.at_ends.insert(pixel);
        } else if (is(paint_regions, equal_depths)) {
            listed.equally_near.insert(pixel);
        } else if (is(paint_regions, point_on_line)) {
            listed.on_outlines.emplace(int(std::floor(CGAL::to_double(exact_operand(each, "p.x")))),
                                       int(std::floor(CGAL::to_double(exact_operand(each, "p.y")))));
        } else if (is(depth_sort, equal_numbers)) {
            ++listed.of_sort;
        } else if (is(remove_behind, equal_depths)) {
            ++listed.of_planes;
        } else if (is(split_piercing, parallel_lines)) {
            ++listed.parallel;
        } else {
            FAIL("an uncounted kind at step " << each.step);
        }
    }
    return listed;
}

}  // namespace

TEST_CASE("On 1,000 scenes of two level polygons the zeros are those of the scene") {
    RandomScenes random(56);
    std::map<std::string, std::size_t> counts;
    for (int i = 0; i < 1000 / thinning; ++i) {
        CAPTURE(i);
        const AdmittedScene scene = two_level_polygons(random);
        const Zeros expected = expected_zeros(*scene);
        const Zeros listed =
            listed_zeros(of_kind(checked(scene, Method::weiler_atherton, "filtered", 0), FindingKind::zero));
        CHECK(listed.on_lines == expected.on_lines);
        CHECK(listed.common == expected.common);
        CHECK(listed.of_boxes == expected.of_boxes);
        CHECK(listed.on_rays == expected.on_rays);
        CHECK(listed.at_painting == expected.at_painting);
        CHECK(listed.at_ends == expected.at_ends);
        CHECK(listed.equally_near == expected.equally_near);
        CHECK(listed.on_outlines == expected.on_outlines);
        CHECK(listed.of_sort == expected.of_sort);
        CHECK(listed.of_planes == expected.of_planes);
        CHECK(listed.parallel == expected.parallel);
        counts["on lines"] += expected.on_lines.size();
        counts["common"] += expected.common.size();
        counts["boxes"] += expected.of_boxes.size();
        counts["on rays"] += expected.on_rays.size();
        counts["at painting"] += expected.at_painting.size();
        counts["at ends"] += expected.at_ends.size();
        counts["equally near"] += expected.equally_near.size();
        counts["on outlines"] += expected.on_outlines.size();
        counts["of planes"] += std::size_t(expected.of_planes);
    }
    for (const auto& each : counts) {
        CAPTURE(each.first);
        CHECK(each.second > 100 / thinning);
    }
    CHECK(counts["common"] > 1000 / thinning);
    CHECK(counts["on lines"] > 1000 / thinning);
    CHECK(counts["at ends"] > 1000 / thinning);
}
