// A skeleton for the floating horizon, with the place of each call of `trace`. You write the procedures. Without them
// the program draws nothing, and `vidno grade` says so.
//
//     floating_horizon [windows | polygons | signs]     writes floating_horizon.jsonl
#include "example.h"

using namespace vidno::student;

class FloatingHorizon {
public:
    FloatingHorizon(const Surface& surface, FloatingHorizonTrace& trace) : trace_(trace) {
        // FH1: the horizons over each column of the area. At first there are none.
        trace.horizons();
        for (std::size_t i = 0; i < surface.curves.size(); ++i) {
            trace.curve(int(i));
            draw(surface.curves[i]);
        }
    }

private:
    /// FH3 to FH10. Here are only the ends of the side edges. The calls, in order:
    ///     Horizon along the left edge, over the columns between its ends: raise, lower; the result: horizon
    ///     side_edge
    ///     Visibility over the first column: height; the result: visibility
    ///     for each next column Visibility, and then for each visible part:
    ///         Intersection, if the part begins or ends between the columns: step; the result: intersection
    ///         draw_line; Horizon: raise, lower; the result: horizon
    ///     Horizon along the right edge
    ///     side_edge
    void draw(const std::vector<Sample>& samples) {
        trace_.side_edge(samples.front().x, samples.front().y);
        trace_.side_edge(samples.back().x, samples.back().y);
    }

    FloatingHorizonTrace& trace_;
};

int main(int count, char** words) {
    const Surface surface = surface_to_draw(example_surface());
    FloatingHorizonTrace trace("floating_horizon.jsonl", surface, detail_from(count, words));
    FloatingHorizon(surface, trace);
}
