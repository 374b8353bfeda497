#include "map_figure.h"

#include "patches.h"
#include "scene/scene_names.h"
#include "table.h"

namespace vidno::figures {

namespace {

/// The border where the exact answer changes: sides of cells, in a plane with p at the upper left.
std::vector<Polyline> border(const SignMap& map, const Plane& plane) {
    std::vector<Polyline> lines;
    const auto add = [&](Point from, Point to) {
        const bool goes_on = !lines.empty() && lines.back().back() == from;
        if (goes_on) {
            lines.back().push_back(to);
        } else {
            lines.push_back({from, to});
        }
    };
    const auto row = [&](int y) { return map.side - y; };  // y grows upward, as in the published maps
    for (int y = 0; y < map.side; ++y) {
        for (int x = 0; x < map.side; ++x) {
            const Sign exact = map.at(x, y).exact;
            if (x > 0 && map.at(x - 1, y).exact != exact) add(plane.at(x, row(y + 1)), plane.at(x, row(y)));
            if (y > 0 && map.at(x, y - 1).exact != exact) add(plane.at(x, row(y)), plane.at(x + 1, row(y)));
        }
    }
    return lines;
}

Picture cells_of(const SignMap& map) {
    Picture picture({0, 0, map.side, map.side}, {});
    for (int y = 0; y < map.side; ++y) {
        for (int x = 0; x < map.side; ++x) picture.paint(x, map.side - 1 - y, color_of(map.at(x, y)));
    }
    return picture;
}

/// One row per answer: how often it was right and wrong, each count beside its colour.
Drawing legend(const SignMap& map, const Style& style, double width) {
    const auto& words = words_of(style.language);
    const auto counts = map.counts();
    Table table{
        .title = std::string(map_word_in(style.language, map.decision)) + ", " + map.kernel,
        .columns = {
            {std::string(words.computed), 0.4}, {std::string(words.right), 0.3}, {std::string(words.wrong), 0.3}}};
    for (std::size_t i = 0; i < map.answers.size(); ++i) {
        if (map.answers[i].empty()) continue;
        int all = 0;
        for (const int count : counts[i]) all += count;
        const int right = counts[i][i];
        const auto color = [&](std::size_t exact) {
            return printed(color_of({Sign(int(i) - 1), Sign(int(exact) - 1)}), style.greyscale);
        };
        table.rows.push_back({{std::string(map_word_in(style.language, map.answers[i]))},
                              {std::to_string(right), color(i)},
                              {std::to_string(all - right), color((i + 1) % 3)}});
    }
    if (!map.name.empty()) table.below.push_back(name_in(style.language, map.name));
    return drawn(table, width, style.letters);
}

}  // namespace

Drawing map_figure(const SignMap& map, const Style& style, double width) {
    const Plane plane{{0, 0, map.side, map.side}, width / map.side, {}, {0, 0, width, width}};
    Drawing drawing{width, width};
    for (const auto& [color, rectangles, last] : patches_of(cells_of(map))) {
        std::vector<Polyline> outlines;
        for (const auto& [x, y, w, h] : rectangles) outlines.push_back(plane.box(x, y, w, h).corners());
        const Color fill = printed(color, style.greyscale);
        drawing.add(Path{std::move(outlines), true, fill, {}});
    }
    add_rimmed(drawing, Path{border(map, plane), false, {}, Stroke{Color{}, 0.5}});
    drawing.add(rectangle({0.1, 0.1, width - 0.2, width - 0.2}, {}, Stroke{ink, 0.5}));
    const Drawing below = legend(map, style, width);
    drawing.place(below, {0, width + 1});
    drawing.height = width + 1 + below.height;
    return drawing;
}

}  // namespace vidno::figures
