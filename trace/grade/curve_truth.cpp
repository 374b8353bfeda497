#include "grade/curve_truth.h"

#include <algorithm>
#include <cmath>

#include "vidno/kernels/exact.h"

namespace vidno {

namespace {

using Heights = std::vector<std::optional<Rational>>;  // over the columns of the area

Rational on_line(const Sample& from, const Sample& to, const Rational& x) {
    if (from.x == to.x) return Rational(from.y);
    return Rational(from.y) + (x - from.x) * (Rational(to.y) - Rational(from.y)) / Rational(to.x - from.x);
}

}  // namespace

struct CurveTruth::Exactly {
    CurveScene scene;
    double slack = 0;
    std::vector<Heights> upper, lower;  // before each curve

    Exactly(const CurveScene& given, Precision precision) : scene(given) {
        double largest = 1;
        const Area& area = scene.area;
        for (const int v : {area.x, area.y, area.right(), area.bottom()})
            largest = std::max(largest, std::abs(double(v)));
        for (const auto& [samples] : scene.curves) {
            for (const auto& sample : samples) largest = std::max(largest, std::abs(sample.y));
        }
        slack = std::ldexp(largest, 10 - (precision == Precision::single ? 24 : 53));

        Heights highest(std::size_t(area.width)), lowest = highest;
        const auto raise = [&](int column, const Rational& y) {
            auto &up = highest[std::size_t(column - area.x)], &low = lowest[std::size_t(column - area.x)];
            if (!up || y < *up) up = y;
            if (!low || y > *low) low = y;
        };
        // A side edge counts over the columns between its ends.
        const auto raise_edge = [&](const Sample& from, const Sample& to) {
            const auto& [left, right] = from.x <= to.x ? std::pair(from, to) : std::pair(to, from);
            for (int x = left.x + 1; x < right.x; ++x) raise(x, on_line(left, right, x));
        };
        for (std::size_t i = 0; i < scene.curves.size(); ++i) {
            const auto& samples = scene.curves[i].samples;
            if (i > 0) raise_edge(scene.curves[i - 1].samples.front(), samples.front());
            upper.push_back(highest);
            lower.push_back(lowest);
            for (int x = samples.front().x; x <= samples.back().x; ++x) raise(x, *height(int(i), x));
            if (i > 0) raise_edge(scene.curves[i - 1].samples.back(), samples.back());
        }
    }

    std::optional<Rational> height(int curve, const Rational& x) const {
        const auto& samples = scene.curves[std::size_t(curve)].samples;
        for (std::size_t i = 1; i < samples.size(); ++i) {
            if (x >= samples[i - 1].x && x <= samples[i].x) return on_line(samples[i - 1], samples[i], x);
        }
        return std::nullopt;
    }

    const std::optional<Rational>& at(const Heights& heights, int column) const {
        static const std::optional<Rational> none;
        const int place = column - scene.area.x;
        return place < 0 || place >= scene.area.width ? none : heights[std::size_t(place)];
    }
};

CurveTruth::CurveTruth(const CurveScene& scene, Precision precision)
    : exactly_(std::make_unique<const Exactly>(scene, precision)) {}
CurveTruth::~CurveTruth() = default;

const CurveScene& CurveTruth::scene() const { return exactly_->scene; }

std::optional<double> CurveTruth::height(int curve, double x) const {
    if (!std::isfinite(x)) return std::nullopt;
    const auto found = exactly_->height(curve, x);
    return found ? std::optional(CGAL::to_double(*found)) : std::nullopt;
}

bool CurveTruth::same_height(double told, double right) const {
    return std::isfinite(told) && std::abs(told - right) <= 64 * exactly_->slack;
}

CurveTruth::Sight CurveTruth::sight(int curve, int column) const {
    const auto y = exactly_->height(curve, column);
    if (!y) return {};
    const auto& up = exactly_->at(exactly_->upper[std::size_t(curve)], column);
    const auto& low = exactly_->at(exactly_->lower[std::size_t(curve)], column);
    const Rational open(exactly_->slack);
    // y grows downward.
    return {!up || *y <= *up + open, !up || *y <= *up - open, !low || *y >= *low - open, !low || *y >= *low + open};
}

bool CurveTruth::is_on_horizon(int curve, double x, double y) const {
    if (!std::isfinite(x + y)) return false;
    const int column = int(std::floor(x));
    for (const auto* heights : {&exactly_->upper[std::size_t(curve)], &exactly_->lower[std::size_t(curve)]}) {
        const auto &left = exactly_->at(*heights, column), &right = exactly_->at(*heights, column + 1);
        if (!left || !right) continue;
        const Rational t = Rational(x) - column, at = *left + (*right - *left) * t;
        // Where the two are nearly parallel, the crossing is known worse in x than in y.
        if (same_height(y, CGAL::to_double(at))) return true;
    }
    return false;
}

}  // namespace vidno
