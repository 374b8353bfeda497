#include "grade/scenes.h"

#include <cassert>
#include <initializer_list>
#include <utility>

#include "scene/exact_scene.h"

namespace vidno {

namespace {

constexpr std::array colors{Color{31, 119, 180},  Color{255, 127, 14}, Color{44, 160, 44},   Color{214, 39, 40},
                            Color{148, 103, 189}, Color{140, 86, 75},  Color{227, 119, 194}, Color{23, 190, 207}};

using Vertices = std::vector<glm::dvec3>;

Vertices level(double left, double top, double right, double bottom, double z) {
    return {{left, top, z}, {right, top, z}, {right, bottom, z}, {left, bottom, z}};
}

/// From the left side to the right one its depth goes from one value to the other.
Vertices sloping(double left, double top, double right, double bottom, double z_left, double z_right) {
    return {{left, top, z_left}, {right, top, z_right}, {right, bottom, z_right}, {left, bottom, z_left}};
}

Scene scene(std::string name, const Area& area, const std::vector<Vertices>& polygons) {
    Scene made{std::move(name), area, {255, 255, 255}, {}};
    for (const auto& vertices : polygons) {
        const std::size_t i = made.polygons.size();
        made.polygons.push_back({std::string(1, char('A' + i)), colors[i % colors.size()], vertices});
        [[maybe_unused]] const Admitted admitted = exact_scene::admit(made.polygons.back());
        assert(admitted.admission == Admission::admitted);
    }
    return made;
}

}  // namespace

std::vector<Scene> scenes_to_grade() {
    constexpr Area square{0, 0, 16, 16};
    return {
        scene("Two triangles apart", square,
              {{{1.25, 1.25, .25}, {6.25, 2.125, .25}, {2.25, 5.75, .25}},
               {{9.25, 7.125, .5}, {14.75, 7.875, .5}, {10.75, 11.25, .5}}}),
        scene("A near square before a far one", square,
              {level(-1, -1, 17, 17, .125), level(4.25, 2.25, 10.25, 7.75, .5)}),
        scene("The near one comes first", square, {level(4.25, 2.25, 10.25, 7.75, .5), level(-1, -1, 17, 17, .125)}),
        scene("Behind depth 0", square, {level(-1, -1, 17, 17, -.75), level(3.25, 1.25, 9.25, 12.75, -.25)}),
        scene("Larger than the area", square, {{{-4.25, 5.75, .25}, {21.25, -3.25, .25}, {12.75, 22.25, .25}}}),
        scene("Two walls through each other", square,
              {sloping(1.25, 2.25, 15.25, 9.75, -.5, .5), sloping(1.25, 4.25, 15.25, 13.75, .4375, -.4375)}),
        scene("Each behind the next", square,
              {sloping(1.25, 2.25, 14.25, 5.25, -.5, .5),
               {{10.25, 1.25, 0}, {14.25, 1.25, 0}, {14.25, 14.25, .25}, {10.25, 14.25, .25}},
               {{1.25, 1.25, 0}, {14.75, 12.25, .5}, {11.25, 14.75, .5}}}),
        scene("Eight pieces", square,
              {{{1.125, 1.25, .125}, {7.25, 2.125, .375}, {3.25, 9.125, .3125}},
               {{5.125, .25, -.25}, {15.25, 3.125, .5}, {8.125, 6.25, .125}},
               {{.25, 8.125, .5}, {9.125, 7.25, -.25}, {6.25, 15.125, .25}},
               {{8.25, 4.125, .75}, {14.125, 6.25, -.5}, {10.25, 13.125, .0625}},
               {{2.125, 3.25, -.125}, {13.25, 9.125, .1875}, {4.125, 13.25, .5}},
               level(6.25, 6.25, 9.75, 8.75, .328125),
               {{11.25, 8.125, 0}, {16.125, 10.25, .25}, {12.25, 16.125, .5}},
               level(.25, 12.25, 15.75, 14.75, -.390625)}),
        scene("An area of 13 x 7", {0, 0, 13, 7}, {level(-1, -1, 14, 8, -.5), level(6.25, 1.25, 12.75, 4.25, .25)}),
        scene("An area of 3 x 1", {0, 0, 3, 1}, {level(-1, -1, 1.75, 2, .25), level(1.25, -1, 4, 2, .125)}),
        scene("An area off the origin", {-5, 3, 8, 8}, {level(-6, 2, 4, 12, -.25), level(-3.75, 4.25, .25, 6.25, .5)}),
        scene("Nothing", {0, 0, 4, 4}, {}),
        scene("Off the area", {0, 0, 8, 8}, {level(9, 1, 12, 4, .5), level(1.25, 2.25, 6.25, 4.25, .25)}),
        scene("Seen edge-on", {0, 0, 8, 8},
              {level(1.25, 1.25, 6.75, 4.25, .25), {{2, 1, .5}, {5, 5, .5}, {5, 5, -.5}, {2, 1, -.5}}}),
        scene("An edge that two share, on the centres of pixels", {0, 0, 8, 8},
              {level(1.25, 1.25, 4.5, 6.75, .25), level(4.5, 1.25, 6.75, 6.75, .25)}),
        scene("A vertex that four share, on the centre of a pixel", {0, 0, 8, 8},
              {{{4.5, 4.5, .25}, {1.25, 4.5, .25}, {4.5, 1.25, .25}},
               {{4.5, 4.5, .25}, {4.5, 1.25, .25}, {7.75, 4.5, .25}},
               {{4.5, 4.5, .25}, {7.75, 4.5, .25}, {4.5, 7.75, .25}},
               {{4.5, 4.5, .25}, {4.5, 7.75, .25}, {1.25, 4.5, .25}}}),
        scene("Vertices on centres and corners of pixels", {0, 0, 8, 8},
              {level(.5, .5, 3.5, 3.5, .25), level(4, 4, 8, 8, .5), {{0.5, 7.5, 0}, {3.5, 4.5, 0}, {3.5, 7.5, 0}}}),
        scene("Two in one plane", {0, 0, 8, 8},
              {sloping(1.25, 1.25, 5.25, 5.25, .125, .375), sloping(1.25, 3.25, 7.25, 6.75, .125, .5)}),
    };
}

}  // namespace vidno
