// Warnock's algorithm, right: it recurses and reports as few steps as possible.
#include "../course.h"

class Drawing {
public:
    Drawing(const Scene& scene, WarnockTrace& trace) : scene_(scene), trace_(trace) {
        std::vector<int> all;
        for (int i = 0; i < int(scene.polygons.size()); ++i) {
            if (!is_edge_on(scene.polygons[std::size_t(i)])) all.push_back(i);
        }
        draw(scene.area.x, scene.area.y, covering_side(scene.area), all);
    }

private:
    void draw(double x, double y, double side, const std::vector<int>& candidates) {
        if (x >= scene_.area.x + scene_.area.width || y >= scene_.area.y + scene_.area.height) return;
        trace_.push(x, y, side, side);
        trace_.pop(x, y, side, side);
        std::vector<int> left;
        for (const int i : candidates) {
            const Box box = box_of(polygon(i));
            if (box.right > x && box.left < x + side && box.bottom > y && box.top < y + side) left.push_back(i);
        }
        if (left.empty()) {
            trace_.decide(Case::empty);
            fill_square(trace_, scene_, x, y, side, scene_.background);
        } else if (side <= 1) {
            trace_.decide(Case::pixel);
            fill_square(trace_, scene_, x, y, side, color_at({x + side / 2, y + side / 2}, left));
        } else if (left.size() == 1) {
            trace_.decide(Case::single);
            fill_square(trace_, scene_, x, y, side, scene_.background);
            std::vector<Vertex> part = polygon(left[0]).vertices;
            const Point corners[] = {{x, y}, {x, y + side}, {x + side, y + side}, {x + side, y}};
            for (int i = 0; i < 4; ++i) part = clipped_by(part, corners[i], corners[(i + 1) % 4]);
            trace_.clip_result(left[0], part);
            fill_polygon(trace_, scene_, left[0], part);
        } else {
            trace_.decide(Case::split);
            const double half = side / 2;
            draw(x, y, half, left);
            draw(x + half, y, half, left);
            draw(x, y + half, half, left);
            draw(x + half, y + half, half, left);
        }
    }

    const Polygon& polygon(int i) const { return scene_.polygons[std::size_t(i)]; }

    Color color_at(Point point, const std::vector<int>& candidates) const {
        Color color = scene_.background;
        double nearest = farthest;
        for (const int i : candidates) {
            const double z = depth(polygon(i), point);
            if (!holds(polygon(i), point) || z <= nearest) continue;
            nearest = z;
            color = polygon(i).color;
        }
        return color;
    }

    const Scene& scene_;
    WarnockTrace& trace_;
};

int main() {
    const Scene scene = scene_to_draw(example_scene());
    WarnockTrace trace("recursion.jsonl", scene);
    Drawing(scene, trace);
}
