#include "grade/claims.h"

#include <algorithm>
#include <cmath>

namespace vidno::grading {

using vidno::in_words;

std::string Claims::owner_of(Color color) const {
    std::string owners;
    for (const auto& polygon : scene().polygons) {
        if (polygon.color == color) owners += (owners.empty() ? "" : " or ") + polygon.id;
    }
    if (!owners.empty()) return owners;
    return color == scene().background ? "the background" : "no polygon, " + in_words(color);
}

void Claims::judge_plane(const event::Plane& e) const {
    const int p = e.polygon.index;
    if (!truth_.has_inside(p)) return;
    const auto& [a, b, c, d] = e.plane;
    if (truth_.is_plane(p, {a.number, b.number, c.number, d.number})) return;
    throw False{Symptom::plane,
                "the plane of " + id(p) + " is " + in_words(a.number) + " x + " + in_words(b.number) + " y + " +
                    in_words(c.number) + " z + " + in_words(d.number) + " = 0",
                "its vertices do not lie on that"};
}

void Claims::judge_depth(int polygon, double x, double y, double z) const {
    if (!truth_.has_inside(polygon) || truth_.is_depth(polygon, x, y, z)) return;
    throw False{Symptom::depth, "the depth of " + id(polygon) + " at " + point_in_words(x, y) + " is " + in_words(z),
                "it is " + in_words(truth_.depth(polygon, x, y))};
}

void Claims::judge_start(double z, const std::string& what) const {
    for (int p = 0; p < int(scene().polygons.size()); ++p) {
        if (!truth_.has_inside(p) || truth_.farthest(p) > z) continue;
        throw False{Symptom::start, what + " at " + in_words(z),
                    id(p) + " has a vertex at depth " + in_words(truth_.farthest(p)) +
                        ", which is not nearer than that: start below all depths"};
    }
}

/// As if points of an outline belonged to nobody.
bool Claims::is_hole(int column, int row, Color color) const {
    const SeenPixel& seen = truth_.seen(column, row);
    return seen.on_outline && color == truth_.color_of(seen.by_none);
}

std::string Claims::why_not(int column, int row, Color color) const {
    const double x = column + 0.5, y = row + 0.5;
    const SeenPixel& seen = truth_.seen(column, row);
    const int right = seen.by_rule;
    const std::string where = pixel_in_words(column, row);
    if (is_hole(column, row, color)) {
        return where + ": its centre is on an outline, and in no direction does " + owner_of(color) +
               " show beside it: outlines that meet there must not both leave it out";
    }
    for (int p = 0; p < int(scene().polygons.size()); ++p) {
        if (truth_.color_of(p) != color || truth_.place(p, x, y) == SceneTruth::Place::outside) continue;
        return where + ": the depth of " + id(p) + " at its centre is " + in_words(truth_.depth(p, x, y)) +
               ", that of " + id(right) + " is " + in_words(truth_.depth(right, x, y)) + ", which is nearer";
    }
    if (right == SeenPixel::background) return where + ": no polygon has its centre";
    return where + ": " + owner_of(truth_.color_of(right)) + " shows at its centre";
}

void Claims::judge_pixel(int column, int row, Color color) {
    const SeenPixel& seen = truth_.seen(column, row);
    if (!truth_.allows(column, row, color)) {
        throw False{is_hole(column, row, color) ? Symptom::hole : Symptom::colour,
                    pixel_in_words(column, row) + " shows " + owner_of(color), why_not(column, row, color)};
    }
    if (truth_.color_of(seen.by_rule) != color) note(seen.on_outline ? Difference::outline : Difference::equally_near);
}

void Claims::judge_comparison(double z, double against, bool nearer) {
    if (nearer == (z > against)) return;
    if (truth_.nearly_equal(z, against)) return note(Difference::equally_near);
    throw False{Symptom::comparison,
                in_words(z) + (nearer ? " is nearer than " : " is not nearer than ") + in_words(against),
                "the greater z is the nearer"};
}

}  // namespace vidno::grading
