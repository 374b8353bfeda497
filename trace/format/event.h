/// Event: one line of a trace, as values. FORMAT.md says what each means.
///
/// This is the one table of events. Each is a struct with its name, the level from which it appears, its lines, its
/// meaning, and its fields in order. The writer, the readers and the recorder's filter are derived from it, and so are
/// the tables of FORMAT.md, the schema and the page's types (event_table/).
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "format/value.h"
#include "format/verdict.h"
#include "vidno/family/relation.h"
#include "vidno/floating_horizon/horizons.h"
#include "vidno/kernel.h"
#include "vidno/picture.h"
#include "vidno/trace.h"
#include "vidno/weiler_atherton/region.h"

namespace vidno {

enum class Detail : unsigned char { windows, polygons, signs };
inline constexpr std::array<std::string_view, 3> detail_names{"windows", "polygons", "signs"};

/// A polygon by its index in the scene; the file has its id.
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

/// A part of a polygon; ground if it is known to be behind all others of its list.
struct PolygonPart {
    PolygonPlace polygon;
    RegionLoops region;
    bool ground = false;
    bool operator==(const PolygonPart&) const = default;
};

/// The two lists besides the APL, in methods with three lists.
enum class OtherList : unsigned char { surrounding, outside };
inline constexpr std::array<std::string_view, 2> other_list_names{"surrounding", "outside"};

using ColumnHeight = std::pair<int, Value>;
using ReportedSample = std::pair<int, double>;
/// The segment of the current curve between the samples on these columns.
using SegmentColumns = std::pair<int, int>;

/// Some lines of the listings.
class LineSet {
public:
    constexpr LineSet(std::initializer_list<Line> lines) {
        for (const Line line : lines) add(line);
    }
    static constexpr LineSet all() {
        LineSet set{};
        set.has_.fill(true);
        return set;
    }
    constexpr void add(Line line) { has_[std::size_t(line)] = true; }
    constexpr bool has(Line line) const { return has_[std::size_t(line)]; }
    constexpr bool operator==(const LineSet&) const = default;

private:
    std::array<bool, line_names.size()> has_{};
};

/// The meaning of a field beyond its type: its word in FORMAT.md, and the range of its whole numbers.
struct Meaning {
    std::string_view word;
    int least = std::numeric_limits<int>::min();
    int most = std::numeric_limits<int>::max();
    constexpr bool has(int number) const { return least <= number && number <= most; }
};
inline constexpr Meaning any_number{};
constexpr Meaning within(int least, int most = std::numeric_limits<int>::max()) { return {"", least, most}; }

namespace event {

using enum Line;

struct Kind {
    std::string_view name;
    Detail from;
};

inline constexpr LineSet any_line = LineSet::all();
inline constexpr Meaning natural = within(0);
inline constexpr Meaning edge_number{"edge", 0};
inline constexpr Meaning of_samples{"segment"};
inline constexpr Meaning end_columns{"columns"};

/// The last fields of a decision.
void checked_fields(auto& checked, auto&& field) {
    field("exact", checked.exact);
    field("by", checked.by);
    field("operands", checked.operands);
}

struct Plane {
    static constexpr Kind kind{"plane", Detail::polygons};
    static constexpr LineSet lines{I1};
    static constexpr std::string_view says =
        "a, b, c, d of the plane a x + b y + c z + d = 0; result of InitializePolygon";
    Line at{};
    PolygonPlace polygon;
    std::array<Value, 4> plane;
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("plane", e.plane);
    }
};

/// A decision on which exact arithmetic differs along the same path.
struct Disagree {
    static constexpr Kind kind{"disagree", Detail::windows};
    static constexpr LineSet lines = any_line;
    static constexpr std::string_view says =
        "exact arithmetic decides differently: see below. The line is that of the event before";
    Line at{};  // that of the event before, which reports the decision or is the first after it
    Decision of{};
    Answer taken, exact;
    Cause cause{};
    std::optional<Operands> operands;
    static void fields(auto& e, auto&& field) {
        field("of", e.of);
        field("taken", e.taken);
        field("exact", e.exact);
        field("cause", e.cause);
        field("operands", e.operands);
    }
};

/// The level from which the calls of a procedure are reported: below `signs` nothing happens inside some. The result of
/// a call is the event with that procedure as its `result_of`.
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
    static constexpr LineSet lines = any_line;
    static constexpr std::string_view says =
        "a procedure begins; *The call stack* says which ones appear only from level `signs` on";
    Line at{};
    Procedure of{};
    static void fields(auto& e, auto&& field) { field("of", e.of); }
};

/// The level from which an event appears.
template <class E>
constexpr Detail level_of(const E& e) {
    if constexpr (std::same_as<E, Call>) {
        return calls_from(e.of);
    } else {
        return E::kind.from;
    }
}

struct Depth {
    static constexpr Kind kind{"depth", Detail::polygons};
    static constexpr LineSet lines{PW5, PC3, Z3, HP3, DS1, RB2};
    static constexpr std::string_view says = "the depth of the polygon's plane at the point; result of Depth";
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
    static constexpr LineSet lines = any_line;
    static constexpr std::string_view says =
        "the printed text fails at this line. With a pixel: it writes outside the area, and the write is skipped. "
        "Without one, the run ends. At RC4, RC5 and SP3 rounding left an outline open; the outline is left out, "
        "and the run goes on";
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
    static constexpr LineSet lines{W3, W13, WS1, WS6, WF1, WF12};
    static constexpr std::string_view says =
        "a window is put on AW. The first window comes with its APL. The APL of a part is a copy of the current "
        "one; with `shared`, which is true, it is the current one, and later changes show in both";
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
    static constexpr LineSet lines{W13, WS6, WF12};
    static constexpr std::string_view says = "a part of the window lies off the area and is not pushed";
    Line at{};
    Window window;
    static void fields(auto& e, auto&& field) { field("window", e.window); }
};

struct Pop {
    static constexpr Kind kind{"pop", Detail::windows};
    static constexpr LineSet lines{W5, WS2, WF2};
    static constexpr std::string_view says = "the top of AW becomes the current window, its APL the current APL";
    Line at{};
    Window window;
    static void fields(auto& e, auto&& field) { field("window", e.window); }
};

struct Decide {
    static constexpr Kind kind{"decide", Detail::windows};
    static constexpr LineSet lines{W7, W8, W9, W10, W13, WS4, WS5, WS6, WF5, WF6, WF9, WF10, WF11, WF12};
    static constexpr std::string_view says = "which case the window is";
    Line at{};
    Case which{};
    static void fields(auto& e, auto&& field) { field("case", e.which); }
};

struct Fill {
    static constexpr Kind kind{"fill", Detail::windows};
    static constexpr LineSet lines{W7, W8, W9, W10, WS4, WS5, WF5, WF6, WF9, WF10, WF11};
    static constexpr std::string_view says = "the window's pixels take the colour";
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
    static constexpr LineSet lines{PW1, HP1};
    static constexpr std::string_view says = "all four corner depths start at z";
    Line at{};
    Value z;
    static void fields(auto& e, auto&& field) { field("z", e.z); }
};

struct Box {
    static constexpr Kind kind{"box", Detail::signs};
    static constexpr LineSet lines{PW3, WS3, RE1};
    static constexpr std::string_view says =
        "the polygon's box, xmin, ymin, xmax, ymax, and whether it lies outside the window";
    Line at{};
    PolygonPlace polygon;
    std::array<Value, 4> box;
    bool outside = false;
    CheckedFields checked;
    static constexpr Decision decides = Decision::outside;
    Answer decision() const { return outside; }
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("box", e.box);
        field("outside", e.outside);
        checked_fields(e.checked, field);
    }
};

struct Discard {
    static constexpr Kind kind{"discard", Detail::polygons};
    static constexpr LineSet lines{PW3, WS3};
    static constexpr std::string_view says = "the polygon leaves the current APL";
    Line at{};
    PolygonPlace polygon;
    static void fields(auto& e, auto&& field) { field("polygon", e.polygon); }
};

struct Count {
    static constexpr Kind kind{"count", Detail::polygons};
    static constexpr LineSet lines{PW4};
    static constexpr std::string_view says = "the polygon is counted: polygonCount so far";
    Line at{};
    PolygonPlace polygon;
    int count = 0;
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("count", e.count, natural);
    }
};

struct Compare {
    static constexpr Kind kind{"compare", Detail::signs};
    static constexpr LineSet lines{PW6, PC4, HP4};
    static constexpr std::string_view says =
        "is depth z strictly greater than the nearest so far; at a corner of the window, or at the point of "
        "PointColor";
    Line at{};
    PolygonPlace polygon;
    std::optional<Corner> corner;
    Value z, against;
    bool nearer = false;
    CheckedFields checked;
    static constexpr Decision decides = Decision::nearer;
    Answer decision() const { return nearer; }
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("corner", e.corner);
        field("z", e.z);
        field("against", e.against);
        field("nearer", e.nearer);
        checked_fields(e.checked, field);
    }
};

struct Nearer {
    static constexpr Kind kind{"nearer", Detail::polygons};
    static constexpr LineSet lines{PW6, HP4};
    static constexpr std::string_view says =
        "at these k corners the polygon is now the nearest; its `depth` there becomes the corner depth";
    Line at{};
    PolygonPlace polygon;
    std::vector<Corner> corners;
    int k = 0;
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("corners", e.corners);
        field("k", e.k, within(0, 4));
    }
};

struct Uncover {
    static constexpr Kind kind{"uncover", Detail::polygons};
    static constexpr LineSet lines{PW7, HP5};
    static constexpr std::string_view says = "hasSurround := false";
    Line at{};
    PolygonPlace polygon;
    static void fields(auto& e, auto&& field) { field("polygon", e.polygon); }
};

struct Mark {
    static constexpr Kind kind{"mark", Detail::polygons};
    static constexpr LineSet lines{PW8};
    static constexpr std::string_view says = "S := true for this polygon in the current APL: it surrounds the window";
    Line at{};
    PolygonPlace polygon;
    static void fields(auto& e, auto&& field) { field("polygon", e.polygon); }
};

struct Cover {
    static constexpr Kind kind{"cover", Detail::polygons};
    static constexpr LineSet lines{PW9, HP6};
    static constexpr std::string_view says = "hasSurround := true and C := its colour";
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
    static constexpr LineSet lines{PW10, RE2};
    static constexpr std::string_view says = "does its box lie strictly inside the window";
    Line at{};
    PolygonPlace polygon;
    bool inside = false;
    CheckedFields checked;
    static constexpr Decision decides = Decision::inside;
    Answer decision() const { return inside; }
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("inside", e.inside);
        checked_fields(e.checked, field);
    }
};

struct Summary {
    static constexpr Kind kind{"summary", Detail::polygons};
    static constexpr LineSet lines{W6};
    static constexpr std::string_view says = "what ProcessWindow found; the colour only with hasSurround";
    static constexpr Procedure result_of = Procedure::process_window;
    Line at{};
    int count = 0;
    bool has_surround = false;
    std::optional<Color> color;
    bool insider = false;
    static void fields(auto& e, auto&& field) {
        field("count", e.count, natural);
        field("hasSurround", e.has_surround);
        field("color", e.color);
        field("insider", e.insider);
    }
};

// PointColor, SurroundTest

struct Nearest {
    static constexpr Kind kind{"nearest", Detail::polygons};
    static constexpr LineSet lines{PC4};
    static constexpr std::string_view says = "z and C of PointColor so far";
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
    static constexpr LineSet lines{W9, WS5, WF11};
    static constexpr std::string_view says = "the colour at the point";
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
    static constexpr LineSet lines{PW8, PC2};
    static constexpr std::string_view says = "does the polygon surround the point";
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
    static constexpr LineSet lines{S2, S3, TF2, CR4, OA4, ED3, BF1};
    static constexpr std::string_view says =
        "on which side of the edge the point lies; S2 while no sign was found, S3 after it. The text above "
        "the table of the family says what the point is at its lines";
    Line at{};
    PolygonPlace polygon;
    int edge = 0;
    ValuePoint point;
    Value value;
    Sign sign{};
    CheckedFields checked;
    static constexpr Decision decides = Decision::orientation;
    Answer decision() const { return int(sign); }
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("edge", e.edge, edge_number);
        field("point", e.point);
        field("value", e.value);
        field("sign", e.sign);
        checked_fields(e.checked, field);
    }
};

// PolygonClip, FillPolygon

struct ClipBegin {
    static constexpr Kind kind{"clip_begin", Detail::polygons};
    static constexpr LineSet lines{PL1};
    static constexpr std::string_view says = "the list of PolygonClip is the polygon's vertices";
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
    static constexpr LineSet lines{PL2};
    static constexpr std::string_view says = "clipping by the side from f0 to F_i begins, with an empty new list";
    Line at{};
    int side = 0;
    ValuePoint from, to;
    static void fields(auto& e, auto&& field) {
        field("side", e.side, within(1, 4));
        field("from", e.from);
        field("to", e.to);
    }
};

struct ClipSign {
    static constexpr Kind kind{"clip_sign", Detail::signs};
    static constexpr LineSet lines{PL3, PL4};
    static constexpr std::string_view says = "Q0 or Q1: positive lies outside";
    Line at{};
    ValueVertex vertex;
    Value value;
    Sign sign{};
    CheckedFields checked;
    static constexpr Decision decides = Decision::orientation;
    Answer decision() const { return int(sign); }
    static void fields(auto& e, auto&& field) {
        field("vertex", e.vertex);
        field("value", e.value);
        field("sign", e.sign);
        checked_fields(e.checked, field);
    }
};

struct ClipCross {
    static constexpr Kind kind{"clip_cross", Detail::polygons};
    static constexpr LineSet lines{PL5};
    static constexpr std::string_view says = "the crossing with the line of the side joins the new list";
    Line at{};
    ValueVertex vertex;
    static void fields(auto& e, auto&& field) { field("vertex", e.vertex); }
};

struct ClipKeep {
    static constexpr Kind kind{"clip_keep", Detail::polygons};
    static constexpr LineSet lines{PL6};
    static constexpr std::string_view says = "the vertex joins the new list";
    Line at{};
    ValueVertex vertex;
    static void fields(auto& e, auto&& field) { field("vertex", e.vertex); }
};

struct ClipDrop {
    static constexpr Kind kind{"clip_drop", Detail::polygons};
    static constexpr LineSet lines{PL6};
    static constexpr std::string_view says = "the vertex lies outside and does not";
    Line at{};
    ValueVertex vertex;
    static void fields(auto& e, auto&& field) { field("vertex", e.vertex); }
};

struct ClipList {
    static constexpr Kind kind{"clip_list", Detail::polygons};
    static constexpr LineSet lines{PL7};
    static constexpr std::string_view says = "the new list becomes the list";
    Line at{};
    int count = 0;
    static void fields(auto& e, auto&& field) { field("count", e.count, natural); }
};

struct ClipResult {
    static constexpr Kind kind{"clip_result", Detail::polygons};
    static constexpr LineSet lines{W12, WF8};
    static constexpr std::string_view says = "the part of the polygon in the window";
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
    static constexpr LineSet lines{F2, PR1};
    static constexpr std::string_view says =
        "where the centre line of a row meets the polygon, or a visible region, and which pixel centres lie "
        "between; of a region twice, just above the line and just below it";
    Line at{};
    int row = 0;
    Value left, right;
    int first = 0, end = 0;
    CheckedFields checked;
    static constexpr Decision decides = Decision::columns;
    Answer decision() const { return std::pair(first, end); }
    static void fields(auto& e, auto&& field) {
        field("row", e.row);
        field("left", e.left);
        field("right", e.right);
        field("first", e.first);
        field("end", e.end);
        checked_fields(e.checked, field);
    }
};

struct Draw {
    static constexpr Kind kind{"draw", Detail::windows};
    static constexpr LineSet lines{W11, W12, WF7, WF8};
    static constexpr std::string_view says = "these runs take the colour";
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
    static constexpr LineSet lines{Z1};
    static constexpr std::string_view says = "every pixel takes the colour, every cell of Z the depth";
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
    static constexpr LineSet lines{Z2};
    static constexpr std::string_view says = "the next polygon; S and AEL are empty";
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
    static constexpr LineSet lines{Z3};
    static constexpr std::string_view says =
        "joins S at its end: edges come sorted. The rows are those whose centre it crosses, first to last; none if "
        "last < first";
    Line at{};
    int edge = 0;
    ValueVertex from, to;
    std::optional<std::pair<int, int>> rows;
    static void fields(auto& e, auto&& field) {
        field("edge", e.edge, edge_number);
        field("from", e.from);
        field("to", e.to);
        field("rows", e.rows);
    }
};

struct Extent {
    static constexpr Kind kind{"extent", Detail::polygons};
    static constexpr LineSet lines{Z4};
    static constexpr std::string_view says = "the polygon's least and greatest y";
    Line at{};
    Value ymin, ymax;
    static void fields(auto& e, auto&& field) {
        field("ymin", e.ymin);
        field("ymax", e.ymax);
    }
};

struct Scanline {
    static constexpr Kind kind{"scanline", Detail::windows};
    static constexpr LineSet lines{Z6};
    static constexpr std::string_view says = "y_t; corrected: the row's centre";
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
    static constexpr LineSet lines{Z8};
    static constexpr std::string_view says = "joins AEL at its end; until: its third element (corrected: its last row)";
    Line at{};
    int edge = 0;
    Value x, z, until, dx, dz;
    static void fields(auto& e, auto&& field) {
        field("edge", e.edge, edge_number);
        field("x", e.x);
        field("z", e.z);
        field("until", e.until);
        field("dx", e.dx);
        field("dz", e.dz);
    }
};

struct Horizontal {
    static constexpr Kind kind{"horizontal", Detail::polygons};
    static constexpr LineSet lines{Z9};
    static constexpr std::string_view says = "a level edge on this scanline is shown by ShowLine";
    Line at{};
    int edge = 0;
    static void fields(auto& e, auto&& field) { field("edge", e.edge, edge_number); }
};

struct Leave {
    static constexpr Kind kind{"leave", Detail::polygons};
    static constexpr LineSet lines{Z10};
    static constexpr std::string_view says = "these leave S; next: y_Snext (corrected: a row)";
    Line at{};
    std::vector<int> edges;
    Value next;
    static void fields(auto& e, auto&& field) {
        field("edges", e.edges, edge_number);
        field("next", e.next);
    }
};

struct AelSort {
    static constexpr Kind kind{"ael_sort", Detail::polygons};
    static constexpr LineSet lines{Z12};
    static constexpr std::string_view says =
        "AEL in this order; next: y_AELnext (corrected: the first row after the one at which an entry ends)";
    Line at{};
    std::vector<int> edges;
    Value next;
    static void fields(auto& e, auto&& field) {
        field("edges", e.edges, edge_number);
        field("next", e.next);
    }
};

struct AelDrop {
    static constexpr Kind kind{"ael_drop", Detail::polygons};
    static constexpr LineSet lines{Z16};
    static constexpr std::string_view says = "these leave AEL; next: y_AELnext";
    Line at{};
    std::vector<int> edges;
    Value next;
    static void fields(auto& e, auto&& field) {
        field("edges", e.edges, edge_number);
        field("next", e.next);
    }
};

struct AelStep {
    static constexpr Kind kind{"ael_step", Detail::polygons};
    static constexpr LineSet lines{Z17};
    static constexpr std::string_view says = "the entry's new x and z";
    Line at{};
    int edge = 0;
    Value x, z;
    static void fields(auto& e, auto&& field) {
        field("edge", e.edge, edge_number);
        field("x", e.x);
        field("z", e.z);
    }
};

struct ShownLine {
    static constexpr Kind kind{"line", Detail::polygons};
    static constexpr LineSet lines{L1};
    static constexpr std::string_view says = "ShowLine's row and its ends (x, z)";
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
    static constexpr LineSet lines{L1, L2};
    static constexpr std::string_view says =
        "nothing to show: return. L1 (printed): the scanline lies above or below the area. L2: no pixel centre of the "
        "area "
        "lies between the ends (printed: `from` lies right of the area, or `to` left of it)";
    Line at{};
    static void fields(auto&, auto&&) {}
};

struct Slope {
    static constexpr Kind kind{"slope", Detail::signs};
    static constexpr LineSet lines{L3};
    static constexpr std::string_view says = "the change of the depth from pixel to pixel";
    Line at{};
    Value dz;
    static void fields(auto& e, auto&& field) { field("dz", e.dz); }
};

struct Columns {
    static constexpr Kind kind{"columns", Detail::signs};
    static constexpr LineSet lines{L4};
    static constexpr std::string_view says = "corrected: the pixel centres between the ends, the depth at the first";
    Line at{};
    int first = 0, end = 0;
    Value z;
    CheckedFields checked;
    static constexpr Decision decides = Decision::columns;
    Answer decision() const { return std::pair(first, end); }
    static void fields(auto& e, auto&& field) {
        field("first", e.first);
        field("end", e.end);
        field("z", e.z);
        checked_fields(e.checked, field);
    }
};

struct Pixel {
    static constexpr Kind kind{"pixel", Detail::signs};
    static constexpr LineSet lines{L6};
    static constexpr std::string_view says = "the depth z against the cell's";
    Line at{};
    int x = 0, y = 0;
    Value z, stored;
    bool shown = false;
    CheckedFields checked;
    static constexpr Decision decides = Decision::nearer;
    Answer decision() const { return shown; }
    static void fields(auto& e, auto&& field) {
        field("x", e.x);
        field("y", e.y);
        field("z", e.z);
        field("stored", e.stored);
        field("shown", e.shown);
        checked_fields(e.checked, field);
    }
};

/// The depths are there from level `polygons`.
struct Span {
    static constexpr Kind kind{"span", Detail::windows};
    static constexpr LineSet lines{Z9, Z14};
    static constexpr std::string_view says =
        "these pixels take the polygon's colour, their cells these depths, run after run; the depths from level "
        "`polygons` on";
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
    static constexpr LineSet lines{WF4};
    static constexpr std::string_view says =
        "the polygon leaves the APL and joins that list at its end; the current window is of that level";
    Line at{};
    PolygonPlace polygon;
    OtherList list{};
    int level = 0;
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("list", e.list);
        field("level", e.level, natural);
    }
};

struct Rejoin {
    static constexpr Kind kind{"rejoin", Detail::polygons};
    static constexpr LineSet lines{WF3};
    static constexpr std::string_view says =
        "the polygon is the last of that list, which it joined at a window of that level; it goes back to its "
        "place in the APL, in the order of the scene";
    Line at{};
    PolygonPlace polygon;
    OtherList list{};  // the list that it leaves
    int level = 0;     // the level at which it joined that list
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("list", e.list);
        field("level", e.level, natural);
    }
};

struct RelationFound {
    static constexpr Kind kind{"relation", Detail::polygons};
    static constexpr LineSet lines{WF4};
    static constexpr std::string_view says = "the relation of the polygon to the window";
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
    static constexpr LineSet lines{TF3};
    static constexpr std::string_view says = "does the edge meet the window, its sides excepted";
    Line at{};
    PolygonPlace polygon;
    int edge = 0;
    bool meets = false;
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("edge", e.edge, edge_number);
        field("meets", e.meets);
    }
};

struct Meets {
    static constexpr Kind kind{"meets", Detail::polygons};
    static constexpr LineSet lines{RE3};
    static constexpr std::string_view says = "does any edge of the polygon";
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
    static constexpr LineSet lines{CR3, CR4};
    static constexpr std::string_view says =
        "how often the outline crosses the ray at the edge's beginning (CR3) or on it (CR4)";
    Line at{};
    PolygonPlace polygon;
    int edge = 0;
    int counts = 0;
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("edge", e.edge, edge_number);
        field("counts", e.counts, within(0, 2));
    }
};

struct Crossings {
    static constexpr Kind kind{"crossings", Detail::polygons};
    static constexpr LineSet lines{RE4};
    static constexpr std::string_view says = "how often the outline crosses the ray in all";
    static constexpr Procedure result_of = Procedure::ray_crossings;
    Line at{};
    PolygonPlace polygon;
    int count = 0;
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("count", e.count, natural);
    }
};

struct Octants {
    static constexpr Kind kind{"octants", Detail::signs};
    static constexpr LineSet lines{OA3, OA4};
    static constexpr std::string_view says =
        "the octants of the edge's ends, and the angle between them; at OA4 the edge was split";
    Line at{};
    PolygonPlace polygon;
    int edge = 0;
    int from = 0, to = 0, difference = 0;
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("edge", e.edge, edge_number);
        field("from", e.from, within(0, 7));
        field("to", e.to, within(0, 7));
        field("difference", e.difference, within(-4, 4));
    }
};

struct Angle {
    static constexpr Kind kind{"angle", Detail::polygons};
    static constexpr LineSet lines{RE4};
    static constexpr std::string_view says = "the sum of the differences";
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
    static constexpr LineSet lines{WF10};
    static constexpr std::string_view says = "the surrounding polygon that hides all others, if one was found";
    static constexpr Procedure result_of = Procedure::hiding_polygon;
    Line at{};
    std::optional<PolygonPlace> polygon;
    static void fields(auto& e, auto&& field) { field("polygon", e.polygon); }
};

struct SplitVertex {
    static constexpr Kind kind{"split_vertex", Detail::polygons};
    static constexpr LineSet lines{VS2};
    static constexpr std::string_view says =
        "a vertex in the window, the pixel boundaries next to it, and whether the window is split there";
    Line at{};
    PolygonPlace polygon;
    int vertex = 0;
    int column = 0, row = 0;
    bool splits = false;
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("vertex", e.vertex, natural);
        field("column", e.column);
        field("row", e.row);
        field("splits", e.splits);
    }
};

struct EdgeDepth {
    static constexpr Kind kind{"edge_depth", Detail::polygons};
    static constexpr LineSet lines{ED5};
    static constexpr std::string_view says = "the depth of an edge of an edge-on polygon in the line of sight";
    Line at{};
    PolygonPlace polygon;
    int edge = 0;
    Value z;
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("edge", e.edge, edge_number);
        field("z", e.z);
    }
};

struct BackFace {
    static constexpr Kind kind{"back_face", Detail::polygons};
    static constexpr LineSet lines{BF2};
    static constexpr std::string_view says = "does the polygon look away from the viewer, so that it takes no part";
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
    static constexpr LineSet lines{WA1};
    static constexpr std::string_view says = "the polygon's part in the area, perhaps empty";
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
    static constexpr LineSet lines{WA2};
    static constexpr std::string_view says = "the pieces to be sorted";
    static constexpr Procedure result_of = Procedure::split_piercing;
    Line at{};
    std::vector<PolygonPart> pieces;
    static void fields(auto& e, auto&& field) { field("pieces", e.pieces); }
};

struct Sorted {
    static constexpr Kind kind{"sorted", Detail::polygons};
    static constexpr LineSet lines{WA3};
    static constexpr std::string_view says = "the polygons of the pieces, the nearest first";
    static constexpr Procedure result_of = Procedure::depth_sort;
    Line at{};
    std::vector<PolygonPlace> polygons;
    static void fields(auto& e, auto&& field) { field("polygons", e.polygons); }
};

struct PushList {
    static constexpr Kind kind{"push_list", Detail::windows};
    static constexpr LineSet lines{WA3, WA6, WA9};
    static constexpr std::string_view says = "the list is put on the stack";
    Line at{};
    std::vector<PolygonPart> pieces;
    static void fields(auto& e, auto&& field) { field("pieces", e.pieces); }
};

struct PopList {
    static constexpr Kind kind{"pop_list", Detail::windows};
    static constexpr LineSet lines{WA4};
    static constexpr std::string_view says =
        "the top of the stack, a list with this number of pieces, becomes the current list; its first piece, which "
        "is of this polygon, clips the others";
    Line at{};
    PolygonPlace clip;  // the first of the list
    int count = 0;
    static void fields(auto& e, auto&& field) {
        field("clip", e.clip);
        field("count", e.count, within(1));
    }
};

struct Beside {
    static constexpr Kind kind{"beside", Detail::polygons};
    static constexpr LineSet lines{WA5};
    static constexpr std::string_view says =
        "the next piece of the current list has its box beside that of the clip polygon: it lies outside";
    Line at{};
    PolygonPlace polygon;
    static void fields(auto& e, auto&& field) { field("polygon", e.polygon); }
};

struct Clipped {
    static constexpr Kind kind{"clipped", Detail::polygons};
    static constexpr LineSet lines{WA5, SP1};
    static constexpr std::string_view says =
        "the next piece of the current list (at SP1 a piece of a pair) is cut in two, either perhaps empty";
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
    static constexpr LineSet lines{WA7};
    static constexpr std::string_view says = "the polygons of those pieces inside that are not behind";
    static constexpr Procedure result_of = Procedure::remove_behind;
    Line at{};
    std::vector<PolygonPlace> polygons;
    static void fields(auto& e, auto&& field) { field("polygons", e.polygons); }
};

struct Show {
    static constexpr Kind kind{"show", Detail::windows};
    static constexpr LineSet lines{WA8};
    static constexpr std::string_view says = "the clip polygon is visible";
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
    static constexpr LineSet lines{SP2};
    static constexpr std::string_view says =
        "the polygons pierce each other: the line in which their planes meet, through the point; on the side of "
        "the normal the first is nearer";
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
    static constexpr LineSet lines{SP3};
    static constexpr std::string_view says = "a piece of the polygon becomes these two";
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
    static constexpr LineSet lines{DS1};
    static constexpr std::string_view says = "the greatest depth of a piece of the polygon";
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
    static constexpr LineSet lines{RC2};
    static constexpr std::string_view says =
        "where a piece of the subject's outline lies in relation to the clip region; the last two words: on its "
        "outline";
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
    static constexpr LineSet lines{RC3};
    static constexpr std::string_view says = "the subject's outline enters the clip region here";
    Line at{};
    ValuePoint point;
    static void fields(auto& e, auto&& field) { field("point", e.point); }
};

struct Leaving {
    static constexpr Kind kind{"leaving", Detail::polygons};
    static constexpr LineSet lines{RC3};
    static constexpr std::string_view says = "it leaves it here";
    Line at{};
    ValuePoint point;
    static void fields(auto& e, auto&& field) { field("point", e.point); }
};

struct Behind {
    static constexpr Kind kind{"behind", Detail::polygons};
    static constexpr LineSet lines{RB3};
    static constexpr std::string_view says =
        "the depths at the point, how z compares with clipZ, and whether the piece inside is hidden";
    Line at{};
    PolygonPlace polygon, clip;
    ValuePoint point;
    Value z, clip_z;
    Sign order{};
    bool behind = false;
    CheckedFields checked;
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
        checked_fields(e.checked, field);
    }
};

// PaintRegions

struct Order {
    static constexpr Kind kind{"order", Detail::signs};
    static constexpr LineSet lines{PR2, PR3};
    static constexpr std::string_view says = "how the depths of two polygons compare at a pixel's centre";
    Line at{};
    PolygonPlace polygon, other;
    ValuePoint point;
    Value z, other_z;
    Sign order{};
    CheckedFields checked;
    static constexpr Decision decides = Decision::comparison;
    Answer decision() const { return int(order); }
    static void fields(auto& e, auto&& field) {
        field("polygon", e.polygon);
        field("other", e.other);
        field("point", e.point);
        field("z", e.z);
        field("otherZ", e.other_z);
        field("order", e.order);
        checked_fields(e.checked, field);
    }
};

struct Paint {
    static constexpr Kind kind{"paint", Detail::windows};
    static constexpr LineSet lines{PR3};
    static constexpr std::string_view says = "these runs of the region's pixels take the colour";
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
    static constexpr LineSet lines{WA10};
    static constexpr std::string_view says = "the end of PaintRegions";
    static constexpr Procedure result_of = Procedure::paint_regions;
    Line at{};
    static void fields(auto&, auto&&) {}
};

// FloatingHorizon

/// Without heights there is no horizon over any column.
struct Horizons {
    static constexpr Kind kind{"horizons", Detail::polygons};
    static constexpr LineSet lines{FH1};
    static constexpr std::string_view says = "the horizons over every column; where a field is missing there is none";
    Line at{};
    std::optional<Value> upper, lower;
    static void fields(auto& e, auto&& field) {
        field("upper", e.upper);
        field("lower", e.lower);
    }
};

struct Curve {
    static constexpr Kind kind{"curve", Detail::windows};
    static constexpr LineSet lines{FH2};
    static constexpr std::string_view says = "the current curve, by its place in the scene";
    Line at{};
    int curve = 0;
    static void fields(auto& e, auto&& field) { field("curve", e.curve, natural); }
};

struct SideEdge {
    static constexpr Kind kind{"side_edge", Detail::polygons};
    static constexpr LineSet lines{FH3, FH10};
    static constexpr std::string_view says = "the left edge (FH3) or the right one has come to this sample";
    static constexpr Procedure result_of = Procedure::side_edge;
    Line at{};
    ReportedSample sample;
    static void fields(auto& e, auto&& field) { field("sample", e.sample); }
};

struct Visibility {
    static constexpr Kind kind{"visibility", Detail::polygons};
    static constexpr LineSet lines{FH4, FH5};
    static constexpr std::string_view says =
        "the curve over column x: 1 above the upper horizon or on it, -1 below the lower one or on it, 0 hidden, 2 "
        "both of the first two";
    static constexpr Procedure result_of = Procedure::visibility;
    Line at{};
    SegmentColumns segment;
    int x = 0;
    VisibilityFlag flag{};
    CheckedFields checked;
    static constexpr Decision decides = Decision::visibility;
    Answer decision() const { return int(flag); }
    static void fields(auto& e, auto&& field) {
        field("segment", e.segment, of_samples);
        field("x", e.x);
        field("flag", e.flag);
        checked_fields(e.checked, field);
    }
};

struct Intersection {
    static constexpr Kind kind{"intersection", Detail::polygons};
    static constexpr LineSet lines{FH7, FH8};
    static constexpr std::string_view says = "where the segment meets a horizon";
    static constexpr Procedure result_of = Procedure::intersection;
    Line at{};
    SegmentColumns segment;
    ValuePoint point;
    std::pair<int, int> columns;
    static void fields(auto& e, auto&& field) {
        field("segment", e.segment, of_samples);
        field("point", e.point);
        field("columns", e.columns, end_columns);
    }
};

struct DrawLine {
    static constexpr Kind kind{"draw_line", Detail::windows};
    static constexpr LineSet lines{FH6, FH7, FH8};
    static constexpr std::string_view says = "this part of the segment is visible";
    Line at{};
    SegmentColumns segment;
    ValuePoint from;
    std::pair<int, int> from_columns;
    ValuePoint to;
    std::pair<int, int> to_columns;
    static void fields(auto& e, auto&& field) {
        field("segment", e.segment, of_samples);
        field("from", e.from);
        field("fromColumns", e.from_columns, end_columns);
        field("to", e.to);
        field("toColumns", e.to_columns, end_columns);
    }
};

/// The columns where the horizons have changed, with the new heights.
struct Horizon {
    static constexpr Kind kind{"horizon", Detail::polygons};
    static constexpr LineSet lines{FH6, FH7, FH8, SE2};
    static constexpr std::string_view says =
        "the columns first <= x <= last were examined (none if last < first), and the horizons have changed over "
        "these";
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
    static constexpr LineSet lines{V1};
    static constexpr std::string_view says = "the curve's height over the column, and the horizons' that are there";
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
    static constexpr LineSet lines{H2};
    static constexpr std::string_view says = "the upper horizon over the column becomes y";
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
    static constexpr LineSet lines{H3};
    static constexpr std::string_view says = "the lower horizon over the column becomes y";
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
    static constexpr LineSet lines{IN2};
    static constexpr std::string_view says =
        "is the segment over this column on the other side of the horizon than over the first one";
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
    template <class E>
    static constexpr bool has() {
        return place_of<E>() < count;
    }
};

template <class... A, class... B>
EventTypes<A..., B...> operator+(EventTypes<A...>, EventTypes<B...>) {
    return {};
}

using EventsOfAll = EventTypes<event::Plane, event::Call, event::Disagree, event::Depth, event::Fault>;
using WarnockEvents =
    EventTypes<event::Push, event::Skip, event::Pop, event::Decide, event::Fill, event::Corners, event::Box,
               event::Discard, event::Count, event::Compare, event::Nearer, event::Uncover, event::Mark, event::Cover,
               event::Insider, event::Summary, event::Nearest, event::PointColor, event::Surround, event::Orient,
               event::ClipBegin, event::ClipSide, event::ClipSign, event::ClipCross, event::ClipKeep, event::ClipDrop,
               event::ClipList, event::ClipResult, event::Row, event::Draw>;
using ZBufferEvents =
    EventTypes<event::Clear, event::Polygon, event::Edge, event::Extent, event::Scanline, event::AelAdd,
               event::Horizontal, event::Leave, event::AelSort, event::AelDrop, event::AelStep, event::ShownLine,
               event::Miss, event::Slope, event::Columns, event::Pixel, event::Span>;
using FamilyEvents = EventTypes<event::Join, event::Rejoin, event::RelationFound, event::Trial, event::Meets,
                                event::Ray, event::Crossings, event::Octants, event::Angle, event::Hiding,
                                event::SplitVertex, event::EdgeDepth, event::BackFace>;
using WeilerAthertonEvents = EventTypes<event::CutToArea, event::Facets, event::Sorted, event::PushList, event::PopList,
                                        event::Beside, event::Clipped, event::NearerOnes, event::Show, event::Pierce,
                                        event::Split, event::GreatestDepth, event::EdgePiece, event::Entering,
                                        event::Leaving, event::Behind, event::Order, event::Paint, event::Painted>;
using FloatingHorizonEvents =
    EventTypes<event::Horizons, event::Curve, event::SideEdge, event::Visibility, event::Intersection, event::DrawLine,
               event::Horizon, event::Height, event::Raise, event::Lower, event::Step>;
using AllEvents = decltype(EventsOfAll{} + WarnockEvents{} + ZBufferEvents{} + FamilyEvents{} + WeilerAthertonEvents{} +
                           FloatingHorizonEvents{});

/// The names, each at the index of its type.
inline constexpr auto& event_names = AllEvents::names;

template <class E>
inline constexpr std::size_t event_place = AllEvents::place_of<E>();

template <class E>
concept EventType = event_place<E> < AllEvents::count;

/// Events that only runs of curves report.
template <class E>
concept FloatingHorizonEvent = FloatingHorizonEvents::has<E>();

class Event;

/// A view of an event of any type. It is valid as long as the event.
class EventView {
public:
    template <EventType E>
    EventView(const E& event) : place_(event_place<E>), event_(&event) {}

    /// The index of its type in AllEvents.
    std::size_t place() const { return place_; }

    /// Null if it has another type.
    template <EventType E>
    const E* get_if() const {
        return place_ == event_place<E> ? static_cast<const E*>(event_) : nullptr;
    }

    /// Calls `use(const event::Push&)` and so on, and returns its result.
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

    /// Whether both are copies of one event.
    bool operator==(const Event& other) const { return owner_ == other.owner_; }

private:
    template <class E>
    explicit Event(std::shared_ptr<const E> event) : EventView(*event), owner_(std::move(event)) {}

    std::shared_ptr<const void> owner_;
};

}  // namespace vidno
