/// Rules: by which texts of the procedures a recorded run differs from the corrected one. An edition is a set of rules.
#pragma once

#include <cstdint>

#include "choice/edition.h"

namespace vidno {

/// The defects of the printed text (vidno/printed.h). A usual mistake (vidno/mistakes/) is a rule under the name of its edition.
enum class Rule : unsigned char {
    x_w1,
    x_w2,
    x_w3,
    x_w4,
    x_w5,
    x_w6,
    x_w7,
    x_w8,
    x_w9,
    x_z,  // ZBuffer and ShowLine as a whole
    x_h1,
    x_h2,
    x_h3,
    x_h4,
    x_h5,
    x_h6
};

class Rules {
public:
    constexpr bool has(Rule defect) const { return has(bit_of(defect)); }
    constexpr bool has(Edition mistake) const { return has(bit_of(mistake)); }
    constexpr void add(Rule defect) { bits_ |= bit_of(defect); }
    constexpr void add(Edition mistake) { bits_ |= bit_of(mistake); }

private:
    using Bits = std::uint32_t;

    static constexpr unsigned defects = unsigned(Rule::x_h6) + 1;
    static_assert(defects + edition_choices.size() <= 32);

    static constexpr Bits bit_of(Rule defect) { return Bits{1} << unsigned(defect); }
    static constexpr Bits bit_of(Edition mistake) { return Bits{1} << (defects + unsigned(mistake)); }
    constexpr bool has(Bits bit) const { return (bits_ & bit) != 0; }

    Bits bits_ = 0;
};

constexpr Rules rules_of(Edition edition) {
    Rules rules;
    if (edition == Edition::printed) {
        for (auto defect = Rule::x_w1; defect <= Rule::x_h6; defect = Rule(unsigned(defect) + 1)) rules.add(defect);
    } else if (is_mistake(edition)) {
        rules.add(edition);
    }
    return rules;
}

}  // namespace vidno
