// The Z-buffer, right: it draws the polygons from the last to the first, and their pixels in reverse order.
#include "z_buffer_style.h"

struct Backwards : PlainStyle {
    static const bool backwards = true;

    static std::vector<Sampled> pixels_of(const Polygon& polygon, const Area& area) {
        std::vector<Sampled> all = PlainStyle::pixels_of(polygon, area);
        std::reverse(all.begin(), all.end());
        return all;
    }
};

int main() { run_as<Backwards>("backwards.jsonl"); }
