// Warnock's algorithm, wrong: sides are whole pixels, and all parts have half the side, rounded down. A side of 1
// becomes 0.
#include "../course.h"

struct Rectangle {
    int x, y, width, height;
};

class Subdivision {
public:
    Subdivision(const Scene& scene, WarnockTrace& trace) : scene_(scene), trace_(trace) {
        push({scene.area.x, scene.area.y, scene.area.width, scene.area.height});
        while (!stack_.empty()) {
            const Rectangle r = stack_.back();
            stack_.pop_back();
            trace.pop(r.x, r.y, r.width, r.height);
            visit(r);
        }
    }

private:
    void push(const Rectangle& r) {
        if (r.width == 0 || r.height == 0) return;
        stack_.push_back(r);
        trace_.push(r.x, r.y, r.width, r.height);
    }

    void visit(const Rectangle& r) {
        int count = 0;
        for (const Polygon& polygon : scene_.polygons) {
            const Box box = box_of(polygon);
            const bool off =
                box.left >= r.x + r.width || box.right <= r.x || box.top >= r.y + r.height || box.bottom <= r.y;
            if (!off) ++count;
        }
        if (count == 0) {
            trace_.decide(Case::empty);
            trace_.fill(r.x, r.y, r.width, r.height, scene_.background);
        } else if (r.width == 1 && r.height == 1) {
            trace_.decide(Case::pixel);
            trace_.fill(r.x, r.y, 1, 1, color_of(r));
        } else {
            trace_.decide(Case::split);
            const int w = r.width / 2, h = r.height / 2;
            push({r.x, r.y, w, h});
            push({r.x + w, r.y, w, h});
            push({r.x, r.y + h, w, h});
            push({r.x + w, r.y + h, w, h});
        }
    }

    Color color_of(const Rectangle& r) const {
        const Point centre{r.x + 0.5, r.y + 0.5};
        const Polygon* shown = nullptr;
        for (const Polygon& polygon : scene_.polygons) {
            if (is_edge_on(polygon) || !holds(polygon, centre)) continue;
            if (!shown || depth(polygon, centre) > depth(*shown, centre)) shown = &polygon;
        }
        return shown ? shown->color : scene_.background;
    }

    const Scene& scene_;
    WarnockTrace& trace_;
    std::vector<Rectangle> stack_;
};

int main() {
    const Scene scene = scene_to_draw(example_scene());
    WarnockTrace trace("halves_of_one.jsonl", scene);
    Subdivision(scene, trace);
}
