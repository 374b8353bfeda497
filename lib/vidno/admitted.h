/// Admitted: a scene, or curves, that the procedures can run on. Also the results of admitting one polygon
/// (admission.h) and of looking at one through a camera (look.h).
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene.h"

namespace vidno {

/// A value that satisfies what every procedure assumes. Only `admit` makes one, and nothing changes it: change a copy
/// of the value and admit that.
template <class Checked>
class Admitted {
public:
    const Checked& operator*() const { return value_; }
    const Checked* operator->() const { return &value_; }
    /// It may be read wherever the value may.
    operator const Checked&() const { return value_; }
    bool operator==(const Admitted&) const = default;

private:
    explicit Admitted(Checked value) : value_(std::move(value)) {}

    template <class Value>
    friend Admitted<Value> admit(Value value);

    Checked value_;
};

using AdmittedScene = Admitted<Scene>;

/// Checks a scene (include admission.h, which needs CGAL) or curves (floating_horizon/curves.h), which may change by
/// rounding only. Throws std::invalid_argument, which says what is wrong with which part.
template <class Value>
Admitted<Value> admit(Value value) {
    make_admissible(value);
    return Admitted<Value>(std::move(value));
}

/// Throws std::invalid_argument unless the sides and the offsets of the area are within the limits of scene.h.
inline void expect_admissible(const Area& area) {
    const auto in_reach = [](int offset) { return -farthest_offset <= offset && offset <= farthest_offset; };
    const auto is_side = [](int side) { return 1 <= side && side <= largest_side; };
    if (!is_side(area.width) || !is_side(area.height)) {
        throw std::invalid_argument("the area has a side that is not 1 to " + std::to_string(largest_side));
    }
    if (!in_reach(area.x) || !in_reach(area.y)) throw std::invalid_argument("the area starts farther than 2^30 from 0");
}

enum class Admission : unsigned char {
    admitted,
    not_finite,
    too_few_vertices,
    out_of_depth_range,
    not_planar,
    not_convex,
};

/// Why a polygon is refused, for messages. The rules are those of admission.h.
inline std::string_view reason_of(Admission admission) {
    switch (admission) {
        case Admission::admitted: return "admitted";
        case Admission::not_finite: return "not finite";
        case Admission::too_few_vertices: return "fewer than three vertices";
        case Admission::out_of_depth_range: return "z outside -1 to 1";
        case Admission::not_planar: return "not planar";
        case Admission::not_convex:
            return "not convex: the outline does not go once around the convex hull of its vertices";
    }
    return "";
}

/// What admission found out about one polygon.
struct PolygonAdmission {
    Admission admission = Admission::admitted;
    std::size_t dropped = 0;  // vertices, reflex by rounding only
};

struct Seen {
    std::vector<ScenePolygon> polygons;  // none if the view shows nothing of it; all of one id
    std::size_t dropped = 0;             // vertices, reflex by rounding
};

}  // namespace vidno
