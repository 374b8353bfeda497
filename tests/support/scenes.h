/// Scenes for tests: builders for small polygons, and random and degenerate ones from a seed.
#pragma once

#include <optional>
#include <string>

#include "scene/families.h"
#include "vidno/admitted.h"
#include "vidno/scene.h"

namespace vidno::test {

inline constexpr Color red{255, 0, 0}, green{0, 128, 0}, blue{0, 0, 255}, white{255, 255, 255};

class SceneBuilder {
public:
    explicit SceneBuilder(Area area);

    SceneBuilder& polygon(Corners vertices);
    SceneBuilder& polygon(std::string id, Color color, Corners vertices);
    SceneBuilder& quad(double left, double top, double right, double bottom, double z);

    AdmittedScene build() const;

private:
    Scene scene_;
};

/// The quad Q over the whole 16 x 16 area, and the square N in its middle in front of it.
inline const Corners far_quad{{-1, -1, .125}, {17, -1, .125}, {17, 17, .125}, {-1, 17, .125}};
inline const Corners near_square{{4, 4, .5}, {12, 4, .5}, {12, 12, .5}, {4, 12, .5}};
inline constexpr Area area_16{0, 0, 16, 16};

/// Three polygons that overlap, on the coarsest grid, so that every kernel takes them unchanged.
AdmittedScene small_scene();

/// With sanitizers a run takes ten times as long. The longest tests then take only one in `thinning` of their scenes or
/// steps, and tests of long runs by code that other tests run too are skipped.
#ifdef VIDNO_SANITIZED
inline constexpr bool sanitized = true;
inline constexpr int thinning = 8;
#else
inline constexpr bool sanitized = false;
inline constexpr int thinning = 1;
#endif

/// All kinds of polygons in areas of all sizes.
struct RandomScenes : RandomPolygons {
    explicit RandomScenes(unsigned seed);

    Area area();
    AdmittedScene scene();
};

/// Each coordinate moved by up to two ulps: what was a coincidence becomes nearly one. None if a polygon is no longer
/// admitted.
std::optional<AdmittedScene> moved_by_ulps(Scene scene, RandomScenes& random);

}  // namespace vidno::test
