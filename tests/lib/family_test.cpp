// The Warnock family: relations on cases computed by hand and against their definition, the variants' pictures against
// brute force in exact rationals, the lists of the full variant against what they should hold.

#include "vidno/family/family.h"

#include <doctest/doctest.h>

#include <map>
#include <set>

#include "support/bodies.h"
#include "support/family_reference.h"
#include "support/reference.h"
#include "support/scenes.h"
#include "support/stage.h"
#include "vidno/family/closed_bodies.h"

using namespace vidno;
using namespace vidno::test;

namespace {

const Window window{4, 4, 4, 4};

AdmittedScene scene_of(const Corners& vertices) { return SceneBuilder(area_16).polygon(vertices).build(); }

/// The relation to the window by both containment tests, and with the vertices in reverse order.
template <class K>
void check_relation(const Corners& vertices, Relation expected) {
    for (const bool reversed : {false, true}) {
        Corners outline = vertices;
        if (reversed) std::reverse(outline.begin(), outline.end());
        CAPTURE(reversed);
        Stage<K, family::Full> by_ray(scene_of(outline));
        CHECK(family::Full::relation(by_ray.run, by_ray.polygon(), window) == expected);
        Stage<K, family::Angles> by_angle(scene_of(outline));
        CHECK(family::Angles::relation(by_angle.run, by_angle.polygon(), window) == expected);
    }
}

Corners rectangle(double left, double top, double right, double bottom) {
    return {{left, top, 0}, {right, top, 0}, {right, bottom, 0}, {left, bottom, 0}};
}

}  // namespace

// ------------------------------------------------------------------------------------- relations, by hand

TEST_CASE_TEMPLATE("Relation: the four of them", K, VIDNO_KERNELS) {
    check_relation<K>(rectangle(9, 4, 12, 8), Relation::outside);
    check_relation<K>(rectangle(5, 5, 7, 7), Relation::inside);
    check_relation<K>(rectangle(5, 5, 9, 7), Relation::intersecting);
    check_relation<K>(rectangle(3, 3, 9, 9), Relation::surrounding);
}

TEST_CASE_TEMPLATE("Relation: a polygon that touches a side is outside if it lies outside, intersecting if inside", K,
                   VIDNO_KERNELS) {
    check_relation<K>(rectangle(8, 4, 12, 8), Relation::outside);
    check_relation<K>({{8, 6, 0}, {12, 4, 0}, {12, 8, 0}}, Relation::outside);
    check_relation<K>(rectangle(8, 8, 12, 12), Relation::outside);
    check_relation<K>(rectangle(5, 5, 8, 7), Relation::intersecting);
    check_relation<K>({{4, 6, 0}, {6, 5, 0}, {6, 7, 0}}, Relation::intersecting);
}

TEST_CASE_TEMPLATE("Relation: an outline along the sides surrounds", K, VIDNO_KERNELS) {
    check_relation<K>(rectangle(4, 4, 8, 8), Relation::surrounding);
    check_relation<K>(rectangle(4, 3, 8, 12), Relation::surrounding);
    // The line x + y = 8 contains the upper left corner and no other point of the window.
    check_relation<K>({{8, 0, 0}, {20, 12, 0}, {12, 20, 0}, {0, 8, 0}}, Relation::surrounding);
    check_relation<K>({{8, 0, 0}, {0, 8, 0}, {0, 0, 0}}, Relation::outside);
}

TEST_CASE_TEMPLATE("Relation: around a corner, where the box cannot tell", K, VIDNO_KERNELS) {
    // x + y = 7 misses the window beyond the upper left corner, where x + y = 8; x + y = 9 meets it.
    check_relation<K>({{7, 0, 0}, {0, 7, 0}, {0, 0, 0}}, Relation::outside);
    check_relation<K>({{9, 0, 0}, {0, 9, 0}, {0, 0, 0}}, Relation::intersecting);
    check_relation<K>({{17, 0, 0}, {0, 17, 0}, {0, 0, 0}}, Relation::surrounding);
}

TEST_CASE_TEMPLATE("Relation: the line of an edge passes through the window, but the edge ends before it", K,
                   VIDNO_KERNELS) {
    // The edge from (10, 10) to (14, 14) lies on the window's diagonal; the box reaches over the window.
    check_relation<K>({{10, 10, 0}, {14, 14, 0}, {3, 15, 0}}, Relation::outside);
}

TEST_CASE_TEMPLATE("Relation: an edge-on polygon is its segment", K, VIDNO_KERNELS) {
    check_relation<K>({{5, 5, 0}, {7, 7, 0}, {6, 6, 1}}, Relation::inside);
    check_relation<K>({{0, 0, 0}, {12, 12, 0}, {6, 6, 1}}, Relation::intersecting);
    check_relation<K>({{4, 0, 0}, {4, 12, 0}, {4, 6, 1}}, Relation::outside);
    check_relation<K>({{0, 7, 0}, {7, 0, 0}, {3.5, 3.5, 1}}, Relation::outside);
    check_relation<K>({{6, 6, 0}, {6, 6, 1}, {6, 6, .5}}, Relation::inside);
    check_relation<K>({{4, 6, 0}, {4, 6, 1}, {4, 6, .5}}, Relation::outside);
}

TEST_CASE_TEMPLATE("RayCrossings: a touch counts two, a pierced vertex one", K, VIDNO_KERNELS) {
    // The ray goes from the window's centre (6, 6) to the right.
    const auto crossings = [](const Corners& vertices) {
        Stage<K, family::Full> stage(scene_of(vertices));
        return family::Full::ray_crossings(stage.run, stage.polygon(), window);
    };
    CHECK_MESSAGE(crossings({{10, 5, 0}, {14, 5, 0}, {14, 7, 0}, {10, 7, 0}}) == 2, "through two edges");
    CHECK_MESSAGE(crossings({{10, 6, 0}, {14, 10, 0}, {10, 10, 0}}) == 2, "touches a vertex");
    CHECK_MESSAGE(crossings({{10, 6, 0}, {14, 6, 0}, {12, 10, 0}}) == 2, "touches along an edge");
    CHECK_MESSAGE(crossings({{10, 6, 0}, {12, 6, 0}, {14, 6, 0}, {12, 10, 0}}) == 2, "along two");
    CHECK_MESSAGE(crossings({{14, 6, 0}, {12, 9, 0}, {10, 6, 0}, {12, 3, 0}}) == 2, "pierces two vertices");
    CHECK_MESSAGE(crossings({{20, 6, 0}, {6, 20, 0}, {-8, 6, 0}, {6, -8, 0}}) == 1, "pierces one, from within");
    CHECK_MESSAGE(crossings({{2, 6, 0}, {-2, 10, 0}, {-2, 2, 0}}) == 0, "on the line, behind the point");
    CHECK_MESSAGE(crossings({{10, 6, 0}, {14, 6, 0}, {12, 6, 1}}) == 0, "a segment on the ray leaves it nowhere");
}

TEST_CASE_TEMPLATE("OctantAngles: full and none, and half ones split where they pass a corner", K, VIDNO_KERNELS) {
    const auto octants = [](const Corners& vertices) {
        Stage<K, family::Angles> stage(scene_of(vertices));
        return family::Angles::octant_angles(stage.run, stage.polygon(), window);
    };
    CHECK(octants({{0, 0, 0}, {12, 0, 0}, {12, 12, 0}, {0, 12, 0}}) == 8);
    CHECK(octants({{0, 12, 0}, {12, 12, 0}, {12, 0, 0}, {0, 0, 0}}) == -8);
    CHECK(octants({{9, 5, 0}, {12, 5, 0}, {12, 7, 0}, {9, 7, 0}}) == 0);
    // From octant 0 to octant 4, above the corner (8, 4): at x = 8 the edge is at y = 2. Back past the corner (4, 8),
    // at y = 10, or the same way, as the third vertex says.
    const glm::dvec3 from(2, -1, 0), to(18, 7, 0), beyond(18, 9, 0);
    CHECK_MESSAGE(octants({from, beyond, {2, 30, 0}}) == 8, "the window is below the edge, in the polygon");
    CHECK_MESSAGE(octants({from, beyond, {18, -1, 0}}) == 0, "the window is below the edge, outside");
    CHECK_MESSAGE(octants({from, to, beyond}) == 0, "there and back");
}

// ------------------------------------------------------------------------------------- relations, against the
// definition

namespace {

/// A window of whole pixels in the area.
Window random_window(RandomScenes& random, const Area& area) {
    const int left = random.whole(area.x, area.right() - 1), right = random.whole(left + 1, area.right());
    const int top = random.whole(area.y, area.bottom() - 1), bottom = random.whole(top + 1, area.bottom());
    return {double(left), double(top), double(right - left), double(bottom - top)};
}

/// Vertices in the window; or on the lines of its sides, on its corners and next to them.
Corners triangle_about(RandomScenes& random, const Window& about) {
    const bool within = random.whole(0, 2) == 0;
    const auto coordinate = [&](double low, double high) {
        if (within) return low + (high - low) * random.whole(0, 16) / 16;
        const double side = random.whole(0, 1) == 0 ? low : high;
        return side + random.whole(-6, 6) * (random.whole(0, 2) == 0 ? 0 : .5);
    };
    const auto vertex = [&] {
        const double x = coordinate(about.x, about.right());
        return glm::dvec3(x, coordinate(about.y, about.bottom()), random.depth());
    };
    const auto a = vertex(), b = vertex();
    return {a, b, vertex()};
}

template <class K, class Set>
void check_relations(const AdmittedScene& scene, const Window& of, std::map<Relation, int>& found) {
    Stage<K, Set> stage(scene);
    const RelationReference reference(of);
    for (const auto& polygon : stage.run.polygons) {
        const Relation expected = reference.of(stage.scene->polygons[std::size_t(polygon.index)]);
        CHECK(Set::relation(stage.run, polygon, of) == expected);
        ++found[expected];
        if (const auto by_box = Set::box_test(stage.run, polygon, of)) CHECK(*by_box == expected);
        const bool has_edge_in = expected == Relation::inside || expected == Relation::intersecting;
        const bool is_point = polygon.box.xmin == polygon.box.xmax && polygon.box.ymin == polygon.box.ymax;
        if (!is_point) CHECK(Set::trial_function(stage.run, polygon, of) == has_edge_in);
    }
}

}  // namespace

TEST_CASE_TEMPLATE("Relation: all tests agree with the definition", K, Exact, Filtered, Grid8) {
    RandomScenes random(17);
    std::map<Relation, int> found;
    for (int i = 0; i < 1500; ++i) {
        CAPTURE(i);
        Scene drawn = random.scene();
        const Window of = random_window(random, drawn.area);
        for (int more = 0; more < 3; ++more) {
            drawn.polygons.push_back({std::to_string(more), red, triangle_about(random, of)});
        }
        const AdmittedScene scene = admit(std::move(drawn));
        check_relations<K, family::Full>(scene, of, found);
        check_relations<K, family::Angles>(scene, of, found);
    }
    for (const Relation relation :
         {Relation::outside, Relation::inside, Relation::intersecting, Relation::surrounding}) {
        CAPTURE(relation_names[std::size_t(relation)]);
        CHECK(found[relation] > 250);
    }
}

// ------------------------------------------------------------------------------------- pictures

namespace {

template <class Set, Kernel K>
Picture painted(const AdmittedScene& scene, const K& kernel) {
    return render<Set>(Set::methods.front(), scene, kernel);
}

template <class Set>
void check_paints(const AdmittedScene& scene, const Picture& expected) {
    CHECK(different_pixels(painted<Set>(scene, Exact{}), expected) == 0);
    CHECK(different_pixels(painted<Set>(scene, Filtered{}), expected) == 0);
}

void check_picture_rule(const AdmittedScene& scene) {
    const Picture expected = Reference(scene).picture();
    check_paints<family::Simplest>(scene, expected);
    check_paints<family::Full>(scene, expected);
    check_paints<family::Angles>(scene, expected);
    check_paints<family::AtVertex>(scene, expected);
    check_paints<family::EdgeOn>(scene, PictureVariation{.shows_edge_on = true}.picture(scene));
}

}  // namespace

TEST_CASE("The variants paint their rules on random and degenerate scenes") {
    RandomScenes random(20261122);
    for (int i = 0; i < 1000; ++i) {
        CAPTURE(i);
        check_picture_rule(random.scene());
    }
}

TEST_CASE("The variants paint their rules on each family of scenes, and when moved by ulps") {
    for (const Family& family : families) {
        CAPTURE(family.name);
        RandomPolygons random(std::mt19937(5));
        for (int i = 0; i < 15; ++i) {
            CAPTURE(i);
            const AdmittedScene scene = random_scene(family, random);
            check_picture_rule(scene);
            check_picture_rule(moved_by_ulps(scene, 2, random));
        }
    }
}

TEST_CASE("The variants paint their rules where depths tie, planes cross and vertices are on centres") {
    check_picture_rule(SceneBuilder(area_16)
                           .polygon({{0, 0, 0}, {10, 0, .625}, {10, 10, .625}, {0, 10, 0}})
                           .polygon({{4, 4, .25}, {16, 4, 1}, {16, 16, 1}, {4, 16, .25}})
                           .build());
    check_picture_rule(SceneBuilder(area_16)
                           .polygon({{0, 2, 0}, {16, 2, 1}, {16, 14, 1}, {0, 14, 0}})
                           .polygon({{2, 0, 1}, {14, 0, 1}, {14, 16, 0}, {2, 16, 0}})
                           .quad(1, 1, 15, 15, .5)
                           .build());
    check_picture_rule(SceneBuilder(area_16)
                           .polygon({{2.5, 2.5, 0}, {12.5, 4.5, .25}, {6.5, 11.5, .5}})
                           .polygon({{.5, .5, .25}, {15.5, .5, .25}, {.5, 15.5, .25}})
                           .build());
    check_picture_rule(SceneBuilder(area_16).build());
}

TEST_CASE("The variants paint their rules on areas of any size and place") {
    for (const Area area :
         {Area{0, 0, 1, 1}, {3, 5, 7, 1}, {-100, 40, 1, 9}, {-8, -8, 13, 11}, {1 << 30, -(1 << 30), 5, 6}}) {
        CAPTURE(area.x);
        const double x = area.x, y = area.y;
        check_picture_rule(SceneBuilder(area)
                               .quad(x - 1, y - 1, x + 4.5, y + 3, .25)
                               .polygon({{x, y, -1}, {x + 12, y + 2, 1}, {x + 3, y + 10, 0}})
                               .polygon({{x + .5, y, 1}, {x + .5, y + 9, 1}, {x + .5, y + 4, -1}})
                               .build());
    }
}

TEST_CASE_TEMPLATE("The variants paint a scene in which nothing rounds alike under every kernel", K, VIDNO_KERNELS) {
    const AdmittedScene scene = SceneBuilder(area_16)
                                    .quad(2, 2, 10, 10, .25)
                                    .quad(6, 6, 14, 14, .5)
                                    .polygon({{0, 0, 0}, {16, 0, 0}, {0, 16, 0}})
                                    .build();
    const Picture expected = Reference(scene).picture();
    CHECK(painted<family::Simplest>(scene, K{}) == expected);
    CHECK(painted<family::Full>(scene, K{}) == expected);
    CHECK(painted<family::Angles>(scene, K{}) == expected);
    CHECK(painted<family::AtVertex>(scene, K{}) == expected);
    CHECK(painted<family::EdgeOn>(scene, K{}) == expected);
}

// ------------------------------------------------------------------------------------- the simplest

namespace {

/// Windows taken from the stack, and relations determined.
struct CountSteps : NoTrace {
    struct Counts {
        int windows = 0, relations = 0;
    };
    Counts* counts;
    explicit CountSteps(Counts& to) : counts(&to) {}
    void pop(Line, const auto&) { ++counts->windows; }
    void relation(Line, const auto&, Relation) { ++counts->relations; }
};

template <class Set, class K = Double>
CountSteps::Counts steps_of(const AdmittedScene& scene) {
    CountSteps::Counts counts;
    render<Set>(Set::methods.front(), scene, K{}, CountSteps(counts));
    return counts;
}

}  // namespace

TEST_CASE("Simplest: windows around a small polygon are split down to its pixel") {
    // On 4 x 4 pixels: the first window, its four parts, and the four pixels of the part in which the polygon's box
    // lies.
    const AdmittedScene scene = SceneBuilder({0, 0, 4, 4}).quad(1.25, 1.25, 1.75, 1.75, 0).build();
    CHECK(steps_of<family::Simplest>(scene).windows == 1 + 4 + 4);
    CHECK_MESSAGE(steps_of<family::Full>(scene).windows == 1, "alone, it is drawn");
}

TEST_CASE("Simplest: even a window that one polygon surrounds is split") {
    const AdmittedScene scene = SceneBuilder({0, 0, 4, 4}).quad(-1, -1, 5, 5, 0).build();
    CHECK(steps_of<family::Simplest>(scene).windows == 1 + 4 + 16);
    CHECK(steps_of<family::Full>(scene).windows == 1);
}

// ------------------------------------------------------------------------------------- three lists

TEST_CASE("Three lists: the near square before the far quad") {
    // The far quad surrounds the first window, so it is tested once. The square intersects only windows that hold a
    // part of its outline: the 4 of 8 x 8 on the first level, each with a corner of it. Their parts of 4 x 4 at most
    // touch its sides, since it goes from 4 to 12, so it surrounds each of them or is outside. 1 + 4 + 16 windows, with
    // a test of the square in each.
    const AdmittedScene scene = SceneBuilder(area_16).polygon(near_square).polygon(far_quad).build();
    const auto steps = steps_of<family::Full>(scene);
    CHECK(steps.windows == 1 + 4 + 16);
    CHECK(steps.relations == 1 + (1 + 4 + 16));
}

namespace {

/// Keeps the lists that the events describe, and compares those of each window with the definition.
struct WatchLists : NoTrace {
    struct Lists {
        const Scene* scene;
        std::map<int, Relation> joined;  // by the place of the polygon; all others are in the third list
        std::set<int> tested;            // at the current window
        Window current;
        int looked_at = 0, wrong = 0, tested_again = 0;

        void expect_right() {
            const RelationReference reference(current);
            for (const auto& [place, relation] : joined) {
                ++looked_at;
                wrong += reference.of(scene->polygons[std::size_t(place)]) == relation ? 0 : 1;
            }
        }
    };
    Lists* lists;
    explicit WatchLists(Lists& to) : lists(&to) {}

    void pop(Line, const Window& of) {
        lists->current = of;
        lists->tested.clear();
    }
    void rejoin(Line, Relation relation, const auto& list) {
        const int place = list.back().polygon->index;
        CHECK(lists->joined.at(place) == relation);
        lists->joined.erase(place);
    }
    void relation(Line, const auto& polygon, Relation) {
        lists->tested_again += lists->joined.contains(polygon.index) ? 1 : 0;
        lists->tested.insert(polygon.index);
    }
    void join(Line, Relation relation, const auto& list) { lists->joined[list.back().polygon->index] = relation; }
    void decide(Line, Case) {
        lists->expect_right();
        std::size_t shown = 0;
        for (const auto& polygon : lists->scene->polygons) shown += polygon.edge_on ? 0 : 1;
        std::size_t known = lists->joined.size();
        for (const int place : lists->tested) known += lists->joined.contains(place) ? 0 : 1;
        CHECK_MESSAGE(known == shown, "each polygon is in a list or has been tested");
    }
};

template <class Set>
void check_lists(const AdmittedScene& scene, WatchLists::Lists& lists) {
    lists.scene = &*scene;
    lists.joined.clear();
    render<Set>(Set::methods.front(), scene, Filtered{}, WatchLists(lists));
}

}  // namespace

TEST_CASE("Three lists: they are right at every window, and no polygon of the first two is tested") {
    RandomScenes random(23);
    WatchLists::Lists lists{};
    for (int i = 0; i < 150; ++i) {
        CAPTURE(i);
        const AdmittedScene scene = random.scene();
        check_lists<family::Full>(scene, lists);
        check_lists<family::AtVertex>(scene, lists);
    }
    CHECK(lists.wrong == 0);
    CHECK(lists.tested_again == 0);
    CHECK(lists.looked_at > 5000);
}

// ------------------------------------------------------------------------------------- split at a vertex

namespace {

template <class K>
std::vector<Window> split_at_vertex(const AdmittedScene& scene, const Window& of) {
    Stage<K, family::AtVertex> stage(scene);
    const WindowParts parts = family::AtVertex::split(stage.run, of, stage.all_active());
    return {parts.begin(), parts.end()};
}

}  // namespace

TEST_CASE_TEMPLATE("VertexSplit: at the pixel boundaries next to the first vertex in the window", K, VIDNO_KERNELS) {
    // (5.25, 6.75) is next to the boundaries x = 5 and y = 7. A vertex halfway between two boundaries takes the smaller
    // one.
    const auto parts = split_at_vertex<K>(scene_of({{5.25, 6.75, 0}, {14, 20, 0}, {2, 20, 0}}), {0, 0, 16, 16});
    CHECK(parts == std::vector<Window>{{0, 0, 5, 7}, {0, 7, 5, 9}, {5, 0, 11, 7}, {5, 7, 11, 9}});
    const auto half = split_at_vertex<K>(scene_of({{5.5, 6.5, 0}, {14, 20, 0}, {2, 20, 0}}), {0, 0, 16, 16});
    CHECK(half == std::vector<Window>{{0, 0, 5, 6}, {0, 6, 5, 10}, {5, 0, 11, 6}, {5, 6, 11, 10}});
}

TEST_CASE_TEMPLATE("VertexSplit: a boundary that is a side of the window does not split", K, VIDNO_KERNELS) {
    const auto across = split_at_vertex<K>(scene_of({{5, .25, 0}, {14, 20, 0}, {2, 20, 0}}), {0, 0, 16, 16});
    CHECK(across == std::vector<Window>{{0, 0, 5, 16}, {5, 0, 11, 16}});
    // A vertex next to a corner would not split the window, so the next vertex does.
    const auto next = split_at_vertex<K>(scene_of({{.25, .25, 0}, {9, 3, 0}, {2, 20, 0}}), {0, 0, 16, 16});
    CHECK(next == std::vector<Window>{{0, 0, 9, 3}, {0, 3, 9, 13}, {9, 0, 7, 3}, {9, 3, 7, 13}});
}

TEST_CASE_TEMPLATE("VertexSplit: without a vertex in the window, in the middle", K, VIDNO_KERNELS) {
    // One vertex is outside, one on a side.
    const AdmittedScene scene = scene_of({{-4, -4, 0}, {5, 3, 0}, {-4, 30, 0}});
    const auto odd = split_at_vertex<K>(scene, {0, 3, 5, 1});
    CHECK(odd == std::vector<Window>{{0, 3, 2, 1}, {2, 3, 3, 1}});
    const auto upright = split_at_vertex<K>(scene, {0, 3, 1, 2});
    CHECK(upright == std::vector<Window>{{0, 3, 1, 1}, {0, 4, 1, 1}});
}

TEST_CASE("VertexSplit: fewer windows if a corner is not in the middle") {
    // Split at (3, 3), the four parts are simple. Split in the middle of 16, and of 8 and 4, the corner always is in
    // one part.
    const AdmittedScene scene = SceneBuilder(area_16).quad(3, 3, 20, 20, .5).quad(-1, -1, 17, 17, 0).build();
    CHECK(steps_of<family::AtVertex>(scene).windows == 1 + 4);
    CHECK(steps_of<family::Full>(scene).windows > 1 + 4 + 4);
}

// ------------------------------------------------------------------------------------- edge-on polygons

TEST_CASE_TEMPLATE("EdgeDepth: the greatest depth of the edges in the line of sight", K, VIDNO_KERNELS) {
    // In the plane x = 2 + 1/2: from (y, z) = (1/2, 0) over (4 1/2, 1) to (8 1/2, 0), and straight back.
    Stage<K, family::EdgeOn> stage(scene_of({{2.5, .5, 0}, {2.5, 4.5, 1}, {2.5, 8.5, 0}}));
    EdgeDepth::initialize_edges(stage.run);
    const auto depth = [&](double y) {
        return as_double(
            stage.run.kernel.finite(family::EdgeOn::depth(stage.run, stage.polygon(), stage.point(2.5, y))));
    };
    CHECK(depth(.5) == 0);
    CHECK(depth(2.5) == .5);
    CHECK(depth(4.5) == 1);
    CHECK(depth(5.5) == .75);
    const auto holds = [&](double x, double y) {
        return family::EdgeOn::surround_test(stage.run, stage.point(x, y), stage.polygon());
    };
    CHECK(holds(2.5, .5));
    CHECK(holds(2.5, 6.5));
    CHECK_FALSE_MESSAGE(holds(2.5, 9.5), "on the line, beyond the end");
    CHECK_FALSE(holds(3.5, 4.5));
}

TEST_CASE_TEMPLATE("EdgeDepth: along an edge, its nearer end", K, VIDNO_KERNELS) {
    // A rectangle from (1 1/2, 1 1/2) to (5 1/2, 5 1/2), its upright edges from z = -1/2 to 1/2; and one that is a
    // single line of sight.
    Stage<K, family::EdgeOn> stage(SceneBuilder(area_16)
                                       .polygon({{1.5, 1.5, -.5}, {5.5, 5.5, -.5}, {5.5, 5.5, .5}, {1.5, 1.5, .5}})
                                       .polygon({{7.5, 7.5, -.25}, {7.5, 7.5, .75}, {7.5, 7.5, .25}})
                                       .build());
    EdgeDepth::initialize_edges(stage.run);
    const auto depth = [&](std::size_t polygon, double at) {
        return as_double(
            stage.run.kernel.finite(family::EdgeOn::depth(stage.run, stage.polygon(polygon), stage.point(at, at))));
    };
    CHECK(depth(0, 1.5) == .5);
    CHECK(depth(0, 3.5) == .5);
    CHECK(depth(0, 5.5) == .5);
    CHECK(depth(1, 7.5) == .75);
}

TEST_CASE("Edge-on polygons: random ones through centres, before, behind and through others") {
    RandomScenes random(31);
    std::size_t seen = 0;
    for (int i = 0; i < 1000; ++i) {
        CAPTURE(i);
        const Area area = random.area();
        SceneBuilder builder(area);
        for (int polygons = random.whole(1, 3); polygons > 0; --polygons) {
            if (random.whole(0, 2) == 0) builder.polygon(random.triangle(area));
            // A way of whole pixels from a centre, its vertices at multiples of a quarter of it.
            const glm::dvec3 from{area.x + random.whole(-2, area.width + 1) + .5,
                                  area.y + random.whole(-2, area.height + 1) + .5, 0};
            const glm::dvec3 way{double(random.whole(-4, 4)), double(random.whole(-4, 4)), 0};
            Corners vertices;
            for (int count = random.whole(3, 5); count > 0; --count) {
                vertices.push_back(from + way * (random.whole(-4, 8) / 4.0) + glm::dvec3{0, 0, random.depth()});
            }
            builder.polygon(vertices);
        }
        const AdmittedScene scene = builder.build();
        const Picture expected = PictureVariation{.shows_edge_on = true}.picture(scene);
        check_paints<family::EdgeOn>(scene, expected);
        seen += different_pixels(expected, Reference(scene).picture());
    }
    CHECK_MESSAGE(seen > 1000, "pixels of edge-on polygons");
}

// ------------------------------------------------------------------------------------- bodies

namespace {

AdmittedScene scene_with(const Faces& faces) {
    SceneBuilder builder(area_16);
    return add_body(builder, faces).build();
}

const glm::dvec3 corner_of_box{4, 4, -.5};
const Faces tilted_box = parallelepiped(corner_of_box, {6, 2, .25}, {-2, 5, .125}, {1, 1, .5});

}  // namespace

TEST_CASE("Closed convex bodies are admitted, one or more of them") {
    CHECK_FALSE(not_closed_convex_bodies(scene_with(tilted_box)).has_value());
    CHECK_FALSE(
        not_closed_convex_bodies(scene_with(tetrahedron({1, 1, 0}, {9, 2, .5}, {4, 12, 0}, {5, 5, -1}))).has_value());
    SceneBuilder two(area_16);
    add_body(two, tilted_box);
    add_body(two, parallelepiped({1, 1, 0}, {3, 0, 0}, {0, 3, 0}, {0, 0, .5}));
    CHECK_FALSE(not_closed_convex_bodies(two.build()).has_value());
    CHECK_FALSE(not_closed_convex_bodies(SceneBuilder(area_16).build()).has_value());
}

TEST_CASE("A scene that does not consist of closed convex bodies is refused, with a polygon that shows it") {
    const auto reason = [](const Faces& faces) { return not_closed_convex_bodies(scene_with(faces)).value_or(""); };
    Faces open = tilted_box;
    open.pop_back();
    CHECK(reason(open).find("has an edge that no other polygon shares") != std::string::npos);

    Faces turned = tilted_box;
    std::reverse(turned[2].begin(), turned[2].end());
    CHECK(reason(turned).find("goes along an edge in the same direction as another polygon") != std::string::npos);

    Faces inside_out = tilted_box;
    for (auto& face : inside_out) std::reverse(face.begin(), face.end());
    CHECK(reason(inside_out).find("in front of it") != std::string::npos);

    Faces bent = tilted_box;
    for (auto& face : bent) {
        for (auto& vertex : face) {
            if (vertex == corner_of_box) vertex.z -= 0x1p-44;
        }
    }
    CHECK(reason(bent).find("is not planar to the last digit") != std::string::npos);

    // Two tetrahedra without their common face: the resulting body has a reflex edge.
    const glm::dvec3 a{4, 4, 0}, b{12, 4, 0}, c{8, 12, 0};
    Faces notched;
    for (const auto& half : {tetrahedron(a, b, c, {8, 6, .5}), tetrahedron(a, b, c, {8, 30, -.5})}) {
        for (const auto& face : half) {
            const auto is_common = [&](const glm::dvec3& v) { return v.z == 0; };
            if (!std::all_of(face.begin(), face.end(), is_common)) notched.push_back(face);
        }
    }
    CHECK(reason(notched).find("in front of it: its body is not convex") != std::string::npos);

    CHECK(reason({{{1, 1, 0}, {1, 1, 0}, {1, 1, 0}}}).find("has no area") != std::string::npos);
}

TEST_CASE_TEMPLATE("BackFaces: the sign of the first turn", K, VIDNO_KERNELS) {
    const auto looks_away = [](const Corners& vertices) {
        Stage<K, family::Bodies> stage(scene_of(vertices));
        return BackFaces::looks_away(stage.run, stage.polygon());
    };
    CHECK_FALSE_MESSAGE(looks_away({{5, 5, 0}, {5, 1, 0}, {1, 1, 0}}), "counter-clockwise on the screen");
    CHECK(looks_away({{1, 1, 0}, {5, 1, 0}, {5, 5, 0}}));
    CHECK_MESSAGE(looks_away({{1, 1, 0}, {3, 1, 0}, {5, 1, 0}, {5, 5, 0}}), "after a vertex that is no corner");
}

TEST_CASE("Bodies: faces that look away may be removed") {
    RandomBodies random(41);
    int admitted = 0, removed = 0;
    for (int i = 0; i < 600; ++i) {
        CAPTURE(i);
        const AdmittedScene scene = random.scene();
        if (not_closed_convex_bodies(scene)) continue;
        ++admitted;
        check_paints<family::Bodies>(scene, PictureVariation{.front_before_back = true}.picture(scene));
        removed += int(steps_of<family::Bodies>(scene).windows < steps_of<Corrected>(scene).windows);
    }
    CHECK(admitted > 300);
    CHECK_MESSAGE(removed > 100, "with fewer polygons there is less to split");
}

TEST_CASE("Bodies: on the outline the face that looks towards the viewer wins, even if the other comes first") {
    // The edge from (1/2, 1/2) to (4 1/2, 4 1/2) is on the outline of the tetrahedron; its fourth vertex is behind it.
    const Faces faces = tetrahedron({.5, .5, 0}, {4.5, 4.5, 0}, {9.5, .5, 0}, {5.5, 1.5, -.5});
    const auto looks_here = [](const Corners& face) { return glm::cross(face[1] - face[0], face[2] - face[0]).z < 0; };
    SceneBuilder builder(area_16);
    for (const bool here : {false, true}) {
        for (const auto& face : faces) {
            if (looks_here(face) == here) builder.polygon(here ? "here" : "away", here ? green : red, face);
        }
    }
    const AdmittedScene scene = builder.build();
    REQUIRE_FALSE(not_closed_convex_bodies(scene).has_value());
    CHECK(render(Method::warnock, scene, Exact{}).at(2, 2) == red);
    CHECK(painted<family::Bodies>(scene, Exact{}).at(2, 2) == green);
    CHECK(painted<family::Bodies>(scene, Filtered{}).at(2, 2) == green);
}

TEST_CASE("A procedure set refuses a method that it does not run") {
    const AdmittedScene scene = SceneBuilder(area_16).quad(2, 2, 8, 8, 0).build();
    CHECK_THROWS_AS(render(Method::warnock_full, scene, Double{}), std::invalid_argument);
    CHECK_THROWS_AS(render(Method::weiler_atherton, scene, Double{}), std::invalid_argument);
    CHECK_THROWS_AS(render<family::Full>(Method::warnock, scene, Double{}), std::invalid_argument);
    CHECK_THROWS_AS(render<family::Full>(Method::zbuffer, scene, Double{}), std::invalid_argument);
    CHECK_THROWS_WITH(render<family::Angles>(Method::warnock_full, scene, Double{}),
                      "the procedure set angles does not run the method warnock-full");
}
