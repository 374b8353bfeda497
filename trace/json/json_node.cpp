#include "json/json_node.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <system_error>
#include <utility>
#include <vector>

#include "json/document_format.h"
#include "json/json_text.h"
#include "json/unique_ids.h"

namespace vidno {

using nlohmann::json;

std::string printable(std::string_view text) {
    constexpr std::size_t most = 100;
    std::string out(first_bytes(text, most));
    for (char& c : out) {
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
    }
    if (out.size() < text.size()) out += "...";
    return out;
}

namespace {

constexpr int deepest_nesting = 16;

/// Builds the document from the parser's calls, and refuses what a tree could no longer show: text that is not JSON,
/// with its place, nesting that is too deep, and a key that an object has twice.
class DocumentBuilder : public nlohmann::json_sax<json> {
public:
    explicit DocumentBuilder(std::string_view text) : text_(text) {}

    json&& document() { return std::move(document_); }

    bool null() override { return add(nullptr); }
    bool boolean(bool value) override { return add(value); }
    bool number_integer(number_integer_t value) override { return add(value); }
    bool number_unsigned(number_unsigned_t value) override { return add(value); }
    bool number_float(number_float_t value, const string_t&) override { return add(value); }
    bool string(string_t& value) override { return add(std::move(value)); }
    bool binary(binary_t& value) override { return add(std::move(value)); }
    bool start_object(std::size_t) override { return open(json::object()); }
    bool start_array(std::size_t) override { return open(json::array()); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }

    bool key(string_t& name) override {
        auto& [container, member] = levels_.back();
        const auto [at, is_new] = container->get_ref<json::object_t&>().try_emplace(std::move(name));
        member = &*at;
        if (!is_new) throw Misread({pointer(), "the key occurs twice", JsonFault::At::second_key});
        return true;
    }

    bool parse_error(std::size_t position, const std::string&, const json::exception& error) override {
        constexpr int number_overflow = 406;
        if (error.id == number_overflow) throw Misread({pointer(), "the number is beyond the range of doubles"});
        throw NotJson(line_and_column(text_, position > 0 ? position - 1 : 0) + ": not valid JSON");
    }

private:
    /// An array or an object that is not closed yet.
    struct Level {
        json* container;
        json::object_t::value_type* member = nullptr;  // in an object, the one whose key was read last
    };

    /// The place of the value that is read.
    std::string pointer() const {
        std::string out;
        for (const auto& [container, member] : levels_) {
            if (container->is_array()) {
                const bool is_innermost = container == levels_.back().container;
                out += "/" + std::to_string(container->size() - (is_innermost ? 0 : 1));
            } else if (member) {
                out += pointer_step(member->first);
            }
        }
        return out;
    }

    json& place(json&& value) {
        if (levels_.empty()) return document_ = std::move(value);
        auto& [container, member] = levels_.back();
        if (!member) return container->get_ref<json::array_t&>().emplace_back(std::move(value));
        return member->second = std::move(value);
    }

    bool add(json&& value) {
        place(std::move(value));
        return true;
    }
    bool open(json&& empty) {
        if (int(levels_.size()) == deepest_nesting) throw Misread({pointer(), "nested too deeply"});
        levels_.push_back({&place(std::move(empty))});
        return true;
    }
    bool close() {
        levels_.pop_back();
        return true;
    }

    std::string_view text_;
    json document_;
    std::vector<Level> levels_;
};

}  // namespace

json parse_json(std::string_view text) {
    DocumentBuilder builder(text);
    json::sax_parse(text, &builder);
    return builder.document();
}

void JsonNode::refuse(std::string_view reason) const { throw Misread({pointer(), std::string(reason)}); }

void JsonNode::require_keys(std::initializer_list<std::string_view> required,
                            std::initializer_list<std::string_view> optional) const {
    require_keys(std::span(required.begin(), required.size()), std::span(optional.begin(), optional.size()));
}

void JsonNode::require_keys(std::span<const std::string_view> required,
                            std::span<const std::string_view> optional) const {
    object();
    const auto is_in = [](const auto& keys, const std::string& key) {
        return std::find(keys.begin(), keys.end(), key) != keys.end();
    };
    std::vector<JsonFault> faults;
    for (const auto& [key, value] : value_.items()) {
        if (is_in(required, key) || is_in(optional, key)) continue;
        faults.push_back({at(key).pointer(), "unknown key", JsonFault::At::key});
    }
    for (const std::string_view key : required) {
        if (!has(key)) faults.push_back({pointer(), "\"" + std::string(key) + "\" is missing"});
    }
    if (!faults.empty()) throw Misread(std::move(faults));
}

void JsonNode::expect_format(std::string_view format) const {
    if (has("format") && at("format").text() != format) at("format").refuse(other_format(at("format").text(), format));
}

std::size_t JsonNode::size() const {
    if (!value_.is_array()) refuse("not an array");
    return value_.size();
}

std::vector<std::string> JsonNode::keys() const {
    std::vector<std::string> keys;
    for (const auto& [key, value] : object().items()) keys.push_back(key);
    return keys;
}

const json& JsonNode::object() const {
    if (!value_.is_object()) refuse("not an object");
    return value_;
}

const std::string& JsonNode::text() const {
    if (!value_.is_string()) refuse("not a string");
    return value_.get_ref<const std::string&>();
}

std::size_t JsonNode::place_among(std::span<const std::string_view> names, std::string_view reason) const {
    if (value_.is_string()) {
        const auto found = std::find(names.begin(), names.end(), text());
        if (found != names.end()) return std::size_t(found - names.begin());
    }
    refuse(reason);
}

bool JsonNode::truth() const {
    if (!value_.is_boolean()) refuse("neither true nor false");
    return value_.get<bool>();
}

int JsonNode::whole_number(int least, int greatest) const {
    const double number = value_.is_number() ? value_.get<double>() : 0.5;
    if (number != std::floor(number)) refuse("not a whole number");
    if (number < least || number > greatest) {
        refuse("not from " + std::to_string(least) + " to " + std::to_string(greatest));
    }
    return int(number);
}

double JsonNode::number() const {
    if (value_.is_number()) return value_.get<double>() + 0.0;
    if (!value_.is_string()) refuse("neither a number nor a hexadecimal one as text, such as \"0x1.8p-3\"");
    return hexadecimal() + 0.0;
}

glm::dvec2 JsonNode::pair() const {
    if (size() != 2) refuse("not two coordinates");
    return {at(0u).number(), at(1u).number()};
}

glm::dvec3 JsonNode::triple() const {
    if (size() != 3) refuse("not three coordinates");
    return {at(0u).number(), at(1u).number(), at(2u).number()};
}

Color JsonNode::color() const {
    const auto color = color_of_hex(text());
    if (!color) refuse("not a colour of the form \"#rrggbb\"");
    return *color;
}

Area JsonNode::window() const {
    require_keys({"x", "y", "width", "height"});
    return {at("x").whole_number(-farthest_offset, farthest_offset),
            at("y").whole_number(-farthest_offset, farthest_offset), at("width").whole_number(1, largest_side),
            at("height").whole_number(1, largest_side)};
}

std::string JsonNode::pointer() const {
    if (parent_ == nullptr) return "";
    const bool in_object = parent_->value_.is_object();
    return parent_->pointer() + (in_object ? pointer_step(key_) : "/" + std::to_string(index_));
}

/// [-]0x h+ [. h*] p [+-] d+
double JsonNode::hexadecimal() const {
    std::string_view rest = text();
    const bool negative = rest.starts_with('-');
    if (negative) rest.remove_prefix(1);
    const bool prefixed = rest.starts_with("0x") || rest.starts_with("0X");
    rest.remove_prefix(prefixed ? 2 : 0);
    constexpr std::string_view digits = "0123456789abcdefABCDEF";
    const bool well_begun = prefixed && rest.find_first_not_of(digits) > 0 && rest.find_first_of("pP") < rest.size();
    double value = 0;
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value, std::chars_format::hex);
    if (error == std::errc::result_out_of_range) refuse("the number is beyond the range of doubles");
    if (!well_begun || error != std::errc() || end != rest.data() + rest.size()) {
        refuse("not a hexadecimal number such as \"0x1.8p-3\"");
    }
    return negative ? -value : value;
}

}  // namespace vidno
