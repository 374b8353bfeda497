#include "json/misread.h"

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <utility>

#include "json/json_node.h"

namespace vidno {

namespace {

/// Walks through a JSON text to a place in it. At the end of the text it stops.
class PlaceFinder {
public:
    explicit PlaceFinder(std::string_view text) : text_(text) { skip_space(); }

    std::size_t at() const { return at_; }

    /// From a container to the value of this step of a pointer; false if it does not exist.
    bool enter(std::string_view step) { return is_next('[') ? enter_item(step) : enter_member(step, 1); }

    /// From an object to the n-th occurrence of this step's key.
    bool enter_key(std::string_view step, int n) {
        if (!enter_member(step, n)) return false;
        at_ = key_;
        return true;
    }

private:
    bool is_next(char c) const { return at_ < text_.size() && text_[at_] == c; }

    void skip_space() { at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size()); }

    /// Skips a value or a key, up to the character that follows.
    void skip_value() {
        int depth = 0;
        do {
            if (is_next('"')) {
                skip_string();
            } else if (is_next('{') || is_next('[')) {
                ++depth;
                ++at_;
            } else if (is_next('}') || is_next(']')) {
                --depth;
                ++at_;
            } else {
                at_ = std::min(text_.find_first_of("\"{}[], \t\r\n:", at_ + 1), text_.size());
            }
            if (depth > 0) at_ = std::min(text_.find_first_not_of(", \t\r\n:", at_), text_.size());
        } while (depth > 0 && at_ < text_.size());
        skip_space();
    }

    void skip_string() {
        for (++at_; at_ < text_.size() && text_[at_] != '"'; ++at_) at_ += text_[at_] == '\\' ? 1 : 0;
        at_ = std::min(at_ + 1, text_.size());
    }

    /// Skips a character.
    bool skip(char c) {
        if (!is_next(c)) return false;
        ++at_;
        skip_space();
        return true;
    }

    bool enter_item(std::string_view step) {
        std::size_t before = 0;
        std::from_chars(step.data() + 1, step.data() + step.size(), before);
        for (skip('['); before > 0; --before) {
            skip_value();
            if (!skip(',')) return false;
        }
        return true;
    }

    bool enter_member(std::string_view step, int n) {
        if (!skip('{')) return false;
        while (is_next('"')) {
            key_ = at_;
            skip_string();
            const auto written = text_.substr(key_, at_ - key_);
            skip_space();
            if (!skip(':')) return false;
            if (is_key(written, step) && --n == 0) return true;
            skip_value();
            if (!skip(',')) return false;
        }
        return false;
    }

    static bool is_key(std::string_view written, std::string_view step) {
        const auto key = nlohmann::json::parse(written, nullptr, false);
        return key.is_string() && pointer_step(key.get_ref<const std::string&>()) == step;
    }

    std::string_view text_;
    std::size_t at_ = 0, key_ = 0;
};

}  // namespace

std::string JsonFault::in_words() const { return pointer.empty() ? reason : pointer + ": " + reason; }

Misread::Misread(JsonFault fault) : Misread(std::vector{std::move(fault)}) {}
Misread::Misread(std::vector<JsonFault> all) : Refused(all.at(0).in_words()), faults(std::move(all)) {}

void Faults::settle() const {
    if (!faults_.empty()) throw Misread(faults_);
}

void Faults::add(const Misread& misread) {
    faults_.insert(faults_.end(), misread.faults.begin(), misread.faults.end());
    if (is_full()) settle();
}

std::string pointer_step(std::string_view key) {
    std::string step = "/";
    for (const char c : printable(key)) {
        if (c == '~') {
            step += "~0";
        } else if (c == '/') {
            step += "~1";
        } else {
            step += c;
        }
    }
    return step;
}

LineStart line_start(std::string_view text, std::size_t position) {
    LineStart found{0, 0};
    for (std::size_t i = 0; i < position; ++i) {
        const bool is_cr_alone = text[i] == '\r' && !text.substr(i + 1).starts_with('\n');
        if (text[i] == '\n' || is_cr_alone) found = {found.lines_before + 1, i + 1};
    }
    return found;
}

std::string line_and_column(std::string_view text, std::size_t position) {
    const std::string_view before = text.substr(0, position);
    const auto [lines, start] = line_start(text, before.size());
    const auto line = before.substr(start);
    const auto is_first_byte = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; };
    const auto column = std::count_if(line.begin(), line.end(), is_first_byte);
    return "line " + std::to_string(lines + 1) + ", column " + std::to_string(column + 1);
}

std::size_t position_of(const JsonFault& fault, std::string_view text) {
    PlaceFinder place(text);
    const std::string_view pointer = fault.pointer;
    for (std::size_t begin = 0; begin < pointer.size();) {
        const std::size_t end = std::min(pointer.find('/', begin + 1), pointer.size());
        const std::string_view step = pointer.substr(begin, end - begin);
        const bool is_of_key = end == pointer.size() && fault.at != JsonFault::At::value;
        const bool found =
            is_of_key ? place.enter_key(step, fault.at == JsonFault::At::key ? 1 : 2) : place.enter(step);
        if (!found) break;
        begin = end;
    }
    return place.at();
}

std::string text_with_places(const Misread& misread, std::string_view text, const std::string& file) {
    std::vector<std::pair<std::size_t, const JsonFault*>> placed;
    for (const auto& fault : misread.faults) placed.emplace_back(position_of(fault, text), &fault);
    const auto is_before = [](const auto& one, const auto& other) { return one.first < other.first; };
    std::stable_sort(placed.begin(), placed.end(), is_before);
    std::string text_of_faults;
    for (const auto& [position, fault] : placed) {
        text_of_faults += (text_of_faults.empty() ? "" : "\n") + file + ": " + line_and_column(text, position) + ": " +
                          fault->in_words();
    }
    if (placed.size() >= Faults::most) text_of_faults += '\n' + file + ": there may be more faults: reading ended here";
    return text_of_faults;
}

}  // namespace vidno
