/// WeilerAthertonRun: one execution of Weiler and Atherton's algorithm: its procedure set, kernel and visitor, the
/// polygons, the lines whose intersections are the vertices, the visible regions so far, and the picture. Run is the
/// equivalent for methods that paint.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "../fault.h"
#include "../picture.h"
#include "../polygon.h"
#include "../trace.h"
#include "loops.h"
#include "support_lines.h"

namespace vidno {

/// A polygon of the scene: the data that all of its pieces share.
template <class Number>
struct SourcePolygon {
    int index = 0;  // its place in the scene
    Color color;
    bool edge_on = false;
    std::vector<Vertex<Number>> vertices;
    Box<Number> box;
    vidno::Plane<Number> plane;
};

/// A part of a polygon, not empty.
template <class Number>
struct PolygonPiece {
    const SourcePolygon<Number>* polygon;
    Region<Number> region;
    bool is_ground;  // known to be behind all others of its list
    Box<Number> box;

    PolygonPiece(const SourcePolygon<Number>* of, Region<Number> part, bool ground = false)
        : polygon(of), region(std::move(part)), is_ground(ground), box(box_around(region)) {}
};

template <class ProcedureSet, WeilerAthertonKernel K, class Visitor>
struct WeilerAthertonRun {
    using Set = ProcedureSet;
    using Arithmetic = K;
    using Number = typename K::Number;
    using Vertices = std::vector<Vertex<Number>>;
    using Piece = PolygonPiece<Number>;
    using Pieces = std::vector<EdgePiece<Number>>;

    [[no_unique_address]] Set set;
    K kernel;
    Visitor trace;
    Area area;
    Picture& picture;
    SupportLines<K> lines{kernel};
    std::vector<SourcePolygon<Number>> polygons;
    std::vector<Piece> facets;   // convex, and none pierces another
    std::vector<Piece> visible;  // disjoint but for their outlines

    WeilerAthertonRun(const Scene& scene, K arithmetic, Visitor visitor, Picture& canvas, Set procedures = {})
        : set(std::move(procedures)),
          kernel(std::move(arithmetic)),
          trace(std::move(visitor)),
          area(scene.area),
          picture(canvas) {
        const auto left = double(area.x), right = double(area.right());
        const auto top = double(area.y), bottom = double(area.bottom());
        area_region_ = bounded_by({kernel.place(left, top), kernel.place(right, top), kernel.place(right, bottom),
                                   kernel.place(left, bottom)});
        polygons.reserve(scene.polygons.size());
        for (const auto& source : scene.polygons) polygons.push_back(initialize_polygon(source));
    }

    SourcePolygon<Number> initialize_polygon(const ScenePolygon& source) {
        auto polygon = polygon_on_screen<SourcePolygon<Number>>(set, kernel, area, source, int(polygons.size()));
        polygon.plane = set.initialize_polygon(*this, polygon.vertices);
        trace.plane(Line::I1, polygon, polygon.plane);
        return polygon;
    }

    /// The part of a polygon, one that is not edge-on, in the area.
    Region<Number> cut_to_area(Line at, const SourcePolygon<Number>& polygon) {
        std::vector<Point<Number>> corners;
        for (const auto& [x, y, z] : polygon.vertices) {
            const Point<Number> corner{x, y};
            if (corners.empty() || kernel.order(corners.back(), corner) != Sign::zero) corners.push_back(corner);
        }
        while (corners.size() > 1 && kernel.order(corners.back(), corners.front()) == Sign::zero) corners.pop_back();
        if (kernel.compare(polygon.plane.c, kernel.number(0)) == Sign::negative) {
            std::reverse(corners.begin(), corners.end());
        }
        trace.call(at, Procedure::region_clip);
        auto part = set.region_clip(*this, bounded_by(corners), area_region_).inside;
        trace.cut_to_area(at, polygon, part);
        return part;
    }

    Number depth(Line at, const SourcePolygon<Number>& polygon, const Point<Number>& place) {
        const Number z = set.depth(*this, polygon, place);
        trace.depth(at, polygon, place, z);
        return z;
    }

    /// How the depths of two polygons at a place compare: positive if the first is nearer.
    Sign order(Line at, const SourcePolygon<Number>& polygon, const SourcePolygon<Number>& other,
               const Point<Number>& place) {
        const Number z = set.depth(*this, polygon, place);
        const Number other_z = set.depth(*this, other, place);
        const Sign order = kernel.compare(z, other_z);
        trace.order(at, polygon, other, place, z, other_z, order);
        return order;
    }

    ClippedRegion<Number> region_clip(Line at, const Piece& subject, const Piece& clip) {
        trace.call(at, Procedure::region_clip);
        auto parts = set.region_clip(*this, subject.region, clip.region);
        trace.clipped(at, *subject.polygon, *clip.polygon, parts.inside, parts.outside);
        return parts;
    }

    /// Do the boxes of two pieces lie apart, or are they parts of one polygon? Then they share no area.
    bool apart(const Piece& a, const Piece& b) const {
        const auto& p = a.box;
        const auto& q = b.box;
        return a.polygon == b.polygon || !(p.xmin < q.xmax) || !(q.xmin < p.xmax) || !(p.ymin < q.ymax) ||
               !(q.ymin < p.ymax);
    }

    std::vector<Piece> split_piercing(Line at, std::vector<Piece> pieces) {
        trace.call(at, Procedure::split_piercing);
        auto convex = set.split_piercing(*this, std::move(pieces));
        trace.facets(at, convex);
        return convex;
    }

    std::vector<Piece> depth_sort(Line at, const std::vector<Piece>& pieces) {
        trace.call(at, Procedure::depth_sort);
        auto sorted = set.depth_sort(*this, pieces);
        trace.sorted(at, sorted);
        return sorted;
    }

    std::vector<Piece> remove_behind(Line at, const std::vector<Piece>& inside, const Piece& clip) {
        trace.call(at, Procedure::remove_behind);
        auto nearer = set.remove_behind(*this, inside, clip);
        trace.nearer_ones(at, nearer);
        return nearer;
    }

    /// Throws a fault if there are more lists than exact arithmetic allows. Lists nest at most as deep as there are
    /// facets, those of one depth share no area, and the lines divide the area into at most `most_parts` parts. Only
    /// rounding can lead to more lists.
    void count_list(Line at) {
        if (++lists_ > lines.most_parts() * double(facets.size())) {
            throw Fault{at, "more lists than the lines can divide the area into"};
        }
    }

    void show(Line at, const Piece& piece) {
        trace.show_region(at, *piece.polygon, piece.region);
        visible.push_back(piece);
    }

    void paint_regions(Line at) {
        trace.call(at, Procedure::paint_regions);
        set.paint_regions(*this);
        trace.painted(at);
    }

    Region<Number> joined(Line at, const std::vector<LoopVertex<Number>>& vertices, const Pieces& pieces) {
        return vidno::joined(kernel, vertices, pieces, [&] { trace.fault(at, "an outline does not close"); });
    }

private:
    /// Orders the vertices so that the region is on the positive side.
    Region<Number> bounded_by(const std::vector<Point<Number>>& corners) {
        Loop<Number> loop;
        for (const auto& corner : corners) loop.push_back({corner, nullptr, nullptr});
        for (std::size_t i = 0; i < loop.size(); ++i) {
            auto& next = loop[(i + 1) % loop.size()];
            loop[i].after = next.before = lines.between(loop[i].at, next.at);
        }
        return {{loop}};
    }

    double lists_ = 0;
    Region<Number> area_region_;
};

}  // namespace vidno
