/// The result of admitting a polygon (admission.h), and of looking at one through a camera (look.h).
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "scene.h"

namespace vidno {

enum class Admission : unsigned char {
    admitted,
    not_finite,
    too_few_vertices,
    out_of_depth_range,
    not_planar,
    not_convex,
};

/// Why a polygon is refused, for messages.
inline std::string_view reason_of(Admission admission) {
    switch (admission) {
        case Admission::admitted: return "admitted";
        case Admission::not_finite: return "not finite";
        case Admission::too_few_vertices: return "fewer than three vertices";
        case Admission::out_of_depth_range: return "z outside -1 to 1";
        case Admission::not_planar: return "not planar";
        case Admission::not_convex: return "not convex";
    }
    return "";
}

struct Admitted {
    Admission admission = Admission::admitted;
    std::size_t dropped = 0;  // vertices, reflex by rounding only
};

struct Seen {
    std::vector<ScenePolygon> polygons;  // none if the view shows nothing of it; all of one id
    std::size_t dropped = 0;             // vertices, reflex by rounding
};

}  // namespace vidno
