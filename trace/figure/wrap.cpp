#include "wrap.h"

#include <algorithm>
#include <array>

#include "drawing.h"

namespace vidno::figures {

namespace {

struct Word {
    std::string text;
    int badness = 0;  // of a break after it
};

bool is_operator(const std::string& word) {
    static constexpr std::array<std::string_view, 16> operators{":=", "=", "≠", "<", ">", "≤", "≥", "+",
                                                                "−",  "-", "/", "·", "∩", "∪", "∈", "×"};
    return std::find(operators.begin(), operators.end(), word) != operators.end();
}

std::vector<Word> words_of(const std::string& text) {
    std::vector<Word> words;
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t end = std::min(text.find(' ', from), text.size());
        words.push_back({text.substr(from, end - from)});
        from = end + 1;
    }
    return words;
}

/// Rates the breaks.
void rate(std::vector<Word>& words) {
    constexpr int at_comma = 1, elsewhere = 2, in_brackets = 8, at_operator = 16;
    std::ptrdiff_t depth = 0;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string& word = words[i].text;
        const auto count = [&](std::string_view of) {
            return std::count_if(word.begin(), word.end(), [&](char c) { return of.find(c) != of.npos; });
        };
        depth += count("([{") - count(")]}");
        int& badness = words[i].badness;
        badness = word.ends_with(';') ? 0 : word.ends_with(',') || word.ends_with(':') ? at_comma : elsewhere;
        if (depth > 0) badness += in_brackets;
        if (is_operator(word) || (i + 1 < words.size() && is_operator(words[i + 1].text))) badness += at_operator;
    }
}

}  // namespace

std::vector<std::string> wrapped(const std::string& text, double size, double width, double first_width) {
    constexpr double least_filled = 0.45;  // of a piece that ends before the last word that fits
    auto words = words_of(text);
    rate(words);
    std::vector<std::string> pieces;
    for (std::size_t first = 0; first < words.size();) {
        const double room = pieces.empty() ? first_width : width;
        std::string piece, best;
        std::size_t next = first;
        int least = 0;
        for (std::size_t i = first; i < words.size(); ++i) {
            piece += (i == first ? "" : " ") + words[i].text;
            const double wide = width_of(piece, size);
            if (i > first && wide > room) break;
            const bool is_last = i + 1 == words.size();
            const int badness = is_last ? -1 : words[i].badness + (wide < least_filled * room ? 4 : 0);
            if (!best.empty() && badness > least) continue;
            best = piece;
            least = badness;
            next = i + 1;
        }
        pieces.push_back(best);
        first = next;
    }
    if (pieces.empty()) pieces.emplace_back();
    return pieces;
}

}  // namespace vidno::figures
