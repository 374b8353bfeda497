/// TextWords: the one tokenizer of the readers of mesh files. It reads a text word by word and knows the line of each.
///
/// A line ends at LF, CR LF or CR. A comment reaches from its mark to the end of the line.
#pragma once

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "json/json_node.h"
#include "refused.h"
#include "vidno/scene.h"

namespace vidno {

inline std::string lower_case(std::string_view text) {
    std::string out(text);
    for (char& c : out) c = char(std::tolower(static_cast<unsigned char>(c)));
    return out;
}

inline void check_face_count(std::uint64_t count) {
    if (count > most_polygons) throw Refused("more than " + std::to_string(most_polygons) + " faces");
}

/// Checks a count in a header against the size of the file.
inline void check_count(std::uint64_t count, std::string_view what, std::uint64_t least_size, std::size_t bytes_left) {
    if (count <= bytes_left / least_size) return;
    throw Refused("the header says " + std::to_string(count) + " " + std::string(what) +
                  ", more than the file can hold");
}

class TextWords {
public:
    explicit TextWords(std::string_view text, char comment_mark = '\0')
        : rest_(text), blanks_or_mark_(blanks), comment_mark_(comment_mark) {
        if (comment_mark != '\0') blanks_or_mark_ += comment_mark;
    }

    /// Goes to the next line; false at the end of the text.
    bool next_line() {
        if (rest_.empty()) return false;
        const std::size_t end = std::min(rest_.find_first_of("\r\n"), rest_.size());
        line_ = rest_.substr(0, end);
        rest_.remove_prefix(std::min(end + (rest_.substr(end).starts_with("\r\n") ? 2 : 1), rest_.size()));
        ++line_number_;
        return true;
    }

    /// The next word of the line; empty at its end.
    std::string_view word() {
        line_.remove_prefix(std::min(line_.find_first_not_of(blanks), line_.size()));
        if (comment_mark_ != '\0' && line_.starts_with(comment_mark_)) line_ = {};
        const std::string_view found = line_.substr(0, line_.find_first_of(blanks_or_mark_));
        line_.remove_prefix(found.size());
        return found;
    }

    /// The next word of the text; empty at its end.
    std::string_view word_of_text() {
        std::string_view found = word();
        while (found.empty() && next_line()) found = word();
        return found;
    }

    /// Goes to the next line that has a word; false at the end of the text.
    bool next_line_with_words() {
        while (next_line()) {
            if (has_word()) return true;
        }
        return false;
    }

    /// Whether the line has a further word.
    bool has_word() const { return !TextWords(*this).word().empty(); }

    /// The rest of the line as a name, which may contain blanks and the mark of a comment; a comment follows a blank.
    std::string name() {
        std::string_view found = line_;
        line_ = {};
        for (std::size_t at = 0; comment_mark_ != '\0' && at < found.size(); ++at) {
            const bool after_blank = at == 0 || blanks.find(found[at - 1]) != std::string_view::npos;
            if (found[at] == comment_mark_ && after_blank) found = found.substr(0, at);
        }
        found.remove_prefix(std::min(found.find_first_not_of(blanks), found.size()));
        return std::string(found.substr(0, found.find_last_not_of(blanks) + 1));
    }

    std::vector<std::string_view> words_of_line() {
        std::vector<std::string_view> all;
        for (std::string_view found = word(); !found.empty(); found = word()) all.push_back(found);
        return all;
    }

    void skip_line() { line_ = {}; }
    std::size_t bytes_left() const { return line_.size() + rest_.size(); }
    std::string_view rest() const { return rest_; }
    std::size_t line() const { return line_number_; }
    std::string place() const { return "line " + std::to_string(line_number_); }

    [[noreturn]] void refuse(std::string_view reason) const { throw Refused(place() + ": " + std::string(reason)); }

    /// A word as a number, which may be infinite or nan, as where it is no coordinate.
    double any_number(std::string_view word) const {
        const std::string written(word);
        if (word.starts_with('+')) word.remove_prefix(1);
        double value = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (error == std::errc::result_out_of_range) return std::strtod(written.c_str(), nullptr);  // 0 or infinite
        if (word.find(".#") != std::string_view::npos) return std::nan("");  // 1.#QNAN, 1.#INF of Microsoft's library
        if (error != std::errc() || end != word.data() + word.size()) refuse_word("number", word);
        return value;
    }

    double number(std::string_view word) const {
        const double value = any_number(word);
        if (std::isfinite(value)) return value;
        const bool has_digits = word.find_first_of("0123456789") < word.find('#');
        refuse(has_digits && word.find(".#") == std::string_view::npos ? "a number beyond the range of doubles"
                                                                       : "a coordinate that is not finite");
    }

    std::int64_t whole_number(std::string_view word) const {
        const std::string_view written = word;
        if (word.starts_with('+')) word.remove_prefix(1);
        std::int64_t value = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (error != std::errc() || end != word.data() + word.size()) refuse_word("whole number", written);
        return value;
    }

    std::uint64_t count(std::string_view word) const {
        const std::int64_t value = whole_number(word);
        if (value < 0) refuse("a negative count");
        return std::uint64_t(value);
    }

private:
    static constexpr std::string_view blanks = " \t\v\f";

    [[noreturn]] void refuse_word(const std::string& wanted, std::string_view word) const {
        refuse(word.empty() ? "a " + wanted + " is missing" : "not a " + wanted + ": " + printable(word));
    }

    std::string_view rest_, line_;
    std::string blanks_or_mark_;
    char comment_mark_;
    std::size_t line_number_ = 0;
};

}  // namespace vidno
