// Where a listed decision is: the pixels that the list names, against the row or the column that the decision's own
// event has.

#include <doctest/doctest.h>

#include <map>
#include <set>

#include "check/check.h"
#include "choice/method.h"
#include "support/scenes.h"

using namespace vidno;
using namespace vidno::test;

namespace {

/// The findings of a run, and the event at each step.
struct Listed {
    std::vector<Finding> findings;
    std::map<std::uint64_t, Event> events;
};

Listed listed(const AdmittedScene& scene, Method method, const std::string& kernel) {
    Listed found;
    FindingList list(choice_of(method).procedure, scene->area, 50);
    std::uint64_t step = 0;
    const RunRequest request{method, *kernel_named(kernel), Edition::corrected, scene};
    check_run(
        request, right_picture(scene, method),
        [&](const EventView& event) { found.events.emplace(++step, event.copy()); }, &list);
    found.findings = list.findings();
    return found;
}

}  // namespace

TEST_CASE("A row of FillPolygon is listed as a row") {
    // The triangle (1, 1.5) (5, 1.5) (3, 6.5) has its upper edge on the centres of row 1 and its lowest vertex on those
    // of row 6. The two gaps are equal, and the list names the first.
    const AdmittedScene scene = SceneBuilder({0, 0, 8, 8}).polygon({{1, 1.5, 0}, {5, 1.5, 0}, {3, 6.5, 0}}).build();
    for (const std::string kernel : {"exact", "double", "filtered"}) {
        CAPTURE(kernel);
        std::set<int> rows;
        for (const auto& each : listed(scene, Method::warnock, kernel).findings) {
            if (each.decision.of != Decision::rows) continue;
            CHECK(each.pixels == PixelRectangle{0, each.pixels.y, 8, 1});
            rows.insert(each.pixels.y);
        }
        CHECK(rows == std::set<int>{1});
    }
}

TEST_CASE("Every kind of decision: the pixels listed hold those that its event names") {
    // What an event names of itself: a pixel, a row, a column, the point whose pixel is decided.
    std::map<Decision, std::size_t> kinds;
    RandomPolygons random(std::mt19937(8));
    for (int trial = 0; trial < 48 / thinning; ++trial) {
        const AdmittedScene scene = random_scene(families[std::size_t(trial) % families.size()], random);
        const Area& area = scene->area;
        for (std::size_t place = 0; place < method_names.size(); ++place) {
            const auto method = Method(place);
            if (refusal_of(method, scene)) continue;
            for (const std::string kernel : {"float", "double", "bits:6", "exact"}) {
                if (!kernel_named(kernel)->choice->runs(method, Edition::corrected)) continue;
                CAPTURE(method_names[place]);
                CAPTURE(kernel);
                CAPTURE(trial);
                const Listed found = listed(scene, method, kernel);
                for (const Finding& each : found.findings) {
                    const PixelRectangle& pixels = each.pixels;
                    const bool is_within = pixels.x >= area.x && pixels.y >= area.y &&
                                           pixels.x + pixels.width <= area.right() &&
                                           pixels.y + pixels.height <= area.bottom();
                    CHECK(is_within);
                    ++kinds[each.decision.of];
                    const auto event = found.events.find(each.step);
                    if (event == found.events.end()) continue;  // after the last one
                    CAPTURE(int(each.decision.of));
                    if (each.decision.of == Decision::rows) {
                        CHECK(pixels.width == area.width);
                    } else if (const auto* row = event->second.get_if<event::Row>()) {
                        CHECK(pixels.y == row->row);
                        CHECK(pixels.height == 1);
                    } else if (const auto* pixel = event->second.get_if<event::Pixel>()) {
                        CHECK(pixels == PixelRectangle{pixel->x, pixel->y, 1, 1});
                    } else if (const auto* order = event->second.get_if<event::Order>()) {
                        CHECK(pixels == PixelRectangle{int(std::floor(number_of(order->point.x))),
                                                       int(std::floor(number_of(order->point.y))), 1, 1});
                    }
                }
            }
        }
    }
    using enum Decision;
    for (const Decision of :
         {comparison, orientation, nearer, outside, inside, first_centre, last_centre, rows, columns}) {
        CAPTURE(int(of));
        CHECK(kinds[of] > 0);
    }
}
