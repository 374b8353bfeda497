/// Event: one line of a trace, as values. FORMAT.md says what each means.
///
/// Every event is a struct with its name, the level from which it appears, and its fields in their order. This is the one
/// table of them: the writer, the reader, and the recorder's filter follow from it.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "value.h"
#include "verdict.h"
#include "vidno/family/relation.h"
#include "vidno/floating_horizon/horizons.h"
#include "vidno/kernel.h"
#include "vidno/picture.h"
#include "vidno/trace.h"
#include "vidno/weiler_atherton/overlay.h"

namespace vidno {

enum class Detail : unsigned char { windows, polygons, signs };
inline constexpr std::array<std::string_view, 3> detail_names{"windows", "polygons", "signs"};

/// A polygon by its place in the scene; in the file stands its id.
struct PolygonPlace {
    int index = 0;
    bool operator==(const PolygonPlace&) const = default;
};

using AplEntry = std::pair<PolygonPlace, bool>;

struct ColumnRun {
    int first = 0, end = 0;
    bool operator==(const ColumnRun&) const = default;
};

/// The loops of a region.
using RegionLoops = std::vector<std::vector<ValuePoint>>;

/// A part of a polygon; ground, if it is known to be behind all others of its list.
struct PolygonPart {
    PolygonPlace polygon;
    RegionLoops region;
    bool ground = false;
    bool operator==(const PolygonPart&) const = default;
};

using ColumnHeight = std::pair<int, Value>;
using SampleTold = std::pair<int, double>;
/// Of the current curve the segment between the samples on these columns.
using SegmentColumns = std::pair<int, int>;

namespace event {

struct Kind {
    std::string_view name;
    Detail from;
};

struct Plane {
    static constexpr Kind kind{"plane", Detail::polygons};
    Line at{};
    PolygonPlace polygon;
    std::array<Value, 4> plane;
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("plane", e.plane);
    }
};

/// A decision that exact arithmetic takes otherwise along the same path.
struct Disagree {
    static constexpr Kind kind{"disagree", Detail::windows};
    Line at{};  // of the event before, which tells the decision or is the first to follow it
    Decision of{};
    Answer taken, exact;
    Cause cause{};
    static void fields(auto& e, auto&& field) {
        field("of", e.of);
        field("taken", e.taken);
        field("exact", e.exact);
        field("cause", e.cause);
    }
};

/// The level from which the calls of a procedure are told: below `signs` nothing happens inside some. What a call came to is
/// the event with that procedure as its `result_of`.
constexpr Detail calls_from(Procedure procedure) {
    switch (procedure) {
        case Procedure::surround_test:
        case Procedure::visibility:
        case Procedure::horizon:
        case Procedure::intersection:
        case Procedure::trial_function:
        case Procedure::ray_crossings:
        case Procedure::octant_angles: return Detail::signs;
        default: return Detail::polygons;
    }
}

struct Call {
    static constexpr Kind kind{"call", Detail::polygons};
    Line at{};
    Procedure of{};
    static void fields(auto& e, auto&& field) { field("of", e.of); }
};

struct Depth {
    static constexpr Kind kind{"depth", Detail::polygons};
    Line at{};
    PolygonPlace polygon;
    ValuePoint point;
    Value z;
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("point", e.point);
        field("z", e.z);
    }
};

struct Fault {
    static constexpr Kind kind{"fault", Detail::windows};
    Line at{};
    std::string reason;
    std::optional<int> x, y;
    static void fields(auto& e, auto&& field) {
        field("reason", e.reason);
        field("x", e.x);
        field("y", e.y);
    }
};

// Warnock

struct Push {
    static constexpr Kind kind{"push", Detail::windows};
    Line at{};
    Window window;
    std::optional<std::vector<AplEntry>> apl;
    std::optional<bool> shared;
    static void fields(auto& e, auto&& field) {
        field("window", e.window);
        field("apl", e.apl);
        field("shared", e.shared);
    }
};

struct Skip {
    static constexpr Kind kind{"skip", Detail::windows};
    Line at{};
    Window window;
    static void fields(auto& e, auto&& field) { field("window", e.window); }
};

struct Pop {
    static constexpr Kind kind{"pop", Detail::windows};
    Line at{};
    Window window;
    static void fields(auto& e, auto&& field) { field("window", e.window); }
};

struct Decide {
    static constexpr Kind kind{"decide", Detail::windows};
    Line at{};
    Case which{};
    static void fields(auto& e, auto&& field) { field("case", e.which); }
};

struct Fill {
    static constexpr Kind kind{"fill", Detail::windows};
    Line at{};
    PixelRectangle rect;
    Color color;
    static void fields(auto& e, auto&& field) {
        field("rect", e.rect);
        field("color", e.color);
    }
};

// ProcessWindow

struct Corners {
    static constexpr Kind kind{"corners", Detail::polygons};
    Line at{};
    Value z;
    static void fields(auto& e, auto&& field) { field("z", e.z); }
};

struct Box {
    static constexpr Kind kind{"box", Detail::signs};
    Line at{};
    PolygonPlace polygon;
    std::array<Value, 4> box;
    bool outside = false;
    Told told;
    static constexpr Decision decides = Decision::outside;
    Answer decision() const { return outside; }
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("box", e.box);
        field("outside", e.outside);
        field("exact", e.told.exact);
        field("by", e.told.by);
    }
};

struct Discard {
    static constexpr Kind kind{"discard", Detail::polygons};
    Line at{};
    PolygonPlace polygon;
    static void fields(auto& e, auto&& field) { field("polygon", e.polygon); }
};

struct Count {
    static constexpr Kind kind{"count", Detail::polygons};
    Line at{};
    PolygonPlace polygon;
    int count = 0;
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("count", e.count);
    }
};

struct Compare {
    static constexpr Kind kind{"compare", Detail::signs};
    Line at{};
    PolygonPlace polygon;
    std::optional<Corner> corner;
    Value z, against;
    bool nearer = false;
    Told told;
    static constexpr Decision decides = Decision::nearer;
    Answer decision() const { return nearer; }
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("corner", e.corner);
        field("z", e.z);
        field("against", e.against);
        field("nearer", e.nearer);
        field("exact", e.told.exact);
        field("by", e.told.by);
    }
};

struct Nearer {
    static constexpr Kind kind{"nearer", Detail::polygons};
    Line at{};
    PolygonPlace polygon;
    std::vector<Corner> corners;
    int k = 0;
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("corners", e.corners);
        field("k", e.k);
    }
};

struct Uncover {
    static constexpr Kind kind{"uncover", Detail::polygons};
    Line at{};
    PolygonPlace polygon;
    static void fields(auto& e, auto&& field) { field("polygon", e.polygon); }
};

struct Mark {
    static constexpr Kind kind{"mark", Detail::polygons};
    Line at{};
    PolygonPlace polygon;
    static void fields(auto& e, auto&& field) { field("polygon", e.polygon); }
};

struct Cover {
    static constexpr Kind kind{"cover", Detail::polygons};
    Line at{};
    PolygonPlace polygon;
    Color color;
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("color", e.color);
    }
};

struct Insider {
    static constexpr Kind kind{"insider", Detail::polygons};
    Line at{};
    PolygonPlace polygon;
    bool inside = false;
    Told told;
    static constexpr Decision decides = Decision::inside;
    Answer decision() const { return inside; }
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("inside", e.inside);
        field("exact", e.told.exact);
        field("by", e.told.by);
    }
};

struct Summary {
    static constexpr Kind kind{"summary", Detail::polygons};
    static constexpr Procedure result_of = Procedure::process_window;
    Line at{};
    int count = 0;
    bool has_surround = false;
    std::optional<Color> color;
    bool insider = false;
    static void fields(auto& e, auto&& field) {
        field("count", e.count);
        field("hasSurround", e.has_surround);
        field("color", e.color);
        field("insider", e.insider);
    }
};

// PointColor, SurroundTest

struct Nearest {
    static constexpr Kind kind{"nearest", Detail::polygons};
    Line at{};
    PolygonPlace polygon;
    Value z;
    Color color;
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("z", e.z);
        field("color", e.color);
    }
};

struct PointColor {
    static constexpr Kind kind{"color", Detail::polygons};
    static constexpr Procedure result_of = Procedure::point_color;
    Line at{};
    ValuePoint point;
    Color color;
    static void fields(auto& e, auto&& field) {
        field("point", e.point);
        field("color", e.color);
    }
};

struct Surround {
    static constexpr Kind kind{"surround", Detail::polygons};
    static constexpr Procedure result_of = Procedure::surround_test;
    Line at{};
    PolygonPlace polygon;
    ValuePoint point;
    bool inside = false;
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("point", e.point);
        field("inside", e.inside);
    }
};

struct Orient {
    static constexpr Kind kind{"orient", Detail::signs};
    Line at{};
    PolygonPlace polygon;
    int edge = 0;
    ValuePoint point;
    Value value;
    Sign sign{};
    Told told;
    static constexpr Decision decides = Decision::orientation;
    Answer decision() const { return int(sign); }
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("edge", e.edge);
        field("point", e.point);
        field("value", e.value);
        field("sign", e.sign);
        field("exact", e.told.exact);
        field("by", e.told.by);
    }
};

// PolygonClip, FillPolygon

struct ClipBegin {
    static constexpr Kind kind{"clip_begin", Detail::polygons};
    Line at{};
    PolygonPlace polygon;
    Window window;
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("window", e.window);
    }
};

struct ClipSide {
    static constexpr Kind kind{"clip_side", Detail::polygons};
    Line at{};
    int side = 0;
    ValuePoint from, to;
    static void fields(auto& e, auto&& field) {
        field("side", e.side);
        field("from", e.from);
        field("to", e.to);
    }
};

struct ClipSign {
    static constexpr Kind kind{"clip_sign", Detail::signs};
    Line at{};
    ValueVertex vertex;
    Value value;
    Sign sign{};
    Told told;
    static constexpr Decision decides = Decision::orientation;
    Answer decision() const { return int(sign); }
    static void fields(auto& e, auto&& field) {
        field("vertex", e.vertex);
        field("value", e.value);
        field("sign", e.sign);
        field("exact", e.told.exact);
        field("by", e.told.by);
    }
};

struct ClipCross {
    static constexpr Kind kind{"clip_cross", Detail::polygons};
    Line at{};
    ValueVertex vertex;
    static void fields(auto& e, auto&& field) { field("vertex", e.vertex); }
};

struct ClipKeep {
    static constexpr Kind kind{"clip_keep", Detail::polygons};
    Line at{};
    ValueVertex vertex;
    static void fields(auto& e, auto&& field) { field("vertex", e.vertex); }
};

struct ClipDrop {
    static constexpr Kind kind{"clip_drop", Detail::polygons};
    Line at{};
    ValueVertex vertex;
    static void fields(auto& e, auto&& field) { field("vertex", e.vertex); }
};

struct ClipList {
    static constexpr Kind kind{"clip_list", Detail::polygons};
    Line at{};
    int count = 0;
    static void fields(auto& e, auto&& field) { field("count", e.count); }
};

struct ClipResult {
    static constexpr Kind kind{"clip_result", Detail::polygons};
    static constexpr Procedure result_of = Procedure::polygon_clip;
    Line at{};
    PolygonPlace polygon;
    std::vector<ValueVertex> vertices;
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("vertices", e.vertices);
    }
};

struct Row {
    static constexpr Kind kind{"row", Detail::signs};
    Line at{};
    int row = 0;
    Value left, right;
    int first = 0, end = 0;
    Told told;
    static constexpr Decision decides = Decision::columns;
    Answer decision() const { return std::pair(first, end); }
    static void fields(auto& e, auto&& field) {
        field("row", e.row);
        field("left", e.left);
        field("right", e.right);
        field("first", e.first);
        field("end", e.end);
        field("exact", e.told.exact);
        field("by", e.told.by);
    }
};

struct Draw {
    static constexpr Kind kind{"draw", Detail::windows};
    static constexpr Procedure result_of = Procedure::fill_polygon;
    Line at{};
    PolygonPlace polygon;
    Color color;
    std::vector<PixelRun> runs;
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("color", e.color);
        field("runs", e.runs);
    }
};

// ZBuffer, ShowLine

struct Clear {
    static constexpr Kind kind{"clear", Detail::windows};
    Line at{};
    Color color;
    Value z;
    static void fields(auto& e, auto&& field) {
        field("color", e.color);
        field("z", e.z);
    }
};

struct Polygon {
    static constexpr Kind kind{"polygon", Detail::windows};
    Line at{};
    PolygonPlace polygon;
    Color color;
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("color", e.color);
    }
};

struct Edge {
    static constexpr Kind kind{"edge", Detail::polygons};
    Line at{};
    int edge = 0;
    ValueVertex from, to;
    std::optional<std::pair<int, int>> rows;
    static void fields(auto& e, auto&& field) {
        field("edge", e.edge);
        field("from", e.from);
        field("to", e.to);
        field("rows", e.rows);
    }
};

struct Extent {
    static constexpr Kind kind{"extent", Detail::polygons};
    Line at{};
    Value ymin, ymax;
    static void fields(auto& e, auto&& field) {
        field("ymin", e.ymin);
        field("ymax", e.ymax);
    }
};

struct Scanline {
    static constexpr Kind kind{"scanline", Detail::windows};
    Line at{};
    Value y;
    int row = 0;
    static void fields(auto& e, auto&& field) {
        field("y", e.y);
        field("row", e.row);
    }
};

struct AelAdd {
    static constexpr Kind kind{"ael_add", Detail::polygons};
    Line at{};
    int edge = 0;
    Value x, z, until, dx, dz;
    static void fields(auto& e, auto&& field) {
        field("edge", e.edge);
        field("x", e.x);
        field("z", e.z);
        field("until", e.until);
        field("dx", e.dx);
        field("dz", e.dz);
    }
};

struct Horizontal {
    static constexpr Kind kind{"horizontal", Detail::polygons};
    Line at{};
    int edge = 0;
    static void fields(auto& e, auto&& field) { field("edge", e.edge); }
};

struct Leave {
    static constexpr Kind kind{"leave", Detail::polygons};
    Line at{};
    std::vector<int> edges;
    Value next;
    static void fields(auto& e, auto&& field) {
        field("edges", e.edges);
        field("next", e.next);
    }
};

struct AelSort {
    static constexpr Kind kind{"ael_sort", Detail::polygons};
    Line at{};
    std::vector<int> edges;
    Value next;
    static void fields(auto& e, auto&& field) {
        field("edges", e.edges);
        field("next", e.next);
    }
};

struct AelDrop {
    static constexpr Kind kind{"ael_drop", Detail::polygons};
    Line at{};
    std::vector<int> edges;
    Value next;
    static void fields(auto& e, auto&& field) {
        field("edges", e.edges);
        field("next", e.next);
    }
};

struct AelStep {
    static constexpr Kind kind{"ael_step", Detail::polygons};
    Line at{};
    int edge = 0;
    Value x, z;
    static void fields(auto& e, auto&& field) {
        field("edge", e.edge);
        field("x", e.x);
        field("z", e.z);
    }
};

struct ShownLine {
    static constexpr Kind kind{"line", Detail::polygons};
    Line at{};
    int row = 0;
    ValuePoint from, to;  // x and z
    static void fields(auto& e, auto&& field) {
        field("row", e.row);
        field("from", e.from);
        field("to", e.to);
    }
};

struct Miss {
    static constexpr Kind kind{"miss", Detail::polygons};
    Line at{};
    static void fields(auto&, auto&&) {}
};

struct Slope {
    static constexpr Kind kind{"slope", Detail::signs};
    Line at{};
    Value dz;
    static void fields(auto& e, auto&& field) { field("dz", e.dz); }
};

struct Columns {
    static constexpr Kind kind{"columns", Detail::signs};
    Line at{};
    int first = 0, end = 0;
    Value z;
    Told told;
    static constexpr Decision decides = Decision::columns;
    Answer decision() const { return std::pair(first, end); }
    static void fields(auto& e, auto&& field) {
        field("first", e.first);
        field("end", e.end);
        field("z", e.z);
        field("exact", e.told.exact);
        field("by", e.told.by);
    }
};

struct Pixel {
    static constexpr Kind kind{"pixel", Detail::signs};
    Line at{};
    int x = 0, y = 0;
    Value z, stored;
    bool shown = false;
    Told told;
    static constexpr Decision decides = Decision::nearer;
    Answer decision() const { return shown; }
    static void fields(auto& e, auto&& field) {
        field("x", e.x);
        field("y", e.y);
        field("z", e.z);
        field("stored", e.stored);
        field("shown", e.shown);
        field("exact", e.told.exact);
        field("by", e.told.by);
    }
};

/// The depths are there from level `polygons`.
struct Span {
    static constexpr Kind kind{"span", Detail::windows};
    static constexpr Procedure result_of = Procedure::show_line;
    Line at{};
    int row = 0;
    std::vector<ColumnRun> runs;
    std::optional<std::vector<Value>> depths;
    static void fields(auto& e, auto&& field) {
        field("row", e.row);
        field("runs", e.runs);
        field("depths", e.depths);
    }
};

// The Warnock family: ThreeListsWarnock, Relation

struct Join {
    static constexpr Kind kind{"join", Detail::polygons};
    Line at{};
    PolygonPlace polygon;
    Relation list{};
    int level = 0;
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("list", e.list);
        field("level", e.level);
    }
};

struct Rejoin {
    static constexpr Kind kind{"rejoin", Detail::polygons};
    Line at{};
    PolygonPlace polygon;
    Relation list{};  // from which it comes
    int level = 0;    // at which it had joined that
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("list", e.list);
        field("level", e.level);
    }
};

struct RelationFound {
    static constexpr Kind kind{"relation", Detail::polygons};
    static constexpr Procedure result_of = Procedure::relation;
    Line at{};
    PolygonPlace polygon;
    Relation relation{};
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("relation", e.relation);
    }
};

// TrialFunction, RayCrossings, OctantAngles

struct Trial {
    static constexpr Kind kind{"trial", Detail::signs};
    Line at{};
    PolygonPlace polygon;
    int edge = 0;
    bool meets = false;
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("edge", e.edge);
        field("meets", e.meets);
    }
};

struct Meets {
    static constexpr Kind kind{"meets", Detail::polygons};
    static constexpr Procedure result_of = Procedure::trial_function;
    Line at{};
    PolygonPlace polygon;
    bool meets = false;
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("meets", e.meets);
    }
};

struct Ray {
    static constexpr Kind kind{"ray", Detail::signs};
    Line at{};
    PolygonPlace polygon;
    int edge = 0;
    int counts = 0;
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("edge", e.edge);
        field("counts", e.counts);
    }
};

struct Crossings {
    static constexpr Kind kind{"crossings", Detail::polygons};
    static constexpr Procedure result_of = Procedure::ray_crossings;
    Line at{};
    PolygonPlace polygon;
    int count = 0;
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("count", e.count);
    }
};

struct Octants {
    static constexpr Kind kind{"octants", Detail::signs};
    Line at{};
    PolygonPlace polygon;
    int edge = 0;
    int from = 0, to = 0, difference = 0;
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("edge", e.edge);
        field("from", e.from);
        field("to", e.to);
        field("difference", e.difference);
    }
};

struct Angle {
    static constexpr Kind kind{"angle", Detail::polygons};
    static constexpr Procedure result_of = Procedure::octant_angles;
    Line at{};
    PolygonPlace polygon;
    int octants = 0;
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("octants", e.octants);
    }
};

// HidingPolygon, VertexSplit, EdgeDepth, BackFaces

struct Hiding {
    static constexpr Kind kind{"hiding", Detail::polygons};
    static constexpr Procedure result_of = Procedure::hiding_polygon;
    Line at{};
    std::optional<PolygonPlace> polygon;
    static void fields(auto& e, auto&& field) { field("polygon", e.polygon); }
};

struct SplitVertex {
    static constexpr Kind kind{"split_vertex", Detail::polygons};
    Line at{};
    PolygonPlace polygon;
    int vertex = 0;
    int column = 0, row = 0;
    bool splits = false;
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("vertex", e.vertex);
        field("column", e.column);
        field("row", e.row);
        field("splits", e.splits);
    }
};

struct EdgeDepth {
    static constexpr Kind kind{"edge_depth", Detail::polygons};
    Line at{};
    PolygonPlace polygon;
    int edge = 0;
    Value z;
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("edge", e.edge);
        field("z", e.z);
    }
};

struct BackFace {
    static constexpr Kind kind{"back_face", Detail::polygons};
    Line at{};
    PolygonPlace polygon;
    bool away = false;
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("away", e.away);
    }
};

// WeilerAtherton

struct CutToArea {
    static constexpr Kind kind{"cut_to_area", Detail::polygons};
    static constexpr Procedure result_of = Procedure::region_clip;
    Line at{};
    PolygonPlace polygon;
    RegionLoops region;
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("region", e.region);
    }
};

struct Facets {
    static constexpr Kind kind{"facets", Detail::polygons};
    static constexpr Procedure result_of = Procedure::split_piercing;
    Line at{};
    std::vector<PolygonPart> pieces;
    static void fields(auto& e, auto&& field) { field("pieces", e.pieces); }
};

struct Sorted {
    static constexpr Kind kind{"sorted", Detail::polygons};
    static constexpr Procedure result_of = Procedure::depth_sort;
    Line at{};
    std::vector<PolygonPlace> polygons;
    static void fields(auto& e, auto&& field) { field("polygons", e.polygons); }
};

struct PushList {
    static constexpr Kind kind{"push_list", Detail::windows};
    Line at{};
    std::vector<PolygonPart> pieces;
    static void fields(auto& e, auto&& field) { field("pieces", e.pieces); }
};

struct PopList {
    static constexpr Kind kind{"pop_list", Detail::windows};
    Line at{};
    PolygonPlace clip;  // the first of the list
    int count = 0;
    static void fields(auto& e, auto&& field) {
        field("clip", e.clip);
        field("count", e.count);
    }
};

struct Beside {
    static constexpr Kind kind{"beside", Detail::polygons};
    Line at{};
    PolygonPlace polygon;
    static void fields(auto& e, auto&& field) { field("polygon", e.polygon); }
};

struct Clipped {
    static constexpr Kind kind{"clipped", Detail::polygons};
    static constexpr Procedure result_of = Procedure::region_clip;
    Line at{};
    PolygonPlace polygon, clip;
    RegionLoops inside, outside;
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("clip", e.clip);
        field("inside", e.inside);
        field("outside", e.outside);
    }
};

struct NearerOnes {
    static constexpr Kind kind{"nearer_ones", Detail::polygons};
    static constexpr Procedure result_of = Procedure::remove_behind;
    Line at{};
    std::vector<PolygonPlace> polygons;
    static void fields(auto& e, auto&& field) { field("polygons", e.polygons); }
};

struct Show {
    static constexpr Kind kind{"show", Detail::windows};
    Line at{};
    PolygonPlace polygon;
    RegionLoops region;
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("region", e.region);
    }
};

// SplitPiercing, DepthSort

struct Pierce {
    static constexpr Kind kind{"pierce", Detail::polygons};
    Line at{};
    PolygonPlace polygon, other;
    ValuePoint normal, point;  // of the line in which their planes meet
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("other", e.other);
        field("normal", e.normal);
        field("point", e.point);
    }
};

struct Split {
    static constexpr Kind kind{"split", Detail::polygons};
    Line at{};
    PolygonPlace polygon;
    RegionLoops region, other;
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("region", e.region);
        field("other", e.other);
    }
};

struct GreatestDepth {
    static constexpr Kind kind{"greatest_depth", Detail::polygons};
    Line at{};
    PolygonPlace polygon;
    Value z;
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("z", e.z);
    }
};

// RegionClip, RemoveBehind

struct EdgePiece {
    static constexpr Kind kind{"edge_piece", Detail::signs};
    Line at{};
    ValuePoint from, to;
    Lies lies{};
    static void fields(auto& e, auto&& field) {
        field("from", e.from);
        field("to", e.to);
        field("lies", e.lies);
    }
};

struct Entering {
    static constexpr Kind kind{"entering", Detail::polygons};
    Line at{};
    ValuePoint point;
    static void fields(auto& e, auto&& field) { field("point", e.point); }
};

struct Leaving {
    static constexpr Kind kind{"leaving", Detail::polygons};
    Line at{};
    ValuePoint point;
    static void fields(auto& e, auto&& field) { field("point", e.point); }
};

struct Behind {
    static constexpr Kind kind{"behind", Detail::polygons};
    Line at{};
    PolygonPlace polygon, clip;
    ValuePoint point;
    Value z, clip_z;
    Sign order{};
    bool behind = false;
    Told told;
    static constexpr Decision decides = Decision::comparison;
    Answer decision() const { return int(order); }
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("clip", e.clip);
        field("point", e.point);
        field("z", e.z);
        field("clipZ", e.clip_z);
        field("order", e.order);
        field("behind", e.behind);
        field("exact", e.told.exact);
        field("by", e.told.by);
    }
};

// PaintRegions

struct Order {
    static constexpr Kind kind{"order", Detail::signs};
    Line at{};
    PolygonPlace polygon, other;
    ValuePoint point;
    Value z, other_z;
    Sign order{};
    Told told;
    static constexpr Decision decides = Decision::comparison;
    Answer decision() const { return int(order); }
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("other", e.other);
        field("point", e.point);
        field("z", e.z);
        field("otherZ", e.other_z);
        field("order", e.order);
        field("exact", e.told.exact);
        field("by", e.told.by);
    }
};

struct Paint {
    static constexpr Kind kind{"paint", Detail::windows};
    Line at{};
    PolygonPlace polygon;
    Color color;
    std::vector<PixelRun> runs;
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("color", e.color);
        field("runs", e.runs);
    }
};

struct Painted {
    static constexpr Kind kind{"painted", Detail::polygons};
    static constexpr Procedure result_of = Procedure::paint_regions;
    Line at{};
    static void fields(auto&, auto&&) {}
};

// FloatingHorizon

/// Without a height there is none over any column.
struct Horizons {
    static constexpr Kind kind{"horizons", Detail::polygons};
    Line at{};
    std::optional<Value> upper, lower;
    static void fields(auto& e, auto&& field) {
        field("upper", e.upper);
        field("lower", e.lower);
    }
};

struct Curve {
    static constexpr Kind kind{"curve", Detail::windows};
    Line at{};
    int curve = 0;
    static void fields(auto& e, auto&& field) { field("curve", e.curve); }
};

struct SideEdge {
    static constexpr Kind kind{"side_edge", Detail::polygons};
    static constexpr Procedure result_of = Procedure::side_edge;
    Line at{};
    SampleTold sample;
    static void fields(auto& e, auto&& field) { field("sample", e.sample); }
};

struct Visibility {
    static constexpr Kind kind{"visibility", Detail::polygons};
    static constexpr Procedure result_of = Procedure::visibility;
    Line at{};
    SegmentColumns segment;
    int x = 0;
    VisibilityFlag flag{};
    Told told;
    static constexpr Decision decides = Decision::visibility;
    Answer decision() const { return int(flag); }
    static void fields(auto& e, auto&& field) {
        field("segment", e.segment);
        field("x", e.x);
        field("flag", e.flag);
        field("exact", e.told.exact);
        field("by", e.told.by);
    }
};

struct Intersection {
    static constexpr Kind kind{"intersection", Detail::polygons};
    static constexpr Procedure result_of = Procedure::intersection;
    Line at{};
    SegmentColumns segment;
    ValuePoint point;
    std::pair<int, int> columns;
    static void fields(auto& e, auto&& field) {
        field("segment", e.segment);
        field("point", e.point);
        field("columns", e.columns);
    }
};

struct DrawLine {
    static constexpr Kind kind{"draw_line", Detail::windows};
    Line at{};
    SegmentColumns segment;
    ValuePoint from;
    std::pair<int, int> from_columns;
    ValuePoint to;
    std::pair<int, int> to_columns;
    static void fields(auto& e, auto&& field) {
        field("segment", e.segment);
        field("from", e.from);
        field("fromColumns", e.from_columns);
        field("to", e.to);
        field("toColumns", e.to_columns);
    }
};

/// The columns where the horizons have changed, with their new heights.
struct Horizon {
    static constexpr Kind kind{"horizon", Detail::polygons};
    static constexpr Procedure result_of = Procedure::horizon;
    Line at{};
    int first = 0, last = 0;
    std::vector<ColumnHeight> upper, lower;
    static void fields(auto& e, auto&& field) {
        field("first", e.first);
        field("last", e.last);
        field("upper", e.upper);
        field("lower", e.lower);
    }
};

// Visibility, Horizon, Intersection

struct Height {
    static constexpr Kind kind{"height", Detail::signs};
    Line at{};
    int x = 0;
    Value y;
    std::optional<Value> upper, lower;
    static void fields(auto& e, auto&& field) {
        field("x", e.x);
        field("y", e.y);
        field("upper", e.upper);
        field("lower", e.lower);
    }
};

struct Raise {
    static constexpr Kind kind{"raise", Detail::signs};
    Line at{};
    int x = 0;
    Value y;
    static void fields(auto& e, auto&& field) {
        field("x", e.x);
        field("y", e.y);
    }
};

struct Lower {
    static constexpr Kind kind{"lower", Detail::signs};
    Line at{};
    int x = 0;
    Value y;
    static void fields(auto& e, auto&& field) {
        field("x", e.x);
        field("y", e.y);
    }
};

struct Step {
    static constexpr Kind kind{"step", Detail::signs};
    Line at{};
    int x = 0;
    bool changes = false;
    static void fields(auto& e, auto&& field) {
        field("x", e.x);
        field("changes", e.changes);
    }
};

}  // namespace event

/// A list of types.
template <class... Events>
struct EventTypes {
    static constexpr std::size_t count = sizeof...(Events);
    static constexpr std::array<std::string_view, count> names{Events::kind.name...};

    template <class E>
    static constexpr std::size_t place_of() {
        std::size_t place = 0;
        ((!std::is_same_v<E, Events> && ++place) && ...);
        return place;
    }
};

using AllEvents =
    EventTypes<event::Plane, event::Call, event::Disagree, event::Depth, event::Fault, event::Push, event::Skip,
               event::Pop, event::Decide, event::Fill, event::Corners, event::Box, event::Discard, event::Count,
               event::Compare, event::Nearer, event::Uncover, event::Mark, event::Cover, event::Insider, event::Summary,
               event::Nearest, event::PointColor, event::Surround, event::Orient, event::ClipBegin, event::ClipSide,
               event::ClipSign, event::ClipCross, event::ClipKeep, event::ClipDrop, event::ClipList, event::ClipResult,
               event::Row, event::Draw, event::Clear, event::Polygon, event::Edge, event::Extent, event::Scanline,
               event::AelAdd, event::Horizontal, event::Leave, event::AelSort, event::AelDrop, event::AelStep,
               event::ShownLine, event::Miss, event::Slope, event::Columns, event::Pixel, event::Span, event::Join,
               event::Rejoin, event::RelationFound, event::Trial, event::Meets, event::Ray, event::Crossings,
               event::Octants, event::Angle, event::Hiding, event::SplitVertex, event::EdgeDepth, event::BackFace,
               event::CutToArea, event::Facets, event::Sorted, event::PushList, event::PopList, event::Beside,
               event::Clipped, event::NearerOnes, event::Show, event::Pierce, event::Split, event::GreatestDepth,
               event::EdgePiece, event::Entering, event::Leaving, event::Behind, event::Order, event::Paint,
               event::Painted, event::Horizons, event::Curve, event::SideEdge, event::Visibility, event::Intersection,
               event::DrawLine, event::Horizon, event::Height, event::Raise, event::Lower, event::Step>;

/// The names, each at the place of its type.
inline constexpr auto& event_names = AllEvents::names;

template <class E>
inline constexpr std::size_t event_place = AllEvents::place_of<E>();

template <class E>
concept EventType = event_place<E> < AllEvents::count;

/// Told by runs of curves alone: those from Horizons on.
template <class E>
concept CurveEvent = EventType<E> && event_place<E>
>= event_place<event::Horizons>;

class Event;

/// An event of any type where it lies, as long as it lies there.
class EventView {
public:
    template <EventType E>
    EventView(const E& event) : place_(event_place<E>), event_(&event) {}

    /// That of its type in AllEvents.
    std::size_t place() const { return place_; }

    /// None if it is of another type.
    template <EventType E>
    const E* get_if() const {
        return place_ == event_place<E> ? static_cast<const E*>(event_) : nullptr;
    }

    /// Calls `use(const event::Push&)` and so on, and gives what that gives.
    decltype(auto) visit(auto&& use) const { return visit_in(AllEvents{}, use); }

    Event copy() const;

private:
    template <class Use, class... Events>
    decltype(auto) visit_in(EventTypes<Events...>, Use& use) const {
        using Result = std::invoke_result_t<Use&, const event::Push&>;
        using Call = Result (*)(const void*, Use&);
        static constexpr Call calls[]{
            [](const void* event, Use& of) -> Result { return of(*static_cast<const Events*>(event)); }...};
        return calls[place_](event_, use);
    }

    std::size_t place_;
    const void* event_;
};

/// An event of any type. It does not change, so copies share it.
class Event : public EventView {
public:
    template <EventType E>
    Event(E event) : Event(std::make_shared<const E>(std::move(event))) {}

private:
    template <class E>
    explicit Event(std::shared_ptr<const E> event) : EventView(*event), owner_(std::move(event)) {}

    std::shared_ptr<const void> owner_;
};

}  // namespace vidno
