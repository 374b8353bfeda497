#include "check/visible_areas.h"

#include <algorithm>
#include <cassert>

#include "vidno/kernels/exact.h"
#include "vidno/kernels/filtered_regions.h"
#include "vidno/weiler_atherton.h"

namespace vidno {

namespace {

using Place = Point<Rational>;

/// The floor of a number as a whole number low <= i < end; for the number `end` itself, the last of them.
int floor_of(const Rational& value, int low, int end) { return Exact{}.last_centre(value + Rational(1) / 2, low, end); }

/// The part of each pixel of a row that a region covers. It is the sum, over the edges, of the area between the edge
/// and the pixel's left side, positive for an edge that goes down and negative for one that goes up.
class RowOfPixels {
public:
    RowOfPixels(const Area& area, int row)
        : area_(area), row_(row), beside_(std::size_t(area.width), 0), across_(std::size_t(area.width), 0) {}

    void add_edge(const Place& from, const Place& to) {
        const bool down = from.y < to.y;
        const Place& upper = down ? from : to;
        const Place& lower = down ? to : from;
        const Rational top = std::max(upper.y, Rational(row_)), bottom = std::min(lower.y, Rational(row_ + 1));
        if (!(top < bottom)) return;
        const auto at_row = [&](const Rational& y) {
            return Place{Rational(upper.x + (lower.x - upper.x) * (y - upper.y) / (lower.y - upper.y)), y};
        };
        add_in_row(at_row(down ? top : bottom), at_row(down ? bottom : top));
    }

    /// Calls take(column, area) for each pixel that is at least partly covered.
    void for_each_covered(auto&& take) const {
        Rational to_the_right = 0;
        for (int x = area_.right() - 1; x >= area_.x; --x) {
            const Rational covered = beside_[place_of(x)] + to_the_right;
            if (covered != 0) take(x, covered);
            to_the_right += across_[place_of(x)];
        }
    }

private:
    std::size_t place_of(int x) const { return std::size_t(x - area_.x); }

    /// Column by column.
    void add_in_row(const Place& from, const Place& to) {
        const Place& left = from.x < to.x ? from : to;
        const Place& right = from.x < to.x ? to : from;
        const int last = floor_of(right.x, area_.x, area_.right());
        for (int x = floor_of(left.x, area_.x, area_.right()); x <= last; ++x) {
            const Rational begin = std::max(left.x, Rational(x));
            const Rational end = x == last ? right.x : Rational(x + 1);
            const Rational share = left.x == right.x ? Rational(1) : Rational((end - begin) / (right.x - left.x));
            const Rational height = (to.y - from.y) * share;
            beside_[place_of(x)] += height * ((begin + end) / 2 - x);
            across_[place_of(x)] += height;
        }
    }

    const Area& area_;
    int row_;
    std::vector<Rational> beside_;  // by the edges in a pixel, of that pixel
    std::vector<Rational> across_;  // and of each one to the left of it
};

std::vector<std::vector<Place>> exactly(const Outlines<Constructed>& outlines) {
    std::vector<std::vector<Place>> exact;
    for (const auto& outline : outlines) {
        exact.emplace_back();
        for (const auto& [x, y] : outline) exact.back().push_back({x.exactly(), y.exactly()});
    }
    return exact;
}

}  // namespace

VisibleAreas::VisibleAreas(const AdmittedScene& scene) : area_(scene->area) {
    using ExactShares = std::vector<std::pair<Color, Rational>>;
    std::vector<ExactShares> exact(std::size_t(area_.width) * std::size_t(area_.height));
    const auto share_of = [](ExactShares& shares, const Color& color) -> Rational& {
        const auto found =
            std::find_if(shares.begin(), shares.end(), [&](const auto& share) { return share.first == color; });
        return found != shares.end() ? found->second : shares.emplace_back(color, 0).second;
    };

    for (const auto& [polygon, outlines] : visible_regions(scene, Filtered{}).regions) {
        const auto loops = exactly(outlines);
        Rational top = loops.front().front().y, bottom = top;
        for (const auto& loop : loops) {
            for (const auto& place : loop) {
                top = std::min(top, place.y);
                bottom = std::max(bottom, place.y);
            }
        }
        const Color color = scene->polygons[std::size_t(polygon)].color;
        const int last = floor_of(bottom, area_.y, area_.bottom());
        for (int y = floor_of(top, area_.y, area_.bottom()); y <= last; ++y) {
            RowOfPixels pixels(area_, y);
            for (const auto& loop : loops) {
                for (std::size_t i = 0; i < loop.size(); ++i) pixels.add_edge(loop[i], loop[(i + 1) % loop.size()]);
            }
            const auto row = row_of(exact, area_, y);
            pixels.for_each_covered([&](int x, const Rational& covered) { share_of(row[x], color) += covered; });
        }
    }

    for (auto& shares : exact) {
        Rational background = 1;
        for (const auto& share : shares) background -= share.second;
        if (background != 0) share_of(shares, scene->background) += background;
        auto& rounded = shares_.emplace_back();
        for (const auto& [color, area] : shares) rounded.push_back({color, CGAL::to_double(area)});
    }
}

double VisibleAreas::wrong_in(const Picture& picture) const {
    assert(picture.area() == area_);
    double wrong = 0;
    for (std::size_t i = 0; i < shares_.size(); ++i) {
        for (const auto& [color, area] : shares_[i]) wrong += color == picture.pixels()[i] ? 0 : area;
    }
    return wrong;
}

}  // namespace vidno
