/// The pictures of a chart's runs: each distinct one once, and the right one first.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "format/floating_horizon_trace.h"
#include "vidno/scene.h"

namespace vidno {

/// Pictures of the pixels of an area.
class ScenePictures {
public:
    /// `pixels`: row by row from the top.
    ScenePictures(int width, const std::vector<Color>& right) : width_(width) { place_of(right); }

    /// The index of a picture, which is added if it is new.
    std::size_t place_of(const std::vector<Color>& pixels);

    /// As in a chart; CHART.md describes it.
    std::string json() const;

private:
    using Runs = std::vector<std::uint64_t>;  // lengths and indices of colours in turn

    int width_;
    std::vector<Color> colors_;
    std::vector<Runs> shown_;
};

/// Drawings of the curves of a surface, to a tenth of a pixel.
class SurfacePictures {
public:
    SurfacePictures(const Area& area, const DrawnLines& right) : area_(area) { place_of(right); }

    std::size_t place_of(const DrawnLines& lines);
    std::string json() const;

private:
    struct Place {
        int x = 0, y = 0;  // in tenths of a pixel
        bool operator==(const Place&) const = default;
    };
    using Drawing = std::vector<std::vector<Place>>;

    static std::vector<Place> straightened(const std::vector<Place>& line);

    Area area_;
    std::vector<Drawing> shown_;
};

}  // namespace vidno
