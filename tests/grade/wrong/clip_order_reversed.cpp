// Warnock's algorithm, wrong: the clip traverses the corners of the window in the opposite direction.
#include "../course.h"

class Picture {
public:
    Picture(const Scene& scene, WarnockTrace& trace) : scene_(scene), trace_(trace) {
        const double side = covering_side(scene.area);
        trace.push(scene.area.x, scene.area.y, side, side);
        show(scene.area.x, scene.area.y, side);
    }

private:
    /// The window is on top of the stack.
    void show(double x, double y, double side) {
        trace_.pop(x, y, side, side);
        std::vector<const Polygon*> here;
        for (const Polygon& polygon : scene_.polygons) {
            const Box box = box_of(polygon);
            const bool meets = box.left < x + side && box.right > x && box.top < y + side && box.bottom > y;
            if (meets && !is_edge_on(polygon)) here.push_back(&polygon);
        }
        if (here.empty()) {
            trace_.decide(Case::empty);
            fill_square(trace_, scene_, x, y, side, scene_.background);
        } else if (side == 1) {
            trace_.decide(Case::pixel);
            fill_square(trace_, scene_, x, y, 1, nearest(here, {x + 0.5, y + 0.5}));
        } else if (here.size() == 1) {
            trace_.decide(Case::single);
            fill_square(trace_, scene_, x, y, side, scene_.background);
            const int polygon = int(here[0] - scene_.polygons.data());
            fill_polygon(trace_, scene_, polygon, clip(polygon, x, y, x + side, y + side));
        } else {
            trace_.decide(Case::split);
            const double half = side / 2;
            for (int i = 3; i >= 0; --i) {
                if (!is_off(x + i % 2 * half, y + i / 2 * half))
                    trace_.push(x + i % 2 * half, y + i / 2 * half, half, half);
            }
            for (int i = 0; i < 4; ++i) {
                if (!is_off(x + i % 2 * half, y + i / 2 * half)) show(x + i % 2 * half, y + i / 2 * half, half);
            }
        }
    }

    bool is_off(double x, double y) const {
        return x >= scene_.area.x + scene_.area.width || y >= scene_.area.y + scene_.area.height;
    }

    std::vector<Vertex> clip(int polygon, double left, double top, double right, double bottom) {
        const Point corners[] = {{left, top}, {right, top}, {right, bottom}, {left, bottom}};
        std::vector<Vertex> vertices = scene_.polygons[std::size_t(polygon)].vertices;
        trace_.clip_begin(polygon);
        for (int i = 0; i < 4 && !vertices.empty(); ++i)
            vertices = clipped_by(vertices, corners[i], corners[(i + 1) % 4]);
        trace_.clip_result(polygon, vertices);
        return vertices;
    }

    Color nearest(const std::vector<const Polygon*>& here, Point centre) const {
        const Polygon* best = nullptr;
        for (const Polygon* each : here) {
            if (holds(*each, centre) && (!best || depth(*each, centre) > depth(*best, centre))) best = each;
        }
        return best ? best->color : scene_.background;
    }

    const Scene& scene_;
    WarnockTrace& trace_;
};

int main() {
    const Scene scene = scene_to_draw(example_scene());
    WarnockTrace trace("clip_order_reversed.jsonl", scene);
    Picture(scene, trace);
}
