/// DepthBuffer, Z: the depth that each pixel shows.
#pragma once

#include <vector>

#include "scene.h"

namespace vidno {

template <class Depth>
class DepthBuffer {
public:
    void clear(const Area& area, const Depth& depth) {
        area_ = area;
        depths_.assign(std::size_t(area.width) * std::size_t(area.height), depth);
    }

    Depth& at(int x, int y) {
        assert(area_.contains(x, y));
        return row(y)[x];
    }

    PixelRow<Depth> row(int y) { return row_of(depths_, area_, y); }

private:
    Area area_;
    std::vector<Depth> depths_;
};

}  // namespace vidno
