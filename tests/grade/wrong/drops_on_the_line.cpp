// Warnock's algorithm, wrong: clipping drops a vertex on the line of a window's side. The program reports only windows
// and pixels.
#include "../course.h"

struct Square {
    double x, y, side;
    std::vector<int> list;
};

class Drawing {
public:
    Drawing(const Scene& scene, WarnockTrace& trace) : scene_(scene), trace_(trace) {
        Square whole{double(scene.area.x), double(scene.area.y), covering_side(scene.area), {}};
        for (int i = 0; i < int(scene.polygons.size()); ++i) {
            if (!is_edge_on(at(i))) whole.list.push_back(i);
        }
        draw(whole);
    }

private:
    const Polygon& at(int i) const { return scene_.polygons[std::size_t(i)]; }

    void draw(const Square& s) {
        if (s.x >= scene_.area.x + scene_.area.width || s.y >= scene_.area.y + scene_.area.height) return;
        trace_.push(s.x, s.y, s.side, s.side);
        trace_.pop(s.x, s.y, s.side, s.side);
        std::vector<int> here;
        for (const int i : s.list) {
            const Box box = box_of(at(i));
            if (box.right > s.x && box.left < s.x + s.side && box.bottom > s.y && box.top < s.y + s.side)
                here.push_back(i);
        }
        if (here.empty()) {
            trace_.decide(Case::empty);
            fill_square(trace_, scene_, s.x, s.y, s.side, scene_.background);
        } else if (s.side == 1) {
            trace_.decide(Case::pixel);
            Color color = scene_.background;
            double nearest = farthest;
            const Point centre{s.x + 0.5, s.y + 0.5};
            for (const int i : here) {
                if (!holds(at(i), centre) || depth(at(i), centre) <= nearest) continue;
                nearest = depth(at(i), centre);
                color = at(i).color;
            }
            fill_square(trace_, scene_, s.x, s.y, 1, color);
        } else if (here.size() == 1) {
            trace_.decide(Case::single);
            fill_square(trace_, scene_, s.x, s.y, s.side, scene_.background);
            std::vector<Vertex> part = at(here[0]).vertices;
            const Point corners[] = {
                {s.x, s.y}, {s.x, s.y + s.side}, {s.x + s.side, s.y + s.side}, {s.x + s.side, s.y}};
            for (int i = 0; i < 4; ++i) part = clipped(part, corners[i], corners[(i + 1) % 4]);
            fill_polygon(trace_, scene_, here[0], part);
        } else {
            trace_.decide(Case::split);
            const double half = s.side / 2;
            for (const double x : {s.x, s.x + half}) {
                for (const double y : {s.y, s.y + half}) draw({x, y, half, here});
            }
        }
    }

    /// Neither keeps a vertex on the line nor treats it as a crossing.
    static std::vector<Vertex> clipped(const std::vector<Vertex>& vertices, Point from, Point to) {
        std::vector<Vertex> kept;
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            const Vertex &p = vertices[i], &q = vertices[(i + 1) % vertices.size()];
            const double cp = cross(from, to, {p.x, p.y}), cq = cross(from, to, {q.x, q.y});
            if (cp < 0) kept.push_back(p);
            if (cp * cq >= 0) continue;
            const double t = cp / (cp - cq);
            kept.push_back({p.x + (q.x - p.x) * t, p.y + (q.y - p.y) * t, p.z + (q.z - p.z) * t});
        }
        return kept;
    }

    const Scene& scene_;
    WarnockTrace& trace_;
};

int main() {
    const Scene scene = scene_to_draw(example_scene());
    WarnockTrace trace("drops_on_the_line.jsonl", scene);
    Drawing(scene, trace);
}
