#include "say/numbers.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

#include "format/event_fields.h"

namespace vidno::say {

namespace {

constexpr std::size_t short_enough = 7, most_in_sentence = 40;  // characters

/// A positive number: 0.digits times ten to the power of `point`. The last digit is not 0.
struct Decimal {
    std::string digits;
    int point = 0;
    bool operator==(const Decimal&) const = default;
};

/// Reads a number as to_chars writes it.
Decimal decimal_in(std::string_view text) {
    const auto e = text.find('e');
    Decimal read;
    if (e != text.npos) {
        const auto from = text.data() + e + (text[e + 1] == '+' ? 2 : 1);
        std::from_chars(from, text.data() + text.size(), read.point);
        text = text.substr(0, e);
    }
    const auto whole = std::min(text.find('.'), text.size());
    read.point += int(whole);
    for (const char each : text) {
        if (each != '.') read.digits += each;
    }
    const auto first = read.digits.find_first_not_of('0');
    if (first == read.digits.npos) return {"0", 1};
    read.point -= int(first);
    read.digits.erase(0, first);
    read.digits.erase(read.digits.find_last_not_of('0') + 1);
    return read;
}

/// The shortest decimal that reads back as the number.
Decimal shortest(double size) {
    std::array<char, 64> text;
    const auto end = std::to_chars(text.data(), text.data() + text.size(), size).ptr;
    return decimal_in({text.data(), std::size_t(end - text.data())});
}

/// Whether a whole number of these digits, divided by a power of ten, is exactly a double.
bool is_exact(const Decimal& decimal) {
    const int places = int(decimal.digits.size()) - decimal.point;
    if (places <= 0) return true;
    unsigned long long fives = 1, number = 0;
    for (const char digit : decimal.digits) number = 10 * number + unsigned(digit - '0');
    for (int i = 0; i < places && fives <= number; ++i) fives *= 5;
    return number % fives == 0;
}

/// The number with this many digits, halves rounded up.
Decimal rounded(double size, int digits) {
    const Decimal all = shortest(size);
    const bool is_half = int(all.digits.size()) == digits + 1 && all.digits.back() == '5' && is_exact(all);
    if (is_half) size = std::nextafter(size, HUGE_VAL);
    std::array<char, 64> text;
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), size, std::chars_format::scientific, digits - 1).ptr;
    return decimal_in({text.data(), std::size_t(end - text.data())});
}

/// One digit before the point and `digits` in all.
std::string with_power(const Decimal& decimal, std::size_t digits) {
    std::string text = decimal.digits;
    text.resize(std::max(digits, text.size()), '0');
    if (text.size() > 1) text.insert(1, ".");
    const int power = decimal.point - 1;
    return text + (power < 0 ? "e-" : "e+") + std::to_string(std::abs(power));
}

/// Without a power of ten where the number is neither very large nor very small.
std::string in_digits(const Decimal& decimal) {
    const auto& [digits, point] = decimal;
    const int count = int(digits.size());
    if (point > 21 || point < -5) return with_power(decimal, 0);
    if (point <= 0) return "0." + std::string(std::size_t(-point), '0') + digits;
    if (point >= count) return digits + std::string(std::size_t(point - count), '0');
    return digits.substr(0, std::size_t(point)) + "." + digits.substr(std::size_t(point));
}

/// The digits of a number that are shown.
struct Shown {
    std::string text;
    bool is_whole = true;  // they are all
};

/// If they are not all, there is room for `≈`.
Shown short_form(double value) {
    const std::string sign = value < 0 ? "-" : "";
    const double size = std::abs(value);
    const Decimal exact = shortest(size);
    const std::string whole = sign + in_digits(exact);
    if (whole.size() <= short_enough) return {whole};
    if (size < 1e-4 || size >= 1e6) {
        const Decimal few = rounded(size, 3);
        return {sign + with_power(few, 3), few == exact};
    }
    for (int digits = 4; digits > 1; --digits) {
        const Decimal few = rounded(size, digits);
        const std::string text = sign + in_digits(few);
        if (text.size() < short_enough) return {text, few == exact};
    }
    const Decimal few = rounded(size, 2);
    return {sign + (few.point > 2 ? with_power(few, 2) : in_digits(few)), few == exact};
}

std::string approximately(const std::string& text) { return "≈" + text; }

std::string with_infinity(std::string text) {
    const auto at = text.find("inf");
    return at == text.npos ? text : text.replace(at, 3, "∞");
}

std::string of_double(double value) {
    if (std::isnan(value)) return "nan";
    if (std::isinf(value)) return value < 0 ? "-∞" : "∞";
    const Shown shown = short_form(value);
    return shown.is_whole ? shown.text : approximately(shown.text);
}

std::string plain(const Value& value) {
    if (!value.fraction) return of_double(value.number);
    const std::string& text = *value.fraction;
    if (text.ends_with("inf")) return with_infinity(text);
    if (text.ends_with("/1")) return text.substr(0, text.size() - 2);
    if (text == "nan" || text.size() <= short_enough || text.ends_with("/0")) return text;
    return approximately(short_form(number_of(value)).text);
}

std::string whole(const Value& value) {
    if (value.fraction) return with_infinity(*value.fraction);
    if (!std::isfinite(value.number)) return of_double(value.number);
    return (value.number < 0 ? "-" : "") + in_digits(shortest(std::abs(value.number)));
}

/// The product of two whole numbers of decimal digits, the last digit first.
std::string product(std::string_view one, std::string_view other) {
    std::string digits(one.size() + other.size(), 0);
    for (std::size_t i = 0; i < one.size(); ++i) {
        int carry = 0;
        for (std::size_t j = 0; j < other.size() || carry > 0; ++j) {
            const int more =
                j < other.size() ? (one[one.size() - 1 - i] - '0') * (other[other.size() - 1 - j] - '0') : 0;
            const int sum = digits[i + j] + more + carry;
            digits[i + j] = char(sum % 10);
            carry = sum / 10;
        }
    }
    return digits;
}

Sign sign_of(int order) { return order < 0 ? Sign::negative : order > 0 ? Sign::positive : Sign::zero; }

Sign order_of_sizes(std::string one, std::string other) {
    const auto size = std::max(one.size(), other.size());
    one.resize(size, 0);
    other.resize(size, 0);
    std::reverse(one.begin(), one.end());
    std::reverse(other.begin(), other.end());
    return sign_of(one.compare(other));
}

struct Fraction {
    bool is_negative;
    std::string_view above, below;
};

std::optional<Fraction> fraction_in(const Value& value) {
    if (!value.fraction || !is_fraction(*value.fraction)) return std::nullopt;
    std::string_view text = *value.fraction;
    const bool is_negative = text.starts_with('-');
    if (is_negative) text.remove_prefix(1);
    const auto slash = text.find('/');
    const Fraction read{is_negative, text.substr(0, slash), text.substr(slash + 1)};
    if (read.below.find_first_not_of('0') == read.below.npos) return std::nullopt;
    return read;
}

Sign order_of_fractions(const Fraction& one, const Fraction& other) {
    const Sign sizes = order_of_sizes(product(one.above, other.below), product(other.above, one.below));
    const bool are_zero = one.above == "0" && other.above == "0";
    if (one.is_negative != other.is_negative && !are_zero) return one.is_negative ? Sign::negative : Sign::positive;
    return one.is_negative ? -sizes : sizes;
}

double double_of(const Value& value) {
    if (!value.fraction) return value.number;
    if (*value.fraction == "inf") return HUGE_VAL;
    if (*value.fraction == "-inf") return -HUGE_VAL;
    return is_fraction(*value.fraction) ? number_of(value) : std::nan("");
}

}  // namespace

std::string in_format(std::string text, Language language) {
    if (language == Language::russian) std::replace(text.begin(), text.end(), '.', ',');
    for (auto at = text.find('-'); at != text.npos; at = text.find('-', at)) text.replace(at, 1, "−");
    return text;
}

std::string short_number(const Value& value, Language language) { return in_format(plain(value), language); }

std::string all_digits(const Value& value, Language language) {
    std::string text = whole(value);
    if (text.ends_with("/1")) text.resize(text.size() - 2);
    return in_format(std::move(text), language);
}

std::string in_full(const Value& value, Language language) {
    const std::string text = whole(value);
    return text.size() > most_in_sentence ? short_number(value, language) : in_format(text, language);
}

std::pair<std::string, std::string> apart(const Value& one, const Value& other, Language language) {
    std::pair looks(short_number(one, language), short_number(other, language));
    if (looks.first != looks.second || one == other) return looks;
    return {in_full(one, language), in_full(other, language)};
}

std::string signed_number(int value) {
    return value > 0 ? "+" + std::to_string(value) : short_number({double(value)}, Language::english);
}

std::optional<Sign> order_of(const Value& one, const Value& other) {
    const auto left = fraction_in(one), right = fraction_in(other);
    if (left && right) return order_of_fractions(*left, *right);
    const double a = double_of(one), b = double_of(other);
    if (std::isnan(a) || std::isnan(b)) return std::nullopt;
    return a < b ? Sign::negative : a > b ? Sign::positive : Sign::zero;
}

bool agrees(bool nearer, const Value& z, const Value& other) {
    return nearer == (order_of(z, other) == Sign::positive);
}

}  // namespace vidno::say
