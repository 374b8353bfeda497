#include "random_scenes.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

namespace vidno::recorded {

namespace {

using Whole = std::int64_t;

/// The generator splitmix64.
class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    Whole whole(Whole low, Whole high) { return low + Whole(next() % std::uint64_t(high - low + 1)); }
    bool one_in(Whole count) { return whole(1, count) == 1; }
    template <class T>
    const T& one_of(const std::vector<T>& items) {
        return items[std::size_t(whole(0, Whole(items.size()) - 1))];
    }

private:
    std::uint64_t next() {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
        z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
        return z ^ (z >> 31);
    }

    std::uint64_t state_;
};

/// x and y in thousandths of a pixel, z in units of 10^-10, so that eighths of a pixel and depths in 1/1024 are
/// integers.
struct Place {
    Whole x = 0, y = 0, z = 0;
};
using Places = std::vector<Place>;

constexpr Whole pixel = 1000;
constexpr Whole depth_unit = 9765625;  // 1/1024
constexpr Whole deepest = 1024 * depth_unit;

struct Area {
    Whole x, y, width, height;  // in pixels
};

std::string padded(const std::string& digits, std::size_t places) {
    return std::string(places > digits.size() ? places - digits.size() : 0, '0') + digits;
}

/// value / 10^places, as a decimal number.
std::string decimal(Whole value, std::size_t places) {
    const std::string digits = padded(std::to_string(value < 0 ? -value : value), places + 1);
    return (value < 0 ? "-" : "") + digits.substr(0, digits.size() - places) + '.' +
           digits.substr(digits.size() - places);
}

std::string text_of(const Area& area) {
    return R"({"x":)" + std::to_string(area.x) + R"(,"y":)" + std::to_string(area.y) + R"(,"width":)" +
           std::to_string(area.width) + R"(,"height":)" + std::to_string(area.height) + '}';
}

/// Twice the area of a triangle.
Whole turn(const Place& p, const Place& q, const Place& r) {
    return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
}

/// The convex hull of the places; empty if it has fewer than three corners.
Places outline_of(Places places) {
    const auto before = [](const Place& p, const Place& q) { return std::pair(p.x, p.y) < std::pair(q.x, q.y); };
    std::sort(places.begin(), places.end(), before);
    Places outline;
    for (int side = 0; side < 2; ++side) {
        const std::size_t first = outline.size();
        for (const auto& place : places) {
            while (outline.size() >= first + 2 && turn(outline.end()[-2], outline.back(), place) <= 0) {
                outline.pop_back();
            }
            outline.push_back(place);
        }
        outline.pop_back();
        std::reverse(places.begin(), places.end());
    }
    const bool has_area = outline.size() >= 3 && turn(outline[0], outline[1], outline[2]) != 0;
    return has_area ? outline : Places{};
}

/// A plane of depths over places on a lattice of eighths of a pixel, with its origin in the middle of an area.
struct Plane {
    Whole a, b, c;  // in 1/1024: change for an eighth of a pixel to the right, downward; depth in the middle

    Whole depth(const Area& area, const Place& place) const {
        const Whole x = (place.x - pixel * (area.x + area.width / 2)) / 125;
        const Whole y = (place.y - pixel * (area.y + area.height / 2)) / 125;
        return std::clamp((a * x + b * y + c) * depth_unit, -deepest, deepest);
    }
};

class SceneMaker {
public:
    explicit SceneMaker(std::uint64_t number)
        : random_(number), area_{random_.whole(-3, 3), random_.whole(-3, 3), side(), side()}, kind_(number % 8) {}

    std::string text(std::uint64_t number) {
        make();
        std::string text = R"({"format":"vidno-scene/1","name":"Random scene )" + std::to_string(number) +
                           R"(","window":)" + text_of(area_) + R"(,"background":")" +
                           (random_.one_in(4) ? "#102030" : "#ffffff") + R"(","polygons":[)";
        for (std::size_t i = 0; i < polygons_.size(); ++i) {
            text += (i > 0 ? ",\n" : "\n") + polygon(i);
        }
        return text + "]}\n";
    }

private:
    Whole side() { return random_.whole(3, 6); }

    void make() {
        if (kind_ == 7) {
            for (Whole i = random_.whole(1, 2); i > 0; --i) add_body();
            return;
        }
        planes_ = {plane(), plane()};
        for (Whole i = random_.whole(2, 3); i > 0; --i) {
            switch (kind_ < 5 ? kind_ : random_.whole(0, 7)) {
                case 0: add_flat(500); break;
                case 1: add_flat(125); break;
                case 2: add_neighbours(); break;
                case 3: add(triangle()); break;
                case 4: random_.one_in(2) ? add_folded() : add(edge_on()); break;
                case 5: add(sliver()); break;
                case 6: add(far_triangle()); break;
                default: polygons_.empty() ? add_flat(1000) : add_again();
            }
        }
    }

    /// Adds a polygon, perhaps reversed, from a random vertex on.
    void add(Places places) {
        if (places.size() < 3) return;
        if (random_.one_in(2)) std::reverse(places.begin(), places.end());
        const auto first = random_.whole(0, Whole(places.size()) - 1);
        std::rotate(places.begin(), places.begin() + first, places.end());
        polygons_.push_back(std::move(places));
    }

    Plane plane() { return {random_.whole(-3, 3), random_.whole(-3, 3), random_.whole(-40, 40)}; }

    /// A place in the area or near it, on a lattice of `step` thousandths of a pixel.
    Place place(Whole step) {
        const auto one = [&](Whole first, Whole length) {
            const Whole margin = 2 * pixel;
            const Whole lattice = (length * pixel + 2 * margin) / step;
            return first * pixel - margin + random_.whole(0, lattice) * step;
        };
        const Whole x = one(area_.x, area_.width);
        return {x, one(area_.y, area_.height), 0};
    }

    Places outline(Whole step) {
        for (;;) {
            Places places;
            for (Whole i = random_.whole(3, 6); i > 0; --i) places.push_back(place(step));
            Places found = outline_of(places);
            if (!found.empty()) return found;
        }
    }

    /// Repeats a vertex or adds one in the middle of an edge; both are admissible.
    void add_idle_vertex(Places& places) {
        const auto i = std::size_t(random_.whole(0, Whole(places.size()) - 1));
        const Place p = places[i], q = places[(i + 1) % places.size()];
        const bool amid = (p.x + q.x) % 250 == 0 && (p.y + q.y) % 250 == 0;
        const Place idle = amid ? Place{(p.x + q.x) / 2, (p.y + q.y) / 2, 0} : p;
        places.insert(places.begin() + Whole(i) + 1, idle);
    }

    Places raised(Places places, const Plane& plane) const {
        for (auto& p : places) p.z = plane.depth(area_, p);
        return places;
    }

    void add_flat(Whole step) {
        Places places = outline(step);
        if (random_.one_in(3)) add_idle_vertex(places);
        add(raised(places, random_.one_of(planes_)));
    }

    /// Adds a polygon cut in two along a diagonal, or a triangle on each edge of another triangle.
    void add_neighbours() {
        const Places places = outline(500);
        const Plane common = random_.one_of(planes_);
        if (places.size() == 3) {
            const Place middle = place(500);
            for (std::size_t i = 0; i < 3; ++i) {
                const Places part = outline_of({places[i], places[(i + 1) % 3], middle});
                if (!part.empty()) add(raised(part, common));
            }
            return;
        }
        const auto cut = std::size_t(random_.whole(2, Whole(places.size()) - 2));
        add(raised(Places(places.begin(), places.begin() + Whole(cut) + 1), common));
        Places rest(places.begin() + Whole(cut), places.end());
        rest.push_back(places.front());
        add(raised(rest, random_.one_in(2) ? common : random_.one_of(planes_)));
    }

    Whole any_depth() { return random_.whole(-999, 999) * 10000000; }

    Places triangle() {
        Places places{place(1), place(1), place(1)};
        for (auto& p : places) p.z = any_depth();
        return places;
    }

    /// Adds two triangles with a common edge: a crease.
    void add_folded() {
        Places places{place(250), place(250), place(250), place(250)};
        for (auto& p : places) p.z = random_.whole(-8, 8) * 64 * depth_unit;
        add({places[0], places[1], places[2]});
        add({places[0], places[1], places[3]});
    }

    Places edge_on() {
        const Place p = place(500);
        const Whole dx = random_.whole(-4, 4) * 500, dy = random_.whole(-4, 4) * 500;
        Places places;
        for (Whole i = random_.whole(3, 4); i > 0; --i) {
            const Whole t = random_.whole(-2, 2);
            places.push_back({p.x + t * dx, p.y + t * dy, random_.whole(-8, 8) * 64 * depth_unit});
        }
        return places;
    }

    Places sliver() {
        const Place p = place(1), q = place(1);
        const Place near_middle{(p.x + q.x) / 2 + random_.whole(-2, 2), (p.y + q.y) / 2 + random_.whole(-2, 2), 0};
        Places places{p, q, near_middle};
        for (auto& each : places) each.z = any_depth();
        return places;
    }

    Places far_triangle() {
        Places places{place(500), place(500), place(500)};
        const Whole far = random_.one_in(2) ? 30 : 200;
        for (auto& p : places) {
            p.x += random_.whole(-1, 1) * far * pixel;
            p.y += random_.whole(-1, 1) * far * pixel;
            p.z = any_depth();
        }
        return places;
    }

    /// Adds a polygon of the scene again, perhaps a little nearer or farther.
    void add_again() {
        Places places = random_.one_of(polygons_);
        const Whole nearer = random_.whole(-1, 1) * depth_unit;
        const auto stays = [&](const Place& p) { return -deepest <= p.z + nearer && p.z + nearer <= deepest; };
        if (std::all_of(places.begin(), places.end(), stays)) {
            for (auto& p : places) p.z += nearer;
        }
        add(std::move(places));
    }

    struct Way {
        Whole x, y, z;  // in half pixels and 1/16 of depth
    };
    static Whole volume(const Way& u, const Way& v, const Way& w) {
        return (u.y * v.z - u.z * v.y) * w.x + (u.z * v.x - u.x * v.z) * w.y + (u.x * v.y - u.y * v.x) * w.z;
    }
    Way way() { return {random_.whole(-8, 8), random_.whole(-8, 8), random_.whole(-4, 4)}; }

    /// Adds a parallelepiped or a tetrahedron, with faces counter-clockwise as seen from outside.
    void add_body() {
        const Place corner = place(500);
        const Whole z = random_.whole(-4, 4);
        Way u = way(), v = way(), w = way();
        while (volume(u, v, w) == 0) u = way(), v = way(), w = way();
        if (volume(u, v, w) > 0) std::swap(u, v);  // y grows downward
        const auto at = [&](Whole i, Whole j, Whole k) {
            return Place{corner.x + 500 * (i * u.x + j * v.x + k * w.x), corner.y + 500 * (i * u.y + j * v.y + k * w.y),
                         64 * depth_unit * (z + i * u.z + j * v.z + k * w.z)};
        };
        if (random_.one_in(2)) {
            const Place o = at(0, 0, 0), a = at(1, 0, 0), b = at(0, 1, 0), c = at(0, 0, 1);
            for (const Places& face : {Places{o, b, a}, {o, a, c}, {a, b, c}, {b, o, c}}) polygons_.push_back(face);
            return;
        }
        polygons_.push_back({at(0, 0, 0), at(0, 1, 0), at(1, 1, 0), at(1, 0, 0)});
        polygons_.push_back({at(0, 0, 0), at(0, 0, 1), at(0, 1, 1), at(0, 1, 0)});
        polygons_.push_back({at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1)});
        polygons_.push_back({at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)});
        polygons_.push_back({at(1, 0, 0), at(1, 1, 0), at(1, 1, 1), at(1, 0, 1)});
        polygons_.push_back({at(0, 1, 0), at(0, 1, 1), at(1, 1, 1), at(1, 1, 0)});
    }

    std::string polygon(std::size_t place) const {
        static constexpr std::array<std::string_view, 8> colors{"#0072b2", "#d55e00", "#009e73", "#f0e442",
                                                                "#cc79a7", "#56b4e9", "#e69f00", "#999999"};
        std::string text = R"({"id":"P)" + std::to_string(place) + R"(","color":")" +
                           std::string(colors[place % colors.size()]) + R"(","vertices":[)";
        for (const auto& [x, y, z] : polygons_[place]) {
            text +=
                (text.back() == '[' ? "[" : ",[") + decimal(x, 3) + ',' + decimal(y, 3) + ',' + decimal(z, 10) + ']';
        }
        return text + "]}";
    }

    Random random_;
    Area area_;
    std::uint64_t kind_;
    std::vector<Plane> planes_;
    std::vector<Places> polygons_;
};

class SurfaceMaker {
public:
    explicit SurfaceMaker(std::uint64_t number)
        : random_(~number), area_{random_.whole(-9, 9), 0, random_.whole(2, 14), 16}, kind_(number % 4) {}

    std::string text(std::uint64_t number) {
        for (Whole i = random_.whole(2, 6); i > 0; --i) {
            curves_.push_back(!curves_.empty() && random_.one_in(4) ? variant(random_.one_of(curves_)) : curve());
        }
        std::string text = R"({"format":"vidno-surface/1","name":"Random surface )" + std::to_string(number) +
                           R"(","window":)" + text_of(area_) + R"(,"curves":[)";
        for (std::size_t i = 0; i < curves_.size(); ++i) {
            text += i > 0 ? ",\n[" : "\n[";
            for (const auto& [x, y] : curves_[i]) {
                text += (text.back() == '[' ? "[" : ",[") + std::to_string(x) + ',' + decimal(y, 6) + ']';
            }
            text += ']';
        }
        return text + "]}\n";
    }

private:
    using Samples = std::vector<std::pair<Whole, Whole>>;  // column, and height in millionths

    Samples curve() {
        const Whole right = area_.x + area_.width - 1;
        const bool cropped = random_.one_in(3);
        const Whole first = cropped ? random_.whole(area_.x, right - 1) : area_.x;
        const Whole last = cropped ? random_.whole(first + 1, right) : right;
        const Whole longest = random_.whole(1, 6);
        Samples samples;
        for (Whole x = first; x < last; x += random_.whole(1, longest)) samples.emplace_back(x, height());
        samples.emplace_back(last, height());
        return samples;
    }

    Whole height() {
        switch (kind_) {
            case 0: return random_.whole(0, 4) * 1000000;
            case 1: return random_.one_in(4) ? random_.whole(0, 1) * 16000000 : 8000000;  // peaks
            case 2: return random_.whole(-64, 1088) * 15625;
            default: return random_.whole(0, 30) * 100000;  // tenths, which doubles do not represent exactly
        }
    }

    /// The curve again, perhaps mirrored in a horizontal line and with fewer samples.
    Samples variant(Samples samples) {
        if (random_.one_in(2)) {
            for (auto& [x, y] : samples) y = 4000000 - y;
        }
        for (std::size_t i = samples.size() - 2; i > 0; --i) {
            if (random_.one_in(2)) samples.erase(samples.begin() + Whole(i));
        }
        return samples;
    }

    Random random_;
    Area area_;
    std::uint64_t kind_;
    std::vector<Samples> curves_;
};

}  // namespace

std::string random_scene(std::uint64_t number) { return SceneMaker(number).text(number); }

std::string random_surface(std::uint64_t number) { return SurfaceMaker(number).text(number); }

}  // namespace vidno::recorded
