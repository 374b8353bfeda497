#include "say/words.h"

#include <algorithm>

namespace vidno::say {

namespace {

bool is_one_in_russian(long long n) { return n % 10 == 1 && n % 100 != 11; }

bool are_few(long long n) { return n % 10 >= 2 && n % 10 <= 4 && (n % 100 < 12 || n % 100 > 14); }

bool is_one(long long n, Language language) { return language == Language::russian ? is_one_in_russian(n) : n == 1; }

}  // namespace

std::string filled(std::string_view text, const std::vector<std::string>& parts) {
    std::string made;
    std::size_t next = 0;
    while (!text.empty()) {
        const auto open = std::min(text.find('{'), text.size());
        made += text.substr(0, open);
        text.remove_prefix(open);
        if (text.empty()) break;
        const bool is_numbered = text[1] != '}';
        made += parts.at(is_numbered ? std::size_t(text[1] - '0') : next++);
        text.remove_prefix(is_numbered ? 3 : 2);
    }
    return made;
}

std::string capital(std::string text) {
    constexpr std::pair<std::string_view, std::string_view> letters[] = {
        {"б", "Б"}, {"в", "В"}, {"и", "И"}, {"л", "Л"}, {"о", "О"}, {"п", "П"}, {"с", "С"}, {"ф", "Ф"}};
    for (const auto& [small, large] : letters) {
        if (text.starts_with(small)) return text.replace(0, small.size(), large);
    }
    if (text[0] >= 'a' && text[0] <= 'z') text[0] += 'A' - 'a';
    return text;
}

std::string joined(const std::vector<std::string>& parts, std::string_view between) {
    std::string text;
    for (const auto& part : parts) {
        if (&part != &parts.front()) text += between;
        text += part;
    }
    return text;
}

std::string listed(const std::vector<std::string>& parts, std::string_view last) {
    if (parts.size() < 2) return joined(parts, "");
    return filled("{} {} {}", {joined({parts.begin(), parts.end() - 1}, ", "), std::string(last), parts.back()});
}

std::string Words::word(const Window& window) const {
    return filled("{} {} × {}", {pair(window.x, window.y), word(Value(window.width)), word(Value(window.height))});
}

std::string Words::list(const std::vector<Value>& numbers) const {
    std::vector<std::string> words;
    for (const auto& number : numbers) words.push_back(word(number));
    return joined(words, between_numbers());
}

std::string Words::counted(long long n, const Plurals& forms) const {
    const auto& [one, few, other] = forms.in(language_);
    const bool has_few = language_ == Language::russian && are_few(n);
    return std::to_string(n) + " " + std::string(is_one(n, language_) ? one : has_few ? few : other);
}

std::string Words::takes(long long n) const {
    const Bilingual takes = is_one(n, language_) ? Bilingual{"takes", "получает"} : Bilingual{"take", "получают"};
    return counted(n, pixel_forms) + " " + std::string(in(takes));
}

std::string Words::columns(int first, int last) const {
    if (first == last) return say("column {}", "столбец {}", first);
    return language_ == Language::russian ? "столбцы " + range(first, last) : say("columns {} to {}", "", first, last);
}

std::string Words::range(int first, int last) const {
    // A dash after a minus sign, or before one, would be hard to read.
    return first == last ? word(first) : word(first) + (first < 0 ? "…" : "–") + word(last);
}

std::string Words::ordered(const Value& one, const Value& other, Sign order) const {
    std::string relation(relation_of(order));
    if (order_of(one, other) != order) return relation;
    const auto [left, right] = apart(one, other, language_);
    return left + " " + relation + " " + right;
}

std::string Words::nearer(const Value& z, const Value& other, bool is) const {
    if (!agrees(is, z, other)) return text_of(is);
    const auto [left, right] = apart(z, other, language_);
    return left + (is ? " > " : " ≯ ") + right;
}

std::string Words::with_sign(const Value& value, Sign sign) const {
    return word(value) + " " + std::string(relation_of(sign)) + " 0";
}

std::vector<std::string> PolygonWords::names(const std::vector<PolygonPlace>& polygons) const {
    std::vector<std::string> names;
    for (const auto polygon : polygons) names.push_back(word(polygon));
    return names;
}

std::string PolygonWords::some(const std::vector<std::string>& names) {
    constexpr std::size_t most = 6;
    if (names.size() <= most) return joined(names, ", ");
    return filled("{} … ({})", {joined({names.begin(), names.begin() + most}, ", "), std::to_string(names.size())});
}

}  // namespace vidno::say
