#include "find/lattice_scenes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "choice/palette.h"
#include "scene/exact_scene.h"
#include "stability/shrink.h"

namespace vidno {

namespace {

constexpr int most_letters = int(palette.size());

void give_letters(Scene& scene) {
    for (std::size_t i = 0; i < scene.polygons.size(); ++i) {
        scene.polygons[i].id = std::string(1, char('A' + i % 26));
        scene.polygons[i].color = default_color(i);
        scene.polygons[i].face.clear();
    }
    scene.name.clear();
}

std::optional<AdmittedScene> admitted_or_none(Scene scene) {
    if (scene.polygons.empty() || scene.polygons.size() > std::size_t(most_letters)) return std::nullopt;
    for (auto& polygon : scene.polygons) {
        for (const auto& vertex : polygon.vertices) {
            if (std::abs(vertex.z) > 1) return std::nullopt;
        }
        if (exact_scene::admit_polygon(polygon).admission != Admission::admitted) return std::nullopt;
    }
    give_letters(scene);
    return exact_scene::admit(std::move(scene));
}

/// Draws numbers of a lattice over an area.
class LatticeNumbers {
public:
    LatticeNumbers(RandomPolygons& random, const Lattice& of)
        : random_(random),
          greatest_(of.greatest),
          unit_(std::ldexp(1.0, -random.whole(0, of.places))),
          depth_unit_(std::ldexp(1.0, -random.whole(0, of.depth_places))) {}

    /// Half of the numbers lie in the area.
    double coordinate(int side) {
        if (greatest_ > 0) return random_.whole(-greatest_, greatest_) * unit_;
        const int steps = int(1 / unit_);
        return random_.whole(0, 1) == 0 ? random_.whole(0, side * steps) * unit_
                                        : random_.whole(-(side + 1) * steps, (2 * side + 1) * steps) * unit_;
    }
    double depth() {
        const int all = int(1 / depth_unit_);
        const int steps = greatest_ > 0 ? std::min(all, greatest_) : all;
        return random_.whole(-steps, steps) * depth_unit_;
    }
    glm::dvec3 vertex(const Area& area) { return glm::dvec3{coordinate(area.width), coordinate(area.height), depth()}; }
    double unit() const { return unit_; }
    double depth_unit() const { return depth_unit_; }

private:
    RandomPolygons& random_;
    int greatest_;
    double unit_, depth_unit_;
};

Corners parallelogram(const glm::dvec3& corner, const glm::dvec3& along, const glm::dvec3& other) {
    return {corner, corner + along, corner + along + other, corner + other};
}

/// A polygon to add to the scene.
Corners drawn_shape(RandomPolygons& random, LatticeNumbers& draw, const Scene& scene) {
    const Area& area = scene.area;
    const int kind = random.whole(0, scene.polygons.empty() ? 5 : 8);
    const glm::dvec3 a = draw.vertex(area);
    const glm::dvec3 b = draw.vertex(area);
    const glm::dvec3 c = draw.vertex(area);
    const auto picked = [&]() -> const Corners& {
        return scene.polygons[std::size_t(random.whole(0, int(scene.polygons.size()) - 1))].vertices;
    };
    switch (kind) {
        case 0:
        case 1: return {a, b, c};
        case 2: return {{a.x, a.y, a.z}, {b.x, b.y, a.z}, {c.x, c.y, a.z}};
        case 3: {  // an upright rectangle, level or tilted about one of its sides
            const double rise = random.whole(0, 2) == 0 ? b.z - a.z : 0;
            return parallelogram(a, {b.x - a.x, 0, rise}, {0, b.y - a.y, 0});
        }
        case 4: {  // over the whole area
            const double margin = random.whole(0, 1) * draw.unit();
            const glm::dvec3 corner{-margin, -margin, a.z};
            return parallelogram(corner, {area.width + 2 * margin, 0, random.whole(0, 2) == 0 ? b.z - a.z : 0},
                                 {0, area.height + 2 * margin, 0});
        }
        case 5: return {a, b, {(a.x + b.x) / 2, (a.y + b.y) / 2, c.z}};
        case 6: {  // with a common edge
            const Corners& other = picked();
            return {other[1], other[0], c};
        }
        case 7: {  // in one plane
            const Corners& other = picked();
            const auto in_plane = [&] {
                const int along = random.whole(-1, 2);
                const int across = random.whole(-1, 2);
                return other[0] + double(along) * (other[1] - other[0]) + double(across) * (other[2] - other[0]);
            };
            const glm::dvec3 first = in_plane();
            const glm::dvec3 second = in_plane();
            return {first, second, in_plane()};
        }
        default: {  // the same outline at another depth, or tilted otherwise
            Corners outline = picked();
            if (outline.size() == 3) outline[std::size_t(random.whole(0, 2))].z = c.z;
            const double deeper = random.whole(-1, 1) * draw.depth_unit();
            for (auto& vertex : outline) vertex.z += deeper;
            return outline;
        }
    }
}

void add_polygon(Scene& scene, Corners vertices) { scene.polygons.push_back({{}, {}, std::move(vertices), false}); }

/// One of the families' scenes, moved to where areas begin.
std::optional<AdmittedScene> family_scene(RandomPolygons& random) {
    const Family& family = families[std::size_t(random.whole(0, int(families.size()) - 1))];
    Scene scene = random_scene(family, random);
    for (auto& polygon : scene.polygons) {
        for (auto& vertex : polygon.vertices) vertex -= glm::dvec3(scene.area.x, scene.area.y, 0);
    }
    scene.area.x = scene.area.y = 0;
    return admitted_or_none(std::move(scene));
}

// ------------------------------------------------------------------------------------- changes

/// Changes one thing of a scene.
class SceneChange {
public:
    SceneChange(Scene& scene, RandomPolygons& random, const Lattice& lattice)
        : scene_(scene), random_(random), lattice_(lattice), draw_(random, lattice) {}

    void one() {
        switch (random_.whole(0, 13)) {
            case 0:
            case 1: return step(one_vertex());
            case 2: return set_coordinate();
            case 3: return shift_polygon();
            case 4: return move_corner();
            case 5: return resize();
            case 6: return add_polygon(scene_, drawn_shape(random_, draw_, scene_));
            case 7: return remove();
            case 8: return replace();
            case 9: return swap();
            case 10: return raise();
            case 11: return copy_vertex();
            case 12: return remove_vertex();
            default: return towards_zero();
        }
    }

private:
    ScenePolygon& one_polygon() {
        return scene_.polygons[std::size_t(random_.whole(0, int(scene_.polygons.size()) - 1))];
    }
    glm::dvec3& vertex_of(ScenePolygon& polygon) {
        return polygon.vertices[std::size_t(random_.whole(0, int(polygon.vertices.size()) - 1))];
    }
    glm::dvec3& one_vertex() { return vertex_of(one_polygon()); }
    double unit(int axis) const { return axis == 2 ? draw_.depth_unit() : draw_.unit(); }

    void step(glm::dvec3& vertex) {
        const int axis = random_.whole(0, 2);
        vertex[axis] += (random_.whole(0, 1) * 2 - 1) * random_.whole(1, 2) * unit(axis);
    }
    void set_coordinate() {
        glm::dvec3& vertex = one_vertex();
        const int axis = random_.whole(0, 2);
        vertex[axis] = draw_.vertex(scene_.area)[axis];
    }
    void shift_polygon() {
        const int axis = random_.whole(0, 2);
        const double by = (random_.whole(0, 1) * 2 - 1) * unit(axis);
        for (auto& vertex : one_polygon().vertices) vertex[axis] += by;
    }
    /// Moves all vertices at one place.
    void move_corner() {
        const glm::dvec3 from = one_vertex();
        glm::dvec3 to = from;
        step(to);
        for (auto& polygon : scene_.polygons) std::replace(polygon.vertices.begin(), polygon.vertices.end(), from, to);
    }
    void resize() {
        int& side = random_.whole(0, 1) == 0 ? scene_.area.width : scene_.area.height;
        side = std::clamp(side + random_.whole(0, 1) * 2 - 1, 1, lattice_.widest);
        if (random_.whole(0, 1) == 0) scene_.area.width = scene_.area.height = side;
    }
    void remove() { scene_.polygons.erase(scene_.polygons.begin() + (&one_polygon() - scene_.polygons.data())); }
    void replace() { one_polygon().vertices = drawn_shape(random_, draw_, scene_); }
    void swap() {
        ScenePolygon& one = one_polygon();
        std::swap(one, one_polygon());
    }
    /// Gives a polygon another depth, or a vertex the depth of another one.
    void raise() {
        if (random_.whole(0, 1) == 0) {
            glm::dvec3& vertex = one_vertex();
            vertex.z = one_vertex().z;
            return;
        }
        const double z = draw_.depth();
        for (auto& vertex : one_polygon().vertices) vertex.z = z;
    }
    void copy_vertex() {
        glm::dvec3& vertex = one_vertex();
        vertex = one_vertex();
    }
    void remove_vertex() {
        auto& vertices = one_polygon().vertices;
        if (vertices.size() > 3) vertices.erase(vertices.begin() + random_.whole(0, int(vertices.size()) - 1));
    }
    /// Rounds a coordinate to a coarser lattice, or halves it there.
    void towards_zero() {
        glm::dvec3& vertex = one_vertex();
        double& value = vertex[random_.whole(0, 2)];
        value = snapped(value, std::max(0, binary_places(value) - random_.whole(1, 3)));
    }

    Scene& scene_;
    RandomPolygons& random_;
    const Lattice& lattice_;
    LatticeNumbers draw_;
};

}  // namespace

Lattice Lattice::of_growth(int growth) {
    constexpr std::array sides{2, 2, 3, 4, 4, 6, 8, 8, 12, 16};
    return {.widest = sides[std::size_t(std::min(growth, int(sides.size()) - 1))],
            .most_polygons = std::min(2 + growth / 3, 6),
            .places = std::min(1 + growth / 4, 3),
            .depth_places = std::min(1 + growth / 2, 6),
            .is_coarse = growth < 5};
}

std::optional<AdmittedScene> lattice_scene(RandomPolygons& random, const Lattice& lattice) {
    if (!lattice.is_coarse && random.whole(0, 3) == 0) return family_scene(random);
    Scene scene;
    scene.area.width = random.whole(1, lattice.widest);
    scene.area.height = random.whole(0, 3) == 0 ? random.whole(1, lattice.widest) : scene.area.width;
    LatticeNumbers draw(random, lattice);
    for (int count = random.whole(1, lattice.most_polygons); count > 0; --count) {
        add_polygon(scene, drawn_shape(random, draw, scene));
    }
    return admitted_or_none(std::move(scene));
}

std::optional<AdmittedScene> random_body(RandomPolygons& random, const Lattice& lattice) {
    Scene scene;
    scene.area.width = scene.area.height = random.whole(1, lattice.widest);
    LatticeNumbers draw(random, lattice);
    const glm::dvec3 a = draw.vertex(scene.area);
    const glm::dvec3 b = draw.vertex(scene.area);
    const glm::dvec3 c = draw.vertex(scene.area);
    const glm::dvec3 d = draw.vertex(scene.area);
    for (const Corners& face : {Corners{a, b, c}, Corners{a, c, d}, Corners{a, d, b}, Corners{b, d, c}}) {
        add_polygon(scene, face);
    }
    return admitted_or_none(std::move(scene));
}

std::optional<AdmittedScene> changed_scene(Scene scene, RandomPolygons& random, const Lattice& lattice) {
    if (!lattice.is_coarse && random.whole(0, 15) == 0) {
        return admitted_or_none(moved_by_ulps(std::move(scene), random.whole(1, 4), random));
    }
    for (int changes = 1 + random.whole(0, 3) * random.whole(0, 1); changes > 0 && !scene.polygons.empty(); --changes) {
        SceneChange(scene, random, lattice).one();
    }
    return admitted_or_none(std::move(scene));
}

AdmittedScene lettered(Scene scene) {
    give_letters(scene);
    return exact_scene::admit(std::move(scene));
}

}  // namespace vidno
