// A template of Warnock's algorithm. The `Style` of each program that uses it replaces a part of it.
#ifndef WARNOCK_STYLE_H
#define WARNOCK_STYLE_H

#include <deque>

#include "../course.h"

struct Tile {
    double x, y, width, height;
    std::vector<int> list;

    bool is_pixel() const { return width <= 1 && height <= 1; }
    Point corner(int i) const { return {x + (i >= 2 ? width : 0), y + (i % 2 == 1 ? height : 0)}; }
};

/// The default style: it keeps the windows on a stack, splits them into four equal parts, and clips a single polygon.
struct PlainStyle {
    static const bool first_in_first_out = false;
    static const bool tells_in_turn = false;  // if false, it reports a window when it puts the window on the stack
    static const bool draws_single = true;

    static Tile first(const Scene& scene) {
        const double side = covering_side(scene.area);
        return {double(scene.area.x), double(scene.area.y), side, side, {}};
    }
    static std::vector<Tile> parts(const Tile& tile) {
        const double w = tile.width / 2, h = tile.height / 2;
        return {{tile.x, tile.y, w, h, tile.list},
                {tile.x, tile.y + h, w, h, tile.list},
                {tile.x + w, tile.y, w, h, tile.list},
                {tile.x + w, tile.y + h, w, h, tile.list}};
    }
    static bool contains(const Polygon& polygon, Point point) { return holds(polygon, point); }
    static bool takes(double z, double nearest) { return z > nearest; }
    /// Whether a polygon that surrounds the tile hides the other one there.
    static bool hides(const Polygon& polygon, const Polygon& other, const Tile& tile) {
        for (int i = 0; i < 4; ++i) {
            if (depth(polygon, tile.corner(i)) < depth(other, tile.corner(i))) return false;
        }
        return true;
    }
    /// The polygon taken to hide all others in a window, given the one that was found to do so there; -1 if there is
    /// none.
    static int hiding(int found) { return found; }
};

template <class Style>
class Warnock {
public:
    Warnock(const Scene& scene, WarnockTrace& trace) : scene_(scene), trace_(trace) {
        Tile first = Style::first(scene);
        for (int i = 0; i < int(scene.polygons.size()); ++i) {
            if (!is_edge_on(at(i))) first.list.push_back(i);
        }
        push(first);
        while (!tiles_.empty()) {
            Tile tile = Style::first_in_first_out ? tiles_.front() : tiles_.back();
            if (Style::first_in_first_out) {
                tiles_.pop_front();
            } else {
                tiles_.pop_back();
            }
            if (Style::tells_in_turn) trace.push(tile.x, tile.y, tile.width, tile.height);
            trace.pop(tile.x, tile.y, tile.width, tile.height);
            show(tile);
        }
    }

private:
    const Polygon& at(int i) const { return scene_.polygons[std::size_t(i)]; }

    void push(const Tile& tile) {
        const Area& area = scene_.area;
        if (tile.x >= area.x + area.width || tile.y >= area.y + area.height) return;
        tiles_.push_back(tile);
        if (!Style::tells_in_turn) trace_.push(tile.x, tile.y, tile.width, tile.height);
    }

    void fill(const Tile& tile, Color color) {
        const Area& area = scene_.area;
        const int right = std::min(int(tile.x + tile.width), area.x + area.width);
        const int bottom = std::min(int(tile.y + tile.height), area.y + area.height);
        trace_.fill(int(tile.x), int(tile.y), right - int(tile.x), bottom - int(tile.y), color);
    }

    void show(Tile& tile) {
        std::vector<int> kept;
        for (const int i : tile.list) {
            const Box box = box_of(at(i));
            const bool outside = box.left >= tile.x + tile.width || box.right <= tile.x ||
                                 box.top >= tile.y + tile.height || box.bottom <= tile.y;
            if (!outside) kept.push_back(i);
        }
        tile.list = kept;
        const int cover = Style::hiding(hiding(tile));
        if (kept.empty()) {
            trace_.decide(Case::empty);
            fill(tile, scene_.background);
        } else if (cover >= 0) {
            trace_.decide(Case::surrounded);
            fill(tile, at(cover).color);
        } else if (tile.is_pixel()) {
            trace_.decide(Case::pixel);
            fill(tile, color_at({tile.x + tile.width / 2, tile.y + tile.height / 2}, kept));
        } else if (Style::draws_single && kept.size() == 1) {
            trace_.decide(Case::single);
            fill(tile, scene_.background);
            std::vector<Vertex> part = at(kept[0]).vertices;
            const int around[] = {0, 1, 3, 2};
            for (int i = 0; i < 4; ++i)
                part = clipped_by(part, tile.corner(around[i]), tile.corner(around[(i + 1) % 4]));
            trace_.clip_result(kept[0], part);
            fill_polygon(trace_, scene_, kept[0], part);
        } else {
            trace_.decide(Case::split);
            for (const Tile& part : Style::parts(tile)) push(part);
        }
    }

    /// A polygon that surrounds the tile and hides all others there; -1 if there is none.
    int hiding(const Tile& tile) const {
        for (const int i : tile.list) {
            bool hides = true;
            for (int corner = 0; corner < 4; ++corner) hides = hides && Style::contains(at(i), tile.corner(corner));
            for (const int other : tile.list) hides = hides && Style::hides(at(i), at(other), tile);
            if (hides) return i;
        }
        return -1;
    }

    Color color_at(Point centre, const std::vector<int>& list) {
        Color color = scene_.background;
        double nearest = farthest;
        for (const int i : list) {
            if (!Style::contains(at(i), centre)) continue;
            const double z = depth(at(i), centre);
            trace_.depth(i, centre.x, centre.y, z);
            if (!Style::takes(z, nearest)) continue;
            nearest = z;
            color = at(i).color;
        }
        trace_.color(centre.x, centre.y, color);
        return color;
    }

    const Scene& scene_;
    WarnockTrace& trace_;
    std::deque<Tile> tiles_;
};

template <class Style>
void run_as(const std::string& file) {
    const Scene scene = scene_to_draw(example_scene());
    WarnockTrace trace(file, scene);
    Warnock<Style>(scene, trace);
}

#endif
