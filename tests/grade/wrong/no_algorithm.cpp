// No algorithm: it finds each pixel by brute force and invents windows that fit the finished picture.
#include "../course.h"

class Pretence {
public:
    Pretence(const Scene& scene, WarnockTrace& trace) : scene_(scene), trace_(trace) {
        split(scene.area.x, scene.area.y, covering_side(scene.area));
    }

private:
    Color color_at(int x, int y) const {
        Color color = scene_.background;
        double nearest = farthest;
        const Point centre{x + 0.5, y + 0.5};
        for (const Polygon& polygon : scene_.polygons) {
            if (is_edge_on(polygon) || !holds(polygon, centre) || depth(polygon, centre) <= nearest) continue;
            nearest = depth(polygon, centre);
            color = polygon.color;
        }
        return color;
    }
    static bool same(Color a, Color b) { return a.red == b.red && a.green == b.green && a.blue == b.blue; }

    void split(double x, double y, double side) {
        const Area& area = scene_.area;
        if (x >= area.x + area.width || y >= area.y + area.height) return;
        trace_.push(x, y, side, side);
        trace_.pop(x, y, side, side);
        const Color color = color_at(int(x), int(y));
        bool uniform = true;
        for (int row = int(y); row < std::min(int(y + side), area.y + area.height); ++row) {
            for (int column = int(x); column < std::min(int(x + side), area.x + area.width); ++column)
                uniform = uniform && same(color, color_at(column, row));
        }
        if (uniform) {
            trace_.decide(same(color, scene_.background) ? Case::empty : Case::surrounded);
            fill_square(trace_, scene_, x, y, side, color);
            return;
        }
        trace_.decide(Case::split);
        for (const double dx : {0.0, side / 2}) {
            for (const double dy : {0.0, side / 2}) split(x + dx, y + dy, side / 2);
        }
    }

    const Scene& scene_;
    WarnockTrace& trace_;
};

int main() {
    const Scene scene = scene_to_draw(example_scene());
    WarnockTrace trace("no_algorithm.jsonl", scene);
    Pretence(scene, trace);
}
