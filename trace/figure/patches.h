/// Patches: a picture as vector graphics.
#pragma once

#include <map>
#include <vector>

#include "vidno/picture.h"

namespace vidno::figures {

/// Pixels of one colour as rectangles that do not overlap: runs, joined where the next row has the same run.
struct Patch {
    Color color;
    std::vector<PixelRectangle> rectangles{};
    std::map<std::pair<int, int>, std::size_t> last{};  // the lowest patch with this start and end
};

/// One patch per colour, in the order in which the colours appear from the top.
inline std::vector<Patch> patches_of(const Picture& picture) {
    std::vector<Patch> patches;
    const auto patch_of = [&](const Color& color) -> Patch& {
        const auto found =
            std::find_if(patches.begin(), patches.end(), [&](const auto& patch) { return patch.color == color; });
        return found == patches.end() ? patches.emplace_back(Patch{color}) : *found;
    };
    const Area& area = picture.area();
    for (int y = area.y; y < area.bottom(); ++y) {
        for (int x = area.x, end = x; x < area.right(); x = end) {
            const Color color = picture.at(x, y);
            while (end < area.right() && picture.at(end, y) == color) ++end;
            auto& [same, rectangles, last] = patch_of(color);
            const auto above = last.find({x, end});
            if (above != last.end() && rectangles[above->second].y + rectangles[above->second].height == y) {
                ++rectangles[above->second].height;
            } else {
                last[{x, end}] = rectangles.size();
                rectangles.push_back({x, y, end - x, 1});
            }
        }
    }
    return patches;
}

}  // namespace vidno::figures
