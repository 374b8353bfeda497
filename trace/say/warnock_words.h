/// WarnockWords: the words about a step of Warnock's algorithm, and what they find in the state after it.
#pragma once

#include <algorithm>

#include "say/words.h"

namespace vidno::say {

/// Where a corner of a window is, in Russian.
inline constexpr std::array<std::string_view, 4> in_corner{"в левом верхнем углу", "в левом нижнем углу",
                                                           "в правом верхнем углу", "в правом нижнем углу"};

/// Whose colour it is: that of one polygon or of the background, or of all that have it if the trace does not say
/// which.
struct Owners {
    std::vector<std::string> polygons{};
    bool background = false;
};

class WarnockWords : public PolygonWords {
public:
    explicit WarnockWords(const PolygonWords& words) : PolygonWords(words) {}

    const WarnockState& warnock() const { return after().warnock(); }
    bool is_at(const auto& event, std::initializer_list<Line> lines) const {
        return std::find(lines.begin(), lines.end(), event.at) != lines.end();
    }
    const std::optional<WarnockState::StackedWindow>& window() const { return warnock().current(); }

    /// The corner of the current window at a point.
    std::optional<Corner> corner_at(const ValuePoint& point) const {
        if (!window()) return std::nullopt;
        const Window& of = window()->window;
        const double x = number_of(point.x), y = number_of(point.y);
        if ((x != of.x && x != of.right()) || (y != of.y && y != of.bottom())) return std::nullopt;
        if (x == of.x) return y == of.y ? Corner::left_bottom : Corner::left_top;
        return y == of.y ? Corner::right_bottom : Corner::right_top;
    }
    std::string_view place_of(Corner corner) const { return in(corner_places[std::size_t(corner)]); }
    std::string places_of(const std::vector<Corner>& corners) const {
        std::vector<std::string> places;
        for (const Corner corner : corners) places.emplace_back(place_of(corner));
        return joined(places, ", ");
    }
    /// "At the top left corner", "At the point (2, 3)".
    std::string at(const ValuePoint& point) const {
        const auto corner = corner_at(point);
        if (!corner) return say("At the point {}", "В точке {}", point);
        return say("At the {} corner", "{1}", place_of(*corner), capital(std::string(in_corner[std::size_t(*corner)])));
    }

    std::vector<std::string> current_list() const {
        return window() ? entries(warnock().list(*window()).entries()) : std::vector<std::string>{};
    }
    std::vector<std::string> entries(const std::vector<AplEntry>& list) const {
        std::vector<std::string> names;
        for (const auto& entry : list) names.push_back(word(entry.first));
        return names;
    }
    /// The only polygon of the current list. None if the trace is too coarse to tell.
    std::optional<std::string> only() const {
        const auto list = current_list();
        return list.size() == 1 ? std::optional(list[0]) : std::nullopt;
    }
    /// The polygon that hides all others in the window: the one that was found, or the only one that surrounds it.
    std::optional<PolygonPlace> hiding() const {
        if (warnock().covering()) return warnock().covering();
        const auto& surrounding = warnock().joined().surrounding;
        return surrounding.empty() ? std::nullopt : std::optional(surrounding.back().polygon);
    }
    std::string name_or(std::optional<PolygonPlace> polygon, Bilingual other) const {
        return polygon ? word(*polygon) : std::string(in(other));
    }
    /// The sum so far for the edges of an outline: crossings of a ray, or octants.
    int containment() const {
        int sum = 0;
        for (const auto& edge : warnock().contained()) {
            if (const auto* ray = edge.get_if<event::Ray>()) sum += ray->counts;
            if (const auto* octants = edge.get_if<event::Octants>()) sum += octants->difference;
        }
        return sum;
    }

    /// The owners of the colour that an event paints or finds.
    Owners owners(const auto& e) const {
        using enum Line;
        constexpr bool fills = std::is_same_v<std::decay_t<decltype(e)>, event::Fill>;
        // These lines fill a window with the background, even if a polygon has that colour.
        if (fills && is_at(e, {W7, W10, WS4, WF5, WF6})) return {{}, true};
        const bool is_point = is_at(e, {W9, WS5, WF11});  // PointColor has found it
        const auto& nearest = warnock().nearest();
        const auto owner = !is_point ? hiding() : nearest ? std::optional(nearest->polygon) : std::nullopt;
        if (owner) return owner_of(*owner, e.color);
        const bool is_background = e.color == header().scene.background;
        if (is_point && is_background && header().detail != Detail::windows) return {{}, true};
        return {with_color(e.color), is_background};
    }

private:
    /// A trace that contradicts itself gets no name, only the colour that it records.
    Owners owner_of(PolygonPlace polygon, const Color& color) const {
        const auto& found = header().scene.polygons[std::size_t(polygon.index)];
        return found.color == color ? Owners{{found.id}} : Owners{};
    }
    std::vector<std::string> with_color(const Color& color) const {
        std::vector<std::string> names;
        for (const auto& polygon : header().scene.polygons) {
            if (polygon.color == color) names.push_back(polygon.id);
        }
        return names;
    }
};

}  // namespace vidno::say
