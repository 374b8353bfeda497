#include "scene/sampling.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace vidno {

namespace {

/// One curve, column by column from its left end.
class Sampler {
public:
    Sampler(const FunctionSurface& surface, int curve)
        : surface_(surface),
          curve_(curve),
          z_(std::lerp(surface.nearest, surface.farthest, double(curve) / (surface.curves - 1))) {}

    Curve evenly() const {
        const int columns = surface_.view.across.columns;
        const int parts = surface_.samples - 1;
        Curve made;
        for (int i = 0; i <= parts; ++i) {
            made.samples.push_back(sample(int((2LL * i * columns + parts) / (2LL * parts))));  // to the nearest column
        }
        return made;
    }

    Curve within(double tolerance) const {
        Curve all;  // a sample on each column
        for (int column = 0; column <= surface_.view.across.columns; ++column) all.samples.push_back(sample(column));
        Curve made;
        const Curve even = evenly();
        const int left = even.samples.front().x;
        for (std::size_t i = 1; i < even.samples.size(); ++i) {
            add(made, all, even.samples[i - 1].x - left, even.samples[i].x - left, tolerance);
        }
        made.samples.push_back(even.samples.back());
        return made;
    }

private:
    Sample sample(int column) const {
        const auto& [origin, across, back, up] = surface_.view;
        const double part = double(column) / across.columns;
        const double x = std::lerp(surface_.left, surface_.right, part);
        const double y = origin.rows + across.rows * part + back.rows * curve_ - up * surface_.function(x, z_);
        return {origin.columns + back.columns * curve_ + column, y};
    }

    /// The samples that are needed from one column on and before another one.
    static void add(Curve& to, const Curve& all, int first, int last, double tolerance) {
        const std::span<const Sample> samples(&all.samples[std::size_t(first)], std::size_t(last - first) + 1);
        if (shows_all(samples, tolerance)) {
            to.samples.push_back(samples.front());
        } else {
            const int middle = std::midpoint(first, last);
            add(to, all, first, middle, tolerance);
            add(to, all, middle, last, tolerance);
        }
    }

    /// Whether the first and the last of these samples, over neighbouring columns, show where the others are.
    static bool shows_all(std::span<const Sample> samples, double tolerance) {
        const Sample &first = samples.front(), &last = samples.back();
        const auto between = samples.subspan(1, samples.size() - 2);
        if (!first.has_point() || !last.has_point()) {
            return std::none_of(between.begin(), between.end(), [](const Sample& each) { return each.has_point(); });
        }
        const double slope = (last.y - first.y) / (last.x - first.x);
        return std::all_of(between.begin(), between.end(), [&](const Sample& each) {
            return each.has_point() && !(std::abs(each.y - (first.y + slope * (each.x - first.x))) > tolerance);
        });
    }

    const FunctionSurface& surface_;
    int curve_;
    double z_;
};

}  // namespace

FunctionSurface on_each_column(FunctionSurface surface) {
    surface.samples = surface.view.across.columns + 1;
    surface.tolerance.reset();
    return surface;
}

std::vector<Curve> sampled(const FunctionSurface& surface) {
    std::vector<Curve> curves;
    for (int i = 0; i < surface.curves; ++i) {
        const Sampler sampler(surface, i);
        curves.push_back(surface.tolerance ? sampler.within(*surface.tolerance) : sampler.evenly());
    }
    return curves;
}

}  // namespace vidno
