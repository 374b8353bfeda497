/// The procedure sets of recorded and judged runs: the method and the edition are chosen at run time, so that one set is compiled
/// for all of them. Each function takes the text of the set that has it.
#pragma once

#include <type_traits>
#include <utility>

#include "run/rules.h"
#include "vidno/family/family.h"
#include "vidno/mistakes/boundary_outside.h"
#include "vidno/mistakes/clip_order_reversed.h"
#include "vidno/mistakes/depth_sign_reversed.h"
#include "vidno/mistakes/depths_not_cleared.h"
#include "vidno/mistakes/integer_division.h"
#include "vidno/mistakes/line_for_edge.h"
#include "vidno/mistakes/octants_not_split.h"
#include "vidno/mistakes/one_list.h"
#include "vidno/mistakes/surround_kept.h"
#include "vidno/mistakes/vertex_counted_twice.h"
#include "vidno/mistakes/y_flipped.h"
#include "vidno/printed.h"

namespace vidno {

/// Warnock's algorithm, its variants and the Z-buffer, corrected.
struct AnyMethod : family::Full {
    static constexpr std::string_view name = "recorded";
    static constexpr auto methods =
        std::to_array({Method::warnock, Method::zbuffer, Method::warnock_simplest, Method::warnock_full,
                       Method::warnock_angles, Method::warnock_vertex, Method::warnock_edges, Method::warnock_bodies});

    Method method{};

    explicit AnyMethod(Method chosen) : method(chosen) {}

    void warnock(auto& run) const {
        switch (method) {
            case Method::warnock_simplest: return family::Simplest::warnock(run);
            case Method::warnock_edges: return family::EdgeOn::warnock(run);
            case Method::warnock_full:
            case Method::warnock_angles:
            case Method::warnock_vertex: return family::Full::warnock(run);
            default: return Corrected::warnock(run);
        }
    }

    bool takes_part(auto& run, const auto& polygon) const {
        if (method == Method::warnock_bodies) return family::Bodies::takes_part(run, polygon);
        return method == Method::warnock_edges || Corrected::takes_part(run, polygon);
    }
    Window root_window(const Area& area) const {
        return method == Method::warnock_vertex ? family::AtVertex::root_window(area) : Corrected::root_window(area);
    }
    std::vector<Window> split(auto& run, const Window& window, const auto& polygons) const {
        return method == Method::warnock_vertex ? family::AtVertex::split(run, window, polygons)
                                                : family::Full::split(run, window, polygons);
    }
    bool surrounds(auto& run, const auto& polygon, const Window& window) const {
        return method == Method::warnock_angles ? family::Angles::surrounds(run, polygon, window)
                                                : family::Full::surrounds(run, polygon, window);
    }
    bool surround_test(auto& run, const auto& point, const auto& polygon) const {
        return method == Method::warnock_edges ? family::EdgeOn::surround_test(run, point, polygon)
                                               : Corrected::surround_test(run, point, polygon);
    }
    auto depth(auto& run, const auto& polygon, const auto& point) const {
        return method == Method::warnock_edges ? family::EdgeOn::depth(run, polygon, point)
                                               : Corrected::depth(run, polygon, point);
    }
};

/// The same by rules, for kernels that run the printed text. Where several rules concern one function the first one counts.
struct AnyEdition : AnyMethod {
    Rules rules;

    AnyEdition(Method chosen, Rules by) : AnyMethod(chosen), rules(by) {}

    /// A defect of the printed text, or the edition of a usual mistake.
    bool has(auto rule) const { return rules.has(rule); }

    // Warnock

    bool takes_part(auto& run, const auto& polygon) const {
        return has(Rule::x_w8) ? Printed::takes_part(run, polygon) : AnyMethod::takes_part(run, polygon);
    }
    Window root_window(const Area& area) const {
        if (has(Rule::x_w5)) return Printed::root_window(area);
        return has(Edition::integer_division) ? mistakes::IntegerDivision::root_window(area)
                                              : AnyMethod::root_window(area);
    }
    std::vector<Window> parts(const Window& window) const {
        return has(Edition::integer_division) ? mistakes::IntegerDivision::parts(window) : Corrected::parts(window);
    }
    template <class List>
    std::shared_ptr<List> list_for_part(const std::shared_ptr<List>& list) const {
        if (has(Rule::x_w9)) return Printed::list_for_part(list);
        return has(Edition::one_list) ? mistakes::OneList::list_for_part(list) : Corrected::list_for_part(list);
    }
    auto first_corner_depth(const auto& kernel) const {
        return has(Rule::x_w2) ? Printed::first_corner_depth(kernel) : Corrected::first_corner_depth(kernel);
    }
    bool discards(bool surrounding, bool outside) const {
        return has(Rule::x_w1) ? Printed::discards(surrounding, outside) : Corrected::discards(surrounding, outside);
    }
    bool uncovers(int k) const {
        if (has(Rule::x_w3)) return Printed::uncovers(k);
        return has(Edition::surround_kept) ? mistakes::SurroundKept::uncovers(k) : Corrected::uncovers(k);
    }
    auto corners_around(const auto& kernel, const Window& window) const {
        return has(Edition::clip_order_reversed) ? mistakes::ClipOrderReversed::corners_around(kernel, window)
                                                 : Corrected::corners_around(kernel, window);
    }
    bool opposite(const auto& kernel, const auto& p, const auto& q) const {
        return has(Rule::x_w7) ? Printed::opposite(kernel, p, q) : Corrected::opposite(kernel, p, q);
    }
    bool surround_test(auto& run, const auto& point, const auto& polygon) const {
        if (has(Rule::x_w4)) return Printed::surround_test(run, point, polygon);
        return has(Edition::boundary_outside) ? mistakes::BoundaryOutside::surround_test(run, point, polygon)
                                              : AnyMethod::surround_test(run, point, polygon);
    }
    auto depth(auto& run, const auto& polygon, const auto& point) const {
        return has(Edition::depth_sign_reversed) ? mistakes::DepthSignReversed::depth(run, polygon, point)
                                                 : AnyMethod::depth(run, polygon, point);
    }
    auto initialize_polygon(auto& run, const auto& vertices) const {
        return has(Rule::x_w6) ? Printed::initialize_polygon(run, vertices)
                               : Corrected::initialize_polygon(run, vertices);
    }
    auto on_screen(const auto& kernel, const Area& area, const glm::dvec3& vertex) const {
        return has(Edition::y_flipped) ? mistakes::YFlipped::on_screen(kernel, area, vertex)
                                       : Corrected::on_screen(kernel, area, vertex);
    }

    // The Warnock family

    int crossings_at_vertex(bool touches) const {
        return has(Edition::vertex_counted_twice) ? mistakes::VertexCountedTwice::crossings_at_vertex(touches)
                                                  : family::Full::crossings_at_vertex(touches);
    }
    bool needs_split(int difference) const {
        return has(Edition::octants_not_split) ? mistakes::OctantsNotSplit::needs_split(difference)
                                               : family::Full::needs_split(difference);
    }
    bool ends_before(const auto& from, const auto& to, const auto& upper_left, const auto& lower_right) const {
        return has(Edition::line_for_edge) ? mistakes::LineForEdge::ends_before(from, to, upper_left, lower_right)
                                           : family::Full::ends_before(from, to, upper_left, lower_right);
    }

    // The Z-buffer

    void z_buffer(auto& run) const { has(Rule::x_z) ? Printed::z_buffer(run) : Corrected::z_buffer(run); }
    auto first_depth(const auto& kernel) const {
        return has(Edition::depths_not_cleared) ? mistakes::DepthsNotCleared::first_depth(kernel)
                                                : Corrected::first_depth(kernel);
    }
    /// The printed Z-buffer has a y, a number; the corrected one has a row.
    template <class Row>
    void show_line(auto& run, const Row& row, const auto& from, const auto& to, const auto& polygon) const {
        if constexpr (std::is_integral_v<Row>) {
            Corrected::show_line(run, row, from, to, polygon);
        } else {
            Printed::show_line(run, row, from, to, polygon);
        }
    }
    std::pair<int, int> columns_shown(const auto& run, int row, const auto& left, const auto& right,
                                      const auto& polygon) const {
        return has(Edition::boundary_outside) ? mistakes::BoundaryOutside::columns_shown(run, row, left, right, polygon)
                                              : Corrected::columns_shown(run, row, left, right, polygon);
    }
};

}  // namespace vidno
