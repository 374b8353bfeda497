// A skeleton for the Z-buffer with an active edge list, with the place of each call of `trace`. You write the
// procedures. Without them the program shows no polygon, and `vidno grade` says so.
//
//     z_buffer [windows | polygons | signs]     writes z_buffer.jsonl
#include "example.h"

using namespace vidno::student;

const double farthest = -2;  // behind all that is visible

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
    /// Z3 to Z17. The calls, in order:
    ///     edge for each edge of S, from the upper end down; extent;
    ///     on each row scanline; ael_add for each edge that begins, leave, ael_sort;
    ///     ShowLine for each pair of AEL; ael_drop for the edges that end; ael_step for those that stay
    void scan(const std::vector<Vertex>&) {}

    /// L1 to L6: line; slope and columns; pixel for each pixel between the ends; the result: span.
    void show_pixel(int x, int row, double z) {
        double& stored = z_[std::size_t((row - area_.y) * area_.width + x - area_.x)];
        trace_.pixel(x, row, z, stored, z > stored);
        if (z > stored) stored = z;
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
