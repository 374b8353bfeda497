// Warnock's algorithm, wrong: once it has found a surrounding polygon, it keeps it even if a later polygon is nearer in
// the window.
#include "course.h"

struct Cell {
    double x, y, side;
    std::vector<int> polygons;
};

class Warnock {
public:
    Warnock(const Scene& scene, WarnockTrace& trace) : scene_(scene), trace_(trace) {
        Cell cell{double(scene.area.x), double(scene.area.y), covering_side(scene.area), {}};
        for (int i = 0; i < int(scene.polygons.size()); ++i) cell.polygons.push_back(i);
        push(cell);
        while (!cells_.empty()) {
            cell = cells_.back();
            cells_.pop_back();
            trace.pop(cell.x, cell.y, cell.side, cell.side);
            show(cell);
        }
    }

private:
    const Polygon& polygon(int i) const { return scene_.polygons[std::size_t(i)]; }

    void push(const Cell& cell) {
        cells_.push_back(cell);
        trace_.push(cell.x, cell.y, cell.side, cell.side);
    }

    void show(Cell& cell) {
        const Point corners[4] = {{cell.x, cell.y},
                                  {cell.x, cell.y + cell.side},
                                  {cell.x + cell.side, cell.y},
                                  {cell.x + cell.side, cell.y + cell.side}};
        double nearest[4] = {farthest, farthest, farthest, farthest};
        trace_.corners(farthest);
        bool has_surround = false;
        Color color = scene_.background;
        std::vector<int> kept;
        for (const int i : cell.polygons) {
            const Box box = box_of(polygon(i));
            if (is_edge_on(polygon(i)) || box.left > cell.x + cell.side || box.right < cell.x ||
                box.top > cell.y + cell.side || box.bottom < cell.y) {
                trace_.discard(i);
                continue;
            }
            kept.push_back(i);
            trace_.count(i, int(kept.size()));
            double z[4];
            for (int j = 0; j < 4; ++j) {
                z[j] = depth(polygon(i), corners[j]);
                trace_.depth(i, corners[j].x, corners[j].y, z[j]);
            }
            int k = 0, inside = 0;
            for (int j = 0; j < 4; ++j) {
                trace_.compare(i, Corner(j), z[j], nearest[j], z[j] > nearest[j]);
                if (z[j] > nearest[j]) {
                    nearest[j] = z[j];
                    ++k;
                }
                inside += holds(polygon(i), corners[j]);
            }
            trace_.nearer(i);
            if (inside == 4 && k == 4) {
                has_surround = true;
                color = polygon(i).color;
                trace_.cover(i);
            }
        }
        cell.polygons = kept;
        trace_.summary(int(kept.size()), has_surround, color, false);
        paint(cell, has_surround, color);
    }

    void paint(const Cell& cell, bool has_surround, Color color) {
        if (cell.polygons.empty()) {
            trace_.decide(Case::empty);
            fill_square(trace_, scene_, cell.x, cell.y, cell.side, scene_.background);
        } else if (has_surround) {
            trace_.decide(Case::surrounded);
            fill_square(trace_, scene_, cell.x, cell.y, cell.side, color);
        } else if (cell.side == 1) {
            trace_.decide(Case::pixel);
            fill_square(trace_, scene_, cell.x, cell.y, 1, color_at({cell.x + 0.5, cell.y + 0.5}, cell.polygons));
        } else {
            trace_.decide(Case::split);
            const double half = cell.side / 2;
            for (const double x : {cell.x, cell.x + half}) {
                for (const double y : {cell.y, cell.y + half}) {
                    const bool off = x >= scene_.area.x + scene_.area.width || y >= scene_.area.y + scene_.area.height;
                    if (!off) push({x, y, half, cell.polygons});
                }
            }
        }
    }

    Color color_at(Point centre, const std::vector<int>& polygons) const {
        Color color = scene_.background;
        double nearest = farthest;
        for (const int i : polygons) {
            if (!holds(polygon(i), centre) || depth(polygon(i), centre) <= nearest) continue;
            nearest = depth(polygon(i), centre);
            color = polygon(i).color;
        }
        return color;
    }

    const Scene& scene_;
    WarnockTrace& trace_;
    std::vector<Cell> cells_;
};

int main() {
    const Scene scene = scene_to_draw(example_scene());
    WarnockTrace trace("surround_kept.jsonl", scene, Detail::signs);
    Warnock(scene, trace);
}
