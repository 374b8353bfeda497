#include "find/scene_size.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "stability/shrink.h"

namespace vidno {

namespace {

struct InUnits {
    double greatest = 0, sum = 0;

    explicit InUnits(const std::vector<double>& numbers) {
        int places = 0;
        for (const double number : numbers) places = std::max(places, binary_places(number));
        for (const double number : numbers) {
            const double units = std::ldexp(std::abs(number), places);
            greatest = std::max(greatest, units);
            sum += units;
        }
    }
};

}  // namespace

SceneSize::SceneSize(const Scene& scene) {
    std::vector<double> places, depths;
    for (const auto& polygon : scene.polygons) {
        for (const auto& vertex : polygon.vertices) {
            places.insert(places.end(), {vertex.x, vertex.y});
            depths.push_back(vertex.z);
        }
    }
    const InUnits across(places), deep(depths);
    numbers = {double(scene.polygons.size()), double(depths.size()), double(scene.area.width) * scene.area.height,
               std::max(across.greatest, deep.greatest), across.sum + deep.sum};
}

SceneSize::SceneSize(const CurveScene& scene) {
    std::vector<double> heights;
    std::size_t samples = 0;
    for (const auto& curve : scene.curves) {
        samples += curve.samples.size();
        for (const auto& sample : curve.samples) {
            if (sample.has_point()) heights.push_back(sample.y);
        }
    }
    const InUnits up(heights);
    numbers = {double(scene.curves.size()), double(samples), double(scene.area.width) * scene.area.height, up.greatest,
               up.sum};
}

}  // namespace vidno
