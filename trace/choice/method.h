/// Method: what each algorithm does, which scenes it takes, and what it paints.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "choice/language.h"
#include "vidno/method.h"
#include "vidno/scene.h"
#include "vidno/trace.h"

namespace vidno {

/// The input and the picture of a method.
struct MethodRule {
    std::string_view domain, rule;
};
inline constexpr MethodRule picture_rule{
    "convex planar polygons",
    "the nearest polygon at each pixel centre, the first of equally near ones; edge-on polygons show nothing"};

struct MethodChoice {
    std::string_view does;
    Bilingual title;  // on the page and in charts; for a variant of Warnock's algorithm, how it differs
    Bilingual says;   // on the page: what it takes and does
    Procedure procedure = Procedure::three_lists_warnock;  // the first one
    MethodRule rule = picture_rule;
    bool takes_closed_bodies = false;  // those of vidno/family/closed_bodies.h alone
    /// It begins with the area and cuts windows along any boundaries of pixels; the others quarter a square, or a
    /// window one pixel wide or high into halves.
    bool cuts_anywhere = false;
};

/// Why a scene does not consist of closed convex bodies, if so.
std::optional<std::string> refuses_bodies(const Scene& scene);

/// Indexed by Method.
inline constexpr std::array method_choices{
    MethodChoice{
        .does = "examine a window; paint it if it is simple, otherwise split it",
        .title = {"Warnock", "Алгоритм Варнока"},
        .says = {"Convex planar polygons. Examines a window; paints it if it is simple, otherwise splits it.",
                 "Выпуклые плоские многоугольники. Окно рассматривается; простое закрашивается, иначе делится."},
        .procedure = Procedure::warnock},
    MethodChoice{
        .does = "scan each polygon with an active edge list; keep the nearest depth at each pixel",
        .title = {"Z-buffer", "Z-буфер"},
        .says = {"Convex planar polygons. Scans each with an active edge list; keeps the nearest depth at each pixel.",
                 "Выпуклые плоские многоугольники. Каждый развёртывается по строкам; в пикселе остаётся ближайшая "
                 "глубина."},
        .procedure = Procedure::z_buffer},
    MethodChoice{
        .does = "split every window that is not empty by the polygons' boxes, down to the pixels",
        .title = {"simplest", "простейший"},
        .says = {"Convex planar polygons. Splits every window that is not empty by the polygons’ boxes, down to the "
                 "pixels.",
                 "Выпуклые плоские многоугольники. Делится каждое окно, не пустое по габаритам, вплоть до "
                 "пикселей."},
        .procedure = Procedure::simplest_warnock},
    MethodChoice{.does = "keep three lists of polygons; test their relation to a window, containment by ray crossings",
                 .title = {"three lists", "три списка"},
                 .says = {"Convex planar polygons. Keeps three lists; containment by crossings of a ray.",
                          "Выпуклые плоские многоугольники. Три списка; охват по пересечениям с лучом."}},
    MethodChoice{.does = "the same, containment by the sum of angles in octants",
                 .title = {"sum of angles", "сумма углов"},
                 .says = {"Convex planar polygons. Keeps three lists; containment by the sum of angles in octants.",
                          "Выпуклые плоские многоугольники. Три списка; охват по сумме углов в октантах."}},
    MethodChoice{.does = "the same, a window split at a vertex in it",
                 .title = {"split at a vertex", "деление в вершине"},
                 .says = {"Convex planar polygons. Keeps three lists; splits a window at a vertex in it.",
                          "Выпуклые плоские многоугольники. Три списка; окно делится в вершине, лежащей в нём."},
                 .cuts_anywhere = true},
    MethodChoice{
        .does = "the same, edge-on polygons shown, their depth taken from their edges",
        .title = {"edge-on polygons", "видимые с ребра"},
        .says = {"Convex planar polygons. Keeps three lists; a polygon seen edge-on shows as a segment, at its nearest "
                 "depth.",
                 "Выпуклые плоские многоугольники. Три списка; видимый с ребра изображается отрезком, с ближайшей "
                 "глубиной."},
        .rule = {"convex planar polygons, and any edge-on ones",
                 "the picture rule, except that an edge-on polygon shows as the closed segment to which it projects, "
                 "at its "
                 "nearest depth"}},
    MethodChoice{
        .does = "back faces removed first, the rest as by warnock",
        .title = {"closed bodies", "замкнутые тела"},
        .says =
            {"Closed convex bodies, each polygon counter-clockwise as seen from outside. Faces that look away are left "
             "out; "
             "of equally near ones the face that looks towards the viewer shows.",
             "Замкнутые выпуклые тела, обход граней снаружи против часовой стрелки. Нелицевые грани не участвуют; из "
             "одинаково близких видна обращённая к наблюдателю."},
        .procedure = Procedure::warnock,
        .rule =
            {"closed convex bodies, each polygon counter-clockwise as seen from outside",
             "the picture rule, except that of equally near faces one that looks towards the viewer comes before one "
             "that looks away"},
        .takes_closed_bodies = true},
    MethodChoice{
        .does = "clip all polygons by the outline of the nearest, and process the parts inside and outside separately; "
                "the visible regions are polygons",
        .title = {"Weiler–Atherton", "Вейлер — Азертон"},
        .says = {"Convex planar polygons. Cuts them by one another’s outlines until what is visible is known as "
                 "regions; then "
                 "paints these.",
                 "Выпуклые плоские многоугольники. Разрезаются контурами друг друга, пока видимое не станет областями; "
                 "затем "
                 "области закрашиваются."},
        .procedure = Procedure::weiler_atherton},
};
static_assert(method_choices.size() == method_names.size());

/// The method that takes curves; those that take polygons are the values of Method.
inline constexpr std::string_view floating_horizon_method = "floating-horizon";
inline constexpr MethodChoice floating_horizon_choice{
    .does = "draw what lies beyond the horizons, and move the horizons there",
    .title = {"Floating horizon", "Плавающий горизонт"},
    .says = {"Curves with samples on whole columns, the nearest first. Draws what lies beyond the horizons, and moves "
             "the horizons there.",
             "Кривые с отсчётами в целых столбцах, начиная с ближней. Рисуется то, что выходит за оба горизонта, и они "
             "сдвигаются до него."},
    .procedure = Procedure::floating_horizon,
    .rule = {"curves with samples on whole columns, the nearest first",
             "a point is visible unless it is strictly between the horizons of the curves before it"}};

/// The method for polygons of this name, which must be one of method_names.
constexpr Method method_named(std::string_view name) {
    return Method(std::find(method_names.begin(), method_names.end(), name) - method_names.begin());
}

constexpr const MethodChoice& choice_of(Method method) { return method_choices[std::size_t(method)]; }

/// The method that, under an always right kernel, paints what this method should.
constexpr Method reference_of(Method method) {
    return choice_of(method).rule.rule == picture_rule.rule ? Method::zbuffer : method;
}

/// The methods whose every step is a line of the course's procedures, so that students are asked about them.
inline constexpr std::array course_methods{Method::warnock, Method::zbuffer};
inline constexpr std::array course_method_names{method_names[0], method_names[1]};

constexpr bool is_of_course(Method method) { return method == Method::warnock || method == Method::zbuffer; }

/// Why the method does not take the scene, if so.
inline std::optional<std::string> refusal_of(Method method, const Scene& scene) {
    return choice_of(method).takes_closed_bodies ? refuses_bodies(scene) : std::nullopt;
}

}  // namespace vidno
