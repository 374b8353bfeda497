// Warnock's algorithm, wrong: y grows upward, as in mathematics, and row 0 is the lowest.
#include "../course.h"

class UpwardScreen {
public:
    UpwardScreen(const Scene& scene, WarnockTrace& trace) : scene_(scene), trace_(trace) {
        const double side = covering_side(scene.area);
        windows_.push_back({scene.area.x + 0.0, scene.area.y + 0.0, side});
        trace.push(scene.area.x, scene.area.y, side, side);
        while (!windows_.empty()) {
            const Square window = windows_.back();
            windows_.pop_back();
            trace.pop(window.x, window.y, window.side, window.side);
            show(window);
        }
    }

private:
    struct Square {
        double x, y, side;
    };

    void show(const Square& w) {
        std::vector<int> meeting;
        for (int i = 0; i < int(scene_.polygons.size()); ++i) {
            const Box box = box_of(scene_.polygons[std::size_t(i)]);
            if (box.left < w.x + w.side && box.right > w.x && box.top < w.y + w.side && box.bottom > w.y)
                meeting.push_back(i);
        }
        if (meeting.empty()) {
            trace_.decide(Case::empty);
            fill(w, scene_.background);
        } else if (w.side <= 1) {
            trace_.decide(Case::pixel);
            fill(w, color_at({w.x + 0.5, w.y + 0.5}, meeting));
        } else {
            trace_.decide(Case::split);
            const double half = w.side / 2;
            for (const Square& part : {Square{w.x, w.y, half}, Square{w.x, w.y + half, half},
                                       Square{w.x + half, w.y, half}, Square{w.x + half, w.y + half, half}}) {
                if (part.x >= scene_.area.x + scene_.area.width || part.y >= scene_.area.y + scene_.area.height)
                    continue;
                windows_.push_back(part);
                trace_.push(part.x, part.y, half, half);
            }
        }
    }

    /// Fills row by row, from the bottom of the screen up.
    void fill(const Square& w, Color color) {
        const Area& area = scene_.area;
        for (int y = int(w.y); y < int(w.y + w.side) && y < area.y + area.height; ++y) {
            const int row = area.y + area.height - 1 - (y - area.y);
            trace_.fill(int(w.x), row, std::min(int(w.side), area.x + area.width - int(w.x)), 1, color);
        }
    }

    Color color_at(Point centre, const std::vector<int>& meeting) const {
        Color color = scene_.background;
        double nearest = farthest;
        for (const int i : meeting) {
            const Polygon& polygon = scene_.polygons[std::size_t(i)];
            if (is_edge_on(polygon) || !holds(polygon, centre) || depth(polygon, centre) <= nearest) continue;
            nearest = depth(polygon, centre);
            color = polygon.color;
        }
        return color;
    }

    const Scene& scene_;
    WarnockTrace& trace_;
    std::vector<Square> windows_;
};

int main() {
    const Scene scene = scene_to_draw(example_scene());
    WarnockTrace trace("y_flipped.jsonl", scene);
    UpwardScreen(scene, trace);
}
