/// Judge: is what a trace tells right, by its meaning?
///
/// Each claim of the trace is held against the scene, in the order of the trace: that a polygon's depth at a point is this,
/// that a window is empty, that a pixel takes that colour. What the trace leaves out is not asked for, and how the program
/// came to a claim is its own affair: any order of windows, polygons, lists and corners, any rule for points of an outline and
/// any polygon of equally near ones is right (scene_truth.h says what is open), and is reported as different where it differs.
/// The first claim that is false is the answer; without one, the pixels that are left wrong.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "format/event.h"
#include "format/trace_writer.h"
#include "grade/scene_truth.h"

namespace vidno {

/// What kind of claim is false. By it a smaller scene is recognized as showing the same, and a usual mistake as itself.
enum class Symptom : unsigned char {
    plane,       // not the polygon's
    depth,       // not that of the plane
    start,       // something shows behind what the depths start at
    comparison,  // which of two depths is nearer
    point_in_polygon,
    left_list,       // a polygon that shows left the list
    surrounded,      // by a polygon before which another shows
    overlooked,      // a polygon that shows was not looked at in the window
    not_plain,       // a window is called empty or single that is not
    too_small,       // a window of a pixel is split, or a larger one called a pixel
    stray_window,    // no part of one that was split, or the first one does not cover the area
    parts_missing,   // the parts of a window do not cover it
    clip,            // not the part in the window
    clipped_away,    // nothing is left of a polygon that has a part in the window
    clipped_inside,  // a vertex in the window is dropped, or one outside kept
    insider,
    edge,         // of AEL
    off_window,   // pixels outside of the window
    off_polygon,  // pixels outside of the polygon
    hole,         // where polygons meet, the pixel belongs to nobody
    colour,       // any other wrong colour
    not_painted,  // pixels that nothing has painted
    impossible    // no state of the procedure that it could follow
};

/// A claim that is false, in words.
struct Wrong {
    std::uint64_t step = 0;   // the number of events before it is told
    std::string at;           // the label of the listing's line; empty where only the picture is wrong
    std::string told, right;  // what the trace says, and what is right
    Symptom symptom{};
};

/// How a program may differ from ours and be as right.
enum class Difference : unsigned char {
    order_of_parts,
    order_of_polygons,
    order_of_vertices,
    outline,
    equally_near,
    hidden_leave,
    single_precision,
    recursion,
    other_windows
};

/// "the parts of a window in another order", ...
std::string_view words_of(Difference difference);

struct Judgement {
    std::optional<Wrong> wrong;
    std::set<Difference> differences;
    Picture picture;  // in the end
};

/// Judges the events of a trace. `complete`: the run came to its end, so that the picture is to be right as well.
Judgement judge(const TraceHeader& header, const std::vector<Event>& events, bool complete);

}  // namespace vidno
