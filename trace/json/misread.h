/// Misread: the errors in a JSON document, and their places.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "refused.h"

namespace vidno {

/// One error.
struct JsonFault {
    /// The target of the pointer: the value, its key, or the second occurrence of the key.
    enum class At : unsigned char { value, key, second_key };

    std::string pointer;  // RFC 6901
    std::string reason;
    At at = At::value;

    /// "/polygons/0/color: not a string"
    std::string in_words() const;
};

/// A document with errors. When it is thrown, its message is the first fault.
struct Misread : Refused {
    explicit Misread(JsonFault fault);
    /// At least one.
    explicit Misread(std::vector<JsonFault> faults);

    std::vector<JsonFault> faults;
};

/// Reads a document part by part. After an error in one part it reads the others, so one pass finds all errors.
class Faults {
public:
    /// The most faults that are collected.
    static constexpr std::size_t most = 20;

    /// Whether `read` could read a part. Throws Misread once there are too many faults.
    bool attempt(auto&& read) {
        try {
            read();
            return true;
        } catch (const Misread& misread) {
            if (is_full()) throw;
            add(misread);
            return false;
        }
    }

    /// Throws Misread if there was an error.
    void settle() const;

private:
    bool is_full() const { return faults_.size() >= most; }
    void add(const Misread& misread);

    std::vector<JsonFault> faults_;
};

/// A key as a step of a JSON pointer, its slash included.
std::string pointer_step(std::string_view key);

/// How many ends of lines are before a place in a text, LF, CR LF or CR; and where the last one ends.
struct LineStart {
    std::size_t lines_before, position;
};
LineStart line_start(std::string_view text, std::size_t position);

/// "line 2, column 13" of a place in a text, counted from 1, in characters.
std::string line_and_column(std::string_view text, std::size_t position);

/// The place of a fault in a JSON text, which is valid at least up to there.
std::size_t position_of(const JsonFault& fault, std::string_view text);

/// The faults in the order of the text, one per line: file, line and column, path in the document, reason.
std::string text_with_places(const Misread& misread, std::string_view text, const std::string& file);

}  // namespace vidno
