// The Z-buffer with an active edge list, as a student writes it for the course. The calls of `trace` report the steps
// to vidno.
//
//     z_buffer [windows | polygons | signs]     writes z_buffer.jsonl
#include <limits>

#include "example.h"

using namespace vidno::student;

const double farthest = -2;  // behind all visible depths
const double never = std::numeric_limits<double>::infinity();

/// An edge of the current polygon, upper end first.
struct Edge {
    int index;
    Vertex from, to;
    int first_row, last_row;  // the first and last row whose centre line it crosses
    double x, z;              // on the current row
    double dx, dz;            // change from row to row
};

std::vector<int> indices(const std::vector<Edge>& edges) {
    std::vector<int> all;
    for (const Edge& edge : edges) all.push_back(edge.index);
    return all;
}

/// The first row or column whose centre is at v or greater.
int first_centre(double v) { return int(std::ceil(v - 0.5)); }

class ZBuffer {
public:
    ZBuffer(const Scene& scene, ZBufferTrace& trace)
        : area_(scene.area), trace_(trace), z_(std::size_t(area_.width * area_.height), farthest) {
        trace.clear(farthest);
        for (std::size_t i = 0; i < scene.polygons.size(); ++i) {
            trace.polygon(int(i));
            scan(scene.polygons[i].vertices);
        }
    }

private:
    void scan(const std::vector<Vertex>& vertices) {
        std::vector<Edge> edges = sorted_edges(vertices);  // S
        std::vector<Edge> active;                          // AEL
        const int bottom = area_.y + area_.height;
        int row = edges.empty() ? bottom : edges.front().first_row;
        for (; row < bottom && !(edges.empty() && active.empty()); ++row) {
            trace_.scanline(row + 0.5, row);
            start_edges(edges, active, row);
            for (std::size_t i = 0; i + 1 < active.size(); i += 2) show_line(row, active[i], active[i + 1]);
            end_edges(active, row);
            for (Edge& edge : active) {
                edge.x += edge.dx;
                edge.z += edge.dz;
                trace_.ael_step(edge.index, edge.x, edge.z);
            }
        }
    }

    /// Leaves out edges that cross no centre line of a row of the area, such as horizontal edges.
    std::vector<Edge> sorted_edges(const std::vector<Vertex>& vertices) {
        std::vector<Edge> edges;
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            Vertex from = vertices[i], to = vertices[(i + 1) % vertices.size()];
            if (to.y < from.y) std::swap(from, to);
            const int first = std::max(first_centre(from.y), area_.y), last = first_centre(to.y) - 1;
            if (first > last) continue;
            const double dx = (to.x - from.x) / (to.y - from.y), dz = (to.z - from.z) / (to.y - from.y);
            const double rows = first + 0.5 - from.y;
            edges.push_back({int(i), from, to, first, last, from.x + rows * dx, from.z + rows * dz, dx, dz});
        }
        const auto above = [](const Edge& a, const Edge& b) { return a.from.y < b.from.y; };
        std::stable_sort(edges.begin(), edges.end(), above);
        for (const Edge& edge : edges) trace_.edge(edge.index, edge.from, edge.to);
        return edges;
    }

    void start_edges(std::vector<Edge>& edges, std::vector<Edge>& active, int row) {
        const auto later = [row](const Edge& edge) { return edge.first_row > row; };
        const auto kept = std::stable_partition(edges.begin(), edges.end(), later);
        if (kept == edges.end()) return;
        const std::vector<Edge> starting(kept, edges.end());
        edges.erase(kept, edges.end());
        for (const Edge& edge : starting) {
            active.push_back(edge);
            trace_.ael_add(edge.index, edge.x, edge.z, edge.last_row, edge.dx, edge.dz);
        }
        double next = never;
        for (const Edge& edge : edges) next = std::min(next, double(edge.first_row));
        trace_.leave(indices(starting), next);
        const auto left_of = [](const Edge& a, const Edge& b) { return a.x < b.x || (a.x == b.x && a.dx < b.dx); };
        std::stable_sort(active.begin(), active.end(), left_of);
        trace_.ael_sort(indices(active), first_end(active));
    }

    void end_edges(std::vector<Edge>& active, int row) {
        const auto stays = [row](const Edge& edge) { return edge.last_row > row; };
        const auto ended = std::stable_partition(active.begin(), active.end(), stays);
        if (ended == active.end()) return;
        const std::vector<int> gone = indices(std::vector<Edge>(ended, active.end()));
        active.erase(ended, active.end());
        trace_.ael_drop(gone, first_end(active));
    }

    /// The first row after the end of some active edge.
    static double first_end(const std::vector<Edge>& active) {
        double end = never;
        for (const Edge& edge : active) end = std::min(end, edge.last_row + 1.0);
        return end;
    }

    void show_line(int row, const Edge& left, const Edge& right) {
        trace_.line(row, left.x, left.z, right.x, right.z);
        const double dz = (right.z - left.z) / (right.x - left.x);
        const int first = std::max(first_centre(left.x), area_.x);
        const int end = std::min(first_centre(right.x), area_.x + area_.width);
        for (int x = first; x < end; ++x) {
            const double z = left.z + (x + 0.5 - left.x) * dz;
            double& stored = z_[std::size_t((row - area_.y) * area_.width + x - area_.x)];
            trace_.pixel(x, row, z, stored, z > stored);
            if (z > stored) stored = z;
        }
        trace_.span();
    }

    Area area_;
    ZBufferTrace& trace_;
    std::vector<double> z_;
};

int main(int count, char** words) {
    const Scene scene = scene_to_draw(example_scene());
    ZBufferTrace trace("z_buffer.jsonl", scene, detail_from(count, words));
    ZBuffer(scene, trace);
}
