#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

namespace std {

namespace {

/// Prints into a buffer first, since printf adds a zero byte for which there may be no room.
char* write_printed(char* to, const char* format, auto value) {
    char text[32];
    return copy_n(text, snprintf(text, sizeof text, format, value), to);
}

/// digits * 10^exponent, as d.ddde+xx. The exponent has two digits at least.
char* write_scientific(char* to, string_view digits, int exponent) {
    *to++ = digits[0];
    if (digits.size() > 1) {
        *to++ = '.';
        to = copy(digits.begin() + 1, digits.end(), to);
    }
    return write_printed(to, "e%+03d", exponent + int(digits.size()) - 1);
}

/// With a negative exponent: as ddd.ddd or 0.00ddd.
char* write_fraction(char* to, string_view digits, int exponent) {
    const int before_point = int(digits.size()) + exponent;
    if (before_point > 0) {
        to = copy_n(digits.begin(), before_point, to);
        *to++ = '.';
        return copy(digits.begin() + before_point, digits.end(), to);
    }
    to = copy_n("0.", 2, to);
    to = fill_n(to, -before_point, '0');
    return copy(digits.begin(), digits.end(), to);
}

}  // namespace

/// The digits come from a library, Dragonbox; the standard defines their layout.
to_chars_result to_chars(char* first, [[maybe_unused]] char* last, double value) {
    assert(isfinite(value) && last - first >= 24);
    if (signbit(value)) *first++ = '-';
    if (value == 0) {
        *first++ = '0';
        return {first, errc{}};
    }
    const auto [significand, exponent] = fmt::detail::dragonbox::to_decimal(abs(value));
    char room[20];
    const string_view digits(room, size_t(to_chars(room, room + sizeof room, significand).ptr - room));
    // Fixed notation has leading or trailing zeros where scientific notation has a point and an exponent.
    const int point = digits.size() > 1 ? 1 : 0;
    if (exponent > 4 + point || exponent < -int(digits.size()) - 2 - point) {
        return {write_scientific(first, digits, exponent), errc{}};
    }
    // A whole number is written with all digits, including those that reading back does not need.
    if (exponent >= 0) return {write_printed(first, "%.0f", abs(value)), errc{}};
    return {write_fraction(first, digits, exponent), errc{}};
}

to_chars_result to_chars(char* first, [[maybe_unused]] char* last, double value, [[maybe_unused]] chars_format format) {
    assert(format == chars_format::fixed && isfinite(value) && last - first >= 400);
    if (signbit(value)) *first++ = '-';
    if (value == 0) {
        *first++ = '0';
        return {first, errc{}};
    }
    const auto [significand, exponent] = fmt::detail::dragonbox::to_decimal(abs(value));
    // A whole number is written with all digits, including those that reading back does not need.
    if (exponent >= 0) return {first + snprintf(first, size_t(last - first), "%.0f", abs(value)), errc{}};
    char room[20];
    const string_view digits(room, size_t(to_chars(room, room + sizeof room, significand).ptr - room));
    return {write_fraction(first, digits, exponent), errc{}};
}

to_chars_result to_chars(char* first, char* last, double value, chars_format format, int precision) {
    const char* written = format == chars_format::fixed ? "%.*f" : "%.*e";
    const int size = snprintf(first, size_t(last - first), written, precision, value);
    if (size >= last - first) return {last, errc::value_too_large};
    return {first + size, errc{}};
}

from_chars_result from_chars(const char* first, const char* last, double& value) {
    const auto [end, error] = fast_float::from_chars(first, last, value);
    return {end, isinf(value) ? errc::result_out_of_range : error};
}

from_chars_result from_chars(const char* first, const char* last, double& value, [[maybe_unused]] chars_format format) {
    assert(format == chars_format::hex);
    const string text = "0x" + string(first, last);
    char* end = nullptr;
    // Not strtod, which rounds twice if the double is subnormal. 113 bits hold the written number, and are rounded
    // once.
    const auto read = double(strtold(text.c_str(), &end));
    const auto length = end - text.c_str() - 2;
    if (length <= 0) return {first, errc::invalid_argument};
    const bool is_zero = text.find_first_not_of("0.", 2) >= min(text.find_first_of("pP"), size_t(end - text.c_str()));
    if (isinf(read) || (read == 0 && !is_zero)) return {first + length, errc::result_out_of_range};
    value = read;
    return {first + length, errc{}};
}

}  // namespace std
