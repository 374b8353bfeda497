/// JsonScanner: reads JSON from its start, for readers of its most common form.
///
/// A function that fails has read part of the text; the reader then gives up, and the tree of json_node.h reports the
/// error. A function that succeeds agrees with the tree.
#pragma once

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include "json/json_text.h"

namespace vidno {

class JsonScanner {
public:
    explicit JsonScanner(std::string_view text) : at_(text.data()), end_(at_ + text.size()) {}

    bool at_end() const { return at_ == end_; }
    bool is_next(char c) const { return at_ != end_ && *at_ == c; }

    bool skip(std::string_view text) {
        if (std::size_t(end_ - at_) < text.size() || !std::equal(text.begin(), text.end(), at_)) return false;
        at_ += text.size();
        return true;
    }

    /// `,"key":`; nothing if another key is next.
    bool skip_key(std::string_view key) {
        const bool is_next = std::size_t(end_ - at_) >= key.size() + 4 && at_[0] == ',' && at_[1] == '"' &&
                             std::equal(key.begin(), key.end(), at_ + 2) && at_[key.size() + 2] == '"' &&
                             at_[key.size() + 3] == ':';
        if (is_next) at_ += key.size() + 4;
        return is_next;
    }

    void skip_space() {
        while (at_ != end_ && (*at_ == ' ' || *at_ == '\n' || *at_ == '\t' || *at_ == '\r')) ++at_;
    }

    /// A string without escapes, of ASCII alone.
    std::optional<std::string_view> string() { return skip("\"") ? rest_of_string() : std::nullopt; }
    /// The rest of a string whose first quote was read.
    std::optional<std::string_view> rest_of_string() {
        const char* const first = at_;
        for (; at_ != end_ && *at_ != '"'; ++at_) {
            const auto byte = static_cast<unsigned char>(*at_);
            if (byte == '\\' || byte < 0x20 || byte >= 0x7f) return std::nullopt;
        }
        if (at_ == end_) return std::nullopt;
        return std::string_view(first, std::size_t(at_++ - first));
    }

    bool string(std::string& target) { return take(target, string()); }

    /// A colour "#rrggbb".
    bool color(Color& target) { return take(target, color_of_hex(string().value_or(""))); }

    /// A string as written, with its quotes.
    std::optional<std::string_view> written_string() {
        const char* const first = at_;
        if (!skip("\"")) return std::nullopt;
        while (at_ != end_ && *at_ != '"') at_ += *at_ == '\\' && at_ + 1 != end_ ? 2 : 1;
        if (at_ == end_) return std::nullopt;
        ++at_;
        return std::string_view(first, std::size_t(at_ - first));
    }

    /// A whole number without a point or a power.
    bool number(int& target) {
        const bool negative = skip("-");
        std::uint64_t digits = 0;
        if (!whole(digits, 10) || has_point_or_power()) return false;
        if (digits > std::uint64_t(std::numeric_limits<int>::max())) return false;
        target = negative ? -int(digits) : int(digits);
        return true;
    }

    bool number(double& target) {
        const char* const first = at_;
        const bool negative = skip("-");
        std::uint64_t digits = 0;
        if (!whole(digits, 18)) return false;
        if (!has_point_or_power()) {
            target = negative ? 0.0 - double(digits) : double(digits);  // an integer: it has no -0
            return true;
        }
        if (is_next('.')) {
            ++at_;
            if (!skip_digits()) return false;
        }
        if (is_next('e') || is_next('E')) {
            ++at_;
            if (is_next('+') || is_next('-')) ++at_;
            if (!skip_digits()) return false;
        }
        const auto [end, error] = std::from_chars(first, at_, target);
        return error == std::errc() && end == at_;
    }

    /// Takes over what was found, if anything was.
    template <class T>
    static bool take(T& target, const auto& found) {
        if (found) target = *found;
        return found.has_value();
    }

private:
    static bool is_digit(char c) { return '0' <= c && c <= '9'; }

    bool has_point_or_power() const { return is_next('.') || is_next('e') || is_next('E'); }

    bool skip_digits() {
        const char* const first = at_;
        while (at_ != end_ && is_digit(*at_)) ++at_;
        return at_ != first;
    }

    /// Reads the digits of a whole number: `most_digits` at most, and no leading zeros.
    bool whole(std::uint64_t& number, int most_digits) {
        const char* const first = at_;
        number = 0;
        while (at_ != end_ && is_digit(*at_)) number = 10 * number + std::uint64_t(*at_++ - '0');
        const auto digits = at_ - first;
        return 0 < digits && digits <= most_digits && (digits == 1 || *first != '0');
    }

    const char* at_;
    const char* end_;
};

}  // namespace vidno
