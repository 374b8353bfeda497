/// The polygons of a scene by the ids that a trace uses.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

#include "format/event_text.h"

namespace vidno {

class KnownPolygons {
public:
    KnownPolygons() = default;
    explicit KnownPolygons(const PolygonNames& names) {
        places_.reserve(names.size());
        for (std::size_t i = 0; i < names.size(); ++i) places_.emplace(names[i], int(i));
    }

    /// Finds a polygon by its id as a JSON string with quotes. None if there is no such polygon.
    std::optional<PolygonPlace> find(std::string_view name) const {
        const auto found = places_.find(name);
        return found == places_.end() ? std::nullopt : std::optional(PolygonPlace{found->second});
    }

private:
    struct Hash : std::hash<std::string_view> {
        using is_transparent = void;
    };
    std::unordered_map<std::string, int, Hash, std::equal_to<>> places_;
};

}  // namespace vidno
