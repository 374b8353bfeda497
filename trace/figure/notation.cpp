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

/// The texts of the events that a history contains; the others have none.
struct Note {
    const Scene& scene;
    Language language;

    const std::string& name(PolygonPlace polygon) const { return scene.polygons[std::size_t(polygon.index)].id; }
    std::string number(const Value& value) const { return readable(value, language); }
    std::string compared(const Value& z, const Value& against, bool nearer) const {
        return number(z) + (nearer ? " > " : " ≯ ") + number(against);
    }
    std::string half_open(int first, int end) const {
        return "[" + std::to_string(first) + std::string(between_numbers(language)) + std::to_string(end) + ")";
    }

    std::string operator()(const event::Pop& e) const { return readable(e.window, language); }
    std::string operator()(const event::Discard& e) const { return "− " + name(e.polygon); }
    std::string operator()(const event::Nearer& e) const { return name(e.polygon) + ": k = " + std::to_string(e.k); }
    std::string operator()(const event::Mark& e) const { return name(e.polygon) + ": S = true"; }
    std::string operator()(const event::Cover& e) const { return name(e.polygon) + ": hasSurround"; }
    std::string operator()(const event::Uncover& e) const {
        return name(e.polygon) + (language == Language::russian ? ": не hasSurround" : ": not hasSurround");
    }
    std::string operator()(const event::Decide& e) const {
        return std::string(words_of(language).cases[std::size_t(e.which)]);
    }
    std::string operator()(const event::Nearest& e) const { return name(e.polygon) + ": z = " + number(e.z); }
    std::string operator()(const event::Fill& e) const {
        return std::to_string(e.rect.width) + " × " + std::to_string(e.rect.height);
    }
    std::string operator()(const event::Draw& e) const { return name(e.polygon); }
    std::string operator()(const event::Paint& e) const { return name(e.polygon); }
    std::string operator()(const event::Clear& e) const { return "z = " + number(e.z); }
    std::string operator()(const event::Columns& e) const { return half_open(e.first, e.end); }
    std::string operator()(const event::Pixel& e) const { return compared(e.z, e.stored, e.shown); }
    std::string operator()(const event::Span& e) const {
        std::string runs;
        for (const auto& [first, end] : e.runs) runs += (runs.empty() ? "" : " ") + half_open(first, end);
        return runs.empty() ? "∅" : runs;
    }
    std::string operator()(const event::Fault& e) const { return e.reason; }
    std::string operator()(const auto&) const { return {}; }
};

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

std::string note_of(const EventView& event, const Scene& scene, Language language) {
    return event.visit(Note{scene, language});
}

}  // namespace vidno::figures
