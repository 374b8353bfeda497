/// RememberedShortest: numbers in their shortest form, with a cache, since a trace repeats most of its numbers.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "json/json_text.h"

namespace vidno {

class RememberedShortest {
public:
    /// As append_number writes it.
    void append(auto& out, double value) {
        if (const Half* half = this->half(value)) {
            out.put(half->size(), [&](char* to) {
                std::memcpy(to, half->data(), half->size());  // all: a copy of fixed size is quick
                return to + half->back();
            });
        } else {
            append_number(out, value, *this);
        }
    }

    char* operator()(char* to, double value) {
        Known& known = known_[hash(value)];
        if (!(known.value == value)) {
            known.value = value;
            known.size = std::size_t(Shortest{}(known.text.data(), value) - known.text.data());
        }
        std::memcpy(to, known.text.data(), known.text.size());  // all, as above
        return to + known.size;
    }

private:
    struct Known {
        double value = std::numeric_limits<double>::quiet_NaN();
        std::size_t size = 0;
        std::array<char, longest_number> text;
    };
    static constexpr int index_bits = 10;

    static std::size_t hash(double value) {
        constexpr std::uint64_t golden_ratio = 0x9e3779b97f4a7c15;  // Fibonacci hashing: the product's upper bits
        return (std::bit_cast<std::uint64_t>(value) * golden_ratio) >> (64 - index_bits);
    }

    /// At most six bytes of text. The last byte is their number; 0: not known yet.
    using Half = std::array<char, 8>;

    /// The text of a multiple of 1/2 below 1024; null for other numbers. Most numbers of a trace are whole pixels and
    /// their centres.
    const Half* half(double value) {
        const double twice = 2 * value;
        if (!(0 <= twice && twice < double(2 * halves_end))) return nullptr;
        const int place = int(twice);
        if (twice != place) return nullptr;
        Half& half = halves_[std::size_t(place)];
        if (half.back() == 0) learn(half, value);
        return &half;
    }
    [[gnu::noinline]] static void learn(Half& half, double value) {
        std::array<char, longest_number> text;
        char* const end = Shortest{}(text.data(), std::abs(value));  // -0 is written as 0
        std::copy(text.data(), end, half.data());
        half.back() = char(end - text.data());
    }

    static constexpr std::size_t halves_end = 1024;

    std::vector<Known> known_{1 << index_bits};
    std::vector<Half> halves_ = std::vector<Half>(2 * halves_end);
};

}  // namespace vidno
