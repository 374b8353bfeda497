/// Judge: is what a trace tells right, by its meaning?
///
/// Each claim of the trace is held against the scene, in the order of the trace: that a polygon's depth at a point is this,
/// that a window is empty, that a pixel takes that colour. What the trace leaves out is not asked for (told.h says what that
/// is), and how the program came to a claim is its own affair: any order of windows, polygons, lists and corners, any rule for
/// points of an outline and any polygon of equally near ones is right (scene_truth.h says what is open), and is reported as
/// different where it differs. The first claim that is false is the answer; without one, the pixels that are left wrong.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "format/event.h"
#include "format/trace_writer.h"
#include "grade/words.h"

namespace vidno {

/// What kind of claim is false. By it a smaller scene is recognized as showing the same, and a usual mistake as itself.
enum class Symptom : unsigned char {
    plane,       // not the polygon's
    depth,       // not that of the plane
    start,       // something shows behind what the depths start at
    comparison,  // which of two depths is nearer
    point_in_polygon,
    box,             // not the polygon's
    count,           // of the polygons in a window
    contradiction,   // what a window is called does not follow from what was found in it
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
    edge,         // of AEL, or where a row meets a polygon
    off_window,   // pixels outside of the window
    off_polygon,  // pixels outside of the polygon
    hole,         // where polygons meet, the pixel belongs to nobody
    colour,       // any other wrong colour
    not_painted,  // pixels that nothing has painted
    horizon,      // not that of the curves before
    visibility,   // a part of a curve is drawn that is hidden, or not drawn that is visible
    region,       // not what is visible of the polygon
    impossible    // no state of the procedure that it could follow
};

/// A claim that is false, in words.
struct Wrong {
    std::uint64_t step = 0;   // the number of events before it
    std::string at;           // the label of the listing's line; empty where only the picture is wrong
    std::string told, right;  // what the trace says, and what is right
    Symptom symptom{};
};

/// A false claim in any run of the scene: of what kind, and about which window, polygon, curve or pixel.
struct FalseClaim {
    Symptom symptom{};
    std::string about;
    auto operator<=>(const FalseClaim&) const = default;
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
    breadth_first,
    other_windows
};

Bilingual words_of(Difference difference);

struct Judgement {
    std::optional<Wrong> wrong;
    std::vector<FalseClaim> false_claims;  // that one first
    std::set<Difference> differences;
    Picture picture;      // in the end
    int open_pixels = 0;  // where rounding may decide which of two polygons shows
};

/// Judges the events of a trace by a program whose numbers have that precision. `complete`: the run came to its end, so that the picture
/// is to be right as well.
Judgement judge(const TraceHeader& header, const std::vector<Event>& events, bool complete, Precision precision,
                const Words& words = Words());

/// The precision of a program that has written these traces: single if it says so, or if none of the many numbers that it tells needs more.
Precision precision_of(const std::vector<const std::vector<Event>*>& traces, bool says_single);

}  // namespace vidno
