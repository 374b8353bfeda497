// Warnock's algorithm, wrong: it halves a side in whole numbers and loses the remainder.
#include "right/warnock_style.h"

struct IntegerDivision : PlainStyle {
    static Tile first(const Scene& scene) {
        const Area& area = scene.area;
        return {double(area.x), double(area.y), double(area.width), double(area.height), {}};
    }
    static std::vector<Tile> parts(const Tile& tile) {
        const int width = int(tile.width), height = int(tile.height);
        const int columns = width > 1 ? 2 : 1, rows = height > 1 ? 2 : 1;
        const double w = width / columns, h = height / rows;
        std::vector<Tile> all;
        for (int i = 0; i < columns; ++i) {
            for (int j = 0; j < rows; ++j) all.push_back({tile.x + i * w, tile.y + j * h, w, h, tile.list});
        }
        return all;
    }
};

int main() { run_as<IntegerDivision>("integer_division.jsonl"); }
