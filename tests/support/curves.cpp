#include "curves.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vidno::test {

namespace {

using Number = FloatingHorizonReference::Number;
using Interval = FloatingHorizonReference::Interval;

Number line(const Sample& a, const Sample& b, const Number& x) {
    const Number far = (x - a.x) / Number(b.x - a.x);
    return Number(a.y) * (1 - far) + Number(b.y) * far;
}

/// Whether the curve goes from this sample to the next.
bool are_joined(const Curve& curve, std::size_t i) {
    return std::isfinite(curve.samples[i].y) && std::isfinite(curve.samples[i + 1].y);
}

/// The sample from which a curve goes through x; none if it has no point there.
std::optional<std::size_t> segment_at(const Curve& curve, const Number& x) {
    for (std::size_t i = 0; i + 1 < curve.samples.size(); ++i) {
        if (are_joined(curve, i) && curve.samples[i].x <= x && x <= curve.samples[i + 1].x) return i;
    }
    return std::nullopt;
}

/// Where a linear function is not negative, from x to x + 1.
void add_part(std::vector<Interval>& parts, int x, const Number& at_x, const Number& at_next) {
    if (at_x < 0 && at_next < 0) return;
    Interval part{x, x + 1};
    const Number fall = at_x - at_next;
    if (at_x < 0) part.first = x + at_x / fall;
    if (at_next < 0) part.last = x + at_x / fall;
    parts.push_back(part);
}

}  // namespace

CurveSceneBuilder::CurveSceneBuilder(Area area) { scene_.area = area; }

CurveSceneBuilder& CurveSceneBuilder::curve(std::vector<Sample> samples) {
    scene_.curves.push_back({std::move(samples)});
    return *this;
}

AdmittedCurves CurveSceneBuilder::build() const { return admit(scene_); }

AdmittedCurves some_curves() {
    return CurveSceneBuilder({-2, 0, 14, 16})
        .curve({{-2, 12}, {8, 12}})
        .curve({{0, 4}, {10, 4}})
        .curve({{0, 2.5}, {4, 7}, {9, 13.1}})
        .curve({{1, 6}, {7, 7.3}})
        .curve({{0, 8}, {4, 4}, {11, 8}})
        .build();
}

FloatingHorizonReference::FloatingHorizonReference(const CurveScene& scene)
    : area_(scene.area), upper_(std::size_t(area_.width)), lower_(std::size_t(area_.width)) {
    Ends before;
    for (const auto& curve : scene.curves) {
        const Ends ends = ends_of(curve);
        if (before && ends) raise_between(before->first, ends->first);
        seen_.push_back(seen(curve));
        for (int x = curve.samples.front().x; x <= curve.samples.back().x; ++x) {
            if (reaches(curve, x)) raise(x, height(curve, x));
        }
        if (before && ends) raise_between(before->second, ends->second);
        before = ends;
    }
}

bool FloatingHorizonReference::reaches(const Curve& curve, const Number& x) { return segment_at(curve, x).has_value(); }

Number FloatingHorizonReference::height(const Curve& curve, const Number& x) {
    const std::size_t i = segment_at(curve, x).value();
    return line(curve.samples[i], curve.samples[i + 1], x);
}

FloatingHorizonReference::Ends FloatingHorizonReference::ends_of(const Curve& curve) {
    std::vector<Sample> joined;
    for (std::size_t i = 0; i + 1 < curve.samples.size(); ++i) {
        if (are_joined(curve, i)) joined.insert(joined.end(), {curve.samples[i], curve.samples[i + 1]});
    }
    if (joined.empty()) return std::nullopt;
    return std::pair(joined.front(), joined.back());
}

std::vector<Interval> FloatingHorizonReference::united(std::vector<Interval> parts) {
    std::sort(parts.begin(), parts.end(), [](const auto& a, const auto& b) {
        return a.first < b.first || (a.first == b.first && a.last < b.last);
    });
    std::vector<Interval> all;
    for (const auto& part : parts) {
        if (all.empty() || all.back().last < part.first) {
            all.push_back(part);
        } else {
            all.back().last = std::max(all.back().last, part.last);
        }
    }
    return all;
}

void FloatingHorizonReference::raise(int x, const Number& y) {
    auto& upper = upper_[index(x)];
    auto& lower = lower_[index(x)];
    upper = upper ? std::min(*upper, y) : y;  // y grows downward
    lower = lower ? std::max(*lower, y) : y;
}

void FloatingHorizonReference::raise_between(const Sample& a, const Sample& b) {
    for (int x = std::min(a.x, b.x) + 1; x < std::max(a.x, b.x); ++x) raise(x, line(a, b, x));
}

FloatingHorizonReference::CurveSeen FloatingHorizonReference::seen(const Curve& curve) const {
    CurveSeen result;
    const int end = curve.samples.back().x;
    for (int x = curve.samples.front().x; x <= end; ++x) {
        if (!reaches(curve, x)) continue;
        const Number y = height(curve, x);
        const Cell& up = upper(x);
        const Cell& low = lower(x);
        result.visible.push_back(!up || !(*up < y && y < *low));
        result.on_horizon.push_back(up && (y == *up || y == *low));
        if (result.visible.back()) result.parts.push_back({x, x});
        if (!reaches(curve, x + Number(1) / 2)) continue;
        const Number next_y = height(curve, x + 1);
        if (!up || !upper(x + 1)) {
            result.parts.push_back({x, x + 1});
            continue;
        }
        add_part(result.parts, x, *up - y, *upper(x + 1) - next_y);   // at or above the upper
        add_part(result.parts, x, y - *low, next_y - *lower(x + 1));  // at or below the lower
    }
    result.parts = united(std::move(result.parts));
    return result;
}

}  // namespace vidno::test
