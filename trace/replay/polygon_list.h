/// PolygonList: a list of active polygons. Copies share the entries until one of them changes.
#pragma once

#include <algorithm>
#include <iterator>
#include <memory>
#include <vector>

#include "format/event.h"
#include "replay/call_stack.h"

namespace vidno {

class PolygonList {
public:
    explicit PolygonList(std::vector<AplEntry> entries = {})
        : shared_(std::make_shared<List>(List{std::move(entries)})) {}

    std::vector<AplEntry> entries() const {
        std::vector<AplEntry> left;
        left.reserve(shared_->entries.size() - shared_->removed);
        const auto& all = shared_->entries;
        std::copy_if(all.begin(), all.end(), std::back_inserter(left), is_left);
        return left;
    }
    bool empty() const { return shared_->entries.size() == shared_->removed; }

    // These throw Impossible for a polygon that is not in the list.
    void mark(PolygonPlace polygon) { find(polygon)->second = true; }
    void remove(PolygonPlace polygon) {
        find(polygon)->first.index = gone;
        ++shared_->removed;
    }

    /// Puts a polygon at its place in the order of the scene.
    void insert(PolygonPlace polygon) {
        *this = PolygonList(entries());
        auto& all = shared_->entries;
        const auto is_before = [](const AplEntry& entry, int index) { return entry.first.index < index; };
        all.insert(std::lower_bound(all.begin(), all.end(), polygon.index, is_before), {polygon, false});
    }

    /// Whether both are copies of one list and have not changed since.
    bool operator==(const PolygonList&) const = default;

private:
    static constexpr int gone = -1;  // in place of the index of a removed polygon
    struct List {
        std::vector<AplEntry> entries;
        std::size_t removed = 0;
        std::size_t last = 0;  // the place that was found last: a procedure goes through its list in order
    };

    static bool is_left(const AplEntry& entry) { return entry.first.index != gone; }

    /// The entry of a polygon, to be changed.
    std::vector<AplEntry>::iterator find(PolygonPlace polygon) {
        if (shared_.use_count() > 1) *this = PolygonList(entries());
        auto& [all, removed, last] = *shared_;
        const auto is_it = [&](const AplEntry& entry) { return entry.first == polygon; };
        const auto middle = all.begin() + std::ptrdiff_t(std::min(last, all.size()));
        auto found = std::find_if(middle, all.end(), is_it);
        if (found == all.end()) {
            found = std::find_if(all.begin(), middle, is_it);
            if (found == middle) throw Impossible{"a polygon that is not in the current APL"};
        }
        last = std::size_t(found - all.begin());
        return found;
    }

    std::shared_ptr<List> shared_;
};

}  // namespace vidno
