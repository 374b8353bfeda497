/// SceneSize: how large a scene is to read and to write.
#pragma once

#include <array>

#include "vidno/floating_horizon/curves.h"
#include "vidno/scene.h"

namespace vidno {

/// Sizes are compared by these numbers in this order.
struct SceneSize {
    std::array<double, 5> numbers{};

    explicit SceneSize(const Scene& scene);
    explicit SceneSize(const CurveScene& scene);

    double parts() const { return numbers[0]; }   // polygons or curves
    double points() const { return numbers[1]; }  // vertices or samples
    double pixels() const { return numbers[2]; }  // of the area
    /// The greatest coordinate: x and y in units of the coarsest 1/2^k of which all are multiples, z in units of its
    /// own; for curves, only y.
    double coordinate() const { return numbers[3]; }
    /// All coordinates, added up in these units.
    double coordinates() const { return numbers[4]; }

    bool operator<(const SceneSize& other) const { return numbers < other.numbers; }
    bool operator==(const SceneSize&) const = default;
};

}  // namespace vidno
