#include <utility>

#include "json/json_text.h"
#include "sign_map/map.h"

namespace vidno {

namespace {

constexpr int zoom = 4;  // a picture of 1024 x 1024 pixels

// Indexed by the computed sign. The colours also differ in lightness.
constexpr std::array<Color, 3> agreeing{{{255, 226, 204}, {255, 255, 255}, {165, 200, 240}}};
constexpr std::array<Color, 3> differing{{{215, 95, 0}, {0, 0, 0}, {30, 70, 170}}};
constexpr Color lower_side{0, 0, 0}, upper_side{255, 255, 255};

}  // namespace

Color color_of(const SignMap::Cell& cell) { return (cell.differs() ? differing : agreeing)[place_of(cell.computed)]; }

Picture picture_of(const SignMap& map) {
    const int side = map.side;
    Picture picture({0, 0, side * zoom, side * zoom}, {});
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const auto& cell = map.at(x, y);
            const int left = x * zoom;
            const int top = (side - 1 - y) * zoom;
            picture.paint(PixelRectangle{left, top, zoom, zoom}, color_of(cell));
            const auto border_with = [&](int i, int j, const PixelRectangle& pixels) {
                if (i < 0 || i == side || j < 0 || j == side) return;
                const Sign beyond = map.at(i, j).exact;
                if (beyond != cell.exact) picture.paint(pixels, cell.exact < beyond ? lower_side : upper_side);
            };
            border_with(x - 1, y, {left, top, 1, zoom});
            border_with(x + 1, y, {left + zoom - 1, top, 1, zoom});
            border_with(x, y + 1, {left, top, zoom, 1});
            border_with(x, y - 1, {left, top + zoom - 1, zoom, 1});
        }
    }
    return picture;
}

std::string map_json(const SignMap& map) {
    const auto counts = map.counts();
    Text out;
    out += "{\"format\":\"vidno-map/1\",\"name\":";
    append_string(out, map.name);
    out += ",\"decision\":";
    append_string(out, map.decision);
    out += ",\"kernel\":";
    append_string(out, map.kernel);
    out += ",\"counts\":[";
    bool first = true;
    for (std::size_t computed = 0; computed < 3; ++computed) {
        for (std::size_t exact = 0; exact < 3; ++exact) {
            if (map.answers[computed].empty() || map.answers[exact].empty()) continue;
            if (!std::exchange(first, false)) out += ',';
            out += "{\"computed\":";
            append_string(out, map.answers[computed]);
            out += ",\"exact\":";
            append_string(out, map.answers[exact]);
            out += ",\"places\":";
            append_integer(out, counts[computed][exact]);
            out += '}';
        }
    }
    out += "],\"differ\":";
    append_integer(out, map.differing());
    out += "}\n";
    return out.string();
}

}  // namespace vidno
