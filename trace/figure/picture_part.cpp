#include <cmath>

#include "parts.h"
#include "patches.h"

namespace vidno::figures {

namespace {

constexpr double grid_from = 2;      // millimetres a pixel
constexpr double hatch_apart = 1.3;  // millimetres
constexpr std::size_t most_textures = 6;

/// Parallel lines at a fixed distance across the whole drawing, cut to the boxes. `slope` is 1 or -1.
std::vector<Polyline> hatching(const std::vector<Box>& boxes, int slope) {
    const double apart = hatch_apart * std::sqrt(2.);
    std::map<int, std::vector<std::pair<double, double>>> lines;  // x - slope y = i apart, from x to x
    for (const auto& box : boxes) {
        const double ends[]{box.x - slope * box.y, box.right() - slope * box.y, box.x - slope * box.bottom(),
                            box.right() - slope * box.bottom()};
        const auto [least, most] = std::minmax_element(std::begin(ends), std::end(ends));
        for (int i = int(std::ceil(*least / apart)); i * apart <= *most; ++i) {
            const auto x_at = [&](double y) { return i * apart + slope * y; };
            const auto [left, right] = std::minmax({x_at(box.y), x_at(box.bottom())});
            lines[i].emplace_back(std::max(left, box.x), std::min(right, box.right()));
        }
    }
    constexpr double touching = 1e-6;
    std::vector<Polyline> found;
    for (auto& [i, pieces] : lines) {
        std::sort(pieces.begin(), pieces.end());
        double until = -1e9;
        for (const auto& [from, to] : pieces) {
            if (to - from < touching) continue;
            const auto at = [&, line = i](double x) { return Point{x, slope * (x - line * apart)}; };
            if (from > until + touching) found.push_back({at(from), at(to)});
            found.back().back() = at(until = to);
        }
    }
    return found;
}

/// Small squares standing on their corners, in alternating rows.
std::vector<Polyline> dots(const std::vector<Box>& boxes) {
    constexpr double reach = 0.16;
    std::vector<Polyline> found;
    for (const auto& box : boxes) {
        for (int row = int(std::ceil(box.y / hatch_apart)); row * hatch_apart < box.bottom(); ++row) {
            const double shift = row % 2 == 0 ? 0 : 0.5;
            for (int i = int(std::ceil(box.x / hatch_apart - shift)); (i + shift) * hatch_apart < box.right(); ++i) {
                const Point at{(i + shift) * hatch_apart, row * hatch_apart};
                found.push_back(
                    {at + Point{-reach, 0}, at + Point{0, -reach}, at + Point{reach, 0}, at + Point{0, reach}});
            }
        }
    }
    return found;
}

/// The index of a colour among those of the scene's polygons; none for the background, which has no texture.
std::optional<std::size_t> texture_of(const Color& color, const Scene& scene) {
    std::vector<Color> colors;
    for (const auto& polygon : scene.polygons) {
        if (std::find(colors.begin(), colors.end(), polygon.color) == colors.end()) colors.push_back(polygon.color);
        if (colors.size() > most_textures) return std::nullopt;
    }
    const auto found = std::find(colors.begin(), colors.end(), color);
    if (found == colors.end() || color == scene.background) return std::nullopt;
    return std::size_t(found - colors.begin());
}

void draw_texture(Drawing& to, std::size_t texture, const std::vector<Box>& boxes, const Color& color) {
    const auto hatch = [&](int slope) { to.add(Path{hatching(boxes, slope), false, {}, Stroke{color}}); };
    switch (texture) {
        case 0: return;  // plain
        case 1: return hatch(-1);
        case 2: return hatch(1);
        case 3: return to.add(Path{dots(boxes), true, color});
        case 4: return hatch(-1), hatch(1);
        default: return hatch(-1), to.add(Path{dots(boxes), true, color});
    }
}

void draw_grid(Drawing& to, const Plane& plane) {
    const Area& area = plane.area;
    std::vector<Polyline> lines;
    for (int x = area.x + 1; x < area.right(); ++x) lines.push_back({plane.at(x, area.y), plane.at(x, area.bottom())});
    for (int y = area.y + 1; y < area.bottom(); ++y) lines.push_back({plane.at(area.x, y), plane.at(area.right(), y)});
    constexpr Color light{0xd9, 0xdd, 0xe3};
    to.add(Path{std::move(lines), false, {}, Stroke{light}});
}

}  // namespace

void draw_picture(Drawing& to, const Moment& moment, const Plane& plane, const Style& style) {
    for (const auto& [color, rectangles, last] : patches_of(moment.state().picture())) {
        std::vector<Box> boxes;
        for (const auto& [x, y, width, height] : rectangles) boxes.push_back(plane.box(x, y, width, height));
        std::vector<Polyline> outlines;
        for (const auto& box : boxes) outlines.push_back(box.corners());
        const Color fill = tinted(color, style.greyscale);
        if (fill == paper) continue;
        // Neighbours overlap by half the stroke, so that no seam shows between them.
        to.add(Path{std::move(outlines), true, fill, Stroke{fill}});
        const auto texture = texture_of(color, moment.scene());
        if (texture) draw_texture(to, *texture, boxes, style.greyscale ? deep(color, true) : color);
    }
    if (plane.scale >= grid_from) draw_grid(to, plane);
}

void draw_frame(Drawing& to, const Plane& plane) {
    constexpr double size = tick_size, gap = 0.8;
    const Area& area = plane.area;
    const Box box = plane.box(whole_area(area));
    to.add(rectangle(box, {}, Stroke{ink, 0.5}));
    const double above = plane.shown.y - gap;
    const double left = plane.shown.x - gap;
    const double letter = 0.7 * size / points_per_millimetre;
    const auto put = [&](std::string text, Point at, Anchor anchor) {
        to.add(Label{std::move(text), at, size, anchor, false, ink});
    };
    put(integer_text(area.x), {box.x, above}, Anchor::middle);
    put("x →", {box.x + box.width / 2, above}, Anchor::middle);
    const std::string right = integer_text(area.right());
    const double room = plane.shown.right() - width_of(right, size) / 2;
    put(right, {std::min(box.right(), room), above}, Anchor::middle);
    put(integer_text(area.y), {left, box.y + letter / 2}, Anchor::end);
    put("y ↓", {left, box.y + box.height / 2 + letter / 2}, Anchor::end);
    put(integer_text(area.bottom()), {left, box.bottom() + letter / 2}, Anchor::end);
}

}  // namespace vidno::figures
