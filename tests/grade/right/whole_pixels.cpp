// Warnock's algorithm, right: the first window is the area itself. If a side is odd, the second part is one pixel
// longer.
#include "warnock_style.h"

struct WholePixels : PlainStyle {
    static Tile first(const Scene& scene) {
        const Area& area = scene.area;
        return {double(area.x), double(area.y), double(area.width), double(area.height), {}};
    }
    static std::vector<Tile> parts(const Tile& tile) {
        std::vector<Tile> all;
        for (const Range& columns : halves(tile.x, tile.width)) {
            for (const Range& rows : halves(tile.y, tile.height))
                all.push_back({columns.from, rows.from, columns.size, rows.size, tile.list});
        }
        return all;
    }

private:
    struct Range {
        double from, size;
    };
    static std::vector<Range> halves(double from, double size) {
        if (size <= 1) return {{from, size}};
        const double half = std::floor(size / 2);
        return {{from, half}, {from + half, size - half}};
    }
};

int main() { run_as<WholePixels>("whole_pixels.jsonl"); }
