#include "replay/values.h"

#include <algorithm>

namespace vidno {

namespace {

using Writer =
    FieldWriter<Text&, decltype(WarnockState::Kept{} + WeilerAthertonState::Kept{} + FloatingHorizonState::Kept{})>;

/// Writes the members of an object, as far as they differ from those of another.
class Members {
public:
    Members(Text& out, Writer& writer) : out_(out), writer_(writer) {}

    template <class T>
    void add(std::string_view key, const T& now, const T* before) {
        if (before && now == *before) return;
        begin(key);
        writer_.value(now);
    }
    template <class T, class As = std::identity>
    void add(std::string_view key, const std::vector<T>& now, const std::vector<T>* before, As as = {}) {
        if (!before) {
            begin(key);
            return writer_.list(now.begin(), now.end(), as);
        }
        const auto same = [&](const T& a, const T& b) { return as(a) == as(b); };
        const auto rest = std::mismatch(now.begin(), now.end(), before->begin(), before->end(), same).first;
        if (rest == now.end() && now.size() == before->size()) return;
        begin(key);
        out_ += std::string_view(R"({"from":)");
        append_integer(out_, rest - now.begin());
        out_ += std::string_view(R"(,"rest":)");
        writer_.list(rest, now.end(), as);
        out_ += '}';
    }
    void begin(std::string_view key) {
        out_ += std::exchange(before_next_, ',');
        writer_.key(key);
    }
    void end() {
        if (before_next_ == '{') out_ += '{';
        out_ += '}';
    }

private:
    Text& out_;
    Writer& writer_;
    char before_next_ = '{';
};

/// The fields of a state as an object.
template <class Own>
void append_fields(Text& out, Writer& writer, const Own& now, const Own* before) {
    std::vector<const void*> others;
    if (before) {
        Own::fields(*before, [&](std::string_view, const auto& field) { others.push_back(&field); });
    }
    Members members(out, writer);
    std::size_t next = 0;
    Own::fields(now, [&]<class T>(std::string_view key, const T& field) {
        members.add(key, field, before ? static_cast<const T*>(others[next++]) : nullptr);
    });
    members.end();
}

/// The lists that changed, by number. One that no window has any more is not mentioned.
void append_lists(Text& out, Writer& writer, const WarnockState& now, const WarnockState* before) {
    Members members(out, writer);
    for (const auto& [number, list] : now.lists()) {
        if (before) {
            const auto known = before->lists().find(number);
            if (known != before->lists().end() && known->second == list) continue;
        }
        members.begin(std::to_string(number));
        writer.value(list.entries());
    }
    members.end();
}

/// A line of a state, with the first and the last column under it.
struct DrawnLine {
    const VisibleLine<Value>* line;

    bool operator==(const DrawnLine& other) const {
        const auto same = [](const LineEnd<Value>& a, const LineEnd<Value>& b) {
            return a.point.x == b.point.x && a.point.y == b.point.y && a.left == b.left && a.right == b.right;
        };
        return line->segment.curve == other.line->segment.curve && same(line->from, other.line->from) &&
               same(line->to, other.line->to);
    }
    static void fields(const DrawnLine& drawn, auto&& field) {
        const auto point = [](const Point<Value>& p) { return ValuePoint{p.x, p.y}; };
        const auto& [segment, from, to] = *drawn.line;
        field("curve", segment.curve);
        field("from", point(from.point));
        field("to", point(to.point));
        field("columns", std::pair(from.right, to.left));
    }
};
DrawnLine as_drawn(const VisibleLine<Value>& line) { return {&line}; }

/// What the values of all states begin with.
template <class AState>
void add_common(Text& out, Members& members, const AState& state, const typename AState::Values* before) {
    members.begin("step");
    append_integer(out, state.step());
    members.add("calls", state.values().calls.frames(), before ? &before->calls.frames() : nullptr);
}

}  // namespace

void ValuesText::append(Text& out, const State& state, const State::Values* before) {
    Writer writer(out, names_, shortest_);
    Members members(out, writer);
    const State::Values& now = state.values();
    add_common(out, members, state, before);
    const auto own = [&](std::string_view name, auto part) {
        members.begin(name);
        append_fields(out, writer, now.*part, before ? &(before->*part) : nullptr);
    };
    switch (algorithm_of(state.header().method)) {
        case Algorithm::warnock:
            own("warnock", &State::Values::warnock);
            members.begin("lists");
            append_lists(out, writer, now.warnock, before ? &before->warnock : nullptr);
            break;
        case Algorithm::z_buffer: own("zbuffer", &State::Values::z_buffer); break;
        case Algorithm::weiler_atherton: own("weilerAtherton", &State::Values::weiler_atherton); break;
    }
    members.end();
}

void ValuesText::append(Text& out, const FloatingHorizonState& state, const FloatingHorizonState::Values* before) {
    Writer writer(out, names_, shortest_);
    Members members(out, writer);
    const FloatingHorizonState::Values& now = state.values();
    add_common(out, members, state, before);
    members.begin("floatingHorizon");
    append_fields(out, writer, now, before);
    members.add("lines", now.lines, before ? &before->lines : nullptr, as_drawn);
    members.end();
}

}  // namespace vidno
