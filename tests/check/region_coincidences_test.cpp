// The exact zeros of all kinds that the list of decisions has for Weiler and Atherton's algorithm, against a count in
// rationals. The count uses the scene and nothing of a run. Its regions are sets of the cells into which all lines of a
// scene divide the plane.

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <initializer_list>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "support/cells.h"
#include "support/in_rationals.h"
#include "support/outlines.h"
#include "support/scenes.h"
#include "support/zeros.h"
#include "vidno/admission.h"

using namespace vidno;
using namespace vidno::test;

namespace {

using Pixels = std::set<std::pair<int, int>>;

struct Zeros {
    /// Points on lines in RegionClip and in SplitPiercing.
    std::set<PointOnLine> in_clip, in_split;
    /// Ends of two edges, or vertices of two regions.
    std::set<Place> common;
    /// Sides of two boxes that touch, in SplitPiercing and for each list.
    std::set<Rational> of_boxes;
    /// The y of a vertex, and of the middle of a piece of an edge.
    std::set<Rational> on_rays;
    /// In PaintRegions: sides of boxes, too, those through a centre, the y of a vertex on a row of centres, and the x
    /// at which two edges meet there.
    std::set<Rational> at_painting;
    /// Centres at the end of a visible region on its row, with two equally near polygons, and on the outline of an
    /// equally near one.
    Pixels at_ends, equally_near, on_outlines;
    /// Equal depths in DepthSort and in RemoveBehind, and parallel planes.
    int of_sort = 0, of_planes = 0, parallel_planes = 0;
    /// Lines of edges that end at one vertex and lie on one line.
    std::set<LineThrough> parallel_edges;
    /// Vertices at which outlines touch and may go straight ahead along another line.
    std::set<Place> straight_ahead;

    /// visit(name, member) for each kind.
    static void for_each_kind(auto&& visit) {
        visit("in clip", &Zeros::in_clip);
        visit("in split", &Zeros::in_split);
        visit("common", &Zeros::common);
        visit("boxes", &Zeros::of_boxes);
        visit("on rays", &Zeros::on_rays);
        visit("at painting", &Zeros::at_painting);
        visit("at ends", &Zeros::at_ends);
        visit("equally near", &Zeros::equally_near);
        visit("on outlines", &Zeros::on_outlines);
        visit("of sort", &Zeros::of_sort);
        visit("of planes", &Zeros::of_planes);
        visit("parallel planes", &Zeros::parallel_planes);
        visit("parallel edges", &Zeros::parallel_edges);
        visit("straight ahead", &Zeros::straight_ahead);
    }
};

std::size_t count_of(int count) { return std::size_t(count); }
std::size_t count_of(const auto& zeros) { return zeros.size(); }

/// Adds the sides that touch, up to the first by which the boxes lie apart. Returns whether they do.
bool lie_apart(const BoxOf& p, const BoxOf& q, std::set<Rational>& touching) {
    for (const auto& [low, high] :
         {std::pair(p.xmin, q.xmax), std::pair(q.xmin, p.xmax), std::pair(p.ymin, q.ymax), std::pair(q.ymin, p.ymax)}) {
        if (low == high) touching.insert(low);
        if (low >= high) return true;
    }
    return false;
}

/// Where two edges cross between their ends.
std::optional<Place> crossing(const EdgeOf& e, const EdgeOf& f) {
    const Rational from = over(f.line(), e.from), to = over(f.line(), e.to);
    const Rational of_from = over(e.line(), f.from), of_to = over(e.line(), f.to);
    if (from * to >= 0 || of_from * of_to >= 0) return std::nullopt;
    return zero_between(e.from, from, e.to, to);
}

/// A part of a polygon of the scene.
struct Part {
    int polygon;
    CellRegion region;
    bool is_ground = false;
};

/// Processes a scene, and collects the coincidences on which the algorithm decides.
class ExpectedZeros {
public:
    explicit ExpectedZeros(const AdmittedScene& scene) : scene_(scene), cells_(cells_of_all_lines()) {
        const CellRegion whole = region_of(corners_of_area());
        std::vector<Part> parts;
        for (int i = 0; i < int(scene_->polygons.size()); ++i) {
            if (scene_->polygons[std::size_t(i)].edge_on) continue;
            auto part = clip(region_of(corners_of(i)), whole).first;
            if (!part.empty()) parts.push_back({i, std::move(part)});
        }
        facets_ = split_piercing(std::move(parts));
        process_lists();
        for (const auto& part : visible_) paint(part);
    }

    Zeros found;

private:
    const ScenePolygon& polygon(int i) const { return scene_->polygons[std::size_t(i)]; }

    // Lines. Two edges have one line if they have the same ends, and two polygons if their planes meet.

    int line_number(const LineThrough& line) {
        lines_.push_back(line);
        return int(lines_.size()) - 1;
    }
    int line_between(const Place& p, const Place& q) const { return between_.at(std::minmax(p, q)); }

    Places corners_of_area() const {
        const Area& area = scene_->area;
        return {{area.x, area.y}, {area.right(), area.y}, {area.right(), area.bottom()}, {area.x, area.bottom()}};
    }

    /// Each place once, with the inside on the positive side.
    Places corners_of(int i) const {
        Places corners = outline_of(polygon(i));
        corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
        while (corners.size() > 1 && corners.back() == corners.front()) corners.pop_back();
        Rational doubled = 0;
        for_each_edge_of(corners, [&](const Place& p, const Place& q) { doubled += cross(corners[0], p, q); });
        if (doubled < 0) std::reverse(corners.begin(), corners.end());
        return corners;
    }

    /// Edges are sorted by their lesser ends and then by the others, each once.
    void add_edges(const Places& corners) {
        for_each_edge_of(corners, [&](const Place& from, const Place& to) {
            const std::pair<Place, Place> ends = std::minmax(from, to);
            const auto has_lesser = [&](const auto& each) { return each.first.first == ends.first; };
            if (std::any_of(between_.begin(), between_.end(), has_lesser)) found.common.insert(ends.first);
            if (between_.contains(ends)) {
                found.common.insert(ends.second);
            } else {
                between_[ends] = line_number(line_through(from, to));
            }
        });
    }

    Cells cells_of_all_lines() {
        add_edges(corners_of_area());
        for (int i = 0; i < int(scene_->polygons.size()); ++i) {
            if (polygon(i).edge_on) continue;
            const auto& v = polygon(i).vertices;
            for (std::size_t k = 0; k < v.size(); ++k) {
                if (k > 0 && place_of(v[k]) == place_of(v[k - 1])) found.common.insert(place_of(v[k]));
            }
            add_edges(corners_of(i));
            for (int j = 0; j < i; ++j) {
                if (polygon(j).edge_on) continue;
                if (const auto line = line_of_planes(polygon(i), polygon(j))) {
                    of_planes_[{i, j}] = line_number(*line);
                }
            }
        }
        std::set<LineThrough> lines(lines_.begin(), lines_.end());
        // A vertex on a straight side separates two edges, so a line must run through it.
        for (const auto& source : scene_->polygons) {
            const auto& v = source.vertices;
            for (std::size_t k = 0; k < v.size() && !source.edge_on; ++k) {
                const Place from = place_of(v[k]), at = place_of(v[(k + 1) % v.size()]);
                if (cross(from, at, place_of(v[(k + 2) % v.size()])) != 0 || from == at) continue;
                lines.insert(line_through(at, {at.first + at.second - from.second, at.second + from.first - at.first}));
            }
        }
        Places ends;
        for (const auto& each : between_) {
            ends.push_back(each.first.first);
            ends.push_back(each.first.second);
        }
        const auto [xmin, ymin, xmax, ymax] = box_of(ends);
        return {{{xmin - 1, ymin - 1}, {xmax + 1, ymin - 1}, {xmax + 1, ymax + 1}, {xmin - 1, ymax + 1}}, lines};
    }

    // Regions

    /// The outline begins at the first corner.
    CellRegion region_of(const Places& corners) const {
        std::set<int> inside;
        for (int cell = 0; cell < int(cells_.cells.size()); ++cell) {
            const Place middle = cells_.middle(cell);
            bool is_inside = true;
            for_each_edge_of(corners, [&](const Place& from, const Place& to) {
                is_inside = is_inside && cross(from, to, middle) > 0;
            });
            if (is_inside) inside.insert(cell);
        }
        std::vector<OutlineSegment> segments;
        for (const auto& segment : cells_.boundary(inside)) {
            const Place &begin = cells_.places[std::size_t(segment.first)],
                        &end = cells_.places[std::size_t(segment.second)];
            for_each_edge_of(corners, [&](const Place& from, const Place& to) {
                const EdgeOf edge{from, to};
                if (edge.holds(begin) && edge.holds(end)) segments.push_back({segment, line_between(from, to)});
            });
            if (begin == corners[0]) std::swap(segments.front(), segments.back());
        }
        return {cells_, std::move(inside), segments};
    }

    /// Both parts. What is on both outlines has the line of the subject.
    std::pair<CellRegion, CellRegion> clip(const CellRegion& subject, const CellRegion& clip_region) {
        add_common(subject, clip_region);
        add_points_on_lines(subject.edges, clip_region.edges);
        add_vertices_on_rays(subject, clip_region);
        add_vertices_on_rays(clip_region, subject);

        std::set<int> inside, outside;
        for (const int cell : subject.cells) (clip_region.cells.contains(cell) ? inside : outside).insert(cell);
        auto of_inside = subject.segments_from_last_vertex(), of_outside = of_inside;
        for (const auto& segment : clip_region.segments_from_last_vertex()) {
            of_inside.push_back(segment);
            of_outside.push_back(segment.reversed());
        }
        CellRegion in(cells_, std::move(inside), of_inside), out(cells_, std::move(outside), of_outside);
        for (const auto* part : {&in, &out}) {
            found.straight_ahead.insert(part->straight_ahead.begin(), part->straight_ahead.end());
        }
        return {std::move(in), std::move(out)};
    }

    /// Vertices are known to be at one place if they have the same two lines, which must not be parallel. Each is
    /// compared with those before it that are at other places; the last vertex of an outline comes first.
    void add_common(const CellRegion& subject, const CellRegion& clip_region) {
        std::vector<OutlineVertex> distinct;
        const auto add = [&](const OutlineVertex& vertex) {
            for (const auto& other : distinct) {
                if (vertex.before != vertex.after && other.on(vertex.before) && other.on(vertex.after)) {
                    const auto& line = lines_[std::size_t(vertex.before)];
                    if (line != lines_[std::size_t(vertex.after)]) return;
                    found.parallel_edges.insert(line);
                }
                if (other.at == vertex.at) {
                    found.common.insert(vertex.at);
                    return;
                }
            }
            distinct.push_back(vertex);
        };
        for (const auto* region : {&subject, &clip_region}) {
            for (const auto& loop : region->loops) {
                add(loop.back());
                std::for_each(loop.begin(), std::prev(loop.end()), add);
            }
        }
    }

    /// The vertices of an edge are known to be on its line. The line of the subject's edge is tested where it may meet
    /// an edge of the clip region, that is, where the line of that edge meets the subject's edge.
    void add_points_on_lines(const std::vector<OutlineEdge>& subject, const std::vector<OutlineEdge>& clip_edges) {
        const auto add = [&](const OutlineVertex& vertex, int line) {
            const auto& through = lines_[std::size_t(line)];
            if (!vertex.on(line) && over(through, vertex.at) == 0) found.in_clip.emplace(vertex.at, through);
        };
        for (const auto& e : subject) {
            for (const auto& f : clip_edges) {
                add(e.from, f.line());
                add(e.to, f.line());
                const auto& through = lines_[std::size_t(f.line())];
                if (over(through, e.from.at) * over(through, e.to.at) > 0) continue;
                add(f.from, e.line());
                add(f.to, e.line());
            }
        }
    }

    /// The vertices of one region on the rays from the middles of the pieces into which it cuts the edges of another
    /// one. Pieces on its outline have no ray.
    void add_vertices_on_rays(const CellRegion& cut, const CellRegion& cutting) {
        for (const auto& edge : cut.edges) {
            std::set<Place> ends{edge.from.at, edge.to.at};
            for (const auto& other : cutting.edges) {
                if (edge.places().holds(other.from.at)) ends.insert(other.from.at);
                if (const auto at = crossing(edge.places(), other.places())) ends.insert(*at);
            }
            for (auto from = ends.begin(), to = std::next(from); to != ends.end(); ++from, ++to) {
                const Place middle{(from->first + to->first) / 2, (from->second + to->second) / 2};
                const auto& edges = cutting.edges;
                const auto holds_middle = [&](const OutlineEdge& other) { return other.places().holds(middle); };
                if (std::any_of(edges.begin(), edges.end(), holds_middle)) continue;
                for (const auto& other : edges) {
                    if (other.from.at.second == middle.second) found.on_rays.insert(middle.second);
                }
            }
        }
    }

    // Polygons that pierce each other

    bool is_on_both_sides(const CellRegion& region, int line) {
        bool positive = false, negative = false;
        for (const auto& loop : region.loops) {
            for (const auto& vertex : loop) {
                const auto& through = lines_[std::size_t(line)];
                const Rational height = over(through, vertex.at);
                if (height == 0 && !vertex.on(line)) found.in_split.emplace(vertex.at, through);
                positive = positive || height > 0;
                negative = negative || height < 0;
            }
        }
        return positive && negative;
    }

    bool line_splits(const CellRegion& region, int line) {
        const auto& edges = region.edges;
        const auto is_on_line = [&](const OutlineEdge& edge) { return edge.line() == line; };
        return std::none_of(edges.begin(), edges.end(), is_on_line) && is_on_both_sides(region, line);
    }

    /// The parts on the positive and on the negative side. On the positive side the later polygon is nearer.
    std::pair<CellRegion, CellRegion> split(const CellRegion& region, int line, int later, int earlier) const {
        std::set<int> positive, negative;
        for (const int cell : region.cells) {
            const Place middle = cells_.middle(cell);
            const bool is_nearer = depth_at(polygon(later), middle) > depth_at(polygon(earlier), middle);
            (is_nearer ? positive : negative).insert(cell);
        }
        auto segments = region.segments();
        for (const auto& segment : cells_.boundary(positive)) {
            segments.push_back({segment, line});
            segments.push_back(segments.back().reversed());
        }
        return {CellRegion(cells_, std::move(positive), segments), CellRegion(cells_, std::move(negative), segments)};
    }

    std::vector<Part> split_piercing(std::vector<Part> parts) {
        std::set<std::pair<int, int>> are_parallel;
        for (std::size_t i = 1; i < parts.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                if (apart(parts[i], parts[j], found.of_boxes)) continue;
                const auto [earlier, later] = std::minmax({parts[i].polygon, parts[j].polygon});
                const auto known = of_planes_.find({later, earlier});
                if (known == of_planes_.end()) {
                    if (are_parallel.emplace(later, earlier).second) ++found.parallel_planes;
                    continue;
                }
                const int line = known->second;
                if (!line_splits(parts[i].region, line) || !line_splits(parts[j].region, line)) continue;
                const CellRegion common = clip(parts[i].region, parts[j].region).first;
                if (!is_on_both_sides(common, line)) continue;
                for (const std::size_t k : {i, j}) {
                    auto [positive, negative] = split(parts[k].region, line, later, earlier);
                    parts[k].region = std::move(positive);
                    parts.push_back({parts[k].polygon, std::move(negative)});
                }
            }
        }
        return parts;
    }

    // Lists

    static bool apart(const Part& a, const Part& b, std::set<Rational>& touching) {
        return a.polygon == b.polygon || lie_apart(a.region.box, b.region.box, touching);
    }

    std::vector<Part> depth_sort() {
        std::vector<std::pair<Rational, Part>> sorted;
        for (const auto& facet : facets_) {
            std::optional<Rational> greatest;
            for (const auto& vertex : facet.region.loops.front()) {
                const Rational z = depth_at(polygon(facet.polygon), vertex.at);
                if (greatest && z == *greatest) ++found.of_sort;
                greatest = greatest ? std::max<Rational>(*greatest, z) : z;
            }
            auto place = sorted.end();
            while (place != sorted.begin() && *greatest > std::prev(place)->first) --place;
            // A piece that is as deep as one before it is compared with it.
            if (place != sorted.begin() && *greatest == std::prev(place)->first) ++found.of_sort;
            sorted.insert(place, {*greatest, facet});
        }
        std::vector<Part> parts;
        for (auto& each : sorted) parts.push_back(std::move(each.second));
        return parts;
    }

    /// Whether a part inside another one is nearer. Equally near ones are compared by their places in the scene.
    bool is_nearer(const Part& part, const Part& clip_part) {
        Rational nearer = 0;
        for (const int cell : part.region.cells) {
            const Place middle = cells_.middle(cell);
            nearer = depth_at(polygon(part.polygon), middle) - depth_at(polygon(clip_part.polygon), middle);
            if (nearer != 0) break;
        }
        if (nearer == 0) ++found.of_planes;
        return nearer > 0 || (nearer == 0 && part.polygon < clip_part.polygon);
    }

    void process_lists() {
        std::vector<std::vector<Part>> lists;
        if (!facets_.empty()) lists.push_back(depth_sort());
        while (!lists.empty()) {
            std::vector<Part> list = std::move(lists.back());
            lists.pop_back();
            Part first = std::move(list.front());
            std::vector<Part> nearer, outside;
            for (auto part = std::next(list.begin()); part != list.end(); ++part) {
                if (apart(*part, first, found.of_boxes)) {
                    outside.push_back(std::move(*part));
                    continue;
                }
                auto [in, out] = clip(part->region, first.region);
                if (!out.empty()) outside.push_back({part->polygon, std::move(out), part->is_ground});
                if (in.empty() || part->is_ground) continue;
                Part inside{part->polygon, std::move(in)};
                if (is_nearer(inside, first)) nearer.push_back(std::move(inside));
            }
            if (!outside.empty()) lists.push_back(std::move(outside));
            if (nearer.empty()) {
                visible_.push_back(std::move(first));
            } else {
                first.is_ground = true;
                nearer.push_back(std::move(first));
                lists.push_back(std::move(nearer));
            }
        }
    }

    // The picture

    void paint(const Part& part) {
        const Area& area = scene_->area;
        std::vector<const Part*> earlier;
        for (const auto& facet : facets_) {
            if (facet.polygon < part.polygon && !apart(facet, part, found.at_painting)) earlier.push_back(&facet);
        }
        for (int y = area.y; y < area.bottom(); ++y) {
            for (const auto& [left, right] : ends_on(part.region, y)) {
                for (int x = area.x; x < area.right(); ++x) {
                    const Rational centre = Rational(x) + half;
                    if (centre == left || centre == right) found.at_ends.emplace(x, y);
                    if (left <= centre && centre <= right) paint(x, y, first_of_equals(part.polygon, earlier, x, y));
                }
            }
        }
    }

    /// The pairs of ends on a row, in two passes: vertices on it count as below it, and then as above it.
    std::vector<std::pair<Rational, Rational>> ends_on(const CellRegion& region, int row) {
        std::vector<std::pair<Rational, Rational>> pairs;
        for (const bool is_on_row_below : {true, false}) {
            const auto ends = ends_in_pass(region, row, is_on_row_below);
            for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
                if (ends[i] == ends[i + 1]) found.at_painting.insert(ends[i]);
                if (i % 2 == 0) pairs.emplace_back(ends[i], ends[i + 1]);
            }
        }
        return pairs;
    }

    std::vector<Rational> ends_in_pass(const CellRegion& region, int row, bool is_on_row_below) {
        const Rational y = Rational(row) + half;
        const auto is_below = [&](const Place& place) {
            return place.second == y ? is_on_row_below : place.second > y;
        };
        std::vector<Rational> ends;
        for (const auto& edge : region.edges) {
            const Place &from = edge.from.at, &to = edge.to.at;
            if (from.second == y) found.at_painting.insert(y);
            if (is_below(from) == is_below(to)) continue;
            ends.push_back(from.first + (y - from.second) * (to.first - from.first) / (to.second - from.second));
        }
        std::sort(ends.begin(), ends.end());
        return ends;
    }

    /// How much nearer the first of two polygons is at a centre.
    Rational how_much_nearer(int i, int j, int x, int y) {
        const Place centre = centre_of_pixel(x, y);
        const Rational nearer = depth_at(polygon(i), centre) - depth_at(polygon(j), centre);
        if (nearer == 0) found.equally_near.emplace(x, y);
        return nearer;
    }

    int first_of_equals(int own, const std::vector<const Part*>& earlier, int x, int y) {
        const Place centre = centre_of_pixel(x, y);
        int first = own;
        for (const auto* facet : earlier) {
            if (facet->polygon >= first || !is_in_box(facet->region.box, centre)) continue;
            if (how_much_nearer(facet->polygon, own, x, y) == 0 && holds(facet->region, x, y)) first = facet->polygon;
        }
        return first;
    }

    /// Whether a closed convex region holds a centre. Its row just above the centre is tested first, and then its
    /// outline.
    bool holds(const CellRegion& region, int x, int y) {
        const Place centre = centre_of_pixel(x, y);
        const auto ends = ends_in_pass(region, y, true);
        if (std::count(ends.begin(), ends.end(), centre.first) > 0) found.on_outlines.emplace(x, y);
        if (!ends.empty() && ends.front() <= centre.first && centre.first < ends.back()) return true;
        bool is_on_outline = false;
        for (const auto& edge : region.edges) {
            if (edge.from.at == centre) found.common.insert(centre);
            is_on_outline = is_on_outline || edge.places().holds(centre);
        }
        if (is_on_outline) found.on_outlines.emplace(x, y);
        return is_on_outline;
    }

    /// Adds the sides through a centre, up to the first beyond which it lies.
    bool is_in_box(const BoxOf& box, const Place& centre) {
        const auto& [x, y] = centre;
        for (const auto& [low, high] :
             {std::pair(box.ymin, y), std::pair(y, box.ymax), std::pair(box.xmin, x), std::pair(x, box.xmax)}) {
            if (low == high) found.at_painting.insert(low);
            if (low > high) return false;
        }
        return true;
    }

    void paint(int x, int y, int own) {
        const auto [known, is_new] = shown_.try_emplace({x, y}, own);
        if (is_new || known->second == own) return;
        const Rational nearer = how_much_nearer(own, known->second, x, y);
        if (nearer > 0 || (nearer == 0 && own < known->second)) known->second = own;
    }

    const AdmittedScene& scene_;
    std::vector<LineThrough> lines_;
    std::map<std::pair<Place, Place>, int> between_;
    std::map<std::pair<int, int>, int> of_planes_;  // of the later and the earlier polygon
    Cells cells_;
    std::vector<Part> facets_, visible_;
    std::map<std::pair<int, int>, int> shown_;
};

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
        } else if (is(region_clip, point_on_line) && has_operand(each, "pivot.x")) {
            listed.straight_ahead.emplace(exact_operand(each, "pivot.x"), exact_operand(each, "pivot.y"));
        } else if (is(region_clip, point_on_line)) {
            listed.in_clip.insert(point_on_line_of(each));
        } else if (is(split_piercing, point_on_line)) {
            listed.in_split.insert(point_on_line_of(each));
        } else if (is(weiler_atherton, equal_numbers) || is(split_piercing, equal_numbers)) {
            listed.of_boxes.insert(exact_operand(each, "a"));
        } else if (is(region_clip, equal_numbers)) {
            listed.on_rays.insert(exact_operand(each, "a"));
        } else if (is(region_clip, parallel_lines)) {
            listed.parallel_edges.insert(line_operand(each, "p"));
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
            ++listed.parallel_planes;
        } else {
            FAIL("an uncounted kind at step " << each.step);
        }
    }
    return listed;
}

using Counts = std::map<std::string, std::size_t>;

/// Compares the zeros of 1,000 scenes with those expected. Returns how many of each kind there are.
Counts check_zeros(unsigned seed, const std::function<AdmittedScene(RandomScenes&)>& scene_from) {
    RandomScenes random(seed);
    Counts counts;
    for (int i = 0; i < 1000 / thinning; ++i) {
        CAPTURE(i);
        const AdmittedScene scene = scene_from(random);
        const Zeros expected = ExpectedZeros(scene).found;
        const Zeros listed =
            listed_zeros(of_kind(checked(scene, Method::weiler_atherton, "filtered", 0), FindingKind::zero));
        Zeros::for_each_kind([&](const char* kind, auto member) {
            CAPTURE(kind);
            CHECK(listed.*member == expected.*member);
            counts[kind] += count_of(expected.*member);
        });
    }
    return counts;
}

void check_more_than(std::size_t least, Counts& counts, std::initializer_list<const char*> kinds) {
    for (const auto* kind : kinds) {
        CAPTURE(kind);
        CHECK(counts[kind] > least / thinning);
    }
}

// Scenes

/// A triangle strictly inside the area of 8 x 8 pixels, with corners on few whole numbers.
Corners triangle(RandomScenes& random, const std::function<double()>& depth) {
    Corners corners;
    do {
        corners.clear();
        for (int k = 0; k < 3; ++k) {
            const double x = random.whole(1, 7), y = random.whole(1, 7);
            corners.emplace_back(x, y, depth());
        }
    } while (cross(place_of(corners[0]), place_of(corners[1]), place_of(corners[2])) == 0);
    return corners;
}

/// Triangles and rectangles with two depths.
AdmittedScene two_level_polygons(RandomScenes& random) {
    SceneBuilder builder({0, 0, 8, 8});
    for (int i = 0; i < 2; ++i) {
        const double z = random.whole(0, 1) / 4.;
        if (random.whole(0, 2) != 0) {
            builder.polygon(triangle(random, [&] { return z; }));
            continue;
        }
        const int left = random.whole(1, 5), top = random.whole(1, 5);
        // Not as arguments, which each compiler evaluates in its own order.
        const int width = random.whole(1, 7 - left), height = random.whole(1, 7 - top);
        builder.quad(left, top, left + width, top + height, z);
    }
    return builder.build();
}

/// Tilted ones, which may pierce each other.
AdmittedScene tilted_triangles(RandomScenes& random) {
    SceneBuilder builder({0, 0, 8, 8});
    for (int count = random.whole(2, 3), i = 0; i < count; ++i) {
        builder.polygon(triangle(random, [&] { return random.whole(0, 3) / 4.; }));
    }
    return builder.build();
}

/// Three level polygons, the farthest first, each strictly inside the one before it. Their corners are on half pixels.
AdmittedScene nested_polygons(RandomScenes& random) {
    const auto turn = [](const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& v) {
        return (q.x - p.x) * (v.y - p.y) - (q.y - p.y) * (v.x - p.x);  // exact for small halves
    };
    const auto holds_all = [&](const Corners& outer, const Corners& inner) {
        const double orientation = turn(outer[0], outer[1], outer[2]);
        return std::all_of(inner.begin(), inner.end(), [&](const auto& v) {
            for (std::size_t i = 0; i < outer.size(); ++i) {
                if (turn(outer[i], outer[(i + 1) % outer.size()], v) * orientation <= 0) return false;
            }
            return true;
        });
    };
    const auto half_triangle = [&](double z) {
        Corners corners;
        for (int k = 0; k < 3; ++k) {
            const double x = random.whole(3, 13) / 2., y = random.whole(3, 13) / 2.;
            corners.emplace_back(x, y, z);
        }
        return corners;
    };
    while (true) {
        Corners quad{{1, 1, 0}, {7, 1, 0}, {7, 7, 0}, {1, 7, 0}};
        for (auto& corner : quad) {
            corner.x += random.whole(-1, 1) / 2.;
            corner.y += random.whole(-1, 1) / 2.;
        }
        const Corners middle = half_triangle(.25);
        for (int tries = 0; tries < 200; ++tries) {
            const Corners inner = half_triangle(.5);
            if (turn(inner[0], inner[1], inner[2]) == 0) continue;
            if (!holds_all(quad, middle) || !holds_all(middle, inner)) continue;
            return SceneBuilder({0, 0, 8, 8}).polygon(quad).polygon(middle).polygon(inner).build();
        }
    }
}

/// Four rectangles whose sides run through pixel centres. They touch, overlap and pierce each other; each is level or
/// tilted, with few depths at its sides.
AdmittedScene rectangles(RandomScenes& random) {
    SceneBuilder builder({0, 0, 8, 8});
    for (int i = 0; i < 4; ++i) {
        const double left = random.whole(0, 5) + .5, top = random.whole(0, 5) + .5;
        const double right = left + random.whole(1, 3), bottom = top + random.whole(1, 3);
        const double at_left = random.whole(0, 1) / 4., at_right = random.whole(0, 1) / 4.;
        Corners corners{
            {left, top, at_left}, {right, top, at_right}, {right, bottom, at_right}, {left, bottom, at_left}};
        std::rotate(corners.begin(), corners.begin() + random.whole(0, 3), corners.end());
        builder.polygon(corners);
    }
    return builder.build();
}

/// One to three polygons of any kind in an area of any size, one of them perhaps twice.
AdmittedScene any_polygons(RandomScenes& random) {
    while (true) {
        const AdmittedScene drawn = random.scene();
        Scene scene = *drawn;
        if (scene.polygons.size() > 2) scene.polygons.resize(2);
        if (random.whole(0, 1) == 0) {
            scene.polygons.push_back(scene.polygons[0]);
            scene.polygons.back().id = "copy";
        }
        AdmittedScene few = admit(std::move(scene));
        if (all_planar(few)) return few;  // otherwise the scene does not determine the depths
    }
}

}  // namespace

TEST_CASE("On 1,000 scenes of two level polygons the zeros of Weiler and Atherton's algorithm are those of the scene") {
    Counts counts = check_zeros(56, two_level_polygons);
    check_more_than(1000, counts, {"in clip", "common", "at ends"});
    check_more_than(100, counts,
                    {"boxes", "on rays", "at painting", "equally near", "on outlines", "of planes", "parallel planes"});
}

TEST_CASE("On 1,000 scenes of tilted triangles the zeros of Weiler and Atherton's algorithm are those of the scene") {
    Counts counts = check_zeros(41, tilted_triangles);
    check_more_than(1000, counts, {"in clip", "common", "on rays", "at painting", "at ends", "of sort"});
    check_more_than(200, counts, {"boxes", "in split"});
}

TEST_CASE("On 1,000 scenes of nested polygons the zeros of Weiler and Atherton's algorithm are those of the scene") {
    Counts counts = check_zeros(43, nested_polygons);
    check_more_than(1000, counts, {"on rays", "at painting", "at ends", "parallel planes"});
    check_more_than(500, counts, {"in clip"});
}

TEST_CASE("On 1,000 scenes of rectangles the zeros of Weiler and Atherton's algorithm are those of the scene") {
    Counts counts = check_zeros(34, rectangles);
    check_more_than(1000, counts, {"in clip", "common", "boxes", "at painting", "at ends", "equally near", "of sort"});
    check_more_than(100, counts, {"in split", "on rays", "on outlines", "of planes", "parallel planes"});
}

TEST_CASE("On 1,000 scenes of any polygons the zeros of Weiler and Atherton's algorithm are those of the scene") {
    Counts counts = check_zeros(45, any_polygons);
    check_more_than(1000, counts, {"common", "of sort"});
    check_more_than(100, counts, {"in clip", "in split", "on rays", "at painting", "at ends", "of planes"});
}
