// The Z-buffer, right: it draws each polygon column by column.
#include "z_buffer_style.h"

struct Columns : PlainStyle {
    static std::vector<Sampled> pixels_of(const Polygon& polygon, const Area& area) {
        std::vector<Sampled> all = PlainStyle::pixels_of(polygon, area);
        std::stable_sort(all.begin(), all.end(), [](const Sampled& a, const Sampled& b) { return a.x < b.x; });
        return all;
    }
};

int main() { run_as<Columns>("columns.jsonl"); }
