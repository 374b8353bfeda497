#include "notation.h"

#include <algorithm>
#include <cmath>

#include "figure_words.h"
#include "say/numbers.h"

namespace vidno::figures {

namespace {

using say::in_format;

std::string written(double value, std::chars_format format, int digits) {
    std::array<char, 64> text;
    const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value, format, digits);
    return {text.data(), end};
}

std::string shortest(double value) {
    std::array<char, 400> text;  // 1e308 has as many digits
    const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed);
    return {text.data(), end};
}

std::string without_zeros(std::string text) {
    while (text.find('.') != text.npos && (text.back() == '0' || text.back() == '.')) {
        const bool point = text.back() == '.';
        text.pop_back();
        if (point) break;
    }
    return text;
}

std::string short_number(double value, std::size_t most) {
    if (std::isnan(value)) return "nan";
    if (std::isinf(value)) return value < 0 ? "-∞" : "∞";
    const double size = std::abs(value);
    if (value == 0) return "0";
    if (size < 1e-4 || size >= 1e6) {
        const std::string exact = shortest(value);
        return exact.size() <= most ? exact : written(value, std::chars_format::scientific, 2);
    }
    std::string exact = shortest(value);
    if (exact.size() <= most) return exact;
    const int whole = std::max(0, int(std::floor(std::log10(size))) + 1);
    for (int digits = 4; digits > 1; --digits) {
        const int places = std::max(0, digits - (size < 1 ? int(std::floor(std::log10(size))) + 1 : whole));
        std::string text = without_zeros(written(value, std::chars_format::fixed, places));
        if (text.size() <= most) return text;
    }
    return written(value, std::chars_format::scientific, 1);
}

constexpr std::string_view between_numbers(Language language) { return language == Language::russian ? "; " : ", "; }

}  // namespace

std::string in_full(double value, Language language) { return in_format(shortest(value), language); }

std::string readable(const Value& value, Language language, std::size_t most) {
    if (!value.fraction) return in_format(short_number(value.number, most), language);
    const std::string& text = *value.fraction;
    if (text.ends_with("/1")) return in_format(text.substr(0, text.size() - 2), language);
    if (text.size() <= most || text.ends_with("/0")) return in_format(text, language);
    return "≈" + in_format(short_number(number_of(value), most), language);
}

std::string pair_of(const std::string& x, const std::string& y, Language language) {
    return "(" + x + std::string(between_numbers(language)) + y + ")";
}

std::string readable(const Window& window, Language language) {
    const auto number = [&](double value) { return readable(value, language); };
    return pair_of(number(window.x), number(window.y), language) + " " + number(window.width) + " × " +
           number(window.height);
}

}  // namespace vidno::figures
