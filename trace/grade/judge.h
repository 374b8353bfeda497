/// Judge: checks the claims of a trace against the exact scene.
///
/// A claim is, for example, the depth of a polygon at a point, that a window is empty, or the colour of a pixel. The
/// judge checks the claims in the order of the trace. It requires no claim that the trace leaves out (claim_counts.h
/// counts the claims), and it accepts any order of windows, polygons, lists and corners, any rule for points of an
/// outline that scene_truth.h allows, and any of several equally near polygons. It lists these differences from our
/// procedures. The verdict is the first false claim or, if there is none, a wrong pixel of the final picture.
#pragma once

#include <array>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "format/event.h"
#include "format/floating_horizon_trace.h"
#include "format/trace_writer.h"
#include "grade/words.h"

namespace vidno {

/// The header of a trace of polygons or of curves.
using AnyHeader = std::variant<TraceHeader, FloatingHorizonHeader>;

/// The method of the trace, by its name.
std::string_view method_of(const AnyHeader& header);
/// The kernel, by its name.
const std::string& kernel_of(const AnyHeader& header);

/// The kind of a false claim. It tells whether a smaller scene shows the same failure, and which usual mistake a
/// program makes.
enum class Symptom : unsigned char {
    plane,       // not the polygon's
    depth,       // not that of the polygon's plane
    start,       // a polygon lies behind the initial depth
    comparison,  // which of two depths is nearer
    point_in_polygon,
    box,             // not the polygon's
    count,           // the number of polygons in a window
    contradiction,   // the case of a window does not follow from what was found in it
    left_list,       // a visible polygon left the list
    surrounded,      // no polygon surrounds the window and hides everything else in it
    overlooked,      // a visible polygon was not examined in the window
    not_plain,       // a window called empty or single is not
    too_small,       // a window of one pixel is split, or a larger one is called a pixel
    stray_window,    // not part of a split window, or the first window does not cover the area
    parts_missing,   // the parts of a window do not cover it
    clip,            // not the polygon's part in the window
    clipped_away,    // a polygon with a part in the window has vanished
    clipped_inside,  // a vertex in the window was dropped, or one outside it was kept
    insider,
    edge,         // an edge of AEL, or where a row meets a polygon
    off_window,   // pixels outside of the window
    off_polygon,  // pixels outside of the polygon
    hole,         // a pixel on a common edge belongs to no polygon
    colour,       // any other wrong colour
    not_painted,  // a pixel that was never painted
    height,       // not the curve's
    horizon,      // not that of the curves before
    visibility,   // a hidden part of a curve is drawn, or a visible part is not
    region,       // not the visible part of the polygon
    impossible    // an event that cannot follow the state before it
};

/// A claim that is false, in words.
struct Wrong {
    std::uint64_t step = 0;      // the number of events before it
    std::string at;              // the label of the listing's line; empty if only the picture is wrong
    std::string claimed, right;  // what the trace claims, and what is right
    Symptom symptom{};
};

/// Identifies a false claim across runs of a scene: its kind, and the window and polygon that it is about.
struct FalseClaim {
    Symptom symptom{};
    std::string about;
    auto operator<=>(const FalseClaim&) const = default;
};

/// How a right program may differ from our procedures.
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
    other_windows,
    touching
};

Bilingual words_of(Difference difference);

struct Judgement {
    std::optional<Wrong> wrong;
    std::vector<FalseClaim> false_claims;  // all of them; the first belongs to `wrong`
    std::set<Difference> differences;
    /// Each wrong pixel: its column, its row and the colour that it shows. Each wrong place of a curve: the curve, the
    /// place in quarters of a column, and whether the curve is drawn there. They count only if the run is complete.
    std::vector<std::array<int, 5>> wrong_places;
    int open_places = 0;        // pixels or columns where rounding may decide what shows
    bool shows_single = false;  // a number was rounded to float
    bool is_plain = false;      // no pixel centre lies on an outline, and no curve meets a horizon over a column
};

/// Judges the events of a trace that a program with numbers of that precision wrote. If `complete`, the run reached its
/// end, so the final picture must be right too. `words` chooses the language of the messages.
Judgement judge(const TraceHeader& header, const std::vector<Event>& events, bool complete, Precision precision,
                const Words& words = Words());
Judgement judge(const FloatingHorizonHeader& header, const std::vector<Event>& events, bool complete,
                Precision precision, const Words& words = Words());
Judgement judge(const AnyHeader& header, const std::vector<Event>& events, bool complete, Precision precision,
                const Words& words = Words());

/// Whether a float has the value of each number of the events.
bool in_floats(const std::vector<Event>& events);

}  // namespace vidno
