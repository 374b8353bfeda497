/// WorkedRun: everything that someone who works a scene by hand writes down, taken from the trace of the exact run.
#pragma once

#include <map>
#include <memory>

#include "choice/method.h"
#include "moment.h"

namespace vidno::figures {

/// The entry of a polygon in a window's list.
struct WorkedEntry {
    bool leaves = false;                 // PW3
    bool surrounds = false;              // S_i, once the window is done
    int k = 0;                           // PW6
    std::optional<Relation> relation{};  // to the window, in Warnock's family
    bool operator==(const WorkedEntry&) const = default;
};

struct WorkedWindow {
    Window window;
    std::map<int, WorkedEntry> entries{};  // by the polygon's place
    Line line{};                           // W7 to W10, W13
    Case which{};
    std::optional<int> painted{};  // the polygon that shows in it; none: background, or a split
    std::uint64_t step = 0;        // at which it was taken from AW
};

/// The span of a polygon that is shown on a row: between two edges of the AEL, or a level edge, which is in no list.
struct WorkedRow {
    int polygon, row;
    std::vector<ZBufferState::ActiveEdge> edges{};
    int first = 0, end = 0;  // the pixels; none if there are no centres between
    std::uint64_t step = 0;
};

/// A list of Weiler and Atherton's algorithm: the polygons of its parts.
struct WorkedList {
    std::vector<int> polygons{};  // the clip polygon first
    std::vector<int> inside{}, outside{}, nearer{};
    bool visible = false;    // the clip polygon is; else the list is examined again
    std::uint64_t step = 0;  // at which it was taken from the stack
};

class WorkedRun {
public:
    /// Runs the scene with the corrected procedures under `exact`.
    WorkedRun(const AdmittedScene& scene, Method method);
    WorkedRun(const WorkedRun&) = delete;
    WorkedRun& operator=(const WorkedRun&) = delete;

    const TraceHeader& header() const { return header_; }
    /// Whether the entries of windows are relations; else they are those of the APL.
    bool has_relations() const {
        return is_family(header_.method) && choice_of(header_.method).procedure != Procedure::warnock;
    }
    const Scene& scene() const { return header_.scene; }
    const std::map<int, std::array<Value, 4>>& planes() const { return planes_; }
    const std::vector<WorkedWindow>& windows() const { return windows_; }  // in the order in which they leave AW
    const std::vector<WorkedRow>& rows() const { return rows_; }
    const std::vector<WorkedList>& lists() const { return lists_; }  // in the order in which they leave the stack
    /// The polygon that the Z-buffer shows at a pixel.
    std::optional<int> shown(int x, int y) const;
    const Moment& start() const { return start_; }
    const Moment& end() const { return end_; }

private:
    void hear(const event::Plane& e) { planes_[e.polygon.index] = e.plane; }
    void hear(const event::Pop& e);
    void hear(const event::Discard& e) { entry(e.polygon).leaves = true; }
    void hear(const event::Nearer& e) { entry(e.polygon).k = e.k; }
    void hear(const event::Mark& e) { entry(e.polygon).surrounds = true; }
    void hear(const event::Cover& e) { covering_ = e.polygon.index; }
    void hear(const event::Decide& e);
    void hear(const event::Nearest& e) { windows_.back().painted = e.polygon.index; }
    void hear(const event::Draw& e) { windows_.back().painted = e.polygon.index; }
    void hear(const event::ShownLine& e);
    void hear(const event::Columns& e);
    void hear(const event::Span& e);
    void hear(const event::Box& e);
    void hear(const event::RelationFound& e) { entry(e.polygon).relation = e.relation; }
    void hear(const event::Hiding& e) {
        if (e.polygon) covering_ = e.polygon->index;
    }
    void hear(const event::PopList& e);
    void hear(const event::Clipped& e);
    void hear(const event::NearerOnes& e);
    void hear(const event::Show&) { lists_.back().visible = true; }
    void hear(const auto&) {}

    WorkedEntry& entry(PolygonPlace polygon) { return windows_.back().entries[polygon.index]; }

    TraceHeader header_;
    Moment start_, end_;
    std::map<int, std::array<Value, 4>> planes_;
    std::vector<WorkedWindow> windows_;
    int covering_ = 0;
    std::vector<WorkedRow> rows_;
    std::vector<WorkedList> lists_;
    std::map<std::pair<int, int>, int> shown_;
};

}  // namespace vidno::figures
