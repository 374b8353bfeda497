#include "state/floating_horizon_state.h"

#include <algorithm>

namespace vidno {

FloatingHorizonState::FloatingHorizonState(const FloatingHorizonHeader& header)
    : header_(&header),
      calls_(Procedure::floating_horizon, header.detail),
      upper_(std::size_t(header.scene.curves->area.width)),
      lower_(upper_.size()) {}

void FloatingHorizonState::apply(const EventView& event) {
    event.visit([this](const auto& e) {
        calls_.take(e);
        take(e);
    });
    ++step_;
}

void FloatingHorizonState::take(const event::Horizons& e) {
    std::fill(upper_.begin(), upper_.end(), e.upper);
    std::fill(lower_.begin(), lower_.end(), e.lower);
}

void FloatingHorizonState::take(const event::Curve& e) {
    const auto curves = int(header_->scene.curves->curves.size());
    if (e.curve < 0 || e.curve >= curves) throw Impossible{"no curve of the scene"};
    curve_ = e.curve;
    segment_.reset();
    previous_.reset();
    current_.reset();
}

void FloatingHorizonState::take(const event::SideEdge& e) { (e.at == Line::FH3 ? left_edge_ : right_edge_) = e.sample; }

std::size_t FloatingHorizonState::column(int x) const {
    const Area& area = header_->scene.curves->area;
    if (x < area.x || x >= area.right()) throw Impossible{"a column outside the area"};
    return std::size_t(x - area.x);
}

void FloatingHorizonState::take(const event::Visibility& e) {
    column(e.x);
    segment_ = e.segment;
    if (e.at == Line::FH4) {
        previous_ = {e.x, e.flag};
        return;
    }
    if (current_) previous_ = current_;
    current_ = {e.x, e.flag};
}

Segment FloatingHorizonState::segment_on(const SegmentColumns& columns) const {
    if (!curve_) throw Impossible{"a segment of no curve"};
    const auto& samples = header_->scene.curves->curves[std::size_t(*curve_)].samples;
    const auto from = std::lower_bound(samples.begin(), samples.end(), columns.first,
                                       [](const Sample& sample, int x) { return sample.x < x; });
    const bool found = from != samples.end() && from->x == columns.first && std::next(from) != samples.end() &&
                       std::next(from)->x == columns.second;
    if (!found) throw Impossible{"no segment of the curve"};
    return {*curve_, *from, *std::next(from)};
}

LineEnd<Value> FloatingHorizonState::end_of(const ValuePoint& point, const std::pair<int, int>& columns) const {
    return {{point.x, point.y}, columns.first, columns.second};
}

void FloatingHorizonState::take(const event::DrawLine& e) {
    segment_ = e.segment;
    add_line<Value>(lines_, {segment_on(e.segment), end_of(e.from, e.from_columns), end_of(e.to, e.to_columns)});
}

void FloatingHorizonState::take(const event::Horizon& e) {
    for (const auto& [x, y] : e.upper) set(upper_, x, y);
    for (const auto& [x, y] : e.lower) set(lower_, x, y);
}

void FloatingHorizonState::set(Heights& horizon, int x, const Value& y) const { horizon[column(x)] = y; }

}  // namespace vidno
