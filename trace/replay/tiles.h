/// Tiles: one value for each pixel of an area, stored in square tiles.
///
/// Copies share a tile until one of them writes to it, and tiles of one value share their memory. So a copy for a large
/// area is cheap, and an area that was painted in a few rectangles takes little memory.
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "vidno/picture.h"

namespace vidno {

template <class T, int side = 64>
class Tiles {
public:
    Tiles(const Area& area, const T& value)
        : area_(area),
          across_(tiles_for(area.width)),
          tiles_(std::size_t(across_) * std::size_t(tiles_for(area.height))) {
        std::fill(tiles_.begin(), tiles_.end(), uniform(value));
    }

    const Area& area() const { return area_; }
    /// The bytes that a copy takes before anything is written.
    std::size_t bytes_of_copy() const { return tiles_.size() * sizeof(tiles_[0]); }

    const T& at(int x, int y) const { return tiles_[tile_of(x, y)]->cells[cell_of(x, y)]; }

    void set(int x, int y, const T& value) { writable(tile_of(x, y)).cells[cell_of(x, y)] = value; }

    /// The pixels must lie in the area.
    void fill(const PixelRectangle& pixels, const T& value) {
        const int left = pixels.x - area_.x, top = pixels.y - area_.y;
        const int right = left + pixels.width, bottom = top + pixels.height;
        if (left >= right) return;
        for (int y = top; y < bottom; y = next(y, bottom)) {
            for (int x = left; x < right; x = next(x, right)) {
                fill_in_tile(x, y, next(x, right), next(y, bottom), value);
            }
        }
    }
    void fill(const PixelRun& run, const T& value) { fill({run.first, run.row, run.end - run.first, 1}, value); }

    /// Calls `take(const T*, count)` for the pieces of a row from left to right.
    void for_row(int y, auto&& take) const {
        for (int x = 0; x < area_.width; x = next(x, area_.width)) {
            take(&at(area_.x + x, y), next(x, area_.width) - x);
        }
    }

private:
    struct Tile {
        std::array<T, std::size_t(side) * side> cells;
    };
    using Shared = std::shared_ptr<Tile>;

    static int tiles_for(int length) { return (length + side - 1) / side; }
    /// The place where the next tile begins, but not beyond the end.
    static int next(int place, int end) { return std::min(end, place - place % side + side); }

    std::size_t tile_of(int x, int y) const {
        return std::size_t((y - area_.y) / side) * std::size_t(across_) + std::size_t((x - area_.x) / side);
    }
    std::size_t cell_of(int x, int y) const {
        return std::size_t((y - area_.y) % side) * side + std::size_t((x - area_.x) % side);
    }

    /// Fills a part of one tile; the places are relative to the area.
    void fill_in_tile(int left, int top, int right, int bottom, const T& value) {
        const std::size_t place = tile_of(area_.x + left, area_.y + top);
        const bool is_whole = right - left == std::min(side, area_.width - left) && left % side == 0 &&
                              bottom - top == std::min(side, area_.height - top) && top % side == 0;
        if (is_whole) {
            tiles_[place] = uniform(value);
            return;
        }
        auto& cells = writable(place).cells;
        for (int y = top; y < bottom; ++y) {
            std::fill_n(cells.begin() + (y % side) * side + left % side, right - left, value);
        }
    }

    const Shared& uniform(const T& value) {
        if (!uniform_ || !(uniform_->cells[0] == value)) {
            uniform_ = std::make_shared<Tile>();
            uniform_->cells.fill(value);
        }
        return uniform_;
    }

    Tile& writable(std::size_t place) {
        Shared& tile = tiles_[place];
        if (tile.use_count() > 1) tile = std::make_shared<Tile>(*tile);
        return *tile;
    }

    Area area_;
    int across_;
    std::vector<Shared> tiles_;
    Shared uniform_;  // the last one, which is never written to
};

}  // namespace vidno
