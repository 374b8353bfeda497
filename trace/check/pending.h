/// Pending: the decisions taken since the last event, kept until the event that reports them or is the first after
/// them.
#pragma once

#include <algorithm>
#include <functional>
#include <iterator>
#include <utility>
#include <vector>

#include "format/event_sink.h"

namespace vidno {

/// `T` has the decision as `of`.
template <class T>
class Pending {
public:
    void add(T decision) { all_.push_back(std::move(decision)); }

    /// The decisions of this event, in order. ShowLine finds its columns before it reports the slope, and reports them
    /// after it.
    std::vector<T> reported_by(const EventView& event) {
        if (all_.empty() || !event.get_if<event::Slope>()) return rest();
        const auto waits = [](const T& each) {
            return each.of == Decision::first_centre || each.of == Decision::last_centre;
        };
        const auto waiting = std::stable_partition(all_.begin(), all_.end(), std::not_fn(waits));
        std::vector<T> later(std::make_move_iterator(waiting), std::make_move_iterator(all_.end()));
        all_.erase(waiting, all_.end());
        return std::exchange(all_, std::move(later));
    }
    /// The decisions that no event follows.
    std::vector<T> rest() { return std::exchange(all_, {}); }

private:
    std::vector<T> all_;
};

}  // namespace vidno
