/// Misread: what is wrong in a document of JSON, and where.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "refused.h"

namespace vidno {

/// One thing that is wrong.
struct JsonFault {
    /// What is pointed at: the value, its key, or the key where an object has it for the second time.
    enum class At : unsigned char { value, key, second_key };

    std::string pointer;  // RFC 6901
    std::string reason;
    At at = At::value;

    /// "/polygons/0/color: not a string"
    std::string told() const;
};

/// A document that is not as it should be. As an error it tells the first of its faults.
struct Misread : Refused {
    explicit Misread(JsonFault fault);
    /// At least one.
    explicit Misread(std::vector<JsonFault> faults);

    std::vector<JsonFault> faults;
};

/// Reads a document part by part: what is wrong with one keeps no other from being read, so that one pass finds all that is wrong.
class Faults {
public:
    /// More are not worth reading.
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

    /// Throws Misread if anything was wrong.
    void settle() const;

private:
    bool is_full() const { return faults_.size() >= most; }
    void add(const Misread& misread);

    std::vector<JsonFault> faults_;
};

/// A key as a step of a JSON pointer, its slash included.
std::string pointer_step(std::string_view key);

/// "line 2, column 13" of a place in a text, counted from 1, in characters.
std::string line_and_column(std::string_view text, std::size_t position);

/// Where in a text of JSON a fault is. The text is JSON at least as far as there.
std::size_t position_of(const JsonFault& fault, std::string_view text);

/// The faults in the order of the text, a line each: file, line and column, path in the document, reason.
std::string told_with_places(const Misread& misread, std::string_view text, const std::string& file);

}  // namespace vidno
