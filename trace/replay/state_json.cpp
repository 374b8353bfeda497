#include "choice/algorithm.h"
#include "choice/method.h"
#include "replay/state.h"
#include "replay/state_text.h"

namespace vidno {

namespace {

class PolygonStateText : StateText {
public:
    explicit PolygonStateText(const State& state) : PolygonStateText(state, polygon_names(state.header().scene)) {}

    std::string line() {
        begin(state_);
        out_ += ",\"picture\":";
        picture();
        switch (algorithm_of(state_.header().method)) {
            case Algorithm::warnock:
                out_ += ",\"warnock\":";
                warnock();
                out_ += ",\"zbuffer\":null";
                break;
            case Algorithm::z_buffer:
                out_ += ",\"warnock\":null,\"zbuffer\":";
                z_buffer();
                break;
            case Algorithm::weiler_atherton:
                out_ += ",\"warnock\":null,\"zbuffer\":null,\"weilerAtherton\":";
                weiler_atherton();
                break;
        }
        out_ += "}\n";
        return out_.string();
    }

private:
    PolygonStateText(const State& state, const PolygonNames& names) : state_(state), names_(names) {}

    void picture() {
        const Area& area = state_.screen().area();
        out_ += '[';
        for (int y = area.y; y < area.bottom(); ++y) {
            if (y > area.y) out_ += ',';
            out_ += '"';
            for (int x = area.x; x < area.right(); ++x) append_hex(out_, state_.screen().color(x, y));
            out_ += '"';
        }
        out_ += ']';
    }

    void window(const Window& w) {
        list(std::array{w.x, w.y, w.width, w.height}, [this](double v) { append_number(out_, v); });
    }
    void apl(const std::vector<AplEntry>& entries) {
        list(entries, [this](const AplEntry& entry) {
            out_ += '[';
            out_ += names_[std::size_t(entry.first.index)];
            out_ += ',';
            boolean(entry.second);
            out_ += ']';
        });
    }
    void joined(const std::vector<WarnockState::Joined>& entries) {
        list(entries, [this](const WarnockState::Joined& entry) {
            out_ += '[';
            out_ += names_[std::size_t(entry.polygon.index)];
            out_ += ',';
            integer(entry.level);
            out_ += ']';
        });
    }
    void vertices(const std::vector<ValueVertex>& vertices) {
        list(vertices, [this](const ValueVertex& v) {
            list(std::array{v.x, v.y, v.z}, [this](const Value& c) { number(c); });
        });
    }

    void warnock() {
        out_ += "{\"stack\":";
        list(state_.warnock().stack(), [this](const auto& stacked) {
            out_ += "{\"window\":";
            window(stacked.window);
            out_ += ",\"apl\":";
            apl(state_.warnock().list(stacked).entries());
            out_ += '}';
        });
        const auto& current = state_.warnock().current();
        out_ += ",\"window\":";
        current ? window(current->window) : null();
        out_ += ",\"apl\":";
        current ? apl(state_.warnock().list(*current).entries()) : null();
        out_ += ",\"corners\":";
        optional(state_.warnock().last().corners, [this](const auto& corners) {
            for (std::size_t i = 0; i < 4; ++i) {
                out_ += i == 0 ? "{\"" : ",\"";
                out_ += corner_names[i];
                out_ += "\":";
                number(corners.of[i]);
            }
            out_ += '}';
        });
        out_ += ",\"k\":";
        optional(state_.warnock().last().k, [this](int k) { integer(k); });
        out_ += ",\"count\":";
        integer(*state_.warnock().last().count);
        out_ += ",\"hasSurround\":";
        boolean(*state_.warnock().last().has_surround);
        out_ += ",\"color\":";
        optional(state_.warnock().last().color, [this](const Color& color) { append_color(out_, color); });
        out_ += ",\"insider\":";
        boolean(*state_.warnock().last().insider);
        out_ += ",\"clip\":";
        optional(state_.warnock().clip(), [this](const WarnockState::Clip& clip) {
            out_ += "{\"vertices\":";
            vertices(clip.vertices);
            out_ += ",\"next\":";
            vertices(clip.next);
            out_ += '}';
        });
        if (choice_of(state_.header().method).procedure == Procedure::three_lists_warnock) {
            out_ += ",\"surrounding\":";
            joined(state_.warnock().joined().surrounding);
            out_ += ",\"outside\":";
            joined(state_.warnock().joined().outside);
        }
        out_ += '}';
    }

    void parts(const WeilerAthertonState::Pieces& parts) {
        list(parts, [this](const auto& piece) {
            const PolygonPart& part = *piece;
            out_ += '[';
            out_ += names_[std::size_t(part.polygon.index)];
            out_ += ',';
            loops(part.region);
            out_ += ',';
            boolean(part.ground);
            out_ += ']';
        });
    }
    void weiler_atherton() {
        out_ += "{\"lists\":";
        list(state_.weiler_atherton().lists(), [this](const auto& pieces) { parts(pieces); });
        out_ += ",\"list\":";
        optional(state_.weiler_atherton().current_list(), [this](const WeilerAthertonState::CurrentList& current) {
            out_ += "{\"pieces\":";
            parts(current.pieces);
            out_ += ",\"inside\":";
            parts(current.inside);
            out_ += ",\"outside\":";
            parts(current.outside);
            out_ += '}';
        });
        out_ += ",\"facets\":";
        parts(state_.weiler_atherton().facets());
        out_ += ",\"visible\":";
        parts(state_.weiler_atherton().visible());
        out_ += '}';
    }

    void z_buffer() {
        out_ += "{\"polygon\":";
        optional(state_.z_buffer().polygon(), [this](PolygonPlace p) { out_ += names_[std::size_t(p.index)]; });
        out_ += ",\"S\":";
        list(state_.z_buffer().edges(), [this](int edge) { integer(edge); });
        out_ += ",\"ael\":";
        list(state_.z_buffer().active_edges(), [this](const ZBufferState::ActiveEdge& entry) { active_edge(entry); });
        out_ += ",\"y\":";
        optional(state_.z_buffer().last().y, [this](const Value& y) { number(y); });
        out_ += ",\"row\":";
        optional(state_.z_buffer().last().row, [this](int row) { integer(row); });
        out_ += ",\"nextS\":";
        optional(state_.z_buffer().last().next_start, [this](const Value& next) { number(next); });
        out_ += ",\"nextAel\":";
        optional(state_.z_buffer().last().next_end, [this](const Value& next) { number(next); });
        out_ += ",\"z\":";
        depths();
        out_ += '}';
    }
    void active_edge(const ZBufferState::ActiveEdge& entry) {
        out_ += "{\"edge\":";
        integer(entry.edge);
        const auto field = [this](std::string_view key, const Value& value) {
            out_ += ",\"";
            out_ += key;
            out_ += "\":";
            number(value);
        };
        field("x", entry.x);
        field("z", entry.z);
        field("until", entry.until);
        field("dx", entry.dx);
        field("dz", entry.dz);
        out_ += '}';
    }
    void depths() {
        const Area& area = state_.screen().area();
        const auto& depths = state_.screen().depths();
        if (!depths) return null();
        out_ += '[';
        for (int y = area.y; y < area.bottom(); ++y) {
            out_ += y > area.y ? ",[" : "[";
            for (int x = area.x; x < area.right(); ++x) {
                if (x > area.x) out_ += ',';
                number(depths->at(x, y));
            }
            out_ += ']';
        }
        out_ += ']';
    }

    const State& state_;
    PolygonNames names_;
};

}  // namespace

std::string state_json(const State& state) { return PolygonStateText(state).line(); }

}  // namespace vidno
