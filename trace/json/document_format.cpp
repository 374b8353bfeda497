#include "json/document_format.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "refused.h"

namespace vidno {

namespace {

using nlohmann::json;

/// Keys that determine the format of a file without "format".
constexpr std::array<std::pair<std::string_view, std::string_view>, 4> telling_keys{{{"polygons", "vidno-scene/1"},
                                                                                     {"curves", "vidno-surface/1"},
                                                                                     {"function", "vidno-surface/1"},
                                                                                     {"fails", "vidno-failure/1"}}};

/// Follows the parser up to the member of the outermost object that determines its format.
class FormatFinder : public nlohmann::json_sax<json> {
public:
    std::string format;

    bool null() override { return next(); }
    bool boolean(bool) override { return next(); }
    bool number_integer(number_integer_t) override { return next(); }
    bool number_unsigned(number_unsigned_t) override { return next(); }
    bool number_float(number_float_t, const string_t&) override { return next(); }
    bool string(string_t& value) override {
        if (is_format_) format = std::move(value);
        return next();
    }
    bool binary(binary_t&) override { return next(); }
    bool start_object(std::size_t) override { return open(); }
    bool start_array(std::size_t) override { return depth_ > 0 && open(); }
    bool end_object() override { return --depth_ > 0; }
    bool end_array() override { return --depth_ > 0; }
    bool key(string_t& name) override {
        if (depth_ != 1) return true;
        is_format_ = name == "format";
        const auto known = std::find_if(telling_keys.begin(), telling_keys.end(),
                                        [&](const auto& telling) { return telling.first == name; });
        if (known == telling_keys.end()) return true;
        format = known->second;
        return false;
    }
    bool parse_error(std::size_t, const std::string&, const json::exception&) override { return false; }

private:
    /// Whether to continue.
    bool next() const { return depth_ > 0 && !is_format_; }
    bool open() {
        ++depth_;
        return !is_format_;
    }

    int depth_ = 0;
    bool is_format_ = false;  // the key of the outermost object that was read last
};

/// 2 for "vidno-trace/2"; none for a format that is not of vidno.
std::optional<int> version_of(std::string_view format) {
    const auto slash = format.find('/');
    if (!format.starts_with("vidno-") || slash == format.npos) return std::nullopt;
    const char* end = format.data() + format.size();
    int version = 0;
    const auto [stop, error] = std::from_chars(format.data() + slash + 1, end, version);
    return error == std::errc{} && stop == end ? std::optional(version) : std::nullopt;
}

/// The words with a format in place of each {}.
std::string with_formats(std::string_view words, std::initializer_list<std::string_view> formats) {
    std::string text(words);
    for (const auto format : formats) text.replace(text.find("{}"), 2, format);
    return text;
}

}  // namespace

std::string document_format(std::string_view text) {
    FormatFinder finder;
    json::sax_parse(text, &finder);
    return finder.format;
}

bool are_of_one_kind(std::string_view format, std::string_view other) {
    return format.substr(0, format.find('/')) == other.substr(0, other.find('/'));
}

std::string other_format(std::string_view format, std::string_view read) {
    const auto [other, newer, older] = english_format_words;
    const auto found = version_of(format);
    const auto known = version_of(read);
    if (!found || found == known) return with_formats(other, {read});
    return with_formats(found > known ? newer : older, {read, format});
}

void expect_format_in(std::string_view text, std::string_view read, const std::string& file) {
    const std::string format = document_format(text);
    if (!format.empty() && format != read) throw Refused(file + ": /format: " + other_format(format, read));
}

}  // namespace vidno
