/// Value: a number of a kernel as a trace holds it.
#pragma once

#include <limits>
#include <memory>
#include <string>
#include <utility>

#include "json/json_text.h"

namespace vidno {

/// A double (a float is one too), or a fraction "p/q" of the exact kernel.
struct Value {
    double number = 0;
    std::shared_ptr<const std::string> fraction;  // none: the number counts

    Value() = default;
    Value(double value) : number(value) {}
    explicit Value(std::string text) : fraction(std::make_shared<const std::string>(std::move(text))) {}

    static Value infinite() { return {std::numeric_limits<double>::infinity()}; }
    static Value minus_infinite() { return {-std::numeric_limits<double>::infinity()}; }

    /// Equality as written: NaN equals itself, -0 equals 0.
    bool operator==(const Value& other) const {
        if (fraction || other.fraction) return fraction && other.fraction && *fraction == *other.fraction;
        return number == other.number || (number != number && other.number != other.number);
    }
};

/// The number itself; for a fraction the nearest double, up to its last digits; for x/0, NaN.
double number_of(const Value& value);

/// A number of the kernel K.
template <class K>
Value as_value(const auto& number) {
    if constexpr (requires { K::reported(number); }) {
        return K::reported(number);
    } else if constexpr (K::has_infinity) {
        return {double(number)};
    } else {
        return Value(K::fraction(number));
    }
}

struct ValuePoint {
    Value x, y;
    bool operator==(const ValuePoint&) const = default;
};

struct ValueVertex {
    Value x, y, z;
    bool operator==(const ValueVertex&) const = default;
};

}  // namespace vidno
