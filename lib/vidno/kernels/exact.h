/// Exact rationals: every decision is right for the doubles of the scene. The reference of all other kernels.
#pragma once

#include <CGAL/Exact_rational.h>
#include <CGAL/Fraction_traits.h>

#include <sstream>
#include <string>

#include "number_kernel.h"

namespace vidno {

using Rational = CGAL::Exact_rational;

struct Exact : NumberKernel<Rational> {
    static constexpr std::string_view name = "exact";

    bool same_rounded(const Rational& v, const Rational& w) const {
        const Rational half(0.5);
        return floor(Rational(v + half)) == floor(Rational(w + half));
    }

    /// "p/q" in lowest terms, q > 0.
    static std::string fraction(const Rational& value) {
        auto [p, q] = parts(value);
        const Integer divisor = CGAL::gcd(p, q);
        std::ostringstream text;
        text << Integer(p / divisor) << '/' << Integer(q / divisor);
        return text.str();
    }

private:
    using Fractions = CGAL::Fraction_traits<Rational>;
    using Integer = Fractions::Numerator_type;

    /// Numerator and denominator, the latter positive.
    static std::pair<Integer, Integer> parts(const Rational& value) {
        Integer p, q;
        Fractions::Decompose()(value, p, q);
        if (q < 0) {
            p = -p;
            q = -q;
        }
        return {p, q};
    }

    static Integer floor(const Rational& value) {
        const auto [p, q] = parts(value);
        const Integer quotient = p / q;  // towards zero
        return Integer(quotient * q) > p ? Integer(quotient - 1) : quotient;
    }
};

}  // namespace vidno
