#include "margin/margin.h"

#include <algorithm>
#include <cassert>
#include <set>
#include <utility>

#include "choice/method.h"
#include "refused.h"
#include "vidno/kernels/exact.h"

namespace vidno {

namespace {

/// a x + b y + c, in the coordinates of the vertex that is moved.
struct LinearForm {
    Rational a = 0, b = 0, c = 0;

    bool is_constant() const { return a == 0 && b == 0; }
    Rational at(const Rational& x, const Rational& y) const { return a * x + b * y + c; }

    friend LinearForm operator+(const LinearForm& p, const LinearForm& q) { return {p.a + q.a, p.b + q.b, p.c + q.c}; }
    friend LinearForm operator-(const LinearForm& p, const LinearForm& q) { return {p.a - q.a, p.b - q.b, p.c - q.c}; }
    /// The product of two linear functions, one of which is constant.
    friend LinearForm operator*(const LinearForm& p, const LinearForm& q) {
        assert(p.is_constant() || q.is_constant());
        return p.is_constant() ? LinearForm{p.c * q.a, p.c * q.b, p.c * q.c} : q * p;
    }
};

using Place = Point<LinearForm>;

Sign sign_of(const Rational& value) { return Sign{int(CGAL::sign(value))}; }

/// (a - pivot) x (b - pivot), where at most one point is the moved vertex. It is multiplied out, so that no product
/// contains it twice.
LinearForm cross(const Place& pivot, const Place& a, const Place& b) {
    const auto product = [](const Place& p, const Place& q) { return p.x * q.y - p.y * q.x; };
    return product(pivot, a) + product(a, b) + product(b, pivot);
}

/// A vertex of an outline while it is clipped: one of the polygon, an edge cut at a side of the window, or a corner of
/// the window.
struct OutlineVertex {
    std::optional<int> vertex{};
    std::vector<int> cut_at{};  // one side, or the two of a corner
    std::set<int> edges{};      // on which it lies
    std::set<int> sides{};      // on which it lies
};

/// Collects the signs of the call to which a step belongs.
class Collector {
public:
    Collector(const RunRequest& request, std::uint64_t step, PolygonPlace polygon, int vertex)
        : scene_(request.scene),
          step_(step),
          moved_(polygon),
          vertex_(vertex),
          running_{choice_of(request.method).procedure} {}

    void follow(const EventView& event);

    bool is_done() const { return done_; }
    bool was_reached() const { return steps_ >= step_; }
    bool was_found() const { return found_; }
    Procedure procedure() const { return procedure_; }

    struct Found {
        LinearForm value;
        StepSign sign;
    };
    std::vector<Found> signs() { return std::move(signs_); }

private:
    static bool has_signs(Procedure procedure) {
        using enum Procedure;
        return procedure == surround_test || procedure == polygon_clip || procedure == trial_function ||
               procedure == ray_crossings || procedure == octant_angles;
    }

    const std::vector<glm::dvec3>& vertices(PolygonPlace polygon) const {
        return scene_.polygons[std::size_t(polygon.index)].vertices;
    }
    bool is_moved(PolygonPlace polygon, int vertex) const { return polygon == moved_ && vertex == vertex_; }
    Place place(PolygonPlace polygon, int vertex) const {
        if (is_moved(polygon, vertex)) return {{1, 0, 0}, {0, 1, 0}};
        const auto& at = vertices(polygon)[std::size_t(vertex)];
        return constant(at.x, at.y);
    }
    static Place constant(double x, double y) { return {{0, 0, Rational(x)}, {0, 0, Rational(y)}}; }
    /// Window corners and pixel centres are doubles under every kernel.
    static Place constant(const ValuePoint& point) { return constant(number_of(point.x), number_of(point.y)); }

    int next(PolygonPlace polygon, int vertex) const { return (vertex + 1) % int(vertices(polygon).size()); }

    void hear(const event::Orient& orient);
    void hear(const event::ClipBegin& begin);
    void hear(const event::ClipSide& side);
    void hear(const event::ClipSign& sign);
    void hear(const event::ClipCross& cross);
    void hear(const event::ClipKeep& keep);
    void hear(const event::ClipList& list);
    void hear(const auto&) {}

    /// The side of the window with this number, and on which side of it a vertex of the outline lies.
    LinearForm beyond(int side, const OutlineVertex& at) const;
    OutlineVertex cut(const OutlineVertex& from, const OutlineVertex& to, int side) const;
    Rational value_now(const LinearForm& value) const {
        const auto& at = vertices(moved_)[std::size_t(vertex_)];
        return value.at(Rational(at.x), Rational(at.y));
    }
    void add(const LinearForm& value, StepSign sign);

    const Scene& scene_;
    std::uint64_t step_;
    PolygonPlace moved_;
    int vertex_;
    std::vector<Procedure> running_;
    std::uint64_t steps_ = 0;
    bool found_ = false, done_ = false;
    Procedure procedure_{};
    std::vector<Found> signs_;  // of the call that is running, then of the one that was found

    // PolygonClip
    PolygonPlace clipped_;
    std::vector<std::array<Place, 2>> sides_;  // each from f0 to F_i
    std::vector<OutlineVertex> outline_, new_outline_;
    std::size_t next_ = 0;  // the vertex of the outline whose sign is reported next
    OutlineVertex from_, to_;
};

void Collector::follow(const EventView& event) {
    ++steps_;
    const bool is_asked = steps_ == step_;
    if (is_asked && has_signs(running_.back())) {
        found_ = true;
        procedure_ = running_.back();
    }
    event.visit([&](const auto& e) { hear(e); });
    if (const auto* call = event.get_if<event::Call>()) {
        running_.push_back(call->of);
        if (!found_ && has_signs(call->of)) signs_.clear();
        if (is_asked && has_signs(call->of)) {
            found_ = true;
            procedure_ = call->of;
        }
    }
    event.visit([&]<class E>(const E&) {
        if constexpr (requires { E::result_of; }) {
            if (found_ && E::result_of == procedure_) done_ = true;
            running_.pop_back();
        }
    });
    if (is_asked && !found_) done_ = true;
}

void Collector::add(const LinearForm& value, StepSign sign) {
    sign.step = steps_;
    sign.sign = sign_of(value_now(value));
    signs_.push_back({value, std::move(sign)});
}

void Collector::hear(const event::Orient& orient) {
    if (!has_signs(running_.back())) return;
    const Place from = place(orient.polygon, orient.edge);
    const Place to = place(orient.polygon, next(orient.polygon, orient.edge));
    add(cross(from, to, constant(orient.point)), {.at = orient.at,
                                                  .polygon = orient.polygon,
                                                  .edge = orient.edge,
                                                  .point = orient.point,
                                                  .in_run = orient.sign});
}

void Collector::hear(const event::ClipBegin& begin) {
    clipped_ = begin.polygon;
    sides_.clear();
    outline_.clear();
    const int count = int(vertices(clipped_).size());
    for (int i = 0; i < count; ++i) outline_.push_back({.vertex = i, .edges = {(i + count - 1) % count, i}});
}

void Collector::hear(const event::ClipSide& side) {
    sides_.push_back({constant(side.from), constant(side.to)});
    new_outline_.clear();
    next_ = outline_.size() - 1;  // the last vertex comes first
}

LinearForm Collector::beyond(int side, const OutlineVertex& at) const {
    const auto& [before, corner] = sides_[std::size_t(side)];
    if (at.vertex) return cross(corner, place(clipped_, *at.vertex), before);
    // Where the lines of two sides meet.
    const auto corner_of = [&](int one, int other) {
        const bool is_upright = sides_[std::size_t(one)][0].x.c == sides_[std::size_t(one)][1].x.c;
        const auto& [x_of, y_of] = std::pair(sides_[std::size_t(is_upright ? one : other)][0],
                                             sides_[std::size_t(is_upright ? other : one)][0]);
        return Place{x_of.x, y_of.y};
    };
    if (at.cut_at.size() > 1) return cross(corner, corner_of(at.cut_at[0], at.cut_at[1]), before);
    const int cut_at = at.cut_at.front();
    const auto& [cut_from, cut_to] = sides_[std::size_t(cut_at)];
    const bool is_parallel = (cut_from.x.c == cut_to.x.c) == (before.x.c == corner.x.c);
    if (is_parallel) return cross(corner, cut_from, before);
    // On the edge from p to q the cut is at (cut_p q - cut_q p) / (cut_p - cut_q), where cut_p and cut_q are the
    // distances of p and q beyond the side. The distance of the cut beyond the other side has the sign of cut_p next_q
    // - cut_q next_p if the divisor is positive, which holds if p is outside. Multiplied out, it is the cross product
    // of p and q about the corner, times a constant.
    const int edge = *at.edges.begin();
    const Place p = place(clipped_, edge), q = place(clipped_, next(clipped_, edge));
    const LinearForm turn = cross(corner_of(cut_at, side), p, q);
    const auto far = [&](const Place& from, const Place& to, const Place& of) {
        return value_now(cross(to, of, from));
    };
    const Rational cut_p = far(cut_from, cut_to, p), cut_q = far(cut_from, cut_to, q);
    const Rational next_p = far(before, corner, p), next_q = far(before, corner, q);
    const Rational exact = (cut_p * next_q - cut_q * next_p) / (cut_p - cut_q);
    const bool agrees = sign_of(exact) == sign_of(value_now(turn));
    // If both are zero, either sign is right.
    return agrees ? turn : LinearForm{} - turn;
}

OutlineVertex Collector::cut(const OutlineVertex& from, const OutlineVertex& to, int side) const {
    const auto common = [](const std::set<int>& a, const std::set<int>& b) {
        const auto found = std::find_if(a.begin(), a.end(), [&](int each) { return b.contains(each); });
        return found == a.end() ? std::nullopt : std::optional(*found);
    };
    if (const auto edge = common(from.edges, to.edges)) return {.cut_at = {side}, .edges = {*edge}, .sides = {side}};
    if (const auto other = common(from.sides, to.sides)) return {.cut_at = {*other, side}, .sides = {*other, side}};
    throw Refused(
        "the step's outline has rounded off the polygon's edges: the exact positions of its cuts are unknown");
}

void Collector::hear(const event::ClipSign& sign) {
    const int side = int(sides_.size()) - 1;
    OutlineVertex& at = outline_[next_];
    const LinearForm value = beyond(side, at);
    StepSign step{.at = sign.at, .polygon = clipped_, .vertex = at.vertex, .side = side + 1, .in_run = sign.sign};
    if (!at.vertex) {
        if (!at.edges.empty()) step.edge = *at.edges.begin();
        step.cut = at.cut_at.front() + 1;
    }
    add(value, step);
    if (signs_.back().sign.sign == Sign::zero) at.sides.insert(side);
    from_ = to_;
    to_ = at;
    next_ = (next_ + 1) % outline_.size();
}

void Collector::hear(const event::ClipCross&) { new_outline_.push_back(cut(from_, to_, int(sides_.size()) - 1)); }
void Collector::hear(const event::ClipKeep&) { new_outline_.push_back(to_); }
void Collector::hear(const event::ClipList&) { outline_ = new_outline_; }

/// A line that a sign may not leave or cross, in the form of MarginSide.
struct Side {
    LinearForm value;
    Sign sign;
    std::vector<StepSign> flips;
    bool bounds = false;
};

/// The signs that depend on the vertex, by their lines.
std::vector<Side> sides_of(const std::vector<Collector::Found>& signs) {
    std::vector<Side> sides;
    for (const auto& [value, sign] : signs) {
        if (value.is_constant()) continue;
        const Rational scale = value.a != 0 ? value.a : value.b;
        const LinearForm line{value.a / scale, value.b / scale, value.c / scale};
        const Sign kept = scale > 0 ? sign.sign : -sign.sign;
        const auto same = std::find_if(sides.begin(), sides.end(), [&](const Side& side) {
            return side.value.a == line.a && side.value.b == line.b && side.value.c == line.c;
        });
        if (same == sides.end()) {
            sides.push_back({line, kept, {sign}});
        } else {
            same->flips.push_back(sign);
        }
    }
    return sides;
}

/// The part of a line inside the other half-planes, from `low` to `high` along it. An end without a value is at
/// infinity.
struct LinePart {
    std::optional<Rational> low, high;
    bool is_empty = false;

    /// Restricts it to where value + t slope has the sign.
    void narrow(const Rational& value, const Rational& slope, Sign sign) {
        if (slope == 0) {
            is_empty = is_empty || sign_of(value) != sign;
            return;
        }
        const Rational end = -value / slope;
        const bool is_low = sign_of(slope) == sign;
        auto& own = is_low ? low : high;
        if (!own || (is_low ? end > *own : end < *own)) own = end;
    }
    bool has_length() const { return !is_empty && (!low || !high || *low < *high); }
    bool has(const Rational& t) const { return !is_empty && (!low || *low <= t) && (!high || t <= *high); }
};

/// A point of a line, and its direction.
struct Ray {
    Rational x, y, dx, dy;

    explicit Ray(const LinearForm& line) : dx(-line.b), dy(line.a) {
        const Rational square = line.a * line.a + line.b * line.b;
        x = -line.a * line.c / square;
        y = -line.b * line.c / square;
    }
    Rational value(const LinearForm& of) const { return of.at(x, y); }
    Rational slope(const LinearForm& of) const { return of.a * dx + of.b * dy; }
};

/// Marks the sides that bound the region. If a sign is zero, the region lies on its line.
void find_bounds(std::vector<Side>& sides) {
    const auto is_zero = [](const Side& side) { return side.sign == Sign::zero; };
    const auto on = std::find_if(sides.begin(), sides.end(), is_zero);
    for (auto& side : sides) {
        if (is_zero(side)) {
            side.bounds = true;
            continue;
        }
        const Ray along(on == sides.end() ? side.value : on->value);
        LinePart part;
        for (const auto& other : sides) {
            if (&other == &side || (on != sides.end() && &other == &*on)) continue;
            if (is_zero(other)) {
                part.is_empty = true;  // two lines meet in a point, which no half-plane bounds
            } else {
                part.narrow(along.value(other.value), along.slope(other.value), other.sign);
            }
        }
        if (on == sides.end()) {
            side.bounds = part.has_length();
        } else {
            const Rational slope = along.slope(side.value);
            side.bounds = slope != 0 && part.has(-along.value(side.value) / slope);
        }
    }
}

}  // namespace

Margin margin_of(const RunRequest& request, std::uint64_t step, PolygonPlace polygon, int vertex) {
    if (request.edition != Edition::corrected) throw Refused("margins are available only for the corrected procedures");
    Collector collector(request, step, polygon, vertex);
    struct Done {};
    FunctionSink sink([&](const EventView& event) {
        collector.follow(event);
        if (collector.is_done()) throw Done{};
    });
    RunRequest traced = request;
    traced.detail = Detail::signs;
    traced.sink = &sink;
    try {
        traced_run(traced);
    } catch (const Done&) {
        // Events after the step do not matter.
    }
    const std::string name = "step " + std::to_string(step);
    if (!collector.was_reached()) throw Refused(name + ": the run has fewer");
    if (!collector.was_found()) throw Refused(name + ": has no orientation or clip sign");
    std::vector<Side> sides = sides_of(collector.signs());
    find_bounds(sides);
    Margin margin{step,
                  collector.procedure(),
                  polygon,
                  vertex,
                  request.scene->polygons[std::size_t(polygon.index)].vertices[std::size_t(vertex)],
                  {}};
    for (auto& [value, sign, flips, bounds] : sides) {
        const auto fraction = [](const Rational& of) { return Fraction{Exact::fraction(of)}; };
        margin.sides.push_back(
            {{fraction(value.a), fraction(value.b), fraction(value.c)}, sign, bounds, std::move(flips)});
    }
    return margin;
}

}  // namespace vidno
