#include "replay/floating_horizon_state.h"
#include "replay/state_text.h"

namespace vidno {

namespace {

class FloatingHorizonStateText : StateText {
public:
    explicit FloatingHorizonStateText(const FloatingHorizonState& state) : state_(state) {}

    std::string line() {
        begin(state_);
        out_ += ",\"lines\":";
        list(state_.values().lines, [this](const VisibleLine<Value>& line) {
            out_ += '[';
            integer(line.segment.curve);
            point(line.from.point);
            point(line.to.point);
            out_ += ']';
        });
        out_ += ",\"curve\":";
        optional(state_.values().curve, [this](int curve) { integer(curve); });
        out_ += ",\"segment\":";
        optional(state_.values().place.segment, [this](const SegmentColumns& s) { integers(s.first, s.second); });
        out_ += ",\"previous\":";
        looked(state_.values().place.previous);
        out_ += ",\"current\":";
        looked(state_.values().place.current);
        out_ += ",\"leftEdge\":";
        edge(state_.values().edges.left);
        out_ += ",\"rightEdge\":";
        edge(state_.values().edges.right);
        out_ += ",\"upper\":";
        horizon(state_.values().horizons.upper);
        out_ += ",\"lower\":";
        horizon(state_.values().horizons.lower);
        out_ += "}\n";
        return out_.string();
    }

private:
    void integers(int a, int b) {
        list(std::array{a, b}, [this](int value) { integer(value); });
    }
    void point(const Point<Value>& p) {
        out_ += ',';
        list(std::array{p.x, p.y}, [this](const Value& value) { number(value); });
    }
    void looked(const std::optional<FloatingHorizonState::Looked>& at) {
        optional(at, [this](const auto& l) { integers(l.first, int(l.second)); });
    }
    void edge(const std::optional<ReportedSample>& at) {
        optional(at, [this](const ReportedSample& sample) {
            out_ += '[';
            integer(sample.first);
            out_ += ',';
            append_number(out_, sample.second);
            out_ += ']';
        });
    }
    void horizon(const FloatingHorizonState::Heights& heights) {
        list(heights, [this](const auto& y) { optional(y, [this](const Value& value) { number(value); }); });
    }

    const FloatingHorizonState& state_;
};

}  // namespace

std::string state_json(const FloatingHorizonState& state) { return FloatingHorizonStateText(state).line(); }

}  // namespace vidno
