#include "chart/chart_pictures.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "json/json_text.h"

namespace vidno {

namespace {

using Json = nlohmann::ordered_json;

/// The index of an item, which is appended if it is new.
template <class Item>
std::size_t place_in(std::vector<Item>& items, const Item& item) {
    const auto known = std::find(items.begin(), items.end(), item);
    const auto place = std::size_t(known - items.begin());
    if (known == items.end()) items.push_back(item);
    return place;
}

}  // namespace

std::size_t ScenePictures::place_of(const std::vector<Color>& pixels) {
    Runs runs;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        if (i > 0 && pixels[i] == pixels[i - 1]) {
            ++runs[runs.size() - 2];
        } else {
            runs.insert(runs.end(), {1, place_in(colors_, pixels[i])});
        }
    }
    return place_in(shown_, runs);
}

std::string ScenePictures::json() const {
    Json colors = Json::array();
    for (const Color& color : colors_) colors.push_back(hex_of(color));
    return Json{{"width", width_}, {"colors", colors}, {"shown", shown_}}.dump();
}

/// Leaves out each point that is within a tenth of a pixel of the line between those that stay.
std::vector<SurfacePictures::Place> SurfacePictures::straightened(const std::vector<Place>& line) {
    std::vector<Place> kept;
    std::size_t from = 0;
    const auto is_straight = [&](std::size_t to) {
        const auto [x, y] = line[from];
        const double across = line[to].x - x, down = line[to].y - y;
        for (std::size_t i = from + 1; i < to; ++i) {
            const double height = across == 0 ? y : y + down * (line[i].x - x) / across;
            if (std::abs(height - line[i].y) > 1) return false;
        }
        return true;
    };
    if (!line.empty()) kept.push_back(line.front());
    for (std::size_t to = 1; to < line.size(); ++to) {
        if (to + 1 < line.size() && is_straight(to + 1)) continue;
        kept.push_back(line[to]);
        from = to;
    }
    return kept;
}

std::size_t SurfacePictures::place_of(const DrawnLines& lines) {
    const auto place = [&](const LineEnd<Value>& end) {
        const auto tenths = [](double value) { return int(std::lround(10 * value)); };
        return Place{tenths(number_of(end.point.x) - area_.x), tenths(number_of(end.point.y) - area_.y)};
    };
    Drawing drawing;
    int curve = -1;
    for (const auto& line : lines) {
        const Place from = place(line.from), to = place(line.to);
        if (line.segment.curve != curve || !(drawing.back().back() == from)) drawing.push_back({from});
        drawing.back().push_back(to);
        curve = line.segment.curve;
    }
    for (auto& line : drawing) line = straightened(line);
    return place_in(shown_, drawing);
}

std::string SurfacePictures::json() const {
    Json shown = Json::array();
    for (const Drawing& drawing : shown_) {
        Json lines = Json::array();
        for (const auto& line : drawing) {
            Json numbers = Json::array();
            for (const auto& [x, y] : line) {
                numbers.push_back(x / 10.);
                numbers.push_back(y / 10.);
            }
            lines.push_back(std::move(numbers));
        }
        shown.push_back(std::move(lines));
    }
    return Json{{"width", area_.width}, {"height", area_.height}, {"shown", shown}}.dump();
}

}  // namespace vidno
