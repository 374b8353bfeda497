// Margins, checked in exact arithmetic against the geometry of the signs: vertices, and points where edges meet the
// window's sides.

#include "margin/margin.h"

#include <doctest/doctest.h>

#include <map>
#include <set>

#include "output.h"
#include "support/scenes.h"
#include "vidno/kernels/exact.h"

using namespace vidno;
using namespace vidno::test;

namespace {

using Place = Point<Rational>;

Rational number(const Fraction& fraction) {
    const auto slash = fraction.text.find('/');
    return Rational(fraction.text.substr(0, slash)) / Rational(fraction.text.substr(slash + 1));
}

Sign sign_of(const Rational& value) { return Sign{int(CGAL::sign(value))}; }

Rational cross(const Place& pivot, const Place& a, const Place& b) {
    return (a.x - pivot.x) * (b.y - pivot.y) - (a.y - pivot.y) * (b.x - pivot.x);
}

/// A side of a margin in numbers.
struct HalfPlane {
    Rational a, b, c;
    Sign sign;
    bool bounds;
    std::set<std::uint64_t> flips;  // steps

    Rational at(const Place& p) const { return a * p.x + b * p.y + c; }
    bool keeps(const Place& p) const { return sign_of(at(p)) == sign; }
};

std::vector<HalfPlane> lines_of(const Margin& margin) {
    std::vector<HalfPlane> lines;
    for (const auto& side : margin.sides) {
        HalfPlane line{number(side.line[0]), number(side.line[1]), number(side.line[2]), side.sign, side.bounds, {}};
        for (const auto& each : side.flips) line.flips.insert(each.step);
        lines.push_back(line);
    }
    return lines;
}

/// A call that tests signs: its events, with their steps.
struct Course {
    Procedure procedure{};
    std::optional<PolygonPlace> polygon;  // none: it tests no sign
    std::vector<std::pair<std::uint64_t, Event>> events;

    using Signs = std::map<std::uint64_t, Sign>;

    /// Along this path, with a vertex moved.
    Signs signs(const AdmittedScene& scene, PolygonPlace moved, int vertex, const Place& to) const {
        const auto outline = [&](PolygonPlace of) {
            std::vector<Place> places;
            for (const auto& v : scene->polygons[std::size_t(of.index)].vertices)
                places.push_back({Rational(v.x), Rational(v.y)});
            if (of == moved) places[std::size_t(vertex)] = to;
            return places;
        };
        const auto place = [](const ValuePoint& p) { return Place{Rational(p.x.number), Rational(p.y.number)}; };
        Signs found;
        std::vector<Place> list, clipped;
        Place from{}, to_now{}, before{}, corner{};
        std::size_t next = 0;
        for (const auto& [step, event] : events) {
            if (const auto* orient = event.get_if<event::Orient>()) {
                const auto v = outline(orient->polygon);
                const auto edge = std::size_t(orient->edge);
                found[step] = sign_of(cross(v[edge], v[(edge + 1) % v.size()], place(orient->point)));
            }
            if (const auto* begin = event.get_if<event::ClipBegin>()) list = outline(begin->polygon);
            if (const auto* side = event.get_if<event::ClipSide>()) {
                before = place(side->from);
                corner = place(side->to);
                clipped.clear();
                next = list.size() - 1;
            }
            if (event.get_if<event::ClipSign>()) {
                from = to_now;
                to_now = list[next];
                next = (next + 1) % list.size();
                found[step] = sign_of(cross(corner, to_now, before));
            }
            if (event.get_if<event::ClipCross>()) {
                const Rational p = cross(corner, from, before), q = cross(corner, to_now, before);
                const Rational t = p == q ? Rational(0) : Rational(p / (p - q));
                clipped.push_back({from.x + (to_now.x - from.x) * t, from.y + (to_now.y - from.y) * t});
            }
            if (event.get_if<event::ClipKeep>()) clipped.push_back(to_now);
            if (event.get_if<event::ClipList>()) list = clipped;
        }
        return found;
    }
};

/// The calls of a run that test signs.
std::vector<Course> courses_of(const RunRequest& asked) {
    static const std::set<Procedure> with_signs{Procedure::surround_test, Procedure::polygon_clip,
                                                Procedure::trial_function, Procedure::ray_crossings,
                                                Procedure::octant_angles};
    std::vector<Course> courses;
    std::optional<Course> running;
    std::uint64_t step = 0;
    FunctionSink hear([&](const EventView& event) {
        ++step;
        const auto* call = event.get_if<event::Call>();
        if (call && with_signs.contains(call->of)) running = Course{call->of, {}, {}};
        if (!running) return;
        running->events.emplace_back(step, event.copy());
        if (const auto* orient = event.get_if<event::Orient>()) running->polygon = orient->polygon;
        if (const auto* begin = event.get_if<event::ClipBegin>()) running->polygon = begin->polygon;
        event.visit([&]<class E>(const E&) {
            if constexpr (requires { E::result_of; }) {
                if (E::result_of != running->procedure) return;
                if (running->polygon) courses.push_back(std::move(*running));
                running.reset();
            }
        });
    });
    RunRequest request = asked;
    request.detail = Detail::signs;
    request.sink = &hear;
    run(request);
    return courses;
}

/// The part of a line that other lines leave: from `low` to `high` along it.
struct Part {
    std::optional<Rational> low, high;

    Rational middle() const {
        if (low && high) return (*low + *high) / 2;
        if (low) return *low + 1;
        return high ? Rational(*high - 1) : Rational(0);
    }
};

}  // namespace

TEST_CASE("The edges of a triangle and a point: the half-planes are worked out by hand") {
    // SurroundTest tests the corners of the window. For (0, 0) and the vertex C = (2, 6) of the triangle
    // (1, 1), (9, 1), (2, 6):
    // from B = (9, 1) to C = (x, y): (x - 9)(0 - 1) - (y - 1)(0 - 9) = -x + 9 y;  at C it is 52, positive.
    // from C to A = (1, 1):          (1 - x)(0 - y) - (1 - y)(0 - x) = x - y;     at C it is -4, negative.
    const AdmittedScene scene = SceneBuilder({0, 0, 8, 8}).polygon({{1, 1, 0}, {9, 1, 0}, {2, 6, 0}}).build();
    const RunRequest request{Method::warnock, *kernel_named("double"), Edition::corrected, scene};
    const auto first = courses_of(request).front();
    const Margin margin = margin_of(request, first.events.back().first, {0}, 2);
    CHECK(margin.procedure == Procedure::surround_test);
    std::set<std::string> lines;
    for (const auto& side : margin.sides) {
        lines.insert(side.line[0].text + ' ' + side.line[1].text + ' ' + side.line[2].text + ' ' +
                     std::to_string(int(side.sign)));
        CHECK(side.flips.size() == 1);
        CHECK(side.bounds);
    }
    // With x in front: x - 9 y is negative.
    for (const auto& line : lines) CHECK((line == "1/1 -9/1 0/1 -1" || line == "1/1 -1/1 0/1 -1"));
    CHECK_FALSE(lines.empty());
    const std::string text = margin_text(margin, scene);
    CHECK(text.find("no sign changes while\n") != std::string::npos);
    const std::string step = std::to_string(margin.sides.front().flips.front().step);
    CHECK(text.find("  x - y < 0\n      edge 2 of A passes over (0, 0): the sign at step " + step +
                    ", S2, is negative\n") != std::string::npos);
}

TEST_CASE("A step without a sign has no margin") {
    const AdmittedScene scene = small_scene();
    const RunRequest request{Method::warnock, *kernel_named("double"), Edition::corrected, scene};
    CHECK_THROWS_AS(margin_of(request, 1, {0}, 0), Refused);
    CHECK_THROWS_AS(margin_of(request, 1'000'000, {0}, 0), Refused);
}

TEST_CASE("1,000 margins: no sign changes inside, and beyond a side exactly the signs change that its label names") {
    RandomScenes random(31);
    const int cases = 1000 / thinning;
    int margins = 0, inside = 0, beyond = 0, on_lines = 0;
    std::map<Procedure, int> of;
    constexpr std::array methods{Method::warnock, Method::warnock_full, Method::warnock_angles};
    for (std::size_t scenes = 0; margins < cases; ++scenes) {
        const AdmittedScene scene = random.scene();
        const RunRequest request{methods[scenes % methods.size()], *kernel_named("filtered"), Edition::corrected,
                                 scene};
        // Some procedures are called far more often than others, so we draw each procedure equally often.
        std::map<Procedure, std::vector<Course>> courses;
        for (auto& each : courses_of(request)) courses[each.procedure].push_back(std::move(each));
        for (int drawn = 0; drawn < 6 && margins < cases && !courses.empty(); ++drawn) {
            const auto& alike = std::next(courses.begin(), random.whole(0, int(courses.size()) - 1))->second;
            const Course& course = alike[std::size_t(random.whole(0, int(alike.size()) - 1))];
            const PolygonPlace polygon = *course.polygon;
            const auto& vertices = scene->polygons[std::size_t(polygon.index)].vertices;
            const int vertex = random.whole(0, int(vertices.size()) - 1);
            const auto& now = vertices[std::size_t(vertex)];
            const Place at{Rational(now.x), Rational(now.y)};
            const auto& chosen = course.events[std::size_t(random.whole(0, int(course.events.size()) - 1))];
            const std::uint64_t step = chosen.first;
            CAPTURE(margins);
            CAPTURE(step);
            const Margin margin = margin_of(request, step, polygon, vertex);
            const auto lines = lines_of(margin);
            const auto signs = [&](const Place& p) { return course.signs(scene, polygon, vertex, p); };
            const auto right = signs(at);
            ++margins;
            CHECK(margin.procedure == course.procedure);
            ++of[margin.procedure];
            for (const auto& line : lines) REQUIRE(line.keeps(at));

            // The lines that the region lies on.
            std::vector<HalfPlane> on;
            for (const auto& line : lines) {
                if (line.sign == Sign::zero) on.push_back(line);
            }
            on_lines += on.empty() ? 0 : 1;
            const auto is_inside = [&](const Place& p) {
                return std::all_of(lines.begin(), lines.end(), [&](const HalfPlane& line) { return line.keeps(p); });
            };
            for (int found = 0, tried = 0; found < 20 && on.size() < 2 && tried < 5000; ++tried) {
                const Rational unit = Rational(1) / Rational(double(1u << random.whole(0, 24)));
                const Rational dx = Rational(random.whole(-64, 64)) * unit, dy = Rational(random.whole(-64, 64)) * unit;
                const Place p =
                    on.empty() ? Place{at.x + dx, at.y + dy} : Place{at.x - on[0].b * dx, at.y + on[0].a * dx};
                if (!is_inside(p)) continue;
                ++found;
                ++inside;
                CHECK(signs(p) == right);
            }

            for (std::size_t i = 0; i < lines.size(); ++i) {
                const HalfPlane& line = lines[i];
                if (!line.bounds) continue;
                // The line along which one comes to this side, and the point: the side's own line, or the one that the
                // region lies on.
                const bool leaves_line = line.sign == Sign::zero;
                if (leaves_line && on.size() > 2) continue;
                Place start{};
                Rational dx, dy;
                if (leaves_line) {
                    start = at;
                    dx = line.a;
                    dy = line.b;
                    for (const auto& other : on) {
                        if (&other - &on[0] >= 0 && other.flips != line.flips) {
                            dx = -other.b;
                            dy = other.a;
                        }
                    }
                } else {
                    const HalfPlane& along = on.empty() ? line : on[0];
                    const Rational square = along.a * along.a + along.b * along.b;
                    const Place foot{-along.a * along.c / square, -along.b * along.c / square};
                    Part part;
                    for (std::size_t j = 0; j < lines.size(); ++j) {
                        if (j == i || lines[j].sign == Sign::zero) continue;
                        const Rational slope = lines[j].b * along.a - lines[j].a * along.b;
                        if (slope == 0) continue;
                        const Rational end = -lines[j].at(foot) / slope;
                        if (sign_of(slope) == lines[j].sign) {
                            if (!part.low || end > *part.low) part.low = end;
                        } else if (!part.high || end < *part.high) {
                            part.high = end;
                        }
                    }
                    const auto on_along = [&](const Rational& t) {
                        return Place{foot.x - along.b * t, foot.y + along.a * t};
                    };
                    if (on.empty()) {
                        start = on_along(part.middle());
                        const Rational outward = line.sign == Sign::positive ? -1 : 1;
                        dx = outward * line.a;
                        dy = outward * line.b;
                    } else {
                        const Rational slope = line.b * along.a - line.a * along.b;
                        start = on_along(-line.at(foot) / slope);
                        const Rational outward = sign_of(slope) == line.sign ? -1 : 1;
                        dx = -outward * along.b;
                        dy = outward * along.a;
                    }
                }
                // Close enough that no other line is crossed, unless it meets this one there. Farther away more would
                // change: a vertex beyond a side may pass its neighbour.
                Rational far = 0x1p-40;
                for (int halved = 0; halved < 200; ++halved, far /= 2) {
                    const Place p{start.x + dx * far, start.y + dy * far};
                    std::set<std::uint64_t> expected;
                    bool only_this = true;
                    for (const auto& other : lines) {
                        if (other.keeps(p)) continue;
                        const bool meets_here = other.at(start) == 0;
                        only_this = only_this && meets_here && (&other == &line || !on.empty());
                        expected.insert(other.flips.begin(), other.flips.end());
                    }
                    if (!only_this) continue;
                    REQUIRE(expected.contains(*line.flips.begin()));
                    std::set<std::uint64_t> changed;
                    for (const auto& [at_step, sign] : signs(p)) {
                        if (sign != right.at(at_step)) changed.insert(at_step);
                    }
                    CHECK(changed == expected);
                    ++beyond;
                    break;
                }
            }
        }
    }
    MESSAGE(inside, " points inside, ", beyond, " beyond a side; ", on_lines, " margins on lines");
    CHECK(inside > 10 * cases);
    CHECK(beyond > cases);
    for (const auto procedure : {Procedure::surround_test, Procedure::polygon_clip, Procedure::trial_function,
                                 Procedure::ray_crossings, Procedure::octant_angles}) {
        CAPTURE(procedure_names[std::size_t(procedure)]);
        CHECK(of[procedure] >= cases / 20);
    }
    CHECK(on_lines >= cases / 50);
}
