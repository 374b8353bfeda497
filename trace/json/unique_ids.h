/// The ids of a scene: non-empty, at most longest_id bytes, all different; and the parts into which polygons are cut.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>
#include <vector>

#include "vidno/scene.h"

namespace vidno {

inline constexpr std::size_t longest_id = 200;

/// The longest prefix of UTF-8 text with at most `most` bytes, without half a character at its end.
inline std::string_view first_bytes(std::string_view text, std::size_t most) {
    if (text.size() <= most) return text;
    while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xC0) == 0x80) --most;
    return text.substr(0, most);
}

/// The reason to refuse a scene whose polygons were cut into more than most_polygons parts.
inline std::string too_many_parts() { return "cut into more than " + std::to_string(most_polygons) + " polygons"; }

/// Parts of polygon "A" become "A.1", "A.2", ...; numbers already in use are skipped. A single part keeps the id.
class PartIds {
public:
    explicit PartIds(std::unordered_set<std::string> taken) : taken_(std::move(taken)) {}

    void name(std::vector<ScenePolygon>& parts) {
        if (parts.size() < 2) return;
        std::size_t number = 0;
        for (auto& part : parts) {
            const std::string stem(first_bytes(part.id, longest_id - 10));
            do {
                part.id = stem + "." + std::to_string(++number);
            } while (!taken_.insert(part.id).second);
        }
    }

private:
    std::unordered_set<std::string> taken_;
};

}  // namespace vidno
