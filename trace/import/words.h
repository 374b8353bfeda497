/// TextWords: code that the readers of mesh files share: reading text word by word, and checking the counts of a header.
#pragma once

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <system_error>

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

/// The words of a text, line by line.
class TextWords {
public:
    explicit TextWords(std::string_view text) : rest_(text) {}

    /// Goes to the next line; false at the end of the text. Comments start with the mark, if there is one.
    bool next_line(char comment_mark = '\0') {
        if (rest_.empty()) return false;
        const std::size_t end = rest_.find('\n');
        line_ = rest_.substr(0, end);
        rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
        ++line_number_;
        if (comment_mark != '\0') line_ = line_.substr(0, line_.find(comment_mark));
        return true;
    }

    /// Goes to the next line that has a word.
    bool next_line_with_words(char comment_mark) {
        while (next_line(comment_mark)) {
            if (line_.find_first_not_of(blanks) != std::string_view::npos) return true;
        }
        return false;
    }

    /// The next word of the line; empty at its end.
    std::string_view word() {
        line_.remove_prefix(std::min(line_.find_first_not_of(blanks), line_.size()));
        const std::string_view found = line_.substr(0, line_.find_first_of(blanks));
        line_.remove_prefix(found.size());
        return found;
    }

    /// The next word of the text.
    std::string_view word_of_text() {
        std::string_view found = word();
        while (found.empty() && next_line()) found = word();
        return found;
    }

    void skip_line() { line_ = {}; }
    std::size_t bytes_left() const { return line_.size() + rest_.size(); }
    std::string_view rest() const { return rest_; }

    [[noreturn]] void refuse(std::string_view reason) const {
        throw Refused("line " + std::to_string(line_number_) + ": " + std::string(reason));
    }

    /// The next three words of the line.
    glm::dvec3 coordinates() {
        glm::dvec3 point;
        for (int axis = 0; axis < 3; ++axis) point[axis] = number(word());
        return point;
    }

    /// A word as a number, which must be finite.
    double number(std::string_view word) const {
        if (word.starts_with('+')) word.remove_prefix(1);
        double value = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (error == std::errc::result_out_of_range) refuse("a number beyond the range of doubles");
        if (error != std::errc() || end != word.data() + word.size()) refuse("not a number");
        if (!std::isfinite(value)) refuse("a coordinate that is not finite");
        return value;
    }

    std::int64_t whole_number(std::string_view word) const {
        if (word.starts_with('+')) word.remove_prefix(1);
        std::int64_t value = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (error != std::errc() || end != word.data() + word.size()) refuse("not a whole number");
        return value;
    }

    std::uint64_t count(std::string_view word) const {
        const std::int64_t value = whole_number(word);
        if (value < 0) refuse("a negative count");
        return std::uint64_t(value);
    }

private:
    static constexpr std::string_view blanks = " \t\r\v\f";
    std::string_view rest_, line_;
    std::size_t line_number_ = 0;
};

}  // namespace vidno
