#include "grade/claims.h"

#include <algorithm>
#include <cmath>

namespace vidno::grading {

std::string Claims::owner_of(Color color) const {
    std::string owners;
    for (const auto& polygon : scene().polygons) {
        if (polygon.color != color) continue;
        if (!owners.empty()) owners += say({" or ", " или "});
        owners += polygon.id;
    }
    if (!owners.empty()) return owners;
    if (color == scene().background) return say({"the background", "фон"});
    return say({"no polygon, {}", "цвет {}, которого нет ни у одного многоугольника"}, color);
}

void Claims::judge_edge(int polygon, int edge) const {
    const int count = int(scene().polygons[std::size_t(polygon)].vertices.size());
    if (0 <= edge && edge < count) return;
    throw False{Symptom::edge, say({"{} has an edge {}", "у многоугольника {} есть ребро {}"}, id(polygon), edge),
                say({"its edges are 0 to {}", "его рёбра — от 0 до {}"}, count - 1)};
}

void Claims::judge_plane(const event::Plane& e) const {
    const int p = e.polygon.index;
    if (!truth_.has_inside(p)) return;
    const auto& [a, b, c, d] = e.plane;
    if (truth_.is_plane(p, {a.number, b.number, c.number, d.number})) return;
    throw False{Symptom::plane,
                say({"the plane of {} is {} x + {} y + {} z + {} = 0", "плоскость {}: {} x + {} y + {} z + {} = 0"},
                    id(p), a.number, b.number, c.number, d.number),
                say({"its vertices do not lie on that plane", "его вершины на ней не лежат"})};
}

void Claims::judge_fault(const event::Fault& e) const {
    if (e.x && e.y) {
        throw False{Symptom::off_polygon,
                    say({"a polygon is drawn at pixel {}", "многоугольник рисуется в пикселе {}"}, pixel(*e.x, *e.y)),
                    say({"that is not in the area", "он не лежит в области"})};
    }
    throw False{Symptom::impossible, say({"this line fails: {}", "на этой строке сбой"}, e.reason),
                say({"the corrected procedure goes on", "исправленная процедура работает дальше"})};
}

void Claims::judge_depth(int polygon, double x, double y, double z) const {
    if (!truth_.has_inside(polygon) || truth_.is_depth(polygon, x, y, z)) return;
    throw False{Symptom::depth,
                say({"the depth of {} at {} is {}", "глубина {} в точке {} равна {}"}, id(polygon), say.point(x, y), z),
                say({"it is {}", "она равна {}"}, truth_.depth(polygon, x, y))};
}

void Claims::judge_start(double z, const Bilingual& what) const {
    for (int p = 0; p < int(scene().polygons.size()); ++p) {
        if (!truth_.has_inside(p) || truth_.farthest(p) > z) continue;
        throw False{
            Symptom::start, say(what, z),
            say({"{} has a vertex at depth {}, which is not nearer than that: start below all depths",
                 "у {} есть вершина на глубине {}, и она не ближе: начальное значение должно быть меньше всех глубин"},
                id(p), truth_.farthest(p))};
    }
}

/// Whether the colour shows only if points of an outline belong to no polygon.
bool Claims::is_hole(int column, int row, Color color) const {
    const SeenPixel& seen = truth_.seen(column, row);
    return seen.on_outline && color == truth_.color_of(seen.by_none);
}

std::string Claims::why_not(int column, int row, Color color) const {
    const double x = column + 0.5, y = row + 0.5;
    const SeenPixel& seen = truth_.seen(column, row);
    const int right = seen.by_rule;
    const std::string where = pixel(column, row);
    if (is_hole(column, row, color)) {
        return say({"pixel {}: its centre is on an outline, and in no direction does {} show beside it: outlines that "
                    "meet there must not both leave it out",
                    "пиксель {}: его центр лежит на контуре, и ни с одной стороны рядом с ним не виден {}: "
                    "сходящиеся там контуры не могут обе его не включать"},
                   where, owner_of(color));
    }
    for (int p = 0; p < int(scene().polygons.size()); ++p) {
        if (truth_.color_of(p) != color || truth_.place(p, x, y) == SceneTruth::Place::outside) continue;
        return say({"pixel {}: the depth of {} at its centre is {}, that of {} is {}, which is nearer",
                    "пиксель {}: глубина {} в его центре равна {}, а глубина {} равна {}, и он ближе"},
                   where, id(p), truth_.depth(p, x, y), id(right), truth_.depth(right, x, y));
    }
    if (right == SeenPixel::background) {
        return say({"pixel {}: no polygon has its centre", "пиксель {}: его центр не лежит ни в одном многоугольнике"},
                   where);
    }
    return say({"pixel {}: {} shows at its centre", "пиксель {}: в его центре виден {}"}, where,
               owner_of(truth_.color_of(right)));
}

void Claims::judge_pixel(int column, int row, Color color) {
    const SeenPixel& seen = truth_.seen(column, row);
    if (!truth_.allows(column, row, color)) {
        throw False{is_hole(column, row, color) ? Symptom::hole : Symptom::colour,
                    say({"pixel {} shows {}", "в пикселе {} виден {}"}, pixel(column, row), owner_of(color)),
                    why_not(column, row, color)};
    }
    if (truth_.color_of(seen.by_rule) != color) note(seen.on_outline ? Difference::outline : Difference::equally_near);
}

void Claims::judge_comparison(double z, double against, bool nearer) {
    if (nearer == (z > against)) return;
    if (truth_.equally_near(z, against)) return note(Difference::equally_near);
    throw False{Symptom::comparison,
                nearer ? say({"{} is nearer than {}", "{} ближе, чем {}"}, z, against)
                       : say({"{} is not nearer than {}", "{} не ближе, чем {}"}, z, against),
                say({"the greater z is the nearer", "ближе тот, у кого z больше"})};
}

void Claims::judge_nearest_so_far(double claimed, const std::optional<double>& known) const {
    if (!known || *known == claimed || truth_.nearly_equal(*known, claimed)) return;
    throw False{Symptom::comparison,
                say({"the nearest depth so far is {}", "ближайшая из прежних глубин равна {}"}, claimed),
                say({"the trace has reported {} before", "раньше в записи сказано {}"}, *known)};
}

bool Claims::is_row(double y, double left, double right, const SceneTruth::Ends& ends, const Window& window) const {
    const double first = ends.first.x, last = ends.second.x;
    const auto is_cut_by = [&](const Window& by) {
        const bool meets = by.y <= y && y <= by.bottom() && first <= by.right() && by.x <= last;
        return meets && (truth_.same_coordinate(left, first) || truth_.same_coordinate(left, std::max(first, by.x))) &&
               (truth_.same_coordinate(right, last) || truth_.same_coordinate(right, std::min(last, by.right())));
    };
    const bool is_whole = truth_.same_coordinate(left, first) && truth_.same_coordinate(right, last);
    return is_whole || is_cut_by(window) || is_cut_by(whole_area(scene().area)) || is_cut_by(truth_.in_area(window));
}

void Claims::judge_columns(int polygon, int row, int first, int end, const SceneTruth::Crossing& left,
                           const SceneTruth::Crossing& right) const {
    const Area& area = scene().area;
    const auto is_at = [&](double end_x, int column) { return truth_.may_coincide(end_x, column + 0.5); };
    for (int column = area.x; column < area.right(); ++column) {
        const bool is_claimed = first <= column && column < end,
                   is_between = left.x < column + 0.5 && column + 0.5 < right.x;
        if (is_claimed == is_between || is_at(left.x, column) || is_at(right.x, column)) continue;
        throw False{
            Symptom::edge,
            say({"on row {} the centres of the columns from {} to {} are in {}",
                 "в строке {} центры столбцов от {} до {} лежат в {}"},
                row, first, end - 1, id(polygon)),
            say({"it reaches from x = {} to {} there", "там он простирается от x = {} до {}"}, left.x, right.x)};
    }
}

}  // namespace vidno::grading
