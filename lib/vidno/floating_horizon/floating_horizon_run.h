/// FloatingHorizonRun: one execution of the floating horizon: its procedure set, kernel and visitor, the curves, the
/// horizons so far, and the lines drawn. Run is the equivalent for methods that paint polygons.
#pragma once

#include <algorithm>
#include <cassert>
#include <optional>
#include <utility>
#include <vector>

#include "../trace.h"
#include "horizons.h"

namespace vidno {

/// An end of a visible line, on a column or between two neighbours.
template <class Number>
struct LineEnd {
    Point<Number> point;
    int left, right;  // the columns next to it; both the same if it is on one

    bool on_column() const { return left == right; }
};

/// A visible part of a segment, from left to right; perhaps a point, on a column.
template <class Number>
struct VisibleLine {
    Segment segment;
    LineEnd<Number> from, to;

    bool is_point() const { return from.on_column() && from.left == to.right; }
};

/// Appends a line. Two lines of one segment that meet on a column are joined; a point joins its neighbour.
template <class Number>
void add_line(std::vector<VisibleLine<Number>>& lines, const VisibleLine<Number>& line) {
    const bool goes_on = !lines.empty() && lines.back().segment.curve == line.segment.curve && line.from.on_column() &&
                         lines.back().to.on_column() && lines.back().to.left == line.from.left;
    if (goes_on && lines.back().is_point()) {
        lines.back() = line;
    } else if (goes_on && lines.back().segment == line.segment) {
        lines.back().to = line.to;
    } else if (!goes_on || !line.is_point()) {
        lines.push_back(line);
    }
}

template <class ProcedureSet, FloatingHorizonKernel K, class Trace>
struct FloatingHorizonRun {
    using Set = ProcedureSet;
    using Arithmetic = K;
    using End = LineEnd<typename K::Number>;

    [[no_unique_address]] Set set;
    K kernel;
    Trace trace;
    const CurveScene& scene;
    Horizons<K> horizons;
    std::vector<VisibleLine<typename K::Number>> lines;

    FloatingHorizonRun(const CurveScene& curves, K arithmetic, Trace visitor, Set procedures = {})
        : set(std::move(procedures)),
          kernel(std::move(arithmetic)),
          trace(std::move(visitor)),
          scene(curves),
          horizons(set.first_horizons(kernel, curves.area)) {}

    void side_edge(Line at, std::optional<Sample>& edge, int curve, const Sample& end) {
        trace.call(at, Procedure::side_edge);
        set.side_edge(*this, edge, curve, end);
        trace.side_edge(at, end);
    }

    VisibilityFlag visibility(Line at, const Segment& segment, int column, const Horizons<K>& before) {
        trace.call(at, Procedure::visibility);
        const VisibilityFlag flag = set.visibility(*this, segment, column, before);
        trace.visibility(at, segment, column, flag);
        return flag;
    }

    /// Over the columns first <= x <= last.
    void horizon(Line at, const Segment& segment, int first, int last) {
        trace.call(at, Procedure::horizon);
        set.horizon(*this, segment, first, last);
        trace.horizon(at, segment, first, last);
    }

    /// Between the columns first and last.
    End intersection(Line at, const Segment& segment, int first, int last, const HorizonArray<K>& horizon,
                     VisibilityFlag side) {
        trace.call(at, Procedure::intersection);
        End end = set.intersection(*this, segment, first, last, horizon, side);
        trace.intersection(at, segment, end);
        return end;
    }

    End on_column(const Segment& segment, int column) const {
        return {kernel.point_on(segment, column), column, column};
    }

    void draw_line(Line at, const Segment& segment, const End& from, const End& to) {
        trace.draw_line(at, segment, from, to);
        add_line(lines, {segment, from, to});
    }
};

}  // namespace vidno
