/// Regions as sets of the convex cells into which lines divide the plane, in rationals. Nothing here shares code with
/// the procedures.
#pragma once

#include <map>
#include <set>
#include <utility>
#include <vector>

#include "support/in_rationals.h"
#include "support/outlines.h"

namespace vidno::test {

/// From one place to another, by their numbers. The cell to which it belongs is on its positive side.
using Segment = std::pair<int, int>;

/// The convex cells into which lines divide a convex outline. A segment separates two cells, and both have its ends as
/// corners.
class Cells {
public:
    /// The outline has its inside on its positive side.
    Cells(const Places& outline, const std::set<LineThrough>& lines) : places(outline) {
        cells.emplace_back();
        for (std::size_t i = 0; i < outline.size(); ++i) cells[0].push_back(int(i));
        for (const auto& line : lines) cut(line);
        for (const auto& corners : cells) {
            for (std::size_t i = 0; i < corners.size(); ++i) {
                following_[{corner(corners, i), corner(corners, i + 1)}] = corner(corners, i + 2);
            }
        }
    }

    Places places;
    std::vector<std::vector<int>> cells;

    /// The mean of a cell's corners, which is strictly inside it.
    Place middle(int cell) const {
        const auto& corners = cells[std::size_t(cell)];
        Place sum;
        for (const int corner : corners) {
            sum.first += places[std::size_t(corner)].first;
            sum.second += places[std::size_t(corner)].second;
        }
        const Rational count(int(corners.size()));
        return {sum.first / count, sum.second / count};
    }

    /// The segments that bound some of the cells.
    std::set<Segment> boundary(const std::set<int>& some) const {
        std::set<Segment> segments;
        for (const int cell : some) {
            const auto& corners = cells[std::size_t(cell)];
            for (std::size_t i = 0; i < corners.size(); ++i) {
                const Segment segment{corner(corners, i), corner(corners, i + 1)};
                if (segments.erase({segment.second, segment.first}) == 0) segments.insert(segment);
            }
        }
        return segments;
    }

    /// The segment of a boundary that follows another one round a corner of the region, through the cells at that
    /// corner.
    Segment following(const std::set<Segment>& boundary, const Segment& segment) const {
        const int at = segment.second;
        int to = following_.at(segment);
        while (!boundary.contains({at, to})) to = following_.at({to, at});
        return {at, to};
    }

private:
    static int corner(const std::vector<int>& corners, std::size_t i) { return corners[i % corners.size()]; }

    void cut(const LineThrough& line) {
        std::vector<Rational> heights;
        for (const auto& place : places) heights.push_back(over(line, place));
        std::map<Segment, int> crossings;
        const auto crossing = [&](int from, int to) {
            const auto [known, is_new] = crossings.try_emplace(std::minmax(from, to), int(places.size()));
            if (is_new) {
                places.push_back(zero_between(places[std::size_t(from)], heights[std::size_t(from)],
                                              places[std::size_t(to)], heights[std::size_t(to)]));
            }
            return known->second;
        };
        std::vector<std::vector<int>> parts;
        for (const auto& corners : cells) {
            std::vector<int> positive, negative;
            bool is_positive = false, is_negative = false;
            for (std::size_t i = 0; i < corners.size(); ++i) {
                const int from = corner(corners, i), to = corner(corners, i + 1);
                const Rational &f = heights[std::size_t(from)], &t = heights[std::size_t(to)];
                is_positive = is_positive || f > 0;
                is_negative = is_negative || f < 0;
                if (f >= 0) positive.push_back(from);
                if (f <= 0) negative.push_back(from);
                if (f * t >= 0) continue;
                positive.push_back(crossing(from, to));
                negative.push_back(positive.back());
            }
            if (is_positive) parts.push_back(std::move(positive));
            if (is_negative) parts.push_back(std::move(negative));
        }
        cells = std::move(parts);
    }

    std::map<Segment, int> following_;  // the corner after a segment of a cell
};

/// A segment of an outline, and the line of the scene on which it lies, by its number. Several lines may run through
/// the same places.
struct OutlineSegment {
    Segment segment;
    int line;

    OutlineSegment reversed() const { return {{segment.second, segment.first}, line}; }
};

/// A vertex of an outline, and the lines of the edges that end and begin there.
struct OutlineVertex {
    Place at;
    int before, after;

    bool on(int line) const { return before == line || after == line; }
};

/// An edge of an outline.
struct OutlineEdge {
    OutlineVertex from, to;

    int line() const { return from.after; }
    EdgeOf places() const { return {from.at, to.at}; }
};

/// A set of cells with its outlines. Each outline has the region on its positive side.
class CellRegion {
public:
    /// Outlines begin with the first of the segments that is on them. Each segment of the boundary must be among them;
    /// the first one for it gives its line.
    CellRegion(const Cells& arrangement, std::set<int> some, const std::vector<OutlineSegment>& segments)
        : cells(std::move(some)) {
        const std::set<Segment> boundary = arrangement.boundary(cells);
        std::map<Segment, int> lines;
        for (const auto& [segment, line] : segments) lines.emplace(segment, line);
        std::map<int, int> beginning;  // how many segments begin at a place
        for (const auto& segment : boundary) ++beginning[segment.first];

        const auto place = [&](int number) -> const Place& { return arrangement.places[std::size_t(number)]; };
        std::set<Segment> unused = boundary;
        for (const auto& start : segments) {
            const Segment& first = start.segment;
            if (!unused.contains(first)) continue;
            std::vector<OutlineSegment> outline;
            Segment next = first;
            do {
                outline.push_back({next, lines.at(next)});
                const auto [from, at] = next;
                std::vector<int> ways;
                for (auto way = unused.lower_bound({at, 0}); way != unused.end() && way->first == at; ++way) {
                    ways.push_back(way->second);
                }
                for (const int to : ways) {
                    if (ways.size() < 2 || lines.at({at, to}) == lines.at(next)) continue;
                    if (cross(place(from), place(at), place(to)) == 0) straight_ahead.insert(place(at));
                }
                next = arrangement.following(boundary, next);
                unused.erase(next);
            } while (next != first);
            auto& vertices = loops.emplace_back();
            std::size_t last = 0;
            for (std::size_t i = 0; i < outline.size(); ++i) {
                const int at = outline[i].segment.first;
                const int before = outline[(i + outline.size() - 1) % outline.size()].line, after = outline[i].line;
                if (before == after && beginning[at] < 2) continue;
                vertices.push_back({place(at), before, after});
                last = i;
            }
            segments_.push_back({std::move(outline), last});
        }
        if (!unused.empty()) FAIL("a segment without a line");

        Places corners;
        for (const auto& loop : loops) {
            for (std::size_t i = 0; i < loop.size(); ++i) {
                edges.push_back({loop[i], loop[(i + 1) % loop.size()]});
                corners.push_back(loop[i].at);
            }
        }
        if (!corners.empty()) box = box_of(corners);
    }

    std::set<int> cells;
    std::vector<std::vector<OutlineVertex>> loops;
    std::vector<OutlineEdge> edges;
    BoxOf box;  // of a region that is not empty
    /// Where an outline that touches another one, or itself, has a way straight ahead, but along another line.
    std::set<Place> straight_ahead;

    bool empty() const { return cells.empty(); }

    /// The segments of the outlines, each from its first vertex on.
    std::vector<OutlineSegment> segments() const {
        std::vector<OutlineSegment> all;
        for (const auto& each : segments_) all.insert(all.end(), each.segments.begin(), each.segments.end());
        return all;
    }
    /// Its segments, each from its last vertex on.
    std::vector<OutlineSegment> segments_from_last_vertex() const {
        std::vector<OutlineSegment> all;
        for (const auto& [outline, last] : segments_) {
            const auto middle = outline.begin() + std::ptrdiff_t(last);
            all.insert(all.end(), middle, outline.end());
            all.insert(all.end(), outline.begin(), middle);
        }
        return all;
    }

private:
    struct Outline {
        std::vector<OutlineSegment> segments;
        std::size_t last;  // the segment that begins at the last vertex
    };
    std::vector<Outline> segments_;
};

}  // namespace vidno::test
