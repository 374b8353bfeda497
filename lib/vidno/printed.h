/// Printed: the procedures as the course text prints them, errors and losses of the scan included.
///
/// Each difference bears the id under which `trace/listings` and the lessons speak of it. What has no integer meaning in
/// the text is fixed so: a fractional (x, y) is the pixel that holds it, a fractional window has the pixels whose
/// centres lie in its half-open rectangle. A run always ends: where the text reads past a list, divides by zero in numbers
/// without infinities, or would step for ever, it ends with a fault.
#pragma once

#include "corrected.h"
#include "printed/initialize_polygon.h"
#include "printed/show_line.h"
#include "printed/surround_test.h"
#include "printed/z_buffer.h"

namespace vidno {

/// A kernel under which the printed text runs: one whose decisions may be wrong, or the reference.
template <class K>
concept PrintedKernel = Kernel<K> && requires(const K& kernel, const typename K::Number& number) {
    kernel.depth_of(number);
    kernel.divide(number, number);
    kernel.same_rounded(number, number);
    kernel.pixel_of(number);
};

struct Printed : Corrected {
    static constexpr std::string_view name = "printed";

    /// X-W8: c as computed decides what is edge-on.
    static bool takes_part(const auto&, const auto& polygon) { return polygon.plane.c != 0; }

    /// X-W5: an area of any size is halved, so that windows end inside pixels.
    static Window root_window(const Area& area) { return whole_area(area); }

    /// X-W9: that a part gets a copy is left unsaid: all windows share one list.
    template <class List>
    static std::shared_ptr<List> list_for_part(const std::shared_ptr<List>& list) {
        return list;
    }

    /// X-W2: depths below 0 are never nearer.
    static auto first_corner_depth(const auto& kernel) { return kernel.depth_of(0); }

    /// X-W1: a "not" is lost: surrounding polygons leave, others never.
    static bool discards(bool surrounding, bool outside) { return surrounding && outside; }

    /// X-W3: a polygon nearest at all corners that does not surround the window leaves the one before it in force.
    static bool uncovers(int k) { return 0 < k && k < 4; }

    /// X-W7: the product of two small numbers underflows to 0.
    static bool opposite(const auto&, const auto& p, const auto& q) { return p * q < 0; }

    /// X-H3: the sides of the screen, 0 and its height in the text, where y grows upward. Beyond one, the higher may be hidden.
    template <class K>
    static Horizons<K> first_horizons(const K& kernel, const Area& area) {
        return {{area, kernel.number(area.bottom())}, {area, kernel.number(area.y)}};
    }

    /// X-H4: a curve is compared with what it has raised itself, and meets its own side edge.
    static const auto& horizons_before(const auto& horizons, auto& /*kept*/) { return horizons; }
    static std::pair<int, int> edge_columns(const Segment& edge) { return std::minmax({edge.from.x, edge.to.x}); }

    /// X-H5: what stands between two samples is not seen.
    static int next_column(const Segment& segment, int) { return segment.to.x; }

    /// X-H6: a point on both horizons has the flag of one.
    static VisibilityFlag flag_on_both() { return VisibilityFlag::above; }

    /// X-H1: the minus is lost in the test for -1, and in the edges' start value -1.
    static bool draws(VisibilityFlag side) { return side == VisibilityFlag::above; }
    static bool no_edge_yet(const std::optional<Sample>& edge) { return !edge || edge->x == 1; }

    /// X-H2: what emerges below is cut by the upper horizon.
    static VisibilityFlag horizon_met(VisibilityFlag was, VisibilityFlag is) {
        return was == VisibilityFlag::hidden ? VisibilityFlag::above : is;
    }

    static auto initialize_polygon(auto& run, const auto& vertices) {
        return printed::InitializePolygon::initialize_polygon(run, vertices);
    }
    static bool surround_test(auto& run, const auto& point, const auto& polygon) {
        return printed::SurroundTest::surround_test(run, point, polygon);
    }
    static void z_buffer(auto& run) { printed::ZBuffer::z_buffer(run); }
    static void show_line(auto& run, const auto& y, const auto& from, const auto& to, const auto& polygon) {
        printed::ShowLine::show_line(run, y, from, to, polygon);
    }
};

}  // namespace vidno
