/// VisibleAreas: how much of each pixel shows which colour, by the visible regions of Weiler and Atherton's algorithm, exactly.
#pragma once

#include <utility>
#include <vector>

#include "vidno/picture.h"

namespace vidno {

class VisibleAreas {
public:
    explicit VisibleAreas(const Scene& scene);

    /// How much of the area a picture of it shows in a wrong colour, in pixels.
    double wrong_in(const Picture& picture) const;

private:
    struct Share {
        Color color;
        double area;  // of the pixel
    };

    Area area_;
    std::vector<std::vector<Share>> shares_;  // of the pixels, row by row
};

}  // namespace vidno
