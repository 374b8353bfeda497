#include "homework/exercises.h"

#include <cmath>
#include <glm/vec2.hpp>
#include <optional>
#include <random>
#include <unordered_set>

#include "homework/profile.h"
#include "json/unique_ids.h"
#include "refused.h"
#include "scene/families.h"
#include "stability/shrink.h"
#include "vidno/admission.h"
#include "vidno/snap.h"

namespace vidno {

namespace {

constexpr int most_places = 12;           // binary, of a coordinate
constexpr int most_tries = 20000;         // of the walk, tried between two exercises
constexpr std::size_t pixels_alike = 32;  // pictures that differ in fewer than one of 32 pixels are alike

using Vertices = std::vector<glm::dvec3>;

// ------------------------------------------------------------------------------------- symmetries of the area

struct Symmetry {
    bool transposed = false, mirrored_x = false, mirrored_y = false;

    glm::dvec2 of(double x, double y, const Area& area) const {
        double u = x - area.x, v = y - area.y;
        if (transposed) std::swap(u, v);
        if (mirrored_x) u = area.width - u;
        if (mirrored_y) v = area.height - v;
        return {area.x + u, area.y + v};
    }
};

/// Eight symmetries for a square, four for another rectangle; the first is the identity.
std::vector<Symmetry> symmetries_of(const Area& area) {
    std::vector<Symmetry> symmetries;
    for (const bool transposed : {false, true}) {
        if (transposed && area.width != area.height) continue;
        for (const bool mirrored_x : {false, true}) {
            for (const bool mirrored_y : {false, true}) symmetries.push_back({transposed, mirrored_x, mirrored_y});
        }
    }
    return symmetries;
}

AdmittedScene moved(Scene scene, const Symmetry& by) {
    for (auto& polygon : scene.polygons) {
        for (auto& vertex : polygon.vertices) {
            const glm::dvec2 place = by.of(vertex.x, vertex.y, scene.area);
            vertex = {place.x, place.y, vertex.z};
        }
    }
    return admit(std::move(scene));
}

bool are_alike(const Picture& picture, const Picture& other) {
    const Area& area = picture.area();
    const std::size_t least = picture.pixels().size() / pixels_alike;
    const auto symmetries = symmetries_of(area);
    return std::any_of(symmetries.begin(), symmetries.end(), [&](const Symmetry& symmetry) {
        std::size_t differing = 0;
        for (int y = area.y; y < area.bottom(); ++y) {
            for (int x = area.x; x < area.right(); ++x) {
                const glm::dvec2 centre = symmetry.of(x + 0.5, y + 0.5, area);
                const Color color = other.at(int(std::floor(centre.x)), int(std::floor(centre.y)));
                differing += picture.at(x, y) == color ? 0 : 1;
            }
        }
        return differing <= least;
    });
}

// ------------------------------------------------------------------------------------- shapes

/// The binary places of a polygon's coordinates.
Resolution lattice_of(const ScenePolygon& polygon) {
    Resolution lattice{0, 0};
    for (const auto& vertex : polygon.vertices) {
        lattice.xy = std::max({lattice.xy, binary_places(vertex.x), binary_places(vertex.y)});
        lattice.z = std::max(lattice.z, binary_places(vertex.z));
    }
    return lattice;
}

bool is_on(const Resolution& lattice, const Vertices& vertices) {
    return std::all_of(vertices.begin(), vertices.end(),
                       [&](const glm::dvec3& vertex) { return vertex == snapped(vertex, lattice); });
}

/// Three vertices of the polygon that are not collinear, if it has such.
std::optional<std::array<glm::dvec3, 3>> corner_of(const Vertices& vertices) {
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const auto& q = vertices[(i + 1) % vertices.size()];
        const auto& r = vertices[(i + 2) % vertices.size()];
        if (admission::turn(vertices[i], q, r) != 0) return std::array{vertices[i], q, r};
    }
    return std::nullopt;
}

bool is_planar_exactly(const Vertices& vertices) {
    using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
    const auto corner = corner_of(vertices);
    if (!corner) return true;
    const auto point = [](const glm::dvec3& v) { return Point(v.x, v.y, v.z); };
    const Point p = point((*corner)[0]), q = point((*corner)[1]), r = point((*corner)[2]);
    return std::all_of(vertices.begin(), vertices.end(), [&](const glm::dvec3& vertex) {
        return CGAL::orientation(p, q, r, point(vertex)) == CGAL::COPLANAR;
    });
}

bool are_in_one_plane(const Vertices& vertices, const Vertices& others) {
    Vertices all = vertices;
    all.insert(all.end(), others.begin(), others.end());
    return is_planar_exactly(all);
}

/// The increase of z in the polygon's plane along a vector in x and y.
double rise(const Vertices& vertices, glm::dvec2 way) {
    const auto corner = corner_of(vertices);
    if (!corner) return 0;
    const glm::dvec3 a = (*corner)[1] - (*corner)[0];
    const glm::dvec3 b = (*corner)[2] - (*corner)[0];
    const double area = a.x * b.y - a.y * b.x;
    return (way.x * (a.z * b.y - a.y * b.z) + way.y * (a.x * b.z - a.z * b.x)) / area;
}

/// The number of vertices at which the outline turns.
std::ptrdiff_t turns_of(const Vertices& vertices) {
    std::ptrdiff_t turns = 0;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const auto& q = vertices[(i + 1) % vertices.size()];
        turns += admission::turn(vertices[i], q, vertices[(i + 2) % vertices.size()]) != 0;
    }
    return turns;
}

struct Reach {
    glm::dvec3 low, high;

    explicit Reach(const Scene& scene)
        : low(scene.area.x, scene.area.y, -1), high(scene.area.right(), scene.area.bottom(), 1) {
        for (const auto& polygon : scene.polygons) {
            for (const auto& vertex : polygon.vertices) {
                low = glm::min(low, vertex);
                high = glm::max(high, vertex);
            }
        }
    }
    bool holds(const Vertices& vertices) const {
        return std::all_of(vertices.begin(), vertices.end(), [&](const glm::dvec3& vertex) {
            return glm::min(low, vertex) == low && glm::max(high, vertex) == high;
        });
    }
};

// ------------------------------------------------------------------------------------- the walk

class Walk {
public:
    Walk(const AdmittedScene& original, Method method, std::uint64_t seed)
        : scene_(original), method_(method), reach_(original), random_(generator(seed)) {
        const ProfiledRun run = profiled_run(original, method);
        profile_ = run.profile;
        original_long_ = most_long_ = run.long_numbers;
        for (const auto& polygon : original->polygons) {
            lattices_.push_back(lattice_of(polygon));
            turns_.push_back(turns_of(polygon.vertices));
        }
    }

    const AdmittedScene& scene() const { return scene_; }
    /// The run of no later scene has more long numbers than this.
    std::uint64_t most_long() const { return most_long_; }

    /// From now on a scene may have as many long numbers as the original.
    void stop_shortening() {
        shortens_ = false;
        most_long_ = original_long_;
    }

    /// Runs a scene and returns the run if it is as hard as the original's, otherwise nothing.
    std::optional<ProfiledRun> run_if_as_hard(const AdmittedScene& scene) const {
        ProfiledRun run = profiled_run(scene, method_);
        if (!is_as_hard(run.profile, profile_)) return std::nullopt;
        return run;
    }

    /// Tries a step. Returns whether it was taken.
    bool step() {
        const auto place = std::size_t(random_.whole(0, int(scene_->polygons.size()) - 1));
        Scene changed = scene_;
        if (random_.whole(0, 9) == 0) {
            tilt(changed.polygons, place);
        } else {
            change(changed.polygons[place].vertices, lattices_[place]);
        }
        if (!may_be(changed.polygons)) return false;
        AdmittedScene next = admit(std::move(changed));
        const auto run = run_if_as_hard(next);
        if (!run || run->long_numbers > most_long_) return false;
        if (shortens_) most_long_ = run->long_numbers;
        scene_ = std::move(next);
        return true;
    }

    Symmetry symmetry() {
        const auto all = symmetries_of(scene_->area);
        return all[std::size_t(random_.whole(0, int(all.size()) - 1))];
    }

private:
    static std::mt19937 generator(std::uint64_t seed) {
        std::seed_seq seeds{std::uint32_t(seed), std::uint32_t(seed >> 32)};
        return std::mt19937(seeds);
    }

    /// One step of the lattice, or up to an eighth of the range, in either direction.
    double steps(int places, int range) {
        const int most = std::max(1, random_.whole(0, 1) * int(std::ldexp(range, places)) / 8);
        return std::ldexp(random_.whole(-most, most), -places);
    }
    glm::dvec2 way(const Resolution& lattice) {
        const double x = steps(lattice.xy, scene_->area.width);
        return {x, steps(lattice.xy, scene_->area.height)};
    }

    void change(Vertices& vertices, const Resolution& lattice) {
        constexpr int depth_range = 2;
        switch (random_.whole(0, 8)) {
            case 0:
            case 1: return shift(vertices, glm::dvec3(way(lattice), 0));
            case 2:
            case 3: return move_some(vertices, 1, way(lattice));
            case 4:
            case 5: return move_some(vertices, 2, way(lattice));
            case 6: return shift(vertices, {0, 0, steps(lattice.z, depth_range)});
            case 7: return mirror(vertices);
            default: return turn(vertices);
        }
    }

    static void shift(Vertices& vertices, const glm::dvec3& by) {
        for (auto& vertex : vertices) vertex += by;
    }
    /// Moves a vertex, or the two of an edge. Only a triangle may change its plane.
    void move_some(Vertices& vertices, std::size_t count, glm::dvec2 by) {
        const double up = vertices.size() == 3 ? 0 : rise(vertices, by);
        const auto first = std::size_t(random_.whole(0, int(vertices.size()) - 1));
        for (std::size_t i = 0; i < count; ++i) vertices[(first + i) % vertices.size()] += glm::dvec3(by, up);
    }
    /// Gives a polygon another plane, of a depth in sixteenths at its first vertex, and with it all polygons in its
    /// plane. A slope of 0 remains one.
    void tilt(std::vector<ScenePolygon>& polygons, std::size_t place) {
        const Vertices vertices = polygons[place].vertices;
        constexpr int steepest = 4;
        constexpr double coarse = 16;
        const auto slope = [&](glm::dvec2 along) {
            if (rise(vertices, along) == 0) return 0.;
            return std::ldexp(random_.whole(1, steepest) * (2 * random_.whole(0, 1) - 1), -random_.whole(3, 6));
        };
        const glm::dvec3 first = vertices.front();
        const double x_slope = slope({1, 0}), y_slope = slope({0, 1});
        const double depth = std::round(first.z * coarse) / coarse;
        for (auto& polygon : polygons) {
            if (!are_in_one_plane(vertices, polygon.vertices)) continue;
            for (auto& vertex : polygon.vertices) {
                vertex.z = depth + x_slope * (vertex.x - first.x) + y_slope * (vertex.y - first.y);
            }
        }
    }
    static void mirror(Vertices& vertices) {
        const auto [left, right] = std::minmax_element(vertices.begin(), vertices.end(),
                                                       [](const auto& a, const auto& b) { return a.x < b.x; });
        const double both = left->x + right->x;
        for (auto& vertex : vertices) vertex.x = both - vertex.x;
    }
    /// Rotates by a quarter turn about the first vertex.
    static void turn(Vertices& vertices) {
        const glm::dvec3 about = vertices.front();
        for (auto& vertex : vertices) {
            vertex = {about.x + (vertex.y - about.y), about.y - (vertex.x - about.x), vertex.z};
        }
    }

    /// Whether anything has changed, and all that has is still like the original.
    bool may_be(std::vector<ScenePolygon>& polygons) const {
        bool is_other = false;
        for (std::size_t place = 0; place < polygons.size(); ++place) {
            if (polygons[place].vertices == scene_->polygons[place].vertices) continue;
            if (!may_be(polygons[place], place)) return false;
            is_other = true;
        }
        return is_other;
    }
    bool may_be(ScenePolygon& polygon, std::size_t place) const {
        const ScenePolygon& before = scene_->polygons[place];
        const auto& vertices = polygon.vertices;
        return is_on(lattices_[place], vertices) && reach_.holds(vertices) && turns_of(vertices) == turns_[place] &&
               is_planar_exactly(vertices) && admit_polygon(polygon).admission == Admission::admitted &&
               polygon.edge_on == before.edge_on && vertices.size() == before.vertices.size();
    }

    AdmittedScene scene_;
    Method method_;
    Reach reach_;
    Profile profile_;
    std::uint64_t original_long_ = 0, most_long_ = 0;
    bool shortens_ = true;
    RandomPolygons random_;
    std::vector<Resolution> lattices_;
    std::vector<std::ptrdiff_t> turns_;
};

/// The scene with its coordinates rounded; none if they no longer make admissible polygons. A polygon that rounding
/// would bend is cut.
std::optional<AdmittedScene> rounded_to(Resolution lattice, const Scene& scene) {
    Scene rounded = scene;
    rounded.polygons.clear();
    std::unordered_set<std::string> ids;
    for (const auto& polygon : scene.polygons) ids.insert(polygon.id);
    PartIds part_ids(std::move(ids));
    for (ScenePolygon polygon : scene.polygons) {
        Snapping snapping;
        std::vector<ScenePolygon> parts = snapped(polygon, lattice, snapping);
        for (auto& vertex : polygon.vertices) vertex = snapped(vertex, lattice);
        const bool stays =
            is_planar_exactly(polygon.vertices) && admit_polygon(polygon).admission == Admission::admitted;
        if (stays) parts = {polygon};
        part_ids.name(parts);
        for (auto& part : parts) rounded.polygons.push_back(std::move(part));
    }
    try {
        return admit(std::move(rounded));
    } catch (const std::invalid_argument&) {
        return std::nullopt;
    }
}

}  // namespace

ByHand by_hand(const AdmittedScene& scene, Method method, const std::string& file) {
    if (scene->polygons.empty()) throw Refused(file + ": polygons: there are none");
    const auto is_by_hand = [](const ScenePolygon& polygon) {
        const auto [xy, z] = lattice_of(polygon);
        return std::max(xy, z) <= most_places && is_planar_exactly(polygon.vertices);
    };
    const auto& polygons = scene->polygons;
    if (std::all_of(polygons.begin(), polygons.end(), is_by_hand)) return {scene, ""};
    const ProfiledRun run = profiled_run(scene, method);
    // A coarse lattice may add ties and points on lines, so one on which the run is as hard comes first.
    for (const bool as_hard : {true, false}) {
        for (int places = 1; places <= most_places; ++places) {
            const auto rounded = rounded_to({places, places}, *scene);
            if (!rounded) continue;
            const ProfiledRun rounded_run = profiled_run(*rounded, method);
            if (rounded_run.picture.pixels() != run.picture.pixels()) continue;
            if (as_hard && !is_as_hard(rounded_run.profile, run.profile)) continue;
            const bool are_cut = (*rounded)->polygons.size() > polygons.size();
            return {*rounded, "coordinates rounded to multiples of 1/" + std::to_string(1 << places) +
                                  (are_cut ? ", and polygons that this would bend cut into triangles" : "") +
                                  "; the picture stays the same"};
        }
    }
    throw Refused(file + ": coordinates with more than " + std::to_string(most_places) +
                  " binary places are not to be worked by hand, and rounded ones give another picture");
}

std::vector<AdmittedScene> exercises_of(const AdmittedScene& scene, Method method, std::size_t count,
                                        std::uint64_t seed, const std::function<void(std::size_t)>& progress) {
    Walk walk(scene, method, seed);
    std::vector<AdmittedScene> exercises;
    std::vector<Picture> pictures{profiled_run(scene, method).picture};
    const auto take_if_new = [&](AdmittedScene candidate, std::uint64_t most_long) {
        auto run = walk.run_if_as_hard(candidate);
        if (!run || run->long_numbers > most_long) return false;
        const auto is_alike = [&](const Picture& other) { return are_alike(run->picture, other); };
        if (std::any_of(pictures.begin(), pictures.end(), is_alike)) return false;
        pictures.push_back(std::move(run->picture));
        exercises.push_back(std::move(candidate));
        return true;
    };
    const std::size_t steps_apart = 2 * scene->polygons.size();
    const auto search = [&](std::uint64_t most_long) {
        std::size_t taken = 0;
        for (int tried = 0; exercises.size() < count && tried < most_tries; ++tried) {
            progress(exercises.size());
            if (!walk.step() || ++taken < steps_apart) continue;
            if (!take_if_new(moved(walk.scene(), walk.symmetry()), most_long)) continue;
            taken = 0;
            tried = 0;
        }
    };
    search(0);
    if (exercises.empty()) {
        walk.stop_shortening();
        search(walk.most_long());
    }
    return exercises;
}

}  // namespace vidno
