/// InsertionSort: stable, and the same comparisons on every machine.
///
/// With rounded numbers a < b < c < a may hold, and NaN may occur. The standard library's sorts require an order, and
/// each library compares in its own sequence. This sort always makes the same comparisons, with the same result.
#pragma once

#include <algorithm>
#include <iterator>
#include <vector>

namespace vidno {

/// `before(a, b)`: whether a must be before b. It makes about one comparison per item if the items are in order, and at
/// most one per pair.
template <class Item>
void insertion_sort(std::vector<Item>& items, auto before) {
    for (auto item = items.begin(); item != items.end(); ++item) {
        auto place = item;
        while (place != items.begin() && before(*item, *std::prev(place))) --place;
        std::rotate(place, item, std::next(item));
    }
}

}  // namespace vidno
