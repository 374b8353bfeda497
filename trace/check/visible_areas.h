/// VisibleAreas: the exact area of each colour in each pixel, by the visible regions of Weiler and Atherton's
/// algorithm.
#pragma once

#include <utility>
#include <vector>

#include "vidno/admitted.h"
#include "vidno/picture.h"

namespace vidno {

class VisibleAreas {
public:
    explicit VisibleAreas(const AdmittedScene& scene);

    /// How much of the area a picture shows in a wrong colour, in pixels.
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
