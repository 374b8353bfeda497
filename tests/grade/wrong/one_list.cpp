// Warnock's algorithm, wrong: all windows share one list and remove polygons from it.
#include <memory>

#include "../course.h"

struct Window {
    double x, y, side;
    std::shared_ptr<std::vector<int>> list;
};

class Warnock {
public:
    Warnock(const Scene& scene, WarnockTrace& trace) : scene_(scene), trace_(trace) {
        Window first{double(scene.area.x), double(scene.area.y), covering_side(scene.area),
                     std::make_shared<std::vector<int>>()};
        for (int i = 0; i < int(scene.polygons.size()); ++i) {
            if (!is_edge_on(polygon(i))) first.list->push_back(i);
        }
        push(first);
        while (!stack_.empty()) {
            const Window window = stack_.back();
            stack_.pop_back();
            trace.pop(window.x, window.y, window.side, window.side);
            process(window);
        }
    }

private:
    const Polygon& polygon(int i) const { return scene_.polygons[std::size_t(i)]; }

    void push(const Window& window) {
        if (window.x >= scene_.area.x + scene_.area.width || window.y >= scene_.area.y + scene_.area.height) return;
        stack_.push_back(window);
        trace_.push(window.x, window.y, window.side, window.side);
    }

    void process(const Window& window) {
        std::vector<int>& list = *window.list;
        for (std::size_t i = 0; i < list.size();) {
            const Box box = box_of(polygon(list[i]));
            const bool outside = box.right < window.x || box.left > window.x + window.side || box.bottom < window.y ||
                                 box.top > window.y + window.side;
            if (outside) {
                trace_.discard(list[i]);
                list.erase(list.begin() + std::ptrdiff_t(i));
            } else {
                ++i;
                trace_.count(list[i - 1], int(i));
            }
        }
        trace_.summary(int(list.size()), false, scene_.background, false);
        if (list.empty()) {
            trace_.decide(Case::empty);
            fill_square(trace_, scene_, window.x, window.y, window.side, scene_.background);
        } else if (window.side == 1) {
            trace_.decide(Case::pixel);
            fill_square(trace_, scene_, window.x, window.y, 1, color_at({window.x + 0.5, window.y + 0.5}, list));
        } else {
            trace_.decide(Case::split);
            const double half = window.side / 2;
            push({window.x, window.y, half, window.list});
            push({window.x, window.y + half, half, window.list});
            push({window.x + half, window.y, half, window.list});
            push({window.x + half, window.y + half, half, window.list});
        }
    }

    Color color_at(Point centre, const std::vector<int>& list) const {
        Color color = scene_.background;
        double nearest = farthest;
        for (const int i : list) {
            const double z = depth(polygon(i), centre);
            if (z > nearest && holds(polygon(i), centre)) {
                nearest = z;
                color = polygon(i).color;
            }
        }
        return color;
    }

    const Scene& scene_;
    WarnockTrace& trace_;
    std::vector<Window> stack_;
};

int main() {
    const Scene scene = scene_to_draw(example_scene());
    WarnockTrace trace("one_list.jsonl", scene, Detail::polygons);
    Warnock(scene, trace);
}
