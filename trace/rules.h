/// Rules: by which texts of the procedures a recorded run differs from the corrected one. An edition is a set of rules.
#pragma once

#include <cstdint>
#include <initializer_list>

#include "edition.h"

namespace vidno {

/// The defects of the printed text (vidno/printed.h), and the usual mistakes (vidno/mistakes.h).
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
    x_h6,
    one_list,
    depths_not_cleared,
    clip_order_reversed,
    y_flipped,
    depth_sign_reversed,
    boundary_outside,
    integer_division,
    surround_kept,
    vertex_counted_twice,
    octants_not_split,
    line_for_edge
};

class Rules {
public:
    constexpr Rules() = default;
    constexpr Rules(std::initializer_list<Rule> rules) {
        for (const Rule rule : rules) add(rule);
    }

    constexpr bool has(Rule rule) const { return (bits_ >> unsigned(rule) & 1) != 0; }
    constexpr void add(Rule rule) { bits_ |= std::uint32_t{1} << unsigned(rule); }

private:
    std::uint32_t bits_ = 0;
};

constexpr Rules rules_of(Edition edition) {
    Rules rules;
    if (edition == Edition::printed) {
        for (auto rule = Rule::x_w1; rule <= Rule::x_h6; rule = Rule(unsigned(rule) + 1)) rules.add(rule);
    } else if (is_mistake(edition)) {
        const auto place =
            unsigned(edition) - unsigned(Edition::one_list);  // in both lists the mistakes have one order
        rules.add(Rule(unsigned(Rule::one_list) + place));
    }
    return rules;
}
static_assert(rules_of(Edition::line_for_edge).has(Rule::line_for_edge));

}  // namespace vidno
