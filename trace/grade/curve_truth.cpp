#include "grade/curve_truth.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "grade/magnitude.h"
#include "scene/rational_curves.h"
#include "vidno/kernels/exact.h"

namespace vidno {

namespace {

using Cell = std::optional<Rational>;

/// Over the columns of the area. Heights grow downward, so the upper horizon is the least height.
struct HorizonPair {
    std::vector<Cell> upper, lower;

    void include(std::size_t column, const Rational& y) {
        if (!upper[column] || y < *upper[column]) upper[column] = y;
        if (!lower[column] || y > *lower[column]) lower[column] = y;
    }
};

/// An open interval of x.
struct Stretch {
    Rational first, last;
};

/// A linear function on the interval between two neighbouring columns.
struct Linear {
    Rational at_first, at_last;

    Rational at(const Rational& t) const { return at_first + (at_last - at_first) * t; }
};

/// The part of 0 < t < 1 where the function exceeds the bound; none if it is empty.
std::optional<Stretch> where_above(const Linear& f, const Rational& bound) {
    const Rational first = f.at_first - bound, last = f.at_last - bound;
    if (first <= 0 && last <= 0) return std::nullopt;
    if (first >= 0 && last >= 0) return Stretch{0, 1};
    const Rational zero = first / (first - last);
    return first > 0 ? Stretch{0, zero} : Stretch{zero, 1};
}

std::optional<Stretch> common(const std::optional<Stretch>& a, const std::optional<Stretch>& b) {
    if (!a || !b) return std::nullopt;
    Stretch both{std::max(a->first, b->first), std::min(a->last, b->last)};
    return both.first < both.last ? std::optional(both) : std::nullopt;
}

/// An x near the middle, with few digits if possible.
double middle_of(const Stretch& part) {
    const double middle = CGAL::to_double(Rational((part.first + part.last) / 2));
    const double rounded = std::round(middle * 64) / 64;
    return part.first < Rational(rounded) && Rational(rounded) < part.last ? rounded : middle;
}

/// The edge from the end of one curve to that of the next, over the columns strictly between.
void include_edge(HorizonPair& horizons, const Sample& from, const Sample& to, int first_column) {
    const auto [first, end] = columns_of_edge(from, to);
    for (int x = first; x < end; ++x) horizons.include(std::size_t(x - first_column), height_on(from, to, x));
}

}  // namespace

struct CurveTruth::Exactly {
    CurveScene scene;
    Precision precision;
    Rational slack;      // the tolerance of a height
    double x_slack = 0;  // the tolerance of an end of a line
    mutable bool shows_single = false;
    double highest = 0, lowest = 0;
    std::vector<std::vector<Cell>> heights;  // of each curve, over its columns; none in a gap
    std::vector<HorizonPair> before, after;  // each curve

    Exactly(const CurveScene& given, Precision of) : scene(given), precision(of) {
        const Area& area = scene.area;
        double largest_y = 1;
        bool any = false;
        for (const auto& [samples] : scene.curves) {
            for (const auto& [x, y] : samples) {
                if (!std::isfinite(y)) continue;
                largest_y = std::max(largest_y, std::abs(y));
                highest = any ? std::min(highest, y) : y;
                lowest = any ? std::max(lowest, y) : y;
                any = true;
            }
        }
        const double largest_x = std::max({1.0, std::abs(double(area.x)), std::abs(double(area.right()))});
        const double unit = rounding(precision);
        // An x that is rounded by this much changes a height by as much times the slope.
        slack = Rational(unit) * Rational(largest_y) * Rational(1 + largest_x / 256);
        x_slack = unit * largest_x;

        HorizonPair horizons{std::vector<Cell>(std::size_t(area.width)), std::vector<Cell>(std::size_t(area.width))};
        std::optional<std::pair<Sample, Sample>> last;
        for (const Curve& curve : scene.curves) {
            const auto ends = ends_of(curve);
            if (last && ends) include_edge(horizons, last->first, ends->first, area.x);
            before.push_back(horizons);
            heights.push_back(heights_of(curve));
            for (std::size_t i = 0; i < heights.back().size(); ++i) {
                if (heights.back()[i]) horizons.include(column(curve.samples.front().x) + i, *heights.back()[i]);
            }
            if (last && ends) include_edge(horizons, last->second, ends->second, area.x);
            after.push_back(horizons);
            last = ends;
        }
    }

    /// Whether a claimed height is the right one.
    bool is_right(double claimed, const Rational& right) const {
        if (!std::isfinite(claimed)) return false;
        const Rational off = magnitude(right - Rational(claimed));
        if (off <= slack * Rational(strictness(precision, claimed))) return true;
        // Heights of a program in double are floats only if the right ones are.
        if (precision == Precision::twice && is_float(claimed) &&
            Rational(double(float(CGAL::to_double(right)))) != right)
            shows_single =
                shows_single || off <= slack * Rational(rounding(Precision::single) / rounding(Precision::twice));
        return false;
    }

    /// The tolerance of a claimed end of a line.
    Rational open_end(double x) const { return Rational(x_slack * strictness(precision, x)); }

    std::size_t column(int x) const { return std::size_t(x - scene.area.x); }
    const std::vector<Sample>& samples(int curve) const { return scene.curves[std::size_t(curve)].samples; }
    int first(int curve) const { return samples(curve).front().x; }
    int last(int curve) const { return samples(curve).back().x; }
    /// The height over one of the curve's columns.
    const Cell& cell(int curve, int x) const { return heights[std::size_t(curve)][std::size_t(x - first(curve))]; }
    bool has_point(int curve, int x) const { return first(curve) <= x && x <= last(curve) && cell(curve, x); }
    const Rational& over(int curve, int x) const { return *cell(curve, x); }
    /// Whether the curve goes from a column to the next. A gap is at least a column wide, as samples are.
    bool goes_on(int curve, int x) const { return has_point(curve, x) && has_point(curve, x + 1); }

    static std::vector<Cell> heights_of(const Curve& curve) {
        const int first = curve.samples.front().x;
        std::vector<Cell> all(std::size_t(curve.samples.back().x - first) + 1);
        for (const Piece& piece : pieces_of(curve)) {
            all[std::size_t(piece.front().x - first)] = Rational(piece.front().y);
            for (std::size_t i = 1; i < piece.size(); ++i) {
                const Sample &from = piece[i - 1], &to = piece[i];
                for (int x = from.x + 1; x <= to.x; ++x) all[std::size_t(x - first)] = height_on(from, to, x);
            }
        }
        return all;
    }

    std::optional<Rational> at(int curve, const Rational& x) const {
        if (x < first(curve) || x > last(curve)) return std::nullopt;
        int left = first(curve);
        while (left + 1 < last(curve) && Rational(left + 1) <= x) ++left;
        if (goes_on(curve, left)) return Linear{over(curve, left), over(curve, left + 1)}.at(x - Rational(left));
        if (x == Rational(left)) return cell(curve, left);
        return x == Rational(left + 1) ? cell(curve, left + 1) : std::nullopt;
    }

    const std::vector<Cell>& horizon(int curve, When when, Side side) const {
        const HorizonPair& both = (when == When::before ? before : after)[std::size_t(curve)];
        return side == Side::upper ? both.upper : both.lower;
    }

    /// How far a curve lies beyond a horizon before it, over a column and the next; negative if it does not reach it.
    /// None unless both columns have the horizon, and the curve goes from one to the other.
    std::optional<Linear> beyond(int curve, Side side, int x) const {
        if (!goes_on(curve, x)) return std::nullopt;
        const auto& cells = horizon(curve, When::before, side);
        const Cell &from = cells[column(x)], &to = cells[column(x + 1)];
        if (!from || !to) return std::nullopt;
        Linear above{*from - over(curve, x), *to - over(curve, x + 1)};
        if (side == Side::upper) return above;
        return Linear{-above.at_first, -above.at_last};
    }

    bool has_horizon(int curve, int x) const {
        return horizon(curve, When::before, Side::upper)[column(x)].has_value();
    }

    /// Between a column and the next, where the curve is surely hidden.
    std::optional<Stretch> hidden(int curve, int x) const {
        const auto above = beyond(curve, Side::upper, x), below = beyond(curve, Side::lower, x);
        if (!above || !below) return std::nullopt;
        const auto short_of = [&](const Linear& f) { return where_above({-f.at_first, -f.at_last}, slack); };
        return moved(common(short_of(*above), short_of(*below)), x);
    }

    /// Where it is surely visible: above, and below.
    std::array<std::optional<Stretch>, 2> visible(int curve, int x) const {
        if (!goes_on(curve, x)) return {};
        if (!has_horizon(curve, x) && !has_horizon(curve, x + 1)) return {Stretch{x, x + 1}, std::nullopt};
        const auto above = beyond(curve, Side::upper, x), below = beyond(curve, Side::lower, x);
        if (!above || !below) return {};
        return {moved(where_above(*above, slack), x), moved(where_above(*below, slack), x)};
    }

    /// Whether the curve is surely visible over a column.
    bool is_visible(int curve, int x) const {
        if (!has_point(curve, x)) return false;
        const Cell &upper = horizon(curve, When::before, Side::upper)[column(x)],
                   &lower = horizon(curve, When::before, Side::lower)[column(x)];
        return !upper || over(curve, x) < *upper - slack || over(curve, x) > *lower + slack;
    }

    static std::optional<Stretch> moved(std::optional<Stretch> part, int by) {
        if (part) part = Stretch{part->first + by, part->last + by};
        return part;
    }

    /// The drawn parts from left to right, longer at both ends by the tolerance, joined where they overlap.
    std::vector<Stretch> widened(const DrawnParts& drawn) const {
        std::vector<Stretch> parts;
        for (const auto& [from, to] : drawn)
            parts.push_back({Rational(from) - open_end(from), Rational(to) + open_end(to)});
        std::sort(parts.begin(), parts.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
        std::vector<Stretch> joined;
        for (const Stretch& part : parts) {
            if (!joined.empty() && part.first <= joined.back().last) {
                joined.back().last = std::max(joined.back().last, part.last);
            } else {
                joined.push_back(part);
            }
        }
        return joined;
    }

    /// A part of an interval that lies in none of the parts, which are in order and apart.
    static std::optional<Stretch> outside(const Stretch& wanted, const std::vector<Stretch>& parts) {
        Rational reached = wanted.first;
        for (const Stretch& part : parts) {
            if (part.last <= reached) continue;
            if (part.first > reached) return Stretch{reached, std::min(part.first, wanted.last)};
            reached = part.last;
            if (reached >= wanted.last) return std::nullopt;
        }
        return Stretch{reached, wanted.last};
    }
};

CurveTruth::CurveTruth(const CurveScene& scene, Precision precision)
    : exactly_(std::make_unique<const Exactly>(scene, precision)) {}
CurveTruth::~CurveTruth() = default;

const CurveScene& CurveTruth::scene() const { return exactly_->scene; }

std::optional<double> CurveTruth::height(int curve, double x) const {
    if (!std::isfinite(x)) return std::nullopt;
    const auto y = exactly_->at(curve, Rational(x));
    return y ? std::optional(CGAL::to_double(*y)) : std::nullopt;
}

bool CurveTruth::is_on_curve(int curve, double x, double y) const {
    if (!std::isfinite(x) || !std::isfinite(y)) return false;
    const auto right = exactly_->at(curve, Rational(x));
    return right && exactly_->is_right(y, *right);
}

bool CurveTruth::is_on_edge(int curve, int x, double y) const {
    if (curve == 0 || !std::isfinite(y)) return false;
    const auto near = ends(curve - 1), far = ends(curve);
    if (!near || !far) return false;
    const auto is_on = [&](const Sample& from, const Sample& to) {
        if (x < std::min(from.x, to.x) || x > std::max(from.x, to.x)) return false;
        if (from.x == to.x) return std::min(from.y, to.y) <= y && y <= std::max(from.y, to.y);
        return exactly_->is_right(y, height_on(from, to, x));
    };
    return is_on(near->first, far->first) || is_on(near->second, far->second);
}

std::optional<std::pair<Sample, Sample>> CurveTruth::ends(int curve) const {
    return ends_of(exactly_->scene.curves[std::size_t(curve)]);
}

bool CurveTruth::same_height(double claimed, double right) const {
    return exactly_->is_right(claimed, Rational(right));
}

bool CurveTruth::shows_single() const { return exactly_->shows_single; }

std::optional<double> CurveTruth::horizon(int curve, When when, Side side, int x) const {
    const Cell& cell = exactly_->horizon(curve, when, side)[exactly_->column(x)];
    return cell ? std::optional(CGAL::to_double(*cell)) : std::nullopt;
}

bool CurveTruth::is_horizon(int curve, When when, Side side, int x, const std::optional<double>& claimed) const {
    const Cell& right = exactly_->horizon(curve, when, side)[exactly_->column(x)];
    if (!right) return !claimed || is_beyond_all(side, *claimed);
    return claimed && exactly_->is_right(*claimed, *right);
}

bool CurveTruth::is_beyond_all(Side side, double y) const {
    return side == Side::upper ? y >= exactly_->lowest : y <= exactly_->highest;
}

bool CurveTruth::may_be(int curve, int x, VisibilityFlag flag) const {
    const Cell &upper = exactly_->horizon(curve, When::before, Side::upper)[exactly_->column(x)],
               &lower = exactly_->horizon(curve, When::before, Side::lower)[exactly_->column(x)];
    if (!upper) return flag != VisibilityFlag::hidden;
    const Rational &y = exactly_->over(curve, x), &slack = exactly_->slack;
    const bool above = y <= *upper + slack, below = y >= *lower - slack;
    switch (flag) {
        case VisibilityFlag::above: return above;
        case VisibilityFlag::below: return below;
        case VisibilityFlag::both: return above && below;
        case VisibilityFlag::hidden: return !exactly_->is_visible(curve, x);
    }
    return false;
}

bool CurveTruth::meets_horizon(int curve, double x) const {
    const int left = int(std::floor(x));
    const bool on_column = x == left;
    if (!height(curve, x)) return false;
    for (const int from : on_column ? std::vector{left - 1, left} : std::vector{left}) {
        if (!exactly_->goes_on(curve, from)) continue;
        if (exactly_->has_horizon(curve, from) != exactly_->has_horizon(curve, from + 1)) return true;
        for (const Side side : {Side::upper, Side::lower}) {
            const auto beyond = exactly_->beyond(curve, side, from);
            if (!beyond) continue;
            // Where the lines cross at a small angle, the place is as uncertain as the heights are.
            if (magnitude(beyond->at(Rational(x) - Rational(from))) <= exactly_->slack) return true;
        }
    }
    return false;
}

bool CurveTruth::may_show(int curve, double x) const {
    if (!height(curve, x)) return false;
    const int left = std::min(int(std::floor(x)), exactly_->last(curve) - 1);
    const auto part = exactly_->hidden(curve, left);
    return !part || Rational(x) <= part->first || Rational(x) >= part->last;
}

bool CurveTruth::may_be_left_out(int curve, double x) const {
    const int left = int(std::floor(x));
    if (x == left) return !exactly_->is_visible(curve, left);
    const auto parts = exactly_->visible(curve, left);
    return std::none_of(parts.begin(), parts.end(), [&](const auto& part) {
        return part && part->first < Rational(x) && Rational(x) < part->last;
    });
}

std::optional<double> CurveTruth::hidden_between(int curve, double from, double to) const {
    const Stretch drawn{Rational(from) + exactly_->open_end(from), Rational(to) - exactly_->open_end(to)};
    const int first = std::max(exactly_->first(curve), int(std::floor(from)));
    const int last = std::min(exactly_->last(curve), int(std::ceil(to)));
    for (int x = first; x < last; ++x) {
        const bool is_gap = !exactly_->goes_on(curve, x);
        const auto away = is_gap ? std::optional(Stretch{x, x + 1}) : exactly_->hidden(curve, x);
        if (const auto part = common(away, drawn)) return middle_of(*part);
    }
    return std::nullopt;
}

std::optional<double> CurveTruth::left_out(int curve, const DrawnParts& drawn) const {
    const std::vector<Stretch> parts = exactly_->widened(drawn);
    const auto is_drawn = [&](int x) {
        return std::any_of(parts.begin(), parts.end(),
                           [&](const Stretch& part) { return part.first <= x && Rational(x) <= part.last; });
    };
    for (int x = exactly_->first(curve); x <= exactly_->last(curve); ++x) {
        if (exactly_->is_visible(curve, x) && !is_drawn(x)) return x;
        if (x == exactly_->last(curve)) break;
        for (const auto& part : exactly_->visible(curve, x)) {
            if (!part) continue;
            if (const auto missing = Exactly::outside(*part, parts)) return middle_of(*missing);
        }
    }
    return std::nullopt;
}

bool CurveTruth::leaves_out_touching(int curve, const DrawnParts& drawn) const {
    const std::vector<Stretch> parts = exactly_->widened(drawn);
    for (int x = exactly_->first(curve); x < exactly_->last(curve); ++x) {
        for (const Side side : {Side::upper, Side::lower}) {
            const auto beyond = exactly_->beyond(curve, side, x);
            if (beyond && beyond->at_first == 0 && beyond->at_last == 0 && Exactly::outside({x, x + 1}, parts))
                return true;
        }
    }
    return false;
}

int CurveTruth::open_columns() const {
    int open = 0;
    for (int curve = 0; curve < int(scene().curves.size()); ++curve) {
        for (int x = exactly_->first(curve); x <= exactly_->last(curve); ++x) {
            bool is_open = false;
            for (const Side side : {Side::upper, Side::lower}) {
                const Cell& cell = exactly_->horizon(curve, When::before, side)[exactly_->column(x)];
                if (!cell || !exactly_->has_point(curve, x)) continue;
                const Rational off = magnitude(*cell - exactly_->over(curve, x));
                is_open = is_open || (off != 0 && off <= exactly_->slack);
            }
            open += int(is_open);
        }
    }
    return open;
}

bool CurveTruth::touches_on_column() const {
    for (int curve = 0; curve < int(scene().curves.size()); ++curve) {
        for (int x = exactly_->first(curve); x <= exactly_->last(curve); ++x) {
            for (const Side side : {Side::upper, Side::lower}) {
                const Cell& cell = exactly_->horizon(curve, When::before, side)[exactly_->column(x)];
                if (cell && exactly_->has_point(curve, x) && *cell == exactly_->over(curve, x)) return true;
            }
        }
    }
    return false;
}

}  // namespace vidno
