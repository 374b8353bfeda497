/// The Warnock family: procedure sets that combine the variants of the algorithm, to be chosen and compared.
///
///     using namespace vidno;
///     const Picture picture = render<family::Full>(Method::warnock_full, scene, Double{});
///
/// Each set paints the picture rule on the scenes of its domain, or the variation stated above the set.
#pragma once

#include <array>
#include <stdexcept>
#include <string_view>

#include "../vidno.h"
#include "back_faces.h"
#include "box_test.h"
#include "calls.h"
#include "edge_depth.h"
#include "hiding_polygon.h"
#include "octant_angles.h"
#include "ray_crossings.h"
#include "relation_test.h"
#include "simplest.h"
#include "three_lists.h"
#include "trial_function.h"
#include "vertex_split.h"

namespace vidno::family {

struct Simplest : Corrected {
    static constexpr std::string_view name = "simplest";
    static constexpr auto methods = std::to_array({Method::warnock_simplest});
    static void warnock(auto& run) { SimplestWarnock::warnock(run); }
};

struct Full : Corrected, RelationTest, BoxTest, TrialFunction, RayCrossings, OctantAngles, HidingPolygon {
    static constexpr std::string_view name = "full";
    static constexpr auto methods = std::to_array({Method::warnock_full});
    static void warnock(auto& run) { ThreeListsWarnock::warnock(run); }

    /// RE4: does a polygon whose edges do not meet a window surround it? If not, it is outside.
    static bool surrounds(auto& run, const auto& polygon, const Window& window) {
        using enum Line;
        return calls::ray_crossings(run, RE4, polygon, window) % 2 == 1;
    }

    /// WF12: the parts of a window, whatever it contains.
    static WindowParts split(auto&, const Window& window, const auto&) { return parts(window); }
};

/// Tests containment by the sum of the angles.
struct Angles : Full {
    static constexpr std::string_view name = "angles";
    static constexpr auto methods = std::to_array({Method::warnock_angles});
    static bool surrounds(auto& run, const auto& polygon, const Window& window) {
        using enum Line;
        return calls::octant_angles(run, RE4, polygon, window) != 0;
    }
};

/// Splits at a vertex. The first window need not be a square, since windows are not halved.
struct AtVertex : Full {
    static constexpr std::string_view name = "at vertex";
    static constexpr auto methods = std::to_array({Method::warnock_vertex});
    static Window root_window(const Area& area) { return whole_area(area); }
    static WindowParts split(auto& run, const Window& window, const auto& polygons) {
        return VertexSplit::split(run, window, polygons);
    }
};

/// Shows edge-on polygons as well: each is the closed segment that it is projected to, at its nearest depth.
struct EdgeOn : Full {
    static constexpr std::string_view name = "edge-on";
    static constexpr auto methods = std::to_array({Method::warnock_edges});
    static void warnock(auto& run) {
        EdgeDepth::initialize_edges(run);
        Full::warnock(run);
    }
    static bool takes_part(const auto&, const auto&) { return true; }
    static bool surround_test(auto& run, const auto& point, const auto& polygon) {
        return polygon.edge_on ? EdgeDepth::on_segment(run, point, polygon) : Full::surround_test(run, point, polygon);
    }
    static auto depth(auto& run, const auto& polygon, const auto& point) {
        return polygon.edge_on ? EdgeDepth::edge_depth(run, polygon, point) : Full::depth(run, polygon, point);
    }
};

/// Closed convex bodies: the faces that look away are removed first. At a centre on the outline of a body such a face
/// may be as near as one that faces the viewer; the latter then shows.
struct Bodies : Corrected {
    static constexpr std::string_view name = "bodies";
    static constexpr auto methods = std::to_array({Method::warnock_bodies});
    static bool takes_part(auto& run, const auto& polygon) {
        return !polygon.edge_on && !BackFaces::looks_away(run, polygon);
    }
};

/// Calls `use` with the set of a method of the family; throws std::invalid_argument for another method.
auto with_set_of(Method method, auto&& use) {
    switch (method) {
        case Method::warnock_simplest: return use(Simplest{});
        case Method::warnock_angles: return use(Angles{});
        case Method::warnock_vertex: return use(AtVertex{});
        case Method::warnock_edges: return use(EdgeOn{});
        case Method::warnock_bodies: return use(Bodies{});
        case Method::warnock_full: return use(Full{});
        default: throw std::invalid_argument("not a method of the Warnock family");
    }
}

}  // namespace vidno::family
