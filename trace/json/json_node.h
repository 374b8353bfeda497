/// Reads JSON from elsewhere: errors are refused with their place in the document, and nothing is ignored.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "json/misread.h"
#include "refused.h"
#include "vidno/scene.h"

namespace vidno {

/// Text that is not JSON.
struct NotJson : Refused {
    using Refused::Refused;
};

/// The document. Throws NotJson, or Misread for text that is nested too deeply or has an object with the same key
/// twice.
nlohmann::json parse_json(std::string_view text);

/// Text from elsewhere, prepared for a message of one line: no control characters, and not too long.
std::string printable(std::string_view text);

/// A value and its place. `refuse` and each failed read throw Misread. A path is built only for errors.
class JsonNode {
public:
    explicit JsonNode(const nlohmann::json& value) : value_(value) {}

    [[noreturn]] void refuse(std::string_view reason) const;

    /// Requires an object with all required keys, and no others except the optional ones. Reports each key at fault.
    void require_keys(std::initializer_list<std::string_view> required,
                      std::initializer_list<std::string_view> optional = {}) const;
    void require_keys(std::span<const std::string_view> required,
                      std::span<const std::string_view> optional = {}) const;

    /// Requires that an object's member "format", if present, is this one. With another format nothing else is checked.
    void expect_format(std::string_view format) const;

    bool has(std::string_view key) const { return value_.contains(key); }
    JsonNode at(std::string_view key) const { return JsonNode(*value_.find(key), this, key, 0); }

    const nlohmann::json& value() const { return value_; }
    bool is_null() const { return value_.is_null(); }
    bool is_text() const { return value_.is_string(); }

    std::size_t size() const;
    JsonNode at(std::size_t index) const { return JsonNode(value_[index], this, {}, index); }

    /// The keys of an object, sorted.
    std::vector<std::string> keys() const;

    const nlohmann::json& object() const;
    const std::string& text() const;
    /// The index of the text among the names. Anything else is refused for this reason.
    std::size_t place_among(std::span<const std::string_view> names, std::string_view reason = "unknown word") const;
    bool truth() const;
    int whole_number(int least, int greatest) const;
    /// A number, or one written as hexadecimal text. -0 becomes 0.
    double number() const;
    glm::dvec2 pair() const;
    glm::dvec3 triple() const;
    Color color() const;
    Area window() const;

private:
    JsonNode(const nlohmann::json& value, const JsonNode* parent, std::string_view key, std::size_t index)
        : value_(value), parent_(parent), key_(key), index_(index) {}

    std::string pointer() const;
    double hexadecimal() const;

    const nlohmann::json& value_;
    const JsonNode* parent_ = nullptr;
    std::string_view key_;
    std::size_t index_ = 0;
};

/// Reads a document by `read`. A refusal names the file and, for an error in the document, the line and column.
auto read_json(std::string_view text, const std::string& file, auto&& read) {
    try {
        const nlohmann::json document = parse_json(text);
        return read(JsonNode(document));
    } catch (const Misread& misread) {
        throw Refused(text_with_places(misread, text, file));
    } catch (const Refused& refused) {
        throw Refused(file + ": " + refused.what());
    }
}

}  // namespace vidno
