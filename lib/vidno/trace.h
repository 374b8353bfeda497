/// Trace: the visitor that hears a run, one call for each event, in the procedures' own words.
///
/// Every event takes the label of the listing line that caused it, and values that the run already has. The recorder
/// (trace/run/recorder.h) turns them into text. trace/FORMAT.md explains each event. A visitor is passed by value and
/// may hold a pointer. Your own visitor hides the events that it wants to hear:
///
///     struct CountSplits : NoTrace {
///         int* splits;
///         void decide(Line, Case which) { *splits += which == Case::split; }
///     };
#pragma once

#include <array>
#include <string_view>

#include "line.h"

namespace vidno {

/// The cases of a window in Warnock's algorithm.
enum class Case : unsigned char { empty, surrounded, pixel, single, split };
inline constexpr std::array<std::string_view, 5> case_names{"empty", "surrounded", "pixel", "single", "split"};

/// Hears nothing and costs nothing. Derive from it to hear the run.
struct NoTrace {
    // Both methods
    void plane(Line, const auto& /*polygon*/, const auto& /*plane*/) {}
    void call(Line, Procedure) {}
    void depth(Line, const auto& /*polygon*/, const auto& /*point*/, const auto& /*z*/) {}
    void fault(Line, std::string_view /*reason*/) {}
    void fault(Line, std::string_view /*reason*/, int /*x*/, int /*y*/) {}

    // Warnock; corners go in the order of Corner
    void push_root(Line, const auto& /*active_windows*/) {}
    void push_part(Line, const auto& /*active_windows*/, bool /*shares_list*/) {}
    void skip(Line, const auto& /*window*/) {}
    void pop(Line, const auto& /*active_window*/) {}
    void decide(Line, Case) {}
    void fill(Line, const auto& /*pixel_rectangle*/, const auto& /*color*/) {}

    // ProcessWindow
    void corners(Line, const auto& /*depth*/) {}
    void box(Line, const auto& /*polygon*/, bool /*outside*/) {}
    void discard(Line, const auto& /*polygon*/) {}
    void count(Line, const auto& /*polygon*/, int /*polygon_count*/) {}
    void compare_corner(Line, const auto& /*polygon*/, int /*corner*/, const auto& /*z*/, const auto& /*against*/,
                        bool /*nearer*/) {}
    void nearer(Line, const auto& /*polygon*/, const std::array<bool, 4>& /*at_corner*/, int /*k*/) {}
    void uncover(Line, const auto& /*polygon*/) {}
    void mark(Line, const auto& /*polygon*/) {}
    void cover(Line, const auto& /*polygon*/) {}
    void insider(Line, const auto& /*polygon*/, bool /*inside*/) {}
    void summary(Line, const auto& /*summary*/) {}

    // PointColor
    void compare(Line, const auto& /*polygon*/, const auto& /*z*/, const auto& /*against*/, bool /*nearer*/) {}
    void nearest(Line, const auto& /*polygon*/, const auto& /*z*/) {}
    void color(Line, const auto& /*point*/, const auto& /*color*/) {}

    // SurroundTest
    void orient(Line, const auto& /*polygon*/, int /*edge*/, const auto& /*point*/, const auto& /*value*/,
                auto /*sign*/) {}
    void surround(Line, const auto& /*polygon*/, const auto& /*point*/, bool /*inside*/) {}

    // PolygonClip
    void clip_begin(Line, const auto& /*polygon*/, const auto& /*window*/) {}
    void clip_side(Line, int /*side*/, const auto& /*from*/, const auto& /*to*/) {}
    void clip_sign(Line, const auto& /*vertex*/, const auto& /*value*/, auto /*sign*/) {}
    void clip_cross(Line, const auto& /*vertex*/) {}
    void clip_keep(Line, const auto& /*vertex*/) {}
    void clip_drop(Line, const auto& /*vertex*/) {}
    void clip_list(Line, const auto& /*vertices*/) {}
    void clip_result(Line, const auto& /*polygon*/, const auto& /*vertices*/) {}

    // FillPolygon
    void row(Line, int /*row*/, const auto& /*left*/, const auto& /*right*/, int /*first*/, int /*end*/) {}
    void draw(Line, const auto& /*polygon*/, const auto& /*runs*/) {}

    // ZBuffer
    void clear(Line, const auto& /*color*/, const auto& /*z*/) {}
    void polygon(Line, const auto& /*polygon*/) {}
    void edge(Line, const auto& /*edge*/) {}
    void extent(Line, const auto& /*ymin*/, const auto& /*ymax*/) {}
    void scanline(Line, const auto& /*y*/, int /*row*/) {}
    void ael_add(Line, const auto& /*active_edge*/) {}
    void horizontal(Line, const auto& /*edge*/) {}
    void leave(Line, const auto& /*edges*/, const auto& /*next*/) {}
    void ael_sort(Line, const auto& /*active_edge_list*/, const auto& /*next*/) {}
    void ael_drop(Line, const auto& /*active_edges*/, const auto& /*next*/) {}
    void ael_step(Line, const auto& /*active_edge*/) {}

    // ShowLine
    void line(Line, int /*row*/, const auto& /*from*/, const auto& /*to*/) {}
    void miss(Line) {}
    void slope(Line, const auto& /*dz*/) {}
    void columns(Line, int /*first*/, int /*end*/, const auto& /*z*/) {}
    void pixel(Line, int /*x*/, int /*y*/, const auto& /*z*/, const auto& /*stored*/, bool /*shown*/) {}
    void span(Line) {}

    // FloatingHorizon
    void horizons(Line, const auto& /*horizons*/) {}
    void curve(Line, int /*curve*/) {}
    void side_edge(Line, const auto& /*sample*/) {}
    void visibility(Line, const auto& /*segment*/, int /*column*/, auto /*flag*/) {}
    void horizon(Line, const auto& /*segment*/, int /*first*/, int /*last*/) {}
    void intersection(Line, const auto& /*segment*/, const auto& /*line_end*/) {}
    void draw_line(Line, const auto& /*segment*/, const auto& /*from*/, const auto& /*to*/) {}

    // Visibility
    void height(Line, int /*column*/, const auto& /*y*/, const auto& /*upper*/, const auto& /*lower*/) {}

    // Horizon
    void raise(Line, int /*column*/, const auto& /*y*/) {}
    void lower(Line, int /*column*/, const auto& /*y*/) {}

    // Intersection
    void step(Line, int /*column*/, bool /*changes*/) {}

    // The Warnock family: ThreeListsWarnock, Relation
    void join(Line, auto /*relation*/, const auto& /*list*/) {}    // the last element has joined
    void rejoin(Line, auto /*relation*/, const auto& /*list*/) {}  // the last element goes back
    void relation(Line, const auto& /*polygon*/, auto /*relation*/) {}

    // TrialFunction, RayCrossings, OctantAngles
    void trial(Line, const auto& /*polygon*/, int /*edge*/, bool /*meets*/) {}
    void meets(Line, const auto& /*polygon*/, bool /*meets*/) {}
    void ray(Line, const auto& /*polygon*/, int /*edge*/, int /*counts*/) {}
    void crossings(Line, const auto& /*polygon*/, int /*count*/) {}
    void octants(Line, const auto& /*polygon*/, int /*edge*/, int /*from*/, int /*to*/, int /*difference*/) {}
    void angle(Line, const auto& /*polygon*/, int /*octants*/) {}

    // HidingPolygon, VertexSplit, EdgeDepth, BackFaces
    void hiding(Line, const auto* /*polygon*/) {}
    void split_vertex(Line, const auto& /*polygon*/, int /*vertex*/, int /*column*/, int /*row*/, bool /*splits*/) {}
    void edge_depth(Line, const auto& /*polygon*/, int /*edge*/, const auto& /*z*/) {}
    void back_face(Line, const auto& /*polygon*/, bool /*away*/) {}

    // WeilerAtherton; a piece is a part of a polygon, with its region
    void cut_to_area(Line, const auto& /*polygon*/, const auto& /*region*/) {}
    void facets(Line, const auto& /*pieces*/) {}  // what SplitPiercing gives
    void sorted(Line, const auto& /*pieces*/) {}
    void push_list(Line, const auto& /*pieces*/) {}
    void pop_list(Line, const auto& /*pieces*/) {}
    void beside(Line, const auto& /*polygon*/) {}
    void nearer_ones(Line, const auto& /*pieces*/) {}
    void show_region(Line, const auto& /*polygon*/, const auto& /*region*/) {}

    // SplitPiercing
    void pierce(Line, const auto& /*polygon*/, const auto& /*other_polygon*/, const auto& /*support_line*/) {}
    void split(Line, const auto& /*polygon*/, const auto& /*region*/, const auto& /*other_region*/) {}

    // DepthSort
    void greatest_depth(Line, const auto& /*polygon*/, const auto& /*z*/) {}

    // RegionClip
    void edge_piece(Line, const auto& /*from*/, const auto& /*to*/, auto /*lies*/) {}
    void enter(Line, const auto& /*point*/) {}
    void leave(Line, const auto& /*point*/) {}
    void clipped(Line, const auto& /*polygon*/, const auto& /*clip_polygon*/, const auto& /*inside*/,
                 const auto& /*outside*/) {}

    // RemoveBehind
    void behind(Line, const auto& /*polygon*/, const auto& /*clip_polygon*/, const auto& /*point*/, const auto& /*z*/,
                const auto& /*clip_z*/, auto /*order*/, bool /*behind*/) {}

    // PaintRegions; it reports the rows of a region as FillPolygon does
    void order(Line, const auto& /*polygon*/, const auto& /*other_polygon*/, const auto& /*point*/, const auto& /*z*/,
               const auto& /*other_z*/, auto /*order*/) {}
    void paint(Line, const auto& /*polygon*/, int /*x*/, int /*y*/) {}
    void region_painted(Line) {}
    void painted(Line) {}
};

}  // namespace vidno
