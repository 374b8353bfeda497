#include "wrap.h"

#include <algorithm>
#include <array>

#include "drawing.h"

namespace vidno::figures {

namespace {

/// The costs of a break after a word, and of each line.
constexpr int at_comma = 1, anywhere = 2, after_link = 5, in_list = 6, in_brackets = 10, at_operator = 16;
constexpr int each_line = 3, short_line = 4;
constexpr double short_share = 0.45;  // of the room; a line that is filled less is short

struct Word {
    std::string text;
    int badness = 0;  // of a break after it
};

bool is_among(std::string_view word, const auto& words) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

bool is_operator(std::string_view word) {
    static constexpr auto operators = std::to_array<std::string_view>(
        {":=", "=", "≠", "<", ">", "≤", "≥", "+", "−", "-", "/", "·", "∩", "∪", "∈", "×", "→"});
    return is_among(word, operators);
}

bool is_conjunction(std::string_view word) {
    static constexpr auto conjunctions = std::to_array<std::string_view>({"and", "or", "и", "или", "а"});
    return is_among(word, conjunctions);
}

/// Whether the next word belongs to this one.
bool is_link(std::string_view word) {
    static constexpr auto links = std::to_array<std::string_view>(
        {"a",      "an",  "the", "of",  "in",  "on",  "at",      "to",       "from", "with", "by",   "for",
         "if",     "is",  "are", "not", "no",  "all", "each",    "every",    "its",  "than", "that", "over",
         "return", "rnd", "sgn", "в",   "на",  "с",   "со",      "не",       "от",   "до",   "по",   "из",
         "за",     "к",   "о",   "об",  "у",   "при", "где",     "для",      "если", "над",  "под",  "вне",
         "все",    "её",  "его", "их",  "нет", "что", "вернуть", "закрасить"});
    return is_among(word, links) || is_conjunction(word);
}

bool is_end(std::string_view word) { return word.ends_with(';') || word.ends_with(',') || word.ends_with(':'); }

std::vector<Word> words_of(const std::string& text) {
    std::vector<Word> words;
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t end = std::min(text.find(' ', from), text.size());
        words.push_back({text.substr(from, end - from)});
        from = end + 1;
    }
    return words;
}

/// Whether the comma after a word separates terms of a list, such as `x, y := ...` or `p₁, p₂`: one of the two is a
/// single word.
bool is_in_list(const std::vector<Word>& words, std::size_t place) {
    if (place + 1 == words.size() || is_conjunction(words[place + 1].text)) return false;
    const bool is_alone = place == 0 || is_end(words[place - 1].text);
    return is_alone || place + 2 == words.size() || is_end(words[place + 1].text);
}

/// Rates the breaks.
void rate(std::vector<Word>& words) {
    std::ptrdiff_t depth = 0;
    bool in_bars = false;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string& word = words[i].text;
        const auto count = [&](std::string_view of) {
            return std::count_if(word.begin(), word.end(), [&](char c) { return of.find(c) != of.npos; });
        };
        depth += count("([{") - count(")]}");
        if (count("|") % 2 == 1) in_bars = !in_bars;
        int& badness = words[i].badness;
        badness = word.ends_with(';') ? 0 : is_end(word) ? at_comma : is_link(word) ? after_link : anywhere;
        if (word.ends_with(',') && is_in_list(words, i)) badness = in_list;
        badness += in_brackets * int(std::max(depth, std::ptrdiff_t{0}) + in_bars);
        const std::string_view next = i + 1 < words.size() ? std::string_view(words[i + 1].text) : "";
        if (is_operator(word) || is_operator(next) || next == "—") badness += at_operator;
    }
}

/// The best way to break the words from one on.
struct Break {
    int badness = 0;
    std::size_t next = 0;  // the word that begins the next line
};

}  // namespace

std::vector<std::string> wrapped(const std::string& text, double size, double width, double first_width) {
    auto words = words_of(text);
    rate(words);
    const auto joined = [&](std::size_t first, std::size_t end) {
        std::string line = words[first].text;
        for (std::size_t i = first + 1; i < end; ++i) line += " " + words[i].text;
        return line;
    };
    std::vector<Break> best(words.size() + 1);
    for (std::size_t first = words.size(); first-- > 0;) {
        const double room = first == 0 ? first_width : width;
        for (std::size_t end = first + 1; end <= words.size(); ++end) {
            const double wide = width_of(joined(first, end), size);
            if (end > first + 1 && wide > room) break;
            int badness = each_line + best[end].badness;
            if (end < words.size()) badness += words[end - 1].badness + (wide < short_share * room ? short_line : 0);
            if (end == first + 1 || badness <= best[first].badness) best[first] = {badness, end};
        }
    }
    std::vector<std::string> pieces;
    for (std::size_t first = 0; first < words.size(); first = best[first].next) {
        pieces.push_back(joined(first, best[first].next));
    }
    if (pieces.empty()) pieces.emplace_back();
    return pieces;
}

}  // namespace vidno::figures
