/// Printed: Warnock's algorithm and the Z-buffer as the course text prints them, with its errors and the losses of the
/// scan.
///
/// Each difference has the id that `trace/listings` and the lessons use. Where the text gives fractions no meaning in
/// pixels, we choose one: a fractional (x, y) is the pixel that holds it, a fractional window has the pixels whose
/// centres lie in its half-open rectangle. A run always ends: where the text reads past a list, divides by zero in
/// numbers without infinities, or would step forever, the run ends with a fault.
#pragma once

#include "corrected.h"
#include "printed/initialize_polygon.h"
#include "printed/show_line.h"
#include "printed/surround_test.h"
#include "printed/z_buffer.h"

namespace vidno {

struct Printed : Corrected {
    static constexpr std::string_view name = "printed";

    /// X-W8: c as computed decides what is edge-on.
    static bool takes_part(const auto&, const auto& polygon) { return polygon.plane.c != 0; }

    /// X-W5: an area of any size is halved, so that windows end inside pixels.
    static Window root_window(const Area& area) { return whole_area(area); }

    /// X-W9: the text does not say that a part gets a copy, so all windows share one list.
    template <class List>
    static std::shared_ptr<List> list_for_part(const std::shared_ptr<List>& list) {
        return list;
    }

    /// X-W2: depths below 0 are never nearer.
    static auto first_corner_depth(const auto& kernel) { return kernel.depth_of(0); }

    /// X-W1: a "not" is lost: surrounding polygons leave, others never.
    static bool discards(bool surrounding, bool outside) { return surrounding && outside; }

    /// X-W3: a polygon that is nearest at all corners does not reset hasSurround, even if it does not surround the
    /// window.
    static bool uncovers(int k) { return 0 < k && k < 4; }

    /// X-W7: the product of two small numbers underflows to 0.
    static bool opposite(const auto&, const auto& p, const auto& q) { return p * q < 0; }

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
