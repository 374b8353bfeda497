/// PixelBlock: eight pixels of a row that are compared at once, as two vectors of four numbers. GCC and clang compile
/// such vectors for every machine.
#pragma once

#include <bit>
#include <cstring>

namespace vidno {

struct PixelBlock {
    static constexpr int pixels = 8;

    using Floats [[gnu::vector_size(16)]] = float;
    using Ints [[gnu::vector_size(16)]] = int;  // as a mask: 0 or all bits

    static bool any(const Ints& mask) {
        using Longs [[gnu::vector_size(16)]] = long long;
        const auto halves = std::bit_cast<Longs>(mask);
        return (halves[0] | halves[1]) != 0;
    }

    template <class Values>
    static Values loaded(const void* from) {
        Values values;
        std::memcpy(&values, from, sizeof values);
        return values;
    }

    /// Stores the values where the mask is set, and the others elsewhere.
    static void store_where(const Ints& mask, const Ints& values, const Ints& others, void* to) {
        const Ints chosen = (values & mask) | (others & ~mask);
        std::memcpy(to, &chosen, sizeof chosen);
    }
};

}  // namespace vidno
