/// The text of rational numbers.
#pragma once

#include <string>

#include "format/event_fields.h"
#include "vidno/kernels/exact.h"

namespace vidno {

/// The number of a text "p/q", or of a whole number. None of another text, or if q is 0.
inline std::optional<Rational> rational_in(const std::string& text) {
    using Fractions = CGAL::Fraction_traits<Rational>;
    const auto slash = text.find('/');
    const bool is_number = is_fraction(slash == text.npos ? text + "/1" : text);
    if (!is_number) return std::nullopt;
    const Fractions::Numerator_type p(text.substr(0, slash));
    const Fractions::Denominator_type q(slash == text.npos ? "1" : text.substr(slash + 1));
    return q == 0 ? std::nullopt : std::optional<Rational>(Fractions::Compose()(p, q));
}

}  // namespace vidno
