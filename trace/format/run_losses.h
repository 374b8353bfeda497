/// RunLosses: what a run loses, as its events tell it: its faults, and what it could not decide because numbers left
/// their range.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "format/event.h"
#include "format/event_text.h"
#include "loss.h"

namespace vidno {

/// A write outside the area does not end a run, nor does an outline that is left out because it does not close.
bool ends_run(const event::Fault& fault);

class RunLosses {
public:
    /// A run under a kernel that is always right decides exactly, however large its approximations become.
    explicit RunLosses(std::string_view kernel);

    /// Hears every event of one level; it counts the steps itself.
    void hear(const EventView& event);

    bool any() const { return !found_.empty(); }

    /// The first ones one by one, and how many follow. `names` are the polygons of the scene.
    std::vector<Loss> all(const PolygonNames& names) const;

private:
    struct Found {
        std::uint64_t step;
        Line at;
        std::string what;
        std::vector<PolygonPlace> polygons;
        std::string elsewhere;  // a pixel or a curve
    };

    void add(Found found);
    void hear(const event::Fault& fault);
    /// The faults of a clip come before the event that names the polygon that was clipped.
    void settle(PolygonPlace polygon);

    bool is_always_right_;
    std::uint64_t steps_ = 0;
    std::vector<Found> found_;
    std::uint64_t more_ = 0;
    std::size_t settled_ = 0;            // the number of losses whose polygon is settled
    std::vector<PolygonPlace> at_hand_;  // the polygon that is scanned, or in which a point is sought
    int curve_ = 0;                      // the current one
    std::vector<PolygonPlace> pierced_;  // the two that pierce each other
};

}  // namespace vidno
