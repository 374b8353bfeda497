/// Words: what the sentences of all algorithms are made of: numbers, points, names and counts in a language.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "replay/floating_horizon_state.h"
#include "replay/state.h"
#include "say/numbers.h"

namespace vidno::say {

/// The forms of a noun after a number: 1 вершина, 2 вершины, 5 вершин. English has no few.
struct Plural {
    std::string_view one, few, other;
};
using Plurals = InEachLanguage<Plural>;
inline constexpr Plurals pixel_forms{{"pixel", "", "pixels"}, {"пиксель", "пикселя", "пикселей"}};
inline constexpr Plurals vertex_forms{{"vertex", "", "vertices"}, {"вершина", "вершины", "вершин"}};

/// The text with the parts in place of `{}`, in order, and of `{0}`, `{1}` and so on.
std::string filled(std::string_view text, const std::vector<std::string>& parts);

/// With a capital letter at its start.
std::string capital(std::string text);

/// The parts with this between them.
std::string joined(const std::vector<std::string>& parts, std::string_view between);

/// "1", "1 and 0", "2, 1 and 0".
std::string listed(const std::vector<std::string>& parts, std::string_view last);

inline std::string text_of(bool answer) { return answer ? "true" : "false"; }

/// How many pixels runs have.
template <class Run>
long long pixels_in(const std::vector<Run>& runs) {
    long long count = 0;
    for (const auto& run : runs) count += run.end - run.first;
    return count;
}

class Words {
public:
    explicit Words(Language language) : language_(language) {}

    Language language() const { return language_; }

    /// The text in the language with these parts.
    std::string say(std::string_view english, std::string_view russian, const auto&... parts) const {
        return filled(Bilingual{english, russian}.in(language_), {word(parts)...});
    }
    std::string_view in(const Bilingual& texts) const { return texts.in(language_); }

    static std::string word(const std::string& text) { return text; }
    static std::string word(std::string_view text) { return std::string(text); }
    static std::string word(const char* text) { return text; }
    std::string word(const Value& number) const { return short_number(number, language_); }
    std::string word(int number) const { return word(Value(number)); }
    std::string word(const ValuePoint& point) const { return pair(point.x, point.y); }
    std::string word(const ValueVertex& vertex) const { return pair(vertex.x, vertex.y); }
    std::string word(const ReportedSample& sample) const { return pair(Value(sample.first), Value(sample.second)); }
    std::string word(const Window& window) const;

    /// Where numbers have a comma, a semicolon stands between them.
    std::string_view between_numbers() const { return in({", ", "; "}); }
    std::string list(const std::vector<Value>& numbers) const;
    std::string pair(const Value& x, const Value& y) const { return "(" + list({x, y}) + ")"; }

    /// "3 vertices".
    std::string counted(long long n, const Plurals& forms) const;
    /// "3 pixels take".
    std::string takes(long long pixels) const;
    /// "column 3", "columns 3 to 5".
    std::string columns(int first, int last) const;
    /// A range without a noun, "3–5".
    std::string range(int first, int last) const;

    // In the notation of a listing

    /// "[3, 5)".
    std::string half_open(int first, int end) const { return "[" + list({double(first), double(end)}) + ")"; }
    /// The order of two numbers; the bare relation if the numbers as written have another.
    std::string ordered(const Value& one, const Value& other, Sign order) const;
    /// Whether a depth is nearer than another one; the bare answer if the depths as written have another.
    std::string nearer(const Value& z, const Value& other, bool is) const;
    std::string with_sign(const Value& value, Sign sign) const;

private:
    Language language_;
};

/// An answer of a decision in words.
struct AnswerWords {
    const Words& words;

    std::string operator()(bool yes) const { return yes ? words.say("yes", "да") : words.say("no", "нет"); }
    std::string operator()(int number) const { return words.word(number); }
    std::string operator()(const std::pair<int, int>& range) const {
        const auto [first, end] = range;
        if (first + 1 == end) return std::to_string(first);
        if (first >= end) return words.say("none", "пусто");
        return words.say("{} to {}", "от {} до {}", std::to_string(first), std::to_string(end - 1));
    }
};

/// The words about a step of a run of polygons, after which it has this state.
class PolygonWords : public Words {
public:
    PolygonWords(const State& after, Language language) : Words(language), after_(after) {}

    using Words::word;
    const std::string& word(PolygonPlace polygon) const {
        return after_.header().scene.polygons[std::size_t(polygon.index)].id;
    }
    std::string say(std::string_view english, std::string_view russian, const auto&... parts) const {
        return filled(in({english, russian}), {word(parts)...});
    }
    std::vector<std::string> names(const std::vector<PolygonPlace>& polygons) const;
    /// The first names, and how many there are if there are more.
    static std::string some(const std::vector<std::string>& names);

    const State& after() const { return after_; }
    const TraceHeader& header() const { return after_.header(); }

private:
    const State& after_;
};

/// The words of a run of curves.
class CurveWords : public Words {
public:
    CurveWords(const FloatingHorizonState& after, Language language) : Words(language), after_(after) {}

    const FloatingHorizonState::Values& after() const { return after_.values(); }
    const FloatingHorizonHeader& header() const { return after_.header(); }

private:
    const FloatingHorizonState& after_;
};

/// The place of a corner of a window on the screen.
inline constexpr std::array<Bilingual, 4> corner_places{{
    {"top left", "левый верхний"},
    {"bottom left", "левый нижний"},
    {"top right", "правый верхний"},
    {"bottom right", "правый нижний"},
}};

}  // namespace vidno::say
