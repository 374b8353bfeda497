#include "say/exactly.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "say/scene_facts.h"
#include "say/warnock_words.h"

namespace vidno::say {

namespace {

using Said = std::string;
using Owner = std::optional<int>;

/// Whether the digits of a sentence are right.
bool looks_like(const Value& computed, const Value& exact, Language language) {
    if (computed.fraction) return computed == exact;
    // Half of a last digit may be rounded either way.
    constexpr double tiny = 1e-12;
    const double one = number_of(computed), other = number_of(exact);
    if (std::abs(one - other) <= tiny * std::abs(other)) return true;
    const auto digits = [&](const Value& value) {
        const Said text = short_number(number_of(value), language);
        constexpr std::string_view about = "≈";
        return text.starts_with(about) ? text.substr(about.size()) : text;
    };
    return digits(computed) == digits(exact);
}

/// What is so at an event of curves. The edges of the surface, and the steps between columns, are not examined.
struct CurveTruths : CurveWords {
    explicit CurveTruths(const CurveWords& words) : CurveWords(words), facts(*header().scene.curves) {}

    CurveFacts facts;

    Said operator()(const event::Visibility& e) const {
        const auto flag = after().curve ? facts.flag(*after().curve, e.x) : std::nullopt;
        // What is on both horizons is on each of them.
        const bool is_so = flag == e.flag || (flag == VisibilityFlag::both && e.flag != VisibilityFlag::hidden);
        return !flag || is_so ? Said() : lies_at(e.x);
    }
    Said operator()(const event::Height& e) const {
        if (!after().curve) return {};
        const auto y = facts.height(*after().curve, e.x);
        if (!y) return {};
        const auto reached = facts.horizons(*after().curve, e.x);
        const auto is_so = [&](const std::optional<Value>& computed, const Value& exact) {
            return computed && looks_like(*computed, exact, language());
        };
        const bool are_so =
            reached ? is_so(e.upper, reached->upper) && is_so(e.lower, reached->lower) : !e.upper && !e.lower;
        return are_so && is_so(e.y, *y) ? Said() : lies_at(e.x);
    }
    Said operator()(const event::Intersection& e) const { return at_end(e.point, e.columns); }
    Said operator()(const event::DrawLine& e) const {
        if (!after().curve) return {};
        for (int x = e.from_columns.first; x <= e.to_columns.second; ++x) {
            if (number_of(e.from.x) >= x || x >= number_of(e.to.x)) continue;
            if (facts.flag(*after().curve, x) == VisibilityFlag::hidden) return lies_at(x);
        }
        Said so = at_end(e.from, e.from_columns);
        return so.empty() ? at_end(e.to, e.to_columns) : so;
    }

    Said operator()(const auto&) const { return {}; }

private:
    /// What is so at an end of a line: a point of the curve over a column, or where it meets a horizon between two.
    Said at_end(const ValuePoint& end, const std::pair<int, int>& columns) const {
        using enum VisibilityFlag;
        const auto [left, right] = columns;
        if (!after().curve) return {};
        if (left == right) {
            const auto y = facts.height(*after().curve, left);
            return y && !looks_like(end.y, *y, language()) ? lies_at(left) : Said();
        }
        std::optional<ValuePoint> found;
        for (const VisibilityFlag side : {above, below}) {
            const auto crossing = facts.crossing(*after().curve, left, side);
            if (!crossing) continue;
            found = crossing;
            if (looks_like(end.x, found->x, language()) && looks_like(end.y, found->y, language())) return {};
        }
        if (found) return say("it meets the horizon at {}.", "она встречает горизонт в {}.", *found);
        return say("it meets no horizon between the columns {} and {}.",
                   "между столбцами {} и {} она горизонта не встречает.", left, right);
    }

    /// "over column 3 it is hidden: the curve is at 1/2, the horizons are at 1/4 and 3/4."
    Said lies_at(int x) const {
        const int curve = *after().curve;
        const auto y = facts.height(curve, x);
        const auto reached = facts.horizons(curve, x);
        if (!reached) {
            return say("over column {} it is visible: it is at {}, and there is no horizon.",
                       "над столбцом {} она видна: её ордината {}, а горизонта там нет.", x, *y);
        }
        const Bilingual is = facts.flag(curve, x) == VisibilityFlag::hidden ? Bilingual{"hidden", "не видна"}
                                                                            : Bilingual{"visible", "видна"};
        return say("over column {} it is {}: it is at {}, the horizons are at {} and {}.",
                   "над столбцом {} она {}: её ордината {}, ординаты горизонтов {} и {}.", x, in(is), *y,
                   reached->upper, reached->lower);
    }
};

/// What is so at an event. Each function returns nothing if the sentence of the event is right.
struct Truths : WarnockWords {
    explicit Truths(const PolygonWords& words) : WarnockWords(words), facts(header()) {}

    SceneFacts facts;
    /// The pixel that the last answer is about.
    mutable std::optional<std::pair<int, int>> pixel{};

    // Numbers

    Said operator()(const event::Depth& e) const {
        const auto depth = facts.depth(e.polygon.index, e.point);
        return depth ? number(e.z, *depth, {"its depth is {}.", "глубина равна {}."}) : Said();
    }
    Said operator()(const event::Orient& e) const {
        const auto value = facts.cross(e.polygon.index, e.edge, e.point);
        if (!value) return {};
        const Sign sign = order_of(*value, 0).value_or(e.sign);
        if (sign == e.sign)
            return number(e.value, *value, {"the cross product is {}.", "векторное произведение равно {}."});
        switch (sign) {
            case Sign::negative:
                return say("it lies on the negative side ({}).", "по отрицательную сторону ({}).", *value);
            case Sign::zero: return say("it lies on the line ({}).", "на прямой ({}).", *value);
            case Sign::positive:
                return say("it lies on the positive side ({}).", "по положительную сторону ({}).", *value);
        }
        return {};
    }

    // The windows

    Said operator()(const event::Box& e) const {
        if (!window()) return {};
        const bool outside = facts.is_box_outside(e.polygon.index, window()->window);
        if (outside == e.outside) return {};
        return outside ? say("the box lies outside the window.", "прямоугольник лежит вне окна.")
                       : say("the box meets the window.", "прямоугольник пересекается с окном.");
    }
    Said operator()(const event::Insider& e) const {
        if (!window()) return {};
        const bool inside = facts.is_box_inside(e.polygon.index, window()->window);
        if (inside == e.inside) return {};
        return inside ? say("the box lies strictly inside.", "прямоугольник лежит строго внутри.")
                      : say("the box does not lie strictly inside.", "прямоугольник не лежит строго внутри.");
    }
    Said operator()(const event::Compare& e) const {
        if (!window()) return {};
        const auto& of = window()->window;
        const bool is_at_right = e.corner == Corner::right_bottom || e.corner == Corner::right_top;
        const bool is_below = e.corner == Corner::left_top || e.corner == Corner::right_top;
        const ValuePoint point = e.corner ? ValuePoint{is_at_right ? of.right() : of.x, is_below ? of.bottom() : of.y}
                                          : ValuePoint{of.x + of.width / 2, of.y + of.height / 2};
        const auto own = facts.depth(e.polygon.index, point);
        if (!own) return {};
        const auto other = e.at == Line::PW6   ? nearest_before(e.polygon, point)
                           : e.at == Line::PC4 ? depth_of_nearest(point)
                                               : std::nullopt;
        const bool nearer = other && order_of(*own, *other) == Sign::positive;
        if (!other || nearer == e.nearer) return number(e.z, *own, {"its depth is {}.", "глубина равна {}."});
        const auto [one, two] = apart(*own, *other, language());
        return nearer ? say("it is nearer: {} > {}.", "он ближе: {} > {}.", one, two)
                      : say("it is not nearer: {} ≯ {}.", "он не ближе: {} ≯ {}.", one, two);
    }
    Said operator()(const event::Mark& e) const { return not_surrounding(e.polygon); }
    Said operator()(const event::Cover& e) const {
        Said outside = not_surrounding(e.polygon);
        if (!outside.empty() || !window()) return outside;
        // Those after it in the scene have not been examined yet.
        const auto nearer =
            facts.unexpected(pixels(), e.polygon.index + 1, [&](Owner owner) { return owner == e.polygon.index; });
        return nearer ? not_nearest(e.polygon, *nearer) : Said();
    }
    Said operator()(const event::Summary& e) const {
        if (!e.has_surround || !window()) return {};
        const auto covering = warnock().covering();
        return covering ? only_shown(covering->index) : Said();
    }
    Said operator()(const event::Hiding& e) const {
        return e.polygon && window() ? only_shown(e.polygon->index) : Said();
    }
    Said operator()(const event::Decide& e) const {
        if (!window()) return {};
        if (e.which == Case::empty) return only_shown({});
        if (e.which == Case::surrounded && hiding()) return only_shown(hiding()->index);
        const auto list = warnock().list(*window()).entries();
        if (e.which != Case::single || list.size() != 1) return {};
        return shown_in(pixels(), everything(), [&](Owner owner) { return !owner || owner == list[0].first.index; });
    }
    /// At W10 and WF6 the only polygon is drawn over the background.
    Said operator()(const event::Fill& e) const {
        if (is_at(e, {Line::W10, Line::WF6})) return {};
        return shown_in(e.rect, everything(), [&](Owner owner) { return color_of(owner) == e.color; });
    }

    // A point and a polygon

    Said operator()(const event::Surround& e) const {
        const auto holds = facts.holds(e.polygon.index, e.point);
        if (!holds || *holds == e.inside) return {};
        return *holds ? say("it lies in {}.", "в {}.", e.polygon) : say("it lies outside {}.", "вне {}.", e.polygon);
    }
    Said operator()(const event::Nearest& e) const {
        const auto depth = window() ? facts.depth(e.polygon.index, centre()) : std::nullopt;
        return depth ? number(e.z, *depth, {"its depth there is {}.", "глубина там равна {}."}) : Said();
    }
    Said operator()(const event::PointColor& e) const {
        const auto seen = facts.seen(e.point);
        if (!seen || color_of(seen->polygon) == e.color) return {};
        return say("it is {}.", "там виден {}.", name(seen->polygon, {"the background", "фон"}));
    }

    // Clipping and filling

    Said operator()(const event::ClipResult& e) const {
        const auto relation = relation_of(e.polygon);
        if (!relation || (*relation == Relation::outside) == e.vertices.empty()) return {};
        return e.vertices.empty() ? say("a part of it lies in the window.", "часть его лежит в окне.")
                                  : say("it lies outside the window.", "он лежит вне окна.");
    }
    Said operator()(const event::Row& e) const {
        if (algorithm_of(header().method) != Algorithm::warnock || !window()) return {};
        const auto list = warnock().list(*window()).entries();
        if (list.size() != 1) return {};
        const auto& of = window()->window;
        return row_of(list[0].first, e, {of.x, of.right()},
                      [&](const Value& left, const Value& right, const Said& columns) {
                          return say("from {} to {}: {}.", "от {} до {}: {}.", left, right, columns);
                      });
    }
    Said operator()(const event::Draw& e) const {
        if (!window()) return {};
        for (const PixelRun& run : e.runs) {
            auto so = shown_in({run.first, run.row, run.end - run.first, 1}, everything(),
                               [&](Owner owner) { return color_of(owner) == e.color; });
            if (!so.empty()) return so;
        }
        const auto [left, top, width, height] = pixels();
        for (int y = top; y < top + height; ++y) {
            int from = left;
            const auto beside = [&](int end) {
                return shown_in({from, y, end - from, 1}, everything(),
                                [&](Owner owner) { return color_of(owner) == header().scene.background; });
            };
            for (const PixelRun& run : e.runs) {
                if (run.row != y) continue;
                auto so = beside(run.first);
                if (!so.empty()) return so;
                from = run.end;
            }
            auto so = beside(left + width);
            if (!so.empty()) return so;
        }
        return {};
    }

    // The variants

    Said operator()(const event::BackFace& e) const {
        const auto& vertices = header().scene.polygons[std::size_t(e.polygon.index)].vertices;
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            const auto& next = vertices[(i + 2) % vertices.size()];
            const auto turn = facts.cross(e.polygon.index, int(i), {next.x, next.y});
            const auto sign = turn ? order_of(*turn, 0) : std::nullopt;
            if (!sign || sign == Sign::zero) continue;
            const bool away = sign == Sign::positive;
            if (away == e.away) return {};
            return away ? say("it runs clockwise.", "он обходится по часовой стрелке.")
                        : say("it runs counter-clockwise.", "он обходится против часовой стрелки.");
        }
        return {};
    }
    Said operator()(const event::RelationFound& e) const {
        const auto relation = relation_of(e.polygon);
        return relation && *relation != e.relation ? so_related(*relation) : Said();
    }
    Said operator()(const event::Meets& e) const {
        const auto relation = relation_of(e.polygon);
        if (!relation) return {};
        const bool meets = *relation == Relation::intersecting || *relation == Relation::inside;
        return meets == e.meets ? Said() : so_related(*relation);
    }
    Said operator()(const event::Crossings& e) const { return contained(e.polygon, e.count % 2 == 1); }
    Said operator()(const event::Angle& e) const { return contained(e.polygon, e.octants != 0); }

    // The Z-buffer

    Said operator()(const event::ShownLine& e) const {
        const auto polygon = after().z_buffer().polygon();
        const auto& y = after().z_buffer().scan().y;
        // As printed, a row is scanned beside its centre.
        if (!polygon || (y && number_of(*y) != e.row + .5)) return {};
        const auto ends = facts.on_row(polygon->index, e.row);
        if (!ends || (looks_like(e.from.x, ends->first) && looks_like(e.to.x, ends->second))) return {};
        return say("from x = {} to x = {}.", "от x = {} до x = {}.", ends->first, ends->second);
    }
    Said operator()(const event::Columns& e) const {
        const auto polygon = after().z_buffer().polygon();
        const auto& frames = after().z_buffer().scan();
        if (!polygon || !frames.row) return {};
        const Area& area = header().scene.area;
        const int row = *frames.row;
        const auto found = centres_on(*polygon, row, {double(area.x), double(area.right())});
        if (found && *found != std::pair(e.first, e.end)) return say("{}.", "{}.", columns_or_none(*found));
        if (e.first >= e.end) return {};
        const auto depth = facts.depth(polygon->index, {e.first + .5, row + .5});
        return depth ? number(e.z, *depth, {"z = {} at the first.", "z = {} в первом."}) : Said();
    }
    Said operator()(const event::Pixel& e) const {
        const auto polygon = after().z_buffer().polygon();
        if (!polygon) return {};
        const ValuePoint centre{e.x + .5, e.y + .5};
        const auto own = facts.depth(polygon->index, centre);
        if (!own) return {};
        if (facts.holds(polygon->index, centre) == false) return not_nearest(*polygon, {e.x, e.y, {}});
        Owner owner;
        facts.unexpected({e.x, e.y, 1, 1}, polygon->index + 1, [&](Owner found) {
            owner = found;
            return true;
        });
        const bool shows = owner == polygon->index;
        if (shows == e.shown) return number(e.z, *own, {"its depth is {}.", "глубина равна {}."});
        if (shows) return say("it is the nearest so far: {}.", "он пока ближе всех: {}.", *own);
        return not_nearest(*polygon, {e.x, e.y, owner});
    }

    // Weiler and Atherton's algorithm

    Said operator()(const event::Order& e) const { return order_at(e.point, e.polygon, e.other, e.order); }
    Said operator()(const event::Behind& e) const { return order_at(e.point, e.polygon, e.clip, e.order); }
    Said operator()(const event::Paint& e) const {
        const auto& color = header().scene.polygons[std::size_t(e.polygon.index)].color;
        for (const auto& run : e.runs) {
            auto so = shown_in({run.first, run.row, run.end - run.first, 1}, everything(),
                               [&](Owner owner) { return color_of(owner) == color; });
            if (!so.empty()) return so;
        }
        return {};
    }

    Said operator()(const auto&) const { return {}; }

    /// What should show at a pixel of this colour.
    Said at_pixel(int x, int y, const Color& color) const {
        return shown_in({x, y, 1, 1}, everything(), [&](Owner owner) { return color_of(owner) == color; });
    }

private:
    int everything() const { return int(header().scene.polygons.size()); }
    PixelRectangle pixels() const { return pixels_of(header().scene.area, window()->window); }
    ValuePoint centre() const {
        const auto& of = window()->window;
        return {of.x + of.width / 2, of.y + of.height / 2};
    }
    Color color_of(Owner owner) const {
        return owner ? header().scene.polygons[std::size_t(*owner)].color : header().scene.background;
    }
    Said name(Owner polygon, const Bilingual& nothing) const {
        return polygon ? word(PolygonPlace{*polygon}) : Said(in(nothing));
    }

    bool looks_like(const Value& computed, const Value& exact) const {
        return say::looks_like(computed, exact, language());
    }
    Said number(const Value& computed, const Value& exact, const Bilingual& so) const {
        return looks_like(computed, exact) ? Said() : say(so.english, so.russian, exact);
    }

    /// The pixel's name; notes it.
    Said named(const SceneFacts::Shown& there) const {
        pixel = {there.x, there.y};
        return pair(double(there.x), double(there.y));
    }

    /// "at pixel (3, 4) B shows, at depth 1/2."
    Said shown_in(const PixelRectangle& rectangle, int polygons, const std::function<bool(Owner)>& expected) const {
        const auto found = facts.unexpected(rectangle, polygons, expected);
        if (!found) return {};
        const Said at = named(*found);
        if (!found->polygon) return say("pixel {} shows the background.", "в пикселе {} виден фон.", at);
        const auto depth = facts.depth(*found->polygon, {found->x + .5, found->y + .5});
        return say("pixel {} shows {}, whose depth there is {}.", "в пикселе {} виден {}, его глубина там {}.", at,
                   PolygonPlace{*found->polygon}, *depth);
    }
    Said only_shown(Owner polygon) const {
        return shown_in(pixels(), everything(), [&](Owner owner) { return owner == polygon; });
    }

    /// Why the polygon does not show at a pixel, where another one or none of those so far does.
    Said not_nearest(PolygonPlace polygon, const SceneFacts::Shown& there) const {
        const ValuePoint centre{there.x + .5, there.y + .5};
        const Said at = named(there);
        if (!there.polygon || facts.holds(polygon.index, centre) == false) {
            return say("the centre of pixel {} lies outside {}.", "центр пикселя {} лежит вне {}.", at, polygon);
        }
        const PolygonPlace other{*there.polygon};
        const auto own = facts.depth(polygon.index, centre), others = facts.depth(other.index, centre);
        const auto [one, two] = apart(*others, *own, language());
        return order_of(*others, *own) == Sign::zero
                   ? say("at pixel {} {} is as near and comes first: {} = {}.",
                         "в пикселе {} {} так же близко и идёт раньше: {} = {}.", at, other, one, two)
                   : say("at pixel {} {} is nearer: {} > {}.", "в пикселе {} {} ближе: {} > {}.", at, other, one, two);
    }

    std::optional<Relation> relation_of(PolygonPlace polygon) const {
        return window() ? facts.relation(polygon.index, window()->window) : std::nullopt;
    }
    Said so_related(Relation relation) const {
        switch (relation) {
            case Relation::outside: return say("it lies outside the window.", "он лежит вне окна.");
            case Relation::inside: return say("it lies inside the window.", "он лежит внутри окна.");
            case Relation::intersecting: return say("it intersects the window.", "он пересекает окно.");
            case Relation::surrounding: return say("it surrounds the window.", "он охватывает окно.");
        }
        return {};
    }
    Said not_surrounding(PolygonPlace polygon) const {
        const auto relation = relation_of(polygon);
        return relation && *relation != Relation::surrounding ? so_related(*relation) : Said();
    }
    Said contained(PolygonPlace polygon, bool surrounds) const {
        const auto relation = relation_of(polygon);
        if (!relation || (*relation == Relation::surrounding) == surrounds) return {};
        return so_related(*relation);
    }

    /// The greatest depth of the polygons before this one in the current list.
    std::optional<Value> nearest_before(PolygonPlace polygon, const ValuePoint& at) const {
        std::optional<Value> nearest;
        for (const auto& [each, surrounds] : warnock().list(*window()).entries()) {
            if (each.index >= polygon.index) break;
            const auto depth = facts.depth(each.index, at);
            if (depth && !(nearest && order_of(*depth, *nearest) != Sign::positive)) nearest = depth;
        }
        return nearest;
    }
    std::optional<Value> depth_of_nearest(const ValuePoint& at) const {
        const auto& nearest = warnock().nearest();
        return nearest ? facts.depth(nearest->polygon.index, at) : std::nullopt;
    }

    /// The columns of the pixels whose centres the polygon holds on a row, between two places.
    std::optional<std::pair<int, int>> centres_on(PolygonPlace polygon, int row,
                                                  std::pair<double, double> within) const {
        const auto ends = facts.on_row(polygon.index, row);
        if (!ends) return std::nullopt;
        int first = int(std::ceil(within.first - .5)), end = int(std::ceil(within.second - .5));
        const auto is_beyond = [](const Value& one, double other, Sign sign) { return order_of(one, other) == sign; };
        first = std::max(first, int(std::floor(std::clamp(number_of(ends->first), within.first, within.second))) - 1);
        end = std::min(end, int(std::ceil(std::clamp(number_of(ends->second), within.first, within.second))) + 1);
        while (first < end && is_beyond(ends->first, first + .5, Sign::positive)) ++first;
        while (first < end && is_beyond(ends->second, end - .5, Sign::negative)) --end;
        return std::pair(first, end);
    }
    Said columns_or_none(const std::pair<int, int>& found) const {
        const auto [first, end] = found;
        return first < end ? columns(first, end - 1) : say("no pixel’s centre", "ни одного центра пикселя");
    }
    Said row_of(PolygonPlace polygon, const auto& e, std::pair<double, double> within, auto&& so) const {
        const auto ends = facts.on_row(polygon.index, e.row);
        const PixelRectangle here = pixels();
        const auto found = centres_on(polygon, e.row, {double(here.x), double(here.x + here.width)});
        if (!ends || !found) return {};
        const auto inside = [&](const Value& x) {
            if (order_of(x, within.first) == Sign::negative) return Value(within.first);
            return order_of(x, within.second) == Sign::positive ? Value(within.second) : x;
        };
        const Value left = inside(ends->first), right = inside(ends->second);
        const bool is_empty = found->first >= found->second && e.first >= e.end;
        const bool is_right =
            (is_empty || *found == std::pair(e.first, e.end)) && looks_like(e.left, left) && looks_like(e.right, right);
        return is_right ? Said() : so(left, right, columns_or_none(*found));
    }

    Said order_at(const ValuePoint& point, PolygonPlace polygon, PolygonPlace other, Sign order) const {
        const auto own = facts.depth(polygon.index, point), others = facts.depth(other.index, point);
        const auto exact = own && others ? order_of(*own, *others) : std::nullopt;
        if (!exact || *exact == order) return {};
        const auto [one, two] = apart(*own, *others, language());
        const char* const sign = *exact == Sign::negative ? "<" : *exact == Sign::zero ? "=" : ">";
        return say("{} {} {}.", "{} {} {}.", one, sign, two);
    }
};

}  // namespace

namespace {

bool can_err(Edition edition, const std::string& kernel) {
    return edition != Edition::corrected || !is_always_right(kernel);
}

std::optional<Exact> found_by(const PolygonWords& words, auto&& ask) {
    if (!can_be_wrong(words.header())) return std::nullopt;
    const Truths truths(words);
    Said text = ask(truths);
    return text.empty() ? std::nullopt : std::optional(Exact{std::move(text), truths.pixel});
}

}  // namespace

bool can_be_wrong(const TraceHeader& header) { return can_err(header.edition, header.kernel); }
bool can_be_wrong(const FloatingHorizonHeader& header) { return can_err(header.edition, header.kernel); }

std::optional<Exact> exactly(const EventView& event, const PolygonWords& words) {
    return found_by(words, [&](const Truths& truths) { return event.visit([&](const auto& e) { return truths(e); }); });
}

std::optional<Exact> exactly(const EventView& event, const CurveWords& words) {
    if (!can_be_wrong(words.header())) return std::nullopt;
    const CurveTruths truths(words);
    Said text = event.visit([&](const auto& e) { return truths(e); });
    return text.empty() ? std::nullopt : std::optional(Exact{std::move(text), std::nullopt});
}

std::optional<Exact> exactly_at(int x, int y, const PolygonWords& words) {
    return found_by(
        words, [&](const Truths& truths) { return truths.at_pixel(x, y, words.after().screen().pixel(x, y).color); });
}

Statement stated(std::string text, const std::optional<Exact>& exact, const Words& words) {
    if (!exact) return {std::move(text)};
    return {words.say("Computed: {}", "Вычислено: {}", text),
            words.say("Exactly: {}", "На самом деле: {}", exact->text), exact->pixel};
}

}  // namespace vidno::say
