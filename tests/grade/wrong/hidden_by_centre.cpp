// Warnock's algorithm, wrong: a surrounding polygon hides another one if it is nearer at the window's centre.
#include "../right/warnock_style.h"

struct HiddenByCentre : PlainStyle {
    static bool hides(const Polygon& polygon, const Polygon& other, const Tile& tile) {
        const Point centre{tile.x + tile.width / 2, tile.y + tile.height / 2};
        return depth(polygon, centre) >= depth(other, centre);
    }
};

int main() { run_as<HiddenByCentre>("hidden_by_centre.jsonl"); }
