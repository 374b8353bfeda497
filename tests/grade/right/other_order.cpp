// Warnock's algorithm, right: it takes polygons from the last to the first, parts and corners in its own order, and
// clips by the right side first.
#include <deque>

#include "../course.h"

struct Entry {
    int polygon;
    bool around;
};

struct Tile {
    double x, y, side;
    std::vector<Entry> list;

    Point corner(int i) const { return {x + (i == 1 || i == 2 ? side : 0), y + (i < 2 ? side : 0)}; }
};

class Painter {
public:
    Painter(const Scene& scene, WarnockTrace& trace) : scene_(scene), trace_(trace) {
        Tile whole{double(scene.area.x), double(scene.area.y), covering_side(scene.area), {}};
        for (int i = int(scene.polygons.size()) - 1; i >= 0; --i) {
            if (!is_edge_on(at(i))) whole.list.push_back({i, false});
        }
        push(whole);
        while (!tiles_.empty()) {
            Tile tile = tiles_.back();
            tiles_.pop_back();
            trace_.pop(tile.x, tile.y, tile.side, tile.side);
            look_at(tile);
        }
    }

private:
    const Polygon& at(int i) const { return scene_.polygons[std::size_t(i)]; }

    void push(const Tile& tile) {
        tiles_.push_back(tile);
        trace_.push(tile.x, tile.y, tile.side, tile.side);
    }

    /// The index in the list of the polygon that surrounds the tile and is the nearest at all corners; -1 if there is
    /// none.
    int cover_of(const Tile& tile) {
        int best = -1;
        double nearest[4] = {farthest, farthest, farthest, farthest};
        for (std::size_t i = 0; i < tile.list.size(); ++i) {
            const int polygon = tile.list[i].polygon;
            int nearer = 0;
            for (int corner = 0; corner < 4; ++corner) {
                const Point p = tile.corner(corner);
                const double z = depth(at(polygon), p);
                trace_.depth(polygon, p.x, p.y, z);
                if (z < nearest[corner]) continue;
                nearest[corner] = z;
                ++nearer;
            }
            if (nearer == 4 && tile.list[i].around) {
                best = int(i);
            } else if (nearer > 0) {
                best = -1;
            }
        }
        return best;
    }

    void look_at(Tile& tile) {
        std::vector<Entry> kept;
        for (Entry entry : tile.list) {
            const Box box = box_of(at(entry.polygon));
            if (box.right <= tile.x || box.left >= tile.x + tile.side || box.bottom <= tile.y ||
                box.top >= tile.y + tile.side) {
                trace_.discard(entry.polygon);
                continue;
            }
            bool all = true;
            for (int i = 0; i < 4; ++i) {
                const bool inside = holds(at(entry.polygon), tile.corner(i));
                trace_.surround(entry.polygon, tile.corner(i).x, tile.corner(i).y, inside);
                all = all && inside;
            }
            if (all && !entry.around) trace_.mark(entry.polygon);
            kept.push_back({entry.polygon, all});
            trace_.count(entry.polygon, int(kept.size()));
        }
        tile.list = kept;
        const int cover = cover_of(tile);
        const Color color = cover < 0 ? scene_.background : at(tile.list[std::size_t(cover)].polygon).color;
        trace_.summary(int(kept.size()), cover >= 0, color, false);
        paint(tile, cover >= 0, color);
    }

    void paint(const Tile& tile, bool covered, Color color) {
        if (tile.list.empty() || covered) {
            trace_.decide(covered ? Case::surrounded : Case::empty);
            fill_square(trace_, scene_, tile.x, tile.y, tile.side, color);
        } else if (tile.side == 1) {
            trace_.decide(Case::pixel);
            fill_square(trace_, scene_, tile.x, tile.y, 1, color_in(tile));
        } else if (tile.list.size() == 1) {
            paint_single(tile);
        } else {
            trace_.decide(Case::split);
            const double half = tile.side / 2;
            for (int i = 0; i < 4; ++i) {
                const Tile part{tile.x + (i % 2) * half, tile.y + (i / 2) * half, half, tile.list};
                if (part.x < scene_.area.x + scene_.area.width && part.y < scene_.area.y + scene_.area.height)
                    push(part);
            }
        }
    }

    void paint_single(const Tile& tile) {
        trace_.decide(Case::single);
        fill_square(trace_, scene_, tile.x, tile.y, tile.side, scene_.background);
        const int polygon = tile.list[0].polygon;
        std::vector<Vertex> part(at(polygon).vertices.rbegin(), at(polygon).vertices.rend());
        trace_.clip_begin(polygon);
        for (int i = 0; i < 4; ++i) part = clipped_by(part, tile.corner((i + 1) % 4), tile.corner((i + 2) % 4));
        trace_.clip_result(polygon, part);
        fill_polygon(trace_, scene_, polygon, part);
    }

    Color color_in(const Tile& tile) {
        const Point centre{tile.x + 0.5, tile.y + 0.5};
        double nearest = farthest;
        Color color = scene_.background;
        for (const Entry& entry : tile.list) {
            const double z = depth(at(entry.polygon), centre);
            if (!holds(at(entry.polygon), centre) || z < nearest) continue;
            nearest = z;
            color = at(entry.polygon).color;
        }
        trace_.color(centre.x, centre.y, color);
        return color;
    }

    const Scene& scene_;
    WarnockTrace& trace_;
    std::deque<Tile> tiles_;
};

int main() {
    const Scene scene = scene_to_draw(example_scene());
    WarnockTrace trace("other_order.jsonl", scene, Detail::polygons);
    Painter(scene, trace);
}
