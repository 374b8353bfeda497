// The procedures of Weiler and Atherton's algorithm on cases computed by hand, over all kernels, and its regions and
// its picture against the picture rule by brute force. Coordinates are short binary fractions where kernels that round
// must agree.

#include "vidno/weiler_atherton.h"

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <random>
#include <vector>

#include "support/kernels.h"
#include "support/reference.h"
#include "support/scenes.h"
#include "support/visitors.h"
#include "vidno/kernels/filtered_regions.h"

using namespace vidno;
using namespace vidno::test;

#define VIDNO_REGION_KERNELS VIDNO_PRINTED_KERNELS, Filtered

namespace vidno {

static Rational exactly(const Rational& number) { return number; }
static Rational exactly(const Constructed& number) { return number.exactly(); }

}  // namespace vidno

namespace {

using Places = std::vector<std::pair<double, double>>;

/// Where the subject's outline enters the clip region, and where it leaves it.
struct HearPassages : NoTrace {
    Places* entered;
    Places* left;
    HearPassages(Places& entering, Places& leaving) : entered(&entering), left(&leaving) {}
    void enter(Line, const auto& p) { entered->emplace_back(as_double(p.x), as_double(p.y)); }
    void leave(Line, const auto& p) { left->emplace_back(as_double(p.x), as_double(p.y)); }
};

/// A run for calling single procedures.
template <class K>
struct WeilerAthertonStage {
    AdmittedScene scene;
    Picture picture;
    Places entered, left;
    WeilerAthertonRun<CorrectedWeilerAtherton, OnRegions<K>, HearPassages> run;
    using Piece = typename decltype(run)::Piece;

    explicit WeilerAthertonStage(AdmittedScene given)
        : scene(std::move(given)),
          picture(scene->area, scene->background),
          run(scene, OnRegions<K>{}, HearPassages(entered, left), picture) {}

    auto part_in_area(std::size_t index) {
        auto part = run.cut_to_area(Line::WA1, run.polygons[index]);
        entered.clear();
        left.clear();
        return part;
    }
    Piece piece(std::size_t index) { return {&run.polygons[index], part_in_area(index)}; }
    std::vector<Piece> all_pieces() {
        std::vector<Piece> pieces;
        for (std::size_t i = 0; i < run.polygons.size(); ++i) pieces.push_back(piece(i));
        return pieces;
    }
};

double area_in_doubles(const auto& region) { return as_double(area_of(outlines_of(region))); }

/// By polygon, of those that show.
std::map<int, double> visible_areas(const auto& regions) {
    std::map<int, double> areas;
    for (const auto& [polygon, outlines] : regions) areas[polygon] += as_double(area_of(outlines));
    return areas;
}
template <class K>
std::map<int, double> visible_areas(const AdmittedScene& scene) {
    return visible_areas(visible_regions(scene, K{}).regions);
}

std::vector<int> places_of(const auto& pieces) {
    std::vector<int> places;
    for (const auto& piece : pieces) places.push_back(piece.polygon->index);
    return places;
}

/// A square of 8 x 8, and regions that touch it in every possible way.
const Corners square{{2, 2, 0}, {10, 2, 0}, {10, 10, 0}, {2, 10, 0}};

struct Contact {
    const char* name;
    Corners clip;
    double area_inside;
    std::size_t loops_inside, loops_outside;
};
const std::vector<Contact> contacts{
    {"corner over corner", {{6, 6, 0}, {14, 6, 0}, {14, 14, 0}, {6, 14, 0}}, 16, 1, 1},
    {"inside: a hole", {{4, 4, 0}, {8, 4, 0}, {8, 8, 0}, {4, 8, 0}}, 16, 1, 2},
    {"around", {{1, 1, 0}, {11, 1, 0}, {11, 11, 0}, {1, 11, 0}}, 64, 1, 0},
    {"apart", {{12, 12, 0}, {14, 12, 0}, {14, 14, 0}}, 0, 0, 1},
    {"the same", square, 64, 1, 0},
    {"across: two parts", {{4, 1, 0}, {8, 1, 0}, {8, 11, 0}, {4, 11, 0}}, 32, 1, 2},
    {"across, from side to side", {{4, 2, 0}, {8, 2, 0}, {8, 10, 0}, {4, 10, 0}}, 32, 1, 2},
    {"beside, along a whole edge", {{10, 2, 0}, {14, 2, 0}, {14, 10, 0}, {10, 10, 0}}, 0, 0, 1},
    {"beside, along part of an edge", {{10, 4, 0}, {14, 4, 0}, {14, 14, 0}, {10, 14, 0}}, 0, 0, 1},
    {"within, along part of an edge", {{6, 4, 0}, {10, 4, 0}, {10, 8, 0}, {6, 8, 0}}, 16, 1, 1},
    {"within, in a corner", {{6, 6, 0}, {10, 6, 0}, {10, 10, 0}, {6, 10, 0}}, 16, 1, 1},
    {"over, along a whole edge", {{6, 2, 0}, {14, 2, 0}, {14, 10, 0}, {6, 10, 0}}, 32, 1, 1},
    {"a vertex on a vertex, outside", {{10, 10, 0}, {14, 10, 0}, {14, 14, 0}}, 0, 0, 1},
    {"a vertex on a vertex, inside", {{2, 2, 0}, {8, 4, 0}, {4, 8, 0}}, 16, 1, 1},
    {"a vertex on an edge, outside", {{10, 6, 0}, {14, 4, 0}, {14, 8, 0}}, 0, 0, 1},
    {"a vertex on an edge, inside", {{10, 6, 0}, {6, 8, 0}, {6, 4, 0}}, 8, 1, 1},
    {"a vertex on an edge, from within, through the opposite one", {{10, 6, 0}, {0, 11, 0}, {0, 1, 0}}, 32, 1, 2},
    {"an edge through a vertex", {{14, 6, 0}, {14, 14, 0}, {6, 14, 0}}, 0, 0, 1},
    {"an edge along the diagonal, through two vertices", {{0, 0, 0}, {12, 12, 0}, {0, 12, 0}}, 32, 1, 1},
    {"all four vertices on edges: four parts", {{6, 2, 0}, {10, 6, 0}, {6, 10, 0}, {2, 6, 0}}, 32, 1, 4},
    {"collinear and repeated vertices", {{4, 2, 0}, {6, 2, 0}, {6, 2, 0}, {8, 2, 0}, {8, 6, 0}, {4, 6, 0}}, 16, 1, 1},
};

}  // namespace

TEST_CASE_TEMPLATE("RegionClip: what is inside and what is outside, in every kind of contact", K,
                   VIDNO_REGION_KERNELS) {
    for (const Contact& contact : contacts) {
        for (const bool reversed : {false, true}) {
            CAPTURE(contact.name);
            CAPTURE(reversed);
            Corners other = contact.clip;
            if (reversed) std::reverse(other.begin(), other.end());
            WeilerAthertonStage<K> stage(SceneBuilder(area_16).polygon(square).polygon(other).build());
            const auto parts = stage.run.region_clip(Line::WA5, stage.piece(0), stage.piece(1));
            CHECK(area_in_doubles(parts.inside) == contact.area_inside);
            CHECK(area_in_doubles(parts.outside) == 64 - contact.area_inside);
            CHECK(parts.inside.loops.size() == contact.loops_inside);
            CHECK(parts.outside.loops.size() == contact.loops_outside);
        }
    }
}

TEST_CASE_TEMPLATE("RegionClip: entering and leaving vertices", K, VIDNO_REGION_KERNELS) {
    // The outline goes right along y = 2, down x = 10, left along y = 10 and up x = 2.
    const auto passages = [](const Corners& clip) {
        WeilerAthertonStage<K> stage(SceneBuilder(area_16).polygon(square).polygon(clip).build());
        const auto subject = stage.piece(0);
        stage.run.region_clip(Line::WA5, subject, stage.piece(1));
        std::sort(stage.entered.begin(), stage.entered.end());
        std::sort(stage.left.begin(), stage.left.end());
        return std::pair(stage.entered, stage.left);
    };
    CHECK(passages(contacts[0].clip) == std::pair(Places{{10, 6}}, Places{{6, 10}}));
    CHECK_MESSAGE((passages({{4, 0, 0}, {8, 0, 0}, {8, 12, 0}, {4, 12, 0}}) ==
                   std::pair(Places{{4, 2}, {8, 10}}, Places{{4, 10}, {8, 2}})),
                  "twice");
    CHECK_MESSAGE((passages({{10, 6, 0}, {14, 4, 0}, {14, 8, 0}}) == std::pair(Places{}, Places{})), "a touch is none");
    CHECK_MESSAGE(
        (passages({{6, 4, 0}, {10, 4, 0}, {10, 8, 0}, {6, 8, 0}}) == std::pair(Places{{10, 4}}, Places{{10, 8}})),
        "along an edge from within: it bounds the part inside");
    CHECK_MESSAGE((passages({{10, 4, 0}, {14, 4, 0}, {14, 8, 0}, {10, 8, 0}}) == std::pair(Places{}, Places{})),
                  "along an edge from outside: it bounds the part outside");
}

TEST_CASE_TEMPLATE("RegionClip: a subject with a hole, and a clip region with one", K, VIDNO_REGION_KERNELS) {
    // The ring of 64 - 16 = 48 around (4, 4) to (8, 8), and the band of 8 x 4 over 3 <= x <= 5: of its 2 x 8 = 16 the
    // hole takes 1 x 4.
    WeilerAthertonStage<K> stage(
        SceneBuilder(area_16).polygon(square).quad(4, 4, 8, 8, 0).quad(3, 2, 5, 10, 0).quad(4, 4, 8, 8, 0).build());
    auto ring = stage.piece(0);
    ring.region = stage.run.region_clip(Line::WA5, ring, stage.piece(1)).outside;
    CHECK(area_in_doubles(ring.region) == 48);
    const auto by_band = stage.run.region_clip(Line::WA5, ring, stage.piece(2));
    CHECK(area_in_doubles(by_band.inside) == 12);
    CHECK(area_in_doubles(by_band.outside) == 36);
    const auto band_by_ring = stage.run.region_clip(Line::WA5, stage.piece(2), ring);
    CHECK(area_in_doubles(band_by_ring.inside) == 12);
    CHECK(area_in_doubles(band_by_ring.outside) == 4);
    CHECK_MESSAGE(stage.run.region_clip(Line::WA5, stage.piece(3), ring).inside.empty(), "what fills the hole");
}

TEST_CASE_TEMPLATE("A polygon is cut to the area", K, VIDNO_REGION_KERNELS) {
    // From (-4, -4) to (4, 4), to (20, 20), over a corner, and beside the area.
    WeilerAthertonStage<K> stage(SceneBuilder(area_16)
                                     .quad(-4, -4, 4, 4, 0)
                                     .quad(-4, -4, 20, 20, 0)
                                     .polygon({{12, 20, 0}, {20, 12, 0}, {20, 20, 0}})
                                     .polygon({{8, -8, 0}, {24, 8, 0}, {8, 8, 0}})
                                     .quad(16, 0, 20, 16, 0)
                                     .build());
    CHECK(area_in_doubles(stage.part_in_area(0)) == 16);
    CHECK(area_in_doubles(stage.part_in_area(1)) == 256);
    CHECK_MESSAGE(stage.part_in_area(2).empty(), "its edge passes through the corner (16, 16)");
    CHECK_MESSAGE(area_in_doubles(stage.part_in_area(3)) == 64, "its edge passes through (16, 0)");
    CHECK_MESSAGE(stage.part_in_area(4).empty(), "beside");
}

TEST_CASE("InsertionSort: in order and stable, and NaN stays in its place") {
    std::vector<std::pair<int, char>> items{{2, 'a'}, {1, 'a'}, {2, 'b'}, {1, 'b'}};
    insertion_sort(items, [](const auto& a, const auto& b) { return a.first < b.first; });
    CHECK(items == std::vector<std::pair<int, char>>{{1, 'a'}, {1, 'b'}, {2, 'a'}, {2, 'b'}});

    // Nothing compares as nearer than NaN, nor NaN as nearer than anything: 1 does not pass it, and 2 does not pass the
    // 1 behind it.
    std::vector<double> numbers{3, std::nan(""), 1, 2};
    std::vector<double> asked;
    insertion_sort(numbers, [&](double a, double b) {
        asked.push_back(b);
        return a < b;
    });
    CHECK(numbers[0] == 3);
    CHECK(std::isnan(numbers[1]));
    CHECK(numbers[2] == 1);
    CHECK(numbers[3] == 2);
    CHECK_MESSAGE(asked.size() == 3, "each with the one before it");
}

TEST_CASE_TEMPLATE("DepthSort: by the greatest depth, equal ones in the order of the scene", K, VIDNO_REGION_KERNELS) {
    // The first reaches from 0 to 1, the others are level; of the last only z = 3/4 x / 16 up to x = 16 is in the area.
    WeilerAthertonStage<K> stage(SceneBuilder(area_16)
                                     .polygon({{0, 0, 0}, {16, 0, 1}, {16, 16, 1}, {0, 16, 0}})
                                     .quad(0, 0, 4, 4, .5)
                                     .quad(0, 0, 4, 4, .875)
                                     .quad(4, 4, 8, 8, .5)
                                     .polygon({{0, 0, 0}, {21.25, 0, .99609375}, {0, 16, 0}})
                                     .build());
    CHECK(places_of(stage.run.depth_sort(Line::WA3, stage.all_pieces())) == std::vector{0, 2, 4, 1, 3});
}

TEST_CASE_TEMPLATE("RemoveBehind: nearer polygons stay, and the first of coplanar ones", K, VIDNO_REGION_KERNELS) {
    // All lie over the same square. The third meets the clip polygon along x = 2 and is in front of it elsewhere, the
    // fourth is behind.
    WeilerAthertonStage<K> stage(SceneBuilder(area_16)
                                     .quad(2, 2, 10, 10, .5)
                                     .quad(2, 2, 10, 10, .5)
                                     .polygon({{2, 2, .5}, {10, 2, 1}, {10, 10, 1}, {2, 10, .5}})
                                     .polygon({{2, 2, .5}, {10, 2, 0}, {10, 10, 0}, {2, 10, .5}})
                                     .quad(2, 2, 10, 10, .5)
                                     .quad(2, 2, 10, 10, .25)
                                     .quad(2, 2, 10, 10, .75)
                                     .build());
    const auto pieces = stage.all_pieces();
    const auto& clip = pieces[1];
    CHECK(places_of(stage.run.remove_behind(Line::WA7, pieces, clip)) == std::vector{0, 2, 6});
}

TEST_CASE_TEMPLATE("SplitPiercing: both are cut where their planes meet, others are not", K, VIDNO_REGION_KERNELS) {
    // z = x / 16 meets z = 1/2 at x = 8. The third polygon meets the level plane along its own edge x = 12 only; the
    // last one's plane meets the others at x = 8, too, but it lies beyond that.
    WeilerAthertonStage<K> stage(SceneBuilder(area_16)
                                     .polygon({{0, 4, 0}, {16, 4, 1}, {16, 12, 1}, {0, 12, 0}})
                                     .quad(4, 0, 12, 16, .5)
                                     .polygon({{10, 13, .25}, {12, 13, .5}, {12, 15, .5}, {10, 15, .25}})
                                     .polygon({{9, 1, .4375}, {11, 1, .3125}, {11, 3, .3125}, {9, 3, .4375}})
                                     .build());
    const auto convex = stage.run.split_piercing(Line::WA2, stage.all_pieces());
    CHECK(places_of(convex) == std::vector{0, 1, 2, 3, 1, 0});
    for (const auto& piece : convex) CHECK(area_in_doubles(piece.region) == (piece.polygon->index < 2 ? 64 : 4));
}

TEST_CASE_TEMPLATE("A near square leaves a ring of the far quad", K, VIDNO_REGION_KERNELS) {
    // 16 x 16 = 256 less 4 x 4 = 16.
    const auto visible = visible_regions(SceneBuilder(area_16).polygon(far_quad).quad(6, 6, 10, 10, .5).build(), K{});
    REQUIRE(visible.regions.size() == 2);
    CHECK(visible_areas(visible.regions) == std::map<int, double>{{0, 240}, {1, 16}});
    CHECK_MESSAGE(visible.regions[0].polygon == 1, "the nearest is found first");
    CHECK_MESSAGE(visible.regions[1].outlines.size() == 2, "the outline and a hole");
    for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 16; ++x) {
            const bool near = 6 <= x && x < 10 && 6 <= y && y < 10;
            CHECK(visible.picture.at(x, y) == color_of(near ? 1 : 0));
        }
    }
}

TEST_CASE_TEMPLATE("A polygon that is sorted last may be in front", K, VIDNO_REGION_KERNELS) {
    // The tilted quad, z = x / 16, reaches z = 1 and is sorted first. It is in front of the square at x >= 12, and
    // behind it at x <= 4.
    const Corners tilted{{0, 0, 0}, {16, 0, 1}, {16, 16, 1}, {0, 16, 0}};
    CHECK(visible_areas<K>(SceneBuilder(area_16).quad(12, 4, 16, 8, .5).polygon(tilted).build()) ==
          std::map<int, double>{{1, 256}});
    CHECK(visible_areas<K>(SceneBuilder(area_16).quad(0, 4, 4, 8, .5).polygon(tilted).build()) ==
          std::map<int, double>{{0, 16}, {1, 240}});
}

TEST_CASE_TEMPLATE("Cyclic overlap of three bars", K, VIDNO_REGION_KERNELS) {
    // The level bar is over the slanted one, x - y from 2 to 4, where z = y / 16 <= 5/16; that is over the upright one
    // for y >= 7, where z = 1 - 3 y / 32 <= 11/32; and that over the level one for y <= 5, where z >= 17/32. The bars
    // have 14 * 3 = 42, 14 * 3 = 42 and 2 * 12 = 24; 3 * 3 = 9 of the level one are hidden, 2 * 3 = 6 of the upright
    // and of the slanted one.
    const AdmittedScene scene = SceneBuilder(area_16)
                                    .quad(1, 2, 15, 5, .5)
                                    .polygon({{11, 1, .90625}, {14, 1, .90625}, {14, 15, -.40625}, {11, 15, -.40625}})
                                    .polygon({{2, 0, 0}, {4, 0, 0}, {16, 12, .75}, {14, 12, .75}})
                                    .build();
    CHECK(visible_areas<K>(scene) == std::map<int, double>{{0, 33}, {1, 36}, {2, 18}});
}

TEST_CASE_TEMPLATE("Two triangles that pierce each other", K, VIDNO_REGION_KERNELS) {
    // z = x / 16 and z = 1 - x / 16 meet at x = 8. Both have 16 * 8 / 2 = 64. At x they are 8 - x / 2 and x / 2 wide,
    // about y = 8: left of the line the second hides 8 * 4 / 2 = 16 of the first, right of it the first as much of the
    // second.
    const AdmittedScene scene = SceneBuilder(area_16)
                                    .polygon({{0, 4, 0}, {16, 8, 1}, {0, 12, 0}})
                                    .polygon({{16, 4, 0}, {0, 8, 1}, {16, 12, 0}})
                                    .build();
    CHECK(visible_areas<K>(scene) == std::map<int, double>{{0, 48}, {1, 48}});
}

TEST_CASE_TEMPLATE("The first of equal polygons shows, and edge-on ones do not", K, VIDNO_REGION_KERNELS) {
    const AdmittedScene scene = SceneBuilder(area_16)
                                    .polygon({{0, 0, 1}, {16, 16, 1}, {8, 8, -1}})
                                    .polygon(near_square)
                                    .polygon(near_square)
                                    .quad(8, 8, 14, 14, .5)
                                    .build();
    CHECK(visible_areas<K>(scene) == std::map<int, double>{{1, 64}, {3, 20}});
}

TEST_CASE_TEMPLATE("No polygons, or none in the area: no regions", K, VIDNO_REGION_KERNELS) {
    for (const AdmittedScene& scene :
         {SceneBuilder(area_16).build(), SceneBuilder(area_16).quad(16, 0, 20, 4, 0).build()}) {
        const auto visible = visible_regions(scene, K{});
        CHECK(visible.regions.empty());
        CHECK(visible.picture == Picture(area_16, white));
    }
}

TEST_CASE_TEMPLATE("The picture: outlines through centres belong to the nearest, then to the first", K,
                   VIDNO_REGION_KERNELS) {
    SUBCASE("the outline of a hole belongs to the polygon in it, a common edge to the first polygon") {
        const AdmittedScene scene =
            SceneBuilder({0, 0, 4, 4}).quad(0, 0, 2.5, 4, 0).quad(2.5, 0, 4, 4, 0).quad(.5, .5, 1.5, 1.5, .5).build();
        const Picture picture = visible_regions(scene, K{}).picture;
        for (int y = 0; y < 4; ++y) {
            for (int x = 0; x < 4; ++x) CHECK(picture.at(x, y) == color_of(x <= 1 && y <= 1 ? 2 : x <= 2 ? 0 : 1));
        }
    }
    SUBCASE("a polygon that is hidden all over shows where it is no farther, if it is the first") {
        // Both begin at x = 1/2 with z = 1/2; from there the first falls behind the second.
        const Corners falling{{.5, 0, .5}, {4.5, 0, 0}, {4.5, 4, 0}, {.5, 4, .5}};
        const Corners rising{{.5, 0, .5}, {4.5, 0, 1}, {4.5, 4, 1}, {.5, 4, .5}};
        const auto first = visible_regions(SceneBuilder({0, 0, 4, 4}).polygon(falling).polygon(rising).build(), K{});
        CHECK(visible_areas(first.regions) == std::map<int, double>{{1, 14}});
        const auto second = visible_regions(SceneBuilder({0, 0, 4, 4}).polygon(rising).polygon(falling).build(), K{});
        for (int y = 0; y < 4; ++y) {
            CHECK(first.picture.at(0, y) == color_of(0));
            CHECK(first.picture.at(1, y) == color_of(1));
            CHECK(second.picture.at(0, y) == color_of(0));
        }
    }
    SUBCASE("so does one that touches from behind in the middle of a region") {
        const AdmittedScene scene = SceneBuilder({0, 0, 4, 4})
                                        .polygon({{1.5, .5, .5}, {3.5, .5, 0}, {1.5, 2.5, .5}})
                                        .quad(0, 0, 4, 4, .5)
                                        .build();
        const auto visible = visible_regions(scene, K{});
        CHECK(visible_areas(visible.regions) == std::map<int, double>{{1, 16}});
        for (int y = 0; y < 4; ++y) {
            for (int x = 0; x < 4; ++x) CHECK(visible.picture.at(x, y) == color_of(x == 1 && y <= 2 ? 0 : 1));
        }
    }
}

namespace {

/// The labels of the listing's lines, in the order of the run's events.
struct HearLabels : NoTrace {
    std::string* reported;
    explicit HearLabels(std::string& to) : reported(&to) {}

    void hear(Line at) { *reported += std::string(line_names[std::size_t(at)]) + ' '; }
    void cut_to_area(Line at, const auto&, const auto&) { hear(at); }
    void facets(Line at, const auto&) { hear(at); }
    void sorted(Line at, const auto&) { hear(at); }
    void nearer_ones(Line at, const auto&) { hear(at); }
    void push_list(Line at, const auto&) { hear(at); }
    void pop_list(Line at, const auto&) { hear(at); }
    void show_region(Line at, const auto&, const auto&) { hear(at); }
    void pierce(Line at, const auto&, const auto&, const auto&) { hear(at); }
    void split(Line at, const auto&, const auto&, const auto&) { hear(at); }
    void greatest_depth(Line at, const auto&, const auto&) { hear(at); }
    void clipped(Line at, const auto&, const auto&, const auto&, const auto&) { hear(at); }
    void behind(Line at, const auto&, const auto&, const auto&, const auto&, const auto&, Sign, bool) { hear(at); }
    void paint(Line at, const auto&, int, int) { hear(at); }
};

}  // namespace

TEST_CASE("A run of Weiler and Atherton's algorithm reports each line of the listing that it reaches") {
    // The second is sorted first, since it rises to z = 1/2 at x = 2, yet the first is nearer where it lies, over x <=
    // 1. So the part inside the second one's outline becomes a list with both, and the rest of the second outside the
    // first becomes a separate list. Their planes meet at x = 3/2, where the first is not, so they need not be clipped
    // for that.
    std::string reported;
    const AdmittedScene scene = SceneBuilder({0, 0, 2, 1})
                                    .quad(0, 0, 1, 1, .375)
                                    .polygon({{0, 0, 0}, {2, 0, .5}, {2, 1, .5}, {0, 1, 0}})
                                    .build();
    visible_regions(scene, Double{}, HearLabels(reported));
    CHECK(reported ==
          "WA1 WA1 WA2 DS1 DS1 WA3 WA3 "
          "WA4 WA5 RB3 WA7 WA9 WA4 WA5 WA6 WA7 WA8 WA4 WA7 WA8 PR3 PR3 ");
}

// ------------------------------------------------------------------------------------- against the picture rule

namespace {

/// A backdrop behind all, so that the regions fill the area.
AdmittedScene before_backdrop(Scene scene) {
    const double left = scene.area.x, right = scene.area.right(), top = scene.area.y, bottom = scene.area.bottom();
    ScenePolygon backdrop{
        "backdrop", white, {{left, top, -1}, {right, top, -1}, {right, bottom, -1}, {left, bottom, -1}}};
    scene.polygons.push_back(backdrop);
    return admit(std::move(scene));
}

/// Does a region hold a point that is on none of its edges? By the winding number, in rationals.
bool holds_point(const auto& outlines, const Rational& x, const Rational& y) {
    int winding = 0;
    for (const auto& loop : outlines) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const auto& p = loop[i];
            const auto& q = loop[(i + 1) % loop.size()];
            const Rational px = exactly(p.x), py = exactly(p.y), qx = exactly(q.x), qy = exactly(q.y);
            const Rational side = (qx - px) * (y - py) - (qy - py) * (x - px);
            if (py <= y && y < qy && side > 0) ++winding;
            if (qy <= y && y < py && side < 0) --winding;
        }
    }
    CHECK((winding == 0 || winding == 1));
    return winding != 0;
}

constexpr double sample_step = 0x1p-20;

/// Checks that random points of the area lie in exactly one region, that of the polygon which the rule shows there.
void check_samples(const auto& regions, const AdmittedScene& scene, const Reference& reference, std::mt19937& random) {
    // Odd multiples, so that level and vertical edges pass between them.
    const auto between = [&](int low, int size) {
        return low + int(random() % unsigned(size << 19)) * 0x1p-19 + sample_step;
    };
    for (int i = 0; i < 10; ++i) {
        const double x = between(scene->area.x, scene->area.width), y = between(scene->area.y, scene->area.height);
        std::vector<Color> found;
        for (const auto& [polygon, outlines] : regions) {
            if (holds_point(outlines, x, y)) found.push_back(scene->polygons[std::size_t(polygon)].color);
        }
        CHECK(found == std::vector{reference.color_at(x, y)});
    }
}

template <class K>
void check_against_rule(const AdmittedScene& scene, const Reference& reference, std::mt19937& random) {
    const auto visible = visible_regions(scene, K{});
    CHECK(different_pixels(visible.picture, reference.picture()) == 0);
    Rational total = 0;
    for (const auto& region : visible.regions) {
        const Rational area = exactly(area_of(region.outlines));
        CHECK(area > 0);
        total += area;
    }
    CHECK(total == scene->area.width * scene->area.height);
    check_samples(visible.regions, scene, reference, random);
}

void check_both(const AdmittedScene& given, std::mt19937& random) {
    const AdmittedScene scene = before_backdrop(given);
    const Reference reference(scene, sample_step);
    check_against_rule<Exact>(scene, reference, random);
    check_against_rule<Filtered>(scene, reference, random);
}

std::size_t wrong_pixels(const AdmittedScene& scene, auto kernel) {
    return different_pixels(visible_regions(scene, kernel).picture, Reference(scene).picture());
}

}  // namespace

TEST_CASE("Regions and pictures are those of the rule, on random and degenerate scenes") {
    RandomScenes random(20261122);
    std::mt19937 samples(1);
    for (int i = 0; i < 1500; ++i) {
        CAPTURE(i);
        check_both(random.scene(), samples);
    }
}

TEST_CASE("Next to coincidences: filtered and exact are right, and double is not") {
    RandomScenes random(33);
    std::mt19937 samples(2);
    std::size_t wrong_in_double = 0;
    for (int i = 0; i < 400; ++i) {
        CAPTURE(i);
        const auto scene = moved_by_ulps(random.scene(), random);
        if (!scene) continue;
        check_both(*scene, samples);
        wrong_in_double += wrong_pixels(*scene, Double{});
    }
    CHECK(wrong_in_double > 0);
}

TEST_CASE("Every kind of contact, nearer and farther, against the rule") {
    std::mt19937 samples(3);
    for (const Contact& contact : contacts) {
        for (const double z : {-.5, 0., .5}) {
            CAPTURE(contact.name);
            CAPTURE(z);
            Corners other = contact.clip;
            for (auto& vertex : other) vertex.z = z + (vertex.x - vertex.y) / 64;
            check_both(SceneBuilder(area_16).polygon(square).polygon(other).polygon(contact.clip).build(), samples);
        }
    }
}

TEST_CASE("Cyclic overlap, a fan about a vertex, planes that meet in one line") {
    std::mt19937 samples(4);
    SUBCASE("four bars, each over the next") {
        check_both(SceneBuilder(area_16)
                       .polygon({{1, 2, .75}, {15, 2, .25}, {15, 5, .25}, {1, 5, .75}})
                       .polygon({{11, 1, .75}, {14, 1, .75}, {14, 15, .25}, {11, 15, .25}})
                       .polygon({{1, 11, .25}, {15, 11, .75}, {15, 14, .75}, {1, 14, .25}})
                       .polygon({{2, 1, .25}, {5, 1, .25}, {5, 15, .75}, {2, 15, .75}})
                       .build(),
                   samples);
    }
    SUBCASE("a fan") {
        const glm::dvec3 hub(7.5, 7.5, .5);
        const Corners rim{{0, 0, 0},   {7.5, -1, 0}, {16, 0, 0}, {17, 7.5, 0},
                          {16, 16, 0}, {7.5, 17, 0}, {0, 16, 0}, {-1, 7.5, 0}};
        SceneBuilder builder(area_16);
        for (std::size_t i = 0; i < rim.size(); ++i) builder.polygon({hub, rim[i], rim[(i + 1) % rim.size()]});
        check_both(builder.build(), samples);
    }
    SUBCASE("three that pierce each other in one line, and one through a vertex of theirs") {
        check_both(SceneBuilder(area_16)
                       .polygon({{0, 2, 0}, {16, 2, 1}, {16, 14, 1}, {0, 14, 0}})
                       .polygon({{2, 0, .875}, {14, 0, .125}, {14, 16, .125}, {2, 16, .875}})
                       .quad(1, 1, 15, 15, .5)
                       .polygon({{8, 2, .5}, {15, 9, -1}, {1, 9, 1}})
                       .build(),
                   samples);
    }
    SUBCASE("areas at any position") {
        for (const Area area : {Area{-100, 40, 1, 9}, {-8, -8, 13, 11}, {1 << 30, -(1 << 30), 5, 6}}) {
            const double x = area.x, y = area.y;
            check_both(SceneBuilder(area)
                           .quad(x - 1, y - 1, x + 4.5, y + 3, .25)
                           .polygon({{x, y, -1}, {x + 12, y + 2, 1}, {x + 3, y + 10, 0}})
                           .build(),
                       samples);
        }
    }
    SUBCASE("a quad that is planar only within the tolerance") {
        check_both(SceneBuilder(area_16)
                       .polygon({{1, 1, .25}, {15, 1, .5}, {15, 15, .5}, {1, 15, .25 + 0x1p-38}})
                       .polygon({{1, 1, .25}, {1, 15, .25}, {15, 15, .25 - 0x1p-38}, {15, 1, .25}})
                       .quad(4, 4, 12, 12, .375)
                       .build(),
                   samples);
    }
}

TEST_CASE("Thirty triangles that pierce each other") {
    RandomScenes random(7);
    std::mt19937 samples(5);
    SceneBuilder builder(area_16);
    for (int i = 0; i < 30; ++i) builder.polygon(random.triangle(area_16));
    check_both(builder.build(), samples);
}

namespace {

struct CountExact {
    int* exact;
    void operator()(FilterStage stage) const { *exact += stage == FilterStage::exact ? 1 : 0; }
};

}  // namespace

TEST_CASE_TEMPLATE("A constructed number is shown as the double nearest to it", K, Filtered, Exact) {
    // From x = -2^20, the edge y = 1 + 3x/4 of the nearer triangle meets two edges of the other one, which leave its
    // vertex (4, 2), at (36/11, 38/11) and (20/7, 22/7): the vectors (-8, 16)/11 and (-8, 8)/7 there span a triangle of
    // area 64/77/2.
    const double x = -1048576;
    const AdmittedScene scene = SceneBuilder({int(x), 0, 4, 4})
                                    .polygon({{x + 3, 4, 0}, {x + 4, 2, 0}, {x + 2, 4, 0}})
                                    .polygon({{x + 1, 4, .5}, {x + 4, 4, .5}, {x, 1, .5}})
                                    .build();
    CHECK(visible_areas<K>(scene).at(0) == 32. / 77);
}

TEST_CASE("The nearest double of a rational number, and the even one of two equally near ones") {
    CHECK(nearest_double(Rational(32) / Rational(77)) == 32. / 77);
    CHECK(nearest_double(Rational(1) + Rational(0x1p-53)) == 1);                // even, as 1 + 2^-52 is not
    CHECK(nearest_double(Rational(1) + Rational(3 * 0x1p-53)) == 1 + 0x1p-51);  // even, as 1 + 2^-52 is not
    CHECK(nearest_double(-Rational(0x1p-1074) * Rational(0.75)) == -0x1p-1074);
}

TEST_CASE("Filtered uses exact arithmetic only at coincidences") {
    const auto asked = [](const AdmittedScene& scene) {
        int exact = 0;
        visible_regions(scene, FilteredBy(CountExact{&exact}));
        return exact;
    };
    // Three outlines that cross, one over the other, in tenths, which doubles cannot represent.
    CHECK(asked(SceneBuilder(area_16)
                    .polygon({{1.1, 1.3, .11}, {14.7, 3.1, .17}, {5.7, 13.7, .13}})
                    .polygon({{14.9, 1.7, .73}, {2.3, 4.3, .79}, {9.7, 15.1, .87}})
                    .polygon({{2.9, 2.1, .41}, {9.1, 14.3, .47}, {15.3, 7.7, .31}})
                    .build()) == 0);
    // Those three, and one whose edge passes, up to rounding, through the point where edges of the first two cross.
    const auto crossing = [](const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& r, const glm::dvec3& s) {
        const double height = (s.x - r.x) * (p.y - r.y) - (s.y - r.y) * (p.x - r.x);
        const double t = height / ((s.y - r.y) * (q.x - p.x) - (s.x - r.x) * (q.y - p.y));
        return glm::dvec3(p.x + (q.x - p.x) * t, p.y + (q.y - p.y) * t, .9);
    };
    CHECK(
        asked(SceneBuilder(area_16)
                  .polygon({{1.1, 1.3, .11}, {14.7, 3.1, .17}, {5.7, 13.7, .13}})
                  .polygon({{14.9, 1.7, .73}, {2.3, 4.3, .79}, {9.7, 15.1, .87}})
                  .polygon(
                      {crossing({1.1, 1.3, 0}, {14.7, 3.1, 0}, {14.9, 1.7, 0}, {2.3, 4.3, 0}), {8, 9, .9}, {4, 9, .9}})
                  .build()) > 0);
}

TEST_CASE_TEMPLATE("Runs under kernels that round end, and report outlines that do not close", K, Float, Double,
                   Bits24) {
    RandomScenes random(34);
    int faults = 0;
    for (int i = 0; i < 300; ++i) {
        HearFaults::Reported reported;
        const AdmittedScene scene = random.scene();
        visible_regions(scene, K{}, HearFaults(reported));
        faults += reported.count;
    }
    CHECK(faults > 0);
}
