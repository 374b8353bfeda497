#include "replay/floating_horizon_state.h"

#include <algorithm>

namespace vidno {

FloatingHorizonState::FloatingHorizonState(const FloatingHorizonHeader& header) : header_(&header) {
    values_.calls = CallStack(Procedure::floating_horizon, header.detail);
    values_.flags.resize(std::size_t(header.scene.curves->area.width));
    values_.horizons = {Heights(values_.flags.size()), Heights(values_.flags.size())};
    values_.before = values_.horizons;
}

void FloatingHorizonState::apply(const EventView& event) {
    event.visit([this]<class E>(const E& e) {
        values_.calls.take(e);
        if constexpr (!Events::has<E>()) {
            throw Impossible{"an event of a run of polygons"};
        } else if constexpr (requires { take(e); }) {
            take(e);
        }
    });
    ++step_;
}

void FloatingHorizonState::take(const event::Horizons& e) {
    std::fill(values_.horizons.upper.begin(), values_.horizons.upper.end(), e.upper);
    std::fill(values_.horizons.lower.begin(), values_.horizons.lower.end(), e.lower);
}

void FloatingHorizonState::take(const event::Curve& e) {
    const auto curves = int(header_->scene.curves->curves.size());
    if (e.curve < 0 || e.curve >= curves) throw Impossible{"no curve of the scene"};
    values_.curve = e.curve;
    if (pieces_of(header_->scene.curves->curves[std::size_t(e.curve)]).empty()) values_.edges = {};
    values_.place = {};
    values_.height.reset();
    std::fill(values_.flags.begin(), values_.flags.end(), std::nullopt);
    values_.before = values_.horizons;
}

std::size_t FloatingHorizonState::column(int x) const {
    const Area& area = header_->scene.curves->area;
    if (x < area.x || x >= area.right()) throw Impossible{"a column outside the area"};
    return std::size_t(x - area.x);
}

void FloatingHorizonState::take(const event::Visibility& e) {
    values_.flags[column(e.x)] = e.flag;
    values_.place.segment = e.segment;
    if (e.at == Line::FH4) {
        values_.place.previous = {e.x, e.flag};
        values_.place.current.reset();  // of the piece before
        values_.before = values_.horizons;
        return;
    }
    if (values_.place.current) values_.place.previous = values_.place.current;
    values_.place.current = {e.x, e.flag};
}

Segment FloatingHorizonState::segment_on(const SegmentColumns& columns) const {
    if (!values_.curve) throw Impossible{"a segment of no curve"};
    const auto& samples = header_->scene.curves->curves[std::size_t(*values_.curve)].samples;
    const auto from = std::lower_bound(samples.begin(), samples.end(), columns.first,
                                       [](const Sample& sample, int x) { return sample.x < x; });
    const bool found = from != samples.end() && from->x == columns.first && std::next(from) != samples.end() &&
                       std::next(from)->x == columns.second && from->has_point() && std::next(from)->has_point();
    if (!found) throw Impossible{"no segment of the curve"};
    return {*values_.curve, *from, *std::next(from)};
}

void FloatingHorizonState::take(const event::DrawLine& e) {
    values_.place.segment = e.segment;
    const auto end = [](const ValuePoint& point, const std::pair<int, int>& columns) {
        return LineEnd<Value>{{point.x, point.y}, columns.first, columns.second};
    };
    add_line<Value>(values_.lines, {segment_on(e.segment), end(e.from, e.from_columns), end(e.to, e.to_columns)});
}

void FloatingHorizonState::take(const event::Horizon& e) {
    for (const auto& [x, y] : e.upper) values_.horizons.upper[column(x)] = y;
    for (const auto& [x, y] : e.lower) values_.horizons.lower[column(x)] = y;
}

}  // namespace vidno
