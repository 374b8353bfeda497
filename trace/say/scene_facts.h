/// SceneFacts and CurveFacts: what is so in a scene, in exact arithmetic and by the rule that its methods follow,
/// whatever a run computes.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "format/trace_header.h"
#include "vidno/family/relation.h"
#include "vidno/floating_horizon/curves.h"
#include "vidno/floating_horizon/horizons.h"
#include "vidno/kernel.h"
#include "vidno/picture.h"
#include "vidno/window.h"

namespace vidno {

/// By the picture rule. Polygons are named by their place in the scene, edges by their first vertex. What is made of an
/// infinite coordinate, or of one that is no number, is not known.
class SceneFacts {
public:
    /// The facts about the scene of a run, whose header must outlive them. Nothing is known of the lines as which its
    /// method may show polygons that are edge-on.
    explicit SceneFacts(const TraceHeader& header);
    ~SceneFacts();
    SceneFacts(const SceneFacts&) = delete;
    SceneFacts& operator=(const SceneFacts&) = delete;

    /// Whether the point lies in the polygon or on its outline.
    std::optional<bool> holds(int polygon, const ValuePoint& at) const;
    /// The cross product of an edge and a point.
    std::optional<Value> cross(int polygon, int edge, const ValuePoint& at) const;
    /// The depth of the polygon's plane.
    std::optional<Value> depth(int polygon, const ValuePoint& at) const;
    /// Where the line through the centres of a row of pixels meets the polygon, from left to right.
    std::optional<std::pair<Value, Value>> on_row(int polygon, int row) const;

    bool is_edge_on(int polygon) const;
    /// Whether the polygon's box lies outside a window, or strictly inside it, as the procedures ask.
    bool is_box_outside(int polygon, const Window& window) const;
    bool is_box_inside(int polygon, const Window& window) const;
    /// What a window has to do with a polygon that is not edge-on, as long as the window's sides do not matter: a
    /// polygon that only touches them gets no answer.
    std::optional<Relation> relation(int polygon, const Window& window) const;

    /// A pixel, and the polygon that shows there; none for the background.
    struct Shown {
        int x, y;
        std::optional<int> polygon;
    };
    std::optional<Shown> shown(int x, int y) const;
    /// What is seen at a point.
    struct Seen {
        std::optional<int> polygon;
    };
    std::optional<Seen> seen(const ValuePoint& at) const;
    /// The first pixel of the rectangle that shows something else than `expected` accepts.
    std::optional<Shown> unexpected(const PixelRectangle& pixels,
                                    const std::function<bool(std::optional<int>)>& expected) const;
    /// The same for the picture of the first polygons of the scene.
    std::optional<Shown> unexpected(const PixelRectangle& pixels, int polygons,
                                    const std::function<bool(std::optional<int>)>& expected) const;

private:
    struct Polygons;
    std::unique_ptr<Polygons> polygons_;
};

/// By the rule of vidno/floating_horizon/floating_horizon.h. Curves are named by their place in the scene, from the
/// nearest.
class CurveFacts {
public:
    /// The curves must outlive the facts.
    explicit CurveFacts(const CurveScene& scene) : scene_(&scene) {}

    /// The height of a curve over a column; none beside it, and in a gap.
    std::optional<Value> height(int curve, int x) const;

    struct Reached {
        Value upper, lower;
    };
    /// The horizons over a column before a curve; none where nothing has reached it.
    std::optional<Reached> horizons(int curve, int x) const;

    /// How a curve lies over a column; none where it has no point.
    std::optional<VisibilityFlag> flag(int curve, int x) const;

    /// Where a curve crosses one of the horizons strictly between a column and the next.
    std::optional<ValuePoint> crossing(int curve, int x, VisibilityFlag side) const;

private:
    const CurveScene* scene_;
};

}  // namespace vidno
