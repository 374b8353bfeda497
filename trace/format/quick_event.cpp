#include "format/quick_event.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>

#include "format/event_fields.h"
#include "json/json_scanner.h"

namespace vidno {

namespace {

/// Finds words among many by a hash.
class WordTable {
public:
    explicit WordTable(std::span<const std::string_view> words) : words_(words) {
        for (std::size_t i = 0; i < words.size(); ++i) {
            std::size_t place = hash(words[i]);
            while (places_[place] != 0) place = (place + 1) % size;
            places_[place] = std::uint8_t(i + 1);
        }
    }

    std::optional<std::size_t> find(std::string_view word) const {
        for (std::size_t place = hash(word); places_[place] != 0; place = (place + 1) % size) {
            const std::size_t i = places_[place] - 1u;
            if (words_[i] == word) return i;
        }
        return std::nullopt;
    }

private:
    static constexpr std::size_t size = 1024;  // several times as many as there are words

    static std::size_t hash(std::string_view word) {
        std::size_t sum = word.size();
        for (const char c : word) sum = sum * 31 + static_cast<unsigned char>(c);
        return sum % size;
    }

    std::span<const std::string_view> words_;
    std::array<std::uint8_t, size> places_{};  // one more than the place of the word; 0: none
};
static_assert(AllEvents::count < 255 && line_names.size() < 255);

}  // namespace

/// Reads one line from its start.
class QuickEvents::Scanner : public JsonScanner {
public:
    Scanner(std::string_view line, const EventContext& context) : JsonScanner(line), context_(context) {}

    std::optional<std::size_t> word(const WordTable& table) {
        const auto text = rest_of_string();
        return text ? table.find(*text) : std::nullopt;
    }

    template <class E>
    bool fields(E& event) {
        bool read = true;
        E::fields(event, [&](std::string_view key, auto& target, const Meaning& meaning = any_number) {
            meaning_ = &meaning;
            read = read && field(key, target);
        });
        return read && skip("}") && at_end();
    }

private:
    template <class T>
    bool field(std::string_view key, T& target) {
        return skip_key(key) && value(target);
    }
    template <class T>
    bool field(std::string_view key, std::optional<T>& target) {
        target.reset();
        return !skip_key(key) || value(target.emplace());
    }

    bool value(int& target) { return number(target) && meaning_->has(target); }
    bool value(double& target) { return number(target); }

    bool value(Value& target) {
        if (!is_next('"')) {
            target.fraction.reset();
            return number(target.number);
        }
        const auto text = string();
        if (!text) return false;
        if (*text == "inf") {
            target = Value::infinite();
        } else if (*text == "-inf") {
            target = Value::minus_infinite();
        } else if (*text == "nan" && !context_.is_exact) {
            target = {std::numeric_limits<double>::quiet_NaN()};
        } else if (context_.is_exact && is_fraction(*text)) {
            target = Value(std::string(*text));
        } else {
            return false;
        }
        return true;
    }

    bool value(bool& target) {
        target = is_next('t');
        return skip(target ? "true" : "false");
    }

    bool value(std::string& target) { return string(target); }
    bool value(Fraction& target) {
        target.text.clear();
        if (skip("null")) return true;
        const auto text = string();
        if (!text || !is_fraction_or_none(*text)) return false;
        target.text = *text;
        return true;
    }
    /// The program writes small letters.
    bool value(Color& target) {
        const auto text = string();
        if (!text || std::any_of(text->begin(), text->end(), [](char c) { return 'A' <= c && c <= 'F'; })) return false;
        return take(target, color_of_hex(*text));
    }

    bool value(PolygonPlace& target) { return take(target, context_.polygons.find(written_string().value_or(""))); }

    bool value(Sign& target) {
        int sign = 0;
        if (!number(sign) || sign < -1 || sign > 1) return false;
        target = Sign{sign};
        return true;
    }
    bool value(VisibilityFlag& target) {
        int flag = 0;
        if (!number(flag) || flag < -1 || flag > 2) return false;
        target = VisibilityFlag(flag);
        return true;
    }

    template <Word T>
    bool value(T& target) {
        const auto& words = words_of(target);
        const auto found = std::find(words.begin(), words.end(), string().value_or(""));
        target = T(found - words.begin());
        return found != words.end();
    }

    bool value(Answer& target) {
        if (is_next('t') || is_next('f')) return value(target.emplace<bool>());
        if (is_next('[')) return value(target.emplace<std::pair<int, int>>());
        return value(target.emplace<int>());
    }
    bool value(Truth& target) {
        target.answer.reset();
        return skip("null") || value(target.answer.emplace());
    }

    template <Listed T>
    bool value(T& target) {
        const auto read = [this](auto& first, auto&... rest) {
            return this->value(first) && ((this->skip(",") && this->value(rest)) && ...);
        };
        return skip("[") && with_items(target, read) && skip("]");
    }
    template <class T>
    bool value(std::vector<T>& target) {
        target.clear();
        if (!skip("[")) return false;
        if (skip("]")) return true;
        do {
            if (!value(target.emplace_back())) return false;
        } while (skip(","));
        return skip("]");
    }

    const EventContext& context_;
    const Meaning* meaning_ = &any_number;  // of the current field
};

template <class E>
std::optional<EventView> QuickEvents::read_as(Scanner& scanner) {
    static const WordTable lines(line_names);
    auto& last = events_[event_place<E>];
    if (!last) last = std::make_shared<E>();
    auto& event = *static_cast<E*>(last.get());
    if (E::kind.from > context_->detail || !scanner.skip(R"(,"at":")")) return std::nullopt;
    const auto line = scanner.word(lines);
    if (!line || !E::lines.has(Line(*line))) return std::nullopt;
    event.at = Line(*line);
    return scanner.fields(event) ? std::optional<EventView>(event) : std::nullopt;
}

template <class... Events>
std::optional<EventView> QuickEvents::read_one_of(EventTypes<Events...>, std::size_t place, Scanner& scanner) {
    static constexpr std::array readers{&QuickEvents::read_as<Events>...};
    return (this->*readers[place])(scanner);
}

std::optional<EventView> QuickEvents::read(std::string_view line) {
    static const WordTable names(AllEvents::names);
    Scanner scanner(line, *context_);
    if (!scanner.skip(R"({"e":")")) return std::nullopt;
    const auto name = scanner.word(names);
    return name ? read_one_of(AllEvents{}, *name, scanner) : std::nullopt;
}

}  // namespace vidno
