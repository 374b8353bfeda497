/// InsertionSort: stable, and the same comparisons on every machine.
///
/// Rounded numbers may say a < b < c < a, or be no numbers. The standard library's sorts must not be asked to order such, and
/// each of them compares others first; what is compared here, and what comes of it, is always the same.
#pragma once

#include <algorithm>
#include <iterator>
#include <vector>

namespace vidno {

/// `before(a, b)`: whether a must be before b. As many comparisons as items if they are in order, else as pairs at most.
template <class Item>
void insertion_sort(std::vector<Item>& items, auto before) {
    for (auto item = items.begin(); item != items.end(); ++item) {
        auto place = item;
        while (place != items.begin() && before(*item, *std::prev(place))) --place;
        std::rotate(place, item, std::next(item));
    }
}

}  // namespace vidno
