// Warnock's algorithm, right: it cuts a window in two across its longer side.
#include "warnock_style.h"

struct Halves : PlainStyle {
    static std::vector<Tile> parts(const Tile& tile) {
        Tile first = tile, second = tile;
        if (tile.width >= tile.height) {
            first.width = second.width = tile.width / 2;
            second.x += first.width;
        } else {
            first.height = second.height = tile.height / 2;
            second.y += first.height;
        }
        return {first, second};
    }
};

int main() { run_as<Halves>("halves.jsonl"); }
