/// Method: what each algorithm does, for which scenes, and what it paints, for the program.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "vidno/method.h"
#include "vidno/scene.h"
#include "vidno/trace.h"

namespace vidno {

/// What a method takes and paints.
struct MethodRule {
    std::string_view domain, rule;
};
inline constexpr MethodRule picture_rule{
    "convex planar polygons",
    "the nearest polygon at each pixel centre, the first of equally near ones; edge-on polygons show nothing"};

struct MethodChoice {
    std::string_view does;
    Procedure procedure = Procedure::three_lists_warnock;  // the first one
    MethodRule rule = picture_rule;
    bool takes_closed_bodies = false;  // those of vidno/family/closed_bodies.h alone
};

/// Why a scene does not consist of closed convex bodies, if it does not.
std::optional<std::string> refuses_bodies(const Scene& scene);

/// By the places of Method.
inline constexpr std::array method_choices{
    MethodChoice{"look at a window; paint it if it is plain, else split it", Procedure::warnock},
    MethodChoice{"scan each polygon with an active edge list; keep the nearest depth at each pixel",
                 Procedure::z_buffer},
    MethodChoice{"split every window that is not empty by the polygons' boxes, down to the pixels",
                 Procedure::simplest_warnock},
    MethodChoice{"keep three lists of polygons; test their relation to a window, containment by ray crossings"},
    MethodChoice{"the same, containment by the sum of angles in octants"},
    MethodChoice{"the same, a window split at a vertex in it"},
    MethodChoice{
        .does = "the same, edge-on polygons shown, their depth taken from their edges",
        .rule = {"convex planar polygons, edge-on ones any",
                 "the picture rule, but that an edge-on polygon is the closed segment it is projected to, at its "
                 "nearest depth"}},
    MethodChoice{"back faces removed first, the rest as by warnock",
                 Procedure::warnock,
                 {"closed convex bodies, each polygon counter-clockwise as seen from outside",
                  "the picture rule, but that of equally near faces one that looks towards the viewer comes before one "
                  "that looks away"},
                 true},
    MethodChoice{
        "clip all polygons by the outline of the nearest, look at what is inside and what is outside by itself; "
        "its visible regions are polygons",
        Procedure::weiler_atherton},
};
static_assert(method_choices.size() == method_names.size());

/// The method that takes curves; those that take polygons are the values of Method.
inline constexpr std::string_view floating_horizon_method = "floating-horizon";
inline constexpr MethodChoice floating_horizon_choice{
    .does = "draw what is beyond both horizons; raise them to it",
    .procedure = Procedure::floating_horizon,
    .rule = {"curves with samples on whole columns, the nearest first",
             "a point is visible unless it is strictly between the horizons of the curves before it"}};

constexpr const MethodChoice& choice_of(Method method) { return method_choices[std::size_t(method)]; }

/// Under an always right kernel it paints what the method should.
constexpr Method reference_of(Method method) {
    return choice_of(method).rule.rule == picture_rule.rule ? Method::zbuffer : method;
}

/// Those whose every step is a line of the course's procedures: what students are asked about.
inline constexpr std::array course_methods{Method::warnock, Method::zbuffer};
inline constexpr std::array course_method_names{method_names[0], method_names[1]};

constexpr bool is_of_course(Method method) { return method == Method::warnock || method == Method::zbuffer; }

/// Why the method does not take the scene, if it does not.
inline std::optional<std::string> refusal_of(Method method, const Scene& scene) {
    return choice_of(method).takes_closed_bodies ? refuses_bodies(scene) : std::nullopt;
}

}  // namespace vidno
