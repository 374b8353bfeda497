/// The procedure sets of recorded and judged runs. The method and the edition are chosen at run time, so that one set
/// is compiled for all of them. Each function calls the text of the set that has it.
#pragma once

#include <array>
#include <concepts>
#include <type_traits>
#include <utility>
#include <vector>

#include "choice/edition.h"
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
#include "vidno/printed/z_buffer_defects.h"

namespace vidno {

/// Warnock's algorithm, its variants and the Z-buffer, corrected.
struct AnyMethod : family::Full {
    static constexpr std::string_view name = "recorded";
    static constexpr auto methods = [] {  // all before Weiler and Atherton's algorithm, which has a set of its own
        std::array<Method, std::size_t(Method::weiler_atherton)> all{};
        for (std::size_t i = 0; i < all.size(); ++i) all[i] = Method(i);
        return all;
    }();

    Method method{};

    explicit AnyMethod(Method chosen) : method(chosen) {}

    /// Calls `use` with the corrected set of the method.
    auto with_set(auto&& use) const { return is_family(method) ? family::with_set_of(method, use) : use(Corrected{}); }
    /// Calls `use` with a rule that only variants with three lists have.
    auto with_full_set(auto&& use) const {
        return with_set([&]<class Set>(Set set) {
            if constexpr (std::derived_from<Set, family::Full>) {
                return use(set);
            } else {
                return use(family::Full{});
            }
        });
    }

    void warnock(auto& run) const {
        with_set([&](auto set) { set.warnock(run); });
    }

    bool takes_part(auto& run, const auto& polygon) const {
        return with_set([&](auto set) { return set.takes_part(run, polygon); });
    }
    Window root_window(const Area& area) const {
        return with_set([&](auto set) { return set.root_window(area); });
    }
    WindowParts split(auto& run, const Window& window, const auto& polygons) const {
        return with_full_set([&](auto set) { return set.split(run, window, polygons); });
    }
    bool surrounds(auto& run, const auto& polygon, const Window& window) const {
        return with_full_set([&](auto set) { return set.surrounds(run, polygon, window); });
    }
    bool surround_test(auto& run, const auto& point, const auto& polygon) const {
        return with_set([&](auto set) { return set.surround_test(run, point, polygon); });
    }
    auto depth(auto& run, const auto& polygon, const auto& point) const {
        return with_set([&](auto set) { return set.depth(run, polygon, point); });
    }
};

/// Calls it with the deviations of an edition, for kernels that run the printed text. If several deviations concern one
/// function, the first one applies.
struct AnyEdition : AnyMethod {
    using ZBufferDefects = printed::ZBufferDefects;

    Edition edition;

    AnyEdition(Method chosen, Edition text) : AnyMethod(chosen), edition(text) {}

    bool has(Deviation deviation) const { return edition.has(deviation); }

    // Warnock

    bool takes_part(auto& run, const auto& polygon) const {
        return has(Deviation::x_w8) ? Printed::takes_part(run, polygon) : AnyMethod::takes_part(run, polygon);
    }
    Window root_window(const Area& area) const {
        if (has(Deviation::x_w5)) return Printed::root_window(area);
        return has(Deviation::integer_division) ? mistakes::IntegerDivision::root_window(area)
                                                : AnyMethod::root_window(area);
    }
    WindowParts parts(const Window& window) const {
        return has(Deviation::integer_division) ? mistakes::IntegerDivision::parts(window) : Corrected::parts(window);
    }
    template <class List>
    std::shared_ptr<List> list_for_part(const std::shared_ptr<List>& list) const {
        return has(Deviation::one_list) ? mistakes::OneList::list_for_part(list) : Corrected::list_for_part(list);
    }
    auto first_corner_depth(const auto& kernel) const {
        return has(Deviation::x_w2) ? Printed::first_corner_depth(kernel) : Corrected::first_corner_depth(kernel);
    }
    bool discards(bool surrounding, bool outside) const {
        return has(Deviation::x_w1) ? Printed::discards(surrounding, outside)
                                    : Corrected::discards(surrounding, outside);
    }
    bool uncovers(int k) const {
        if (has(Deviation::x_w3)) return Printed::uncovers(k);
        return has(Deviation::surround_kept) ? mistakes::SurroundKept::uncovers(k) : Corrected::uncovers(k);
    }
    auto corners_around(const auto& kernel, const Window& window) const {
        return has(Deviation::clip_order_reversed) ? mistakes::ClipOrderReversed::corners_around(kernel, window)
                                                   : Corrected::corners_around(kernel, window);
    }
    bool opposite(const auto& kernel, const auto& p, const auto& q) const {
        return has(Deviation::x_w7) ? Printed::opposite(kernel, p, q) : Corrected::opposite(kernel, p, q);
    }
    bool surround_test(auto& run, const auto& point, const auto& polygon) const {
        if (has(Deviation::x_w4)) return Printed::surround_test(run, point, polygon);
        return has(Deviation::boundary_outside) ? mistakes::BoundaryOutside::surround_test(run, point, polygon)
                                                : AnyMethod::surround_test(run, point, polygon);
    }
    auto depth(auto& run, const auto& polygon, const auto& point) const {
        if (has(Deviation::x_w6)) expect_depth(run.kernel, polygon.plane);
        return has(Deviation::depth_sign_reversed) ? mistakes::DepthSignReversed::depth(run, polygon, point)
                                                   : AnyMethod::depth(run, polygon, point);
    }
    auto initialize_polygon(auto& run, const auto& vertices) const {
        return has(Deviation::x_w6) ? Printed::initialize_polygon(run, vertices)
                                    : Corrected::initialize_polygon(run, vertices);
    }
    auto on_screen(const auto& kernel, const Area& area, const glm::dvec3& vertex) const {
        return has(Deviation::y_flipped) ? mistakes::YFlipped::on_screen(kernel, area, vertex)
                                         : Corrected::on_screen(kernel, area, vertex);
    }

    /// A plane of three collinear vertices has no depth. As printed, the polygon does not take part, since its c is 0.
    static void expect_depth(const auto& kernel, const auto& plane) {
        try {
            kernel.divide(plane.d, plane.c);
        } catch (const DivisionByZero&) {
            throw Fault{Line::D1, "division by zero"};
        }
    }

    // The Warnock family

    int crossings_at_vertex(bool touches) const {
        return has(Deviation::vertex_counted_twice) ? mistakes::VertexCountedTwice::crossings_at_vertex(touches)
                                                    : family::Full::crossings_at_vertex(touches);
    }
    bool needs_split(int difference) const {
        return has(Deviation::octants_not_split) ? mistakes::OctantsNotSplit::needs_split(difference)
                                                 : family::Full::needs_split(difference);
    }
    bool ends_before(const auto& from, const auto& to, const auto& upper_left, const auto& lower_right) const {
        return has(Deviation::line_for_edge) ? mistakes::LineForEdge::ends_before(from, to, upper_left, lower_right)
                                             : family::Full::ends_before(from, to, upper_left, lower_right);
    }

    // The Z-buffer

    /// With all of its defects the Z-buffer is the printed text.
    void z_buffer(auto& run) const {
        using enum Deviation;
        constexpr Edition all = Edition(x_z1) + x_z2 + x_z3 + x_z4 + x_z5 + x_z6 + x_z7;
        edition.has(all) ? Printed::z_buffer(run) : Corrected::z_buffer(run);
    }
    auto scanline(const auto& kernel, const auto& polygon, int row) const {
        return has(Deviation::x_z6) ? ZBufferDefects::scanline(kernel, polygon, row)
                                    : Corrected::scanline(kernel, polygon, row);
    }
    int row_after(const auto& kernel, const auto& y, int top, int bottom) const {
        return has(Deviation::x_z1) ? ZBufferDefects::row_after(kernel, y, top, bottom)
                                    : Corrected::row_after(kernel, y, top, bottom);
    }
    int rows_end(const Area& area) const {
        return has(Deviation::x_z3) ? ZBufferDefects::rows_end(area) : Corrected::rows_end(area);
    }
    auto first_depth(const auto& kernel) const {
        if (has(Deviation::x_z7)) return ZBufferDefects::first_depth(kernel);
        return has(Deviation::depths_not_cleared) ? mistakes::DepthsNotCleared::first_depth(kernel)
                                                  : Corrected::first_depth(kernel);
    }
    /// In the printed Z-buffer y is a number; in the corrected one it is a row.
    template <class Row>
    void show_line(auto& run, const Row& row, const auto& from, const auto& to, const auto& polygon) const {
        if constexpr (!std::is_integral_v<Row>) {
            Printed::show_line(run, row, from, to, polygon);
        } else if (has(Deviation::x_z3)) {
            ZBufferDefects::show_line(run, row, from, to, polygon);
        } else {
            Corrected::show_line(run, row, from, to, polygon);
        }
    }
    bool misses(int first, int end) const {
        return has(Deviation::x_z2) ? ZBufferDefects::misses(first, end) : Corrected::misses(first, end);
    }
    auto slope_of_point(const auto& kernel, const auto& left, const auto& right) const {
        return has(Deviation::x_z4) ? ZBufferDefects::slope_of_point(kernel, left, right)
                                    : Corrected::slope_of_point(kernel, left, right);
    }
    auto start_of(const auto& run, const auto& left, int column) const {
        return has(Deviation::x_z5) ? ZBufferDefects::start_of(run, left, column)
                                    : Corrected::start_of(run, left, column);
    }
    std::pair<int, int> columns_shown(const auto& run, int row, const auto& left, const auto& right,
                                      const auto& polygon) const {
        if (has(Deviation::x_z5)) return ZBufferDefects::columns_shown(run, row, left, right, polygon);
        return has(Deviation::boundary_outside)
                   ? mistakes::BoundaryOutside::columns_shown(run, row, left, right, polygon)
                   : Corrected::columns_shown(run, row, left, right, polygon);
    }
    bool shows(const auto& kernel, const auto& depth, const auto& stored, const Pixel& pixel) const {
        return has(Deviation::x_z7) ? ZBufferDefects::shows(kernel, depth, stored, pixel)
                                    : Corrected::shows(kernel, depth, stored, pixel);
    }
};

}  // namespace vidno
