// A skeleton for Warnock's algorithm, with the stack of windows and the place of each call of `trace`. You write the
// procedures. Without them the program treats every window as empty, and `vidno grade` says so.
//
//     warnock [windows | polygons | signs]     writes warnock.jsonl
#include "example.h"

using namespace vidno::student;

const double farthest = -2;  // behind all that is visible

struct Active {
    int polygon;
    bool surrounds;
};

/// A square, and the polygons that may show in it.
struct Window {
    double x, y, size;
    std::vector<Active> polygons;  // APL
};

/// The result of ProcessWindow.
struct Summary {
    int count = 0;
    bool has_surround = false, insider = false;
    Color color{0, 0, 0};
};

class Warnock {
public:
    Warnock(const Scene& scene, WarnockTrace& trace) : scene_(scene), trace_(trace) {
        // InitializePolygon: the plane of each polygon, from all of its vertices. A polygon seen edge-on does not take
        // part. trace.plane(i, a, b, c, d)
        Window whole{double(scene.area.x), double(scene.area.y), 1, {}};
        while (whole.size < scene.area.width || whole.size < scene.area.height) whole.size *= 2;
        for (int i = 0; i < int(scene.polygons.size()); ++i) whole.polygons.push_back({i, false});
        push(whole);
        while (!windows_.empty()) {
            Window window = windows_.back();
            windows_.pop_back();
            trace.pop(window.x, window.y, window.size, window.size);
            show(window);
        }
    }

private:
    void push(const Window& window) {
        const Area& area = scene_.area;
        if (window.x >= area.x + area.width || window.y >= area.y + area.height) {
            trace_.skip(window.x, window.y, window.size, window.size);
            return;
        }
        windows_.push_back(window);
        trace_.push(window.x, window.y, window.size, window.size);
    }

    /// W6 to W13. Here is only W7; the other cases are yours: Case::surrounded, Case::pixel, Case::single and
    /// Case::split, which pushes the four parts.
    void show(Window& window) {
        const Summary found = process_window(window);
        if (found.count == 0) {
            trace_.decide(Case::empty);
            fill(window, scene_.background);
        }
    }

    /// PW1 to PW10. The calls, in order, for each polygon of the list:
    ///     box, and discard if it lies outside of the window; count;
    ///     depth at each corner; compare at each corner, and nearer; uncover;
    ///     surround at the corners, and mark; cover, or insider
    Summary process_window(Window&) {
        Summary found;
        trace_.corners(farthest);
        trace_.summary(found.count, found.has_surround, found.color, found.insider);
        return found;
    }

    // Yours, too:
    //     PointColor(point)         surround and depth of each polygon, compare, nearest; the result: color
    //     Depth(polygon, point)     depth
    //     SurroundTest              orient for each edge; the result: surround
    //     PolygonClip               clip_begin; for each side clip_side, clip_sign, clip_cross, clip_keep, clip_drop,
    //                               clip_list; the result: clip_result
    //     FillPolygon               row for each row; the result: draw

    void fill(const Window& window, Color color) {
        const Area& area = scene_.area;
        const int x = int(window.x), y = int(window.y), size = int(window.size);
        trace_.fill(x, y, std::min(size, area.x + area.width - x), std::min(size, area.y + area.height - y), color);
    }

    const Scene& scene_;
    WarnockTrace& trace_;
    std::vector<Window> windows_;  // AW
};

int main(int count, char** words) {
    const Scene scene = scene_to_draw(example_scene());
    WarnockTrace trace("warnock.jsonl", scene, detail_from(count, words));
    Warnock(scene, trace);
}
