// The two Z-buffer procedures on cases computed by hand, over all kernels.

#include <doctest/doctest.h>

#include "support/scenes.h"
#include "support/stage.h"

using namespace vidno;
using namespace vidno::test;

namespace {

struct AelRow {
    int row;
    std::vector<double> x, z;  // of the entries, from the left
    bool operator==(const AelRow&) const = default;
};

/// Notes the contents of AEL when the pairs are shown.
struct WatchAel : NoTrace {
    std::vector<AelRow>* rows;
    explicit WatchAel(std::vector<AelRow>& to) : rows(&to) {}
    void scanline(Line, const auto&, int row) { rows->push_back({row, {}, {}}); }
    void call(Line at, Procedure) {
        if (at == Line::Z14) rows->back() = {rows->back().row, {}, {}};
    }
    void line(Line, int, const auto& from, const auto& to) {
        rows->back().x = {as_double(from.x), as_double(to.x)};
        rows->back().z = {as_double(from.z), as_double(to.z)};
    }
};

/// Checks that AEL always holds two entries on a row of a convex polygon.
struct ExpectPairs : NoTrace {
    int* others;
    explicit ExpectPairs(int& count) : others(&count) {}
    void ael_sort(Line, const auto& entries, const auto&) { *others += entries.size() == 2 ? 0 : 1; }
};

}  // namespace

TEST_CASE_TEMPLATE("ShowLine: pixel centres between the ends, the depth stepped to the first", K, VIDNO_KERNELS) {
    // From (1.25, 0) to (4.75, 7/8): dz = 1/4. The centres are 1.5, 2.5, 3.5, 4.5, the depths 1/16, 5/16, 9/16, 13/16.
    Stage<K> stage(
        SceneBuilder({0, 0, 8, 4}).polygon({{1.25, 2, 0}, {4.75, 2, .875}, {4.75, 3, .875}, {1.25, 3, 0}}).build());
    stage.run.depth_buffer.clear(stage.scene->area, stage.run.kernel.farthest());
    const auto& kernel = stage.run.kernel;
    Corrected::show_line(stage.run, 2, kernel.vertex({1.25, 2.5, 0}), kernel.vertex({4.75, 2.5, .875}),
                         stage.polygon());
    for (int x = 0; x < 8; ++x) {
        CAPTURE(x);
        const bool painted = 1 <= x && x <= 4;
        CHECK((stage.picture.at(x, 2) == color_of(0)) == painted);
        const typename K::Depth stored = stage.run.depth_buffer.at(x, 2);
        if (painted) {
            CHECK(as_double(kernel.finite(stored)) == (4 * x - 3) / 16.0);
        } else {
            CHECK_FALSE(kernel.nearer(stored, kernel.farthest(), Pixel{x, 2}));
        }
    }
}

TEST_CASE_TEMPLATE("ShowLine: both ends on centres are painted, a span of one point too", K, VIDNO_KERNELS) {
    Stage<K> stage(SceneBuilder({0, 0, 8, 4}).quad(0, 0, 8, 4, 0).build());
    stage.run.depth_buffer.clear(stage.scene->area, stage.run.kernel.farthest());
    const auto& kernel = stage.run.kernel;
    const auto show = [&](int row, double x1, double x2) {
        Corrected::show_line(stage.run, row, kernel.vertex({x1, row + .5, 0}), kernel.vertex({x2, row + .5, 0}),
                             stage.polygon());
    };
    show(0, 1.5, 3.5);
    show(1, 2.5, 2.5);
    show(2, 2.75, 3.25);
    const auto painted = [&](int row) {
        std::vector<int> columns;
        for (int x = 0; x < 8; ++x) {
            if (stage.picture.at(x, row) != white) columns.push_back(x);
        }
        return columns;
    };
    CHECK(painted(0) == std::vector{1, 2, 3});
    CHECK(painted(1) == std::vector{2});
    CHECK_MESSAGE(painted(2).empty(), "no centre lies between the ends");
}

TEST_CASE_TEMPLATE("ShowLine: a line off the area paints nothing, one across it starts at its side", K, VIDNO_KERNELS) {
    Stage<K> stage(SceneBuilder({10, 0, 4, 1}).polygon({{2.5, 0, 0}, {18.5, 0, 1}, {18.5, 1, 1}, {2.5, 1, 0}}).build());
    stage.run.depth_buffer.clear(stage.scene->area, stage.run.kernel.farthest());
    const auto& kernel = stage.run.kernel;
    const auto show = [&](double x1, double z1, double x2, double z2) {
        Corrected::show_line(stage.run, 0, kernel.vertex({x1, .5, z1}), kernel.vertex({x2, .5, z2}), stage.polygon());
    };
    show(0, 0, 9, 0);
    show(14, 0, 20, 0);
    CHECK(stage.picture == Picture(stage.scene->area, white));
    show(2.5, 0, 18.5, 1);  // dz = 1/16; at 10.5 the depth is 8/16
    CHECK(stage.picture == Picture(stage.scene->area, color_of(0)));
    CHECK(as_double(kernel.finite(stage.run.depth_buffer.at(10, 0))) == .5);
}

TEST_CASE_TEMPLATE("ZBuffer: the active edges of a diamond, row by row", K, VIDNO_KERNELS) {
    // (4, .5), (8, 4.5), (4, 8.5), (0, 4.5): the vertices lie on centres of rows 0, 4 and 8; z = x / 8. On row j the
    // edges are at 4 -+ j down to row 4, then at j - 4 and 12 - j; on row 8 they meet again: the outline is closed.
    const AdmittedScene scene =
        SceneBuilder({0, 0, 9, 9}).polygon({{4, .5, .5}, {8, 4.5, 1}, {4, 8.5, .5}, {0, 4.5, 0}}).build();
    std::vector<AelRow> rows;
    render(Method::zbuffer, scene, K{}, WatchAel(rows));
    REQUIRE(rows.size() == 9);
    for (int j = 0; j <= 8; ++j) {
        const double left = j <= 4 ? 4 - j : j - 4;
        const double right = j <= 4 ? 4 + j : 12 - j;
        CHECK(rows[std::size_t(j)] == AelRow{j, {left, right}, {left / 8, right / 8}});
    }
}

TEST_CASE_TEMPLATE("ZBuffer: a side vertex on the last row's centre hands over, it does not double", K, VIDNO_KERNELS) {
    // The last row is 5 (centre 5.5), the lowest point 6: the vertex (9.5, 5.5) lies on that row and is not the end.
    const AdmittedScene scene =
        SceneBuilder(area_16).polygon({{10, 2, 0}, {14, 2.5, 0}, {13.5, 6, 0}, {9.5, 5.5, 0}}).build();
    int others = 0;
    render(Method::zbuffer, scene, K{}, ExpectPairs(others));
    CHECK(others == 0);
}

TEST_CASE_TEMPLATE("ZBuffer: the closed outline is painted", K, VIDNO_KERNELS) {
    // Corners on the centres (1.5, 1.5) and (3.5, 3.5): three by three pixels.
    const Picture picture =
        render(Method::zbuffer, SceneBuilder({0, 0, 5, 5}).quad(1.5, 1.5, 3.5, 3.5, 0).build(), K{});
    for (int y = 0; y < 5; ++y) {
        for (int x = 0; x < 5; ++x) {
            const bool inside = 1 <= x && x <= 3 && 1 <= y && y <= 3;
            CHECK(picture.at(x, y) == (inside ? color_of(0) : white));
        }
    }
}

TEST_CASE_TEMPLATE("ZBuffer: depths -1 and 1 are visible, and the first of equal depths wins", K, VIDNO_KERNELS) {
    const AdmittedScene scene =
        SceneBuilder({0, 0, 3, 1}).quad(0, 0, 3, 1, -1).quad(1, 0, 3, 1, 1).quad(2, 0, 3, 1, 1).build();
    const Picture picture = render(Method::zbuffer, scene, K{});
    CHECK(picture.at(0, 0) == color_of(0));
    CHECK(picture.at(1, 0) == color_of(1));
    CHECK(picture.at(2, 0) == color_of(1));
}

TEST_CASE_TEMPLATE("ZBuffer: an edge-on polygon shows nothing", K, VIDNO_KERNELS) {
    const AdmittedScene scene = SceneBuilder(area_16).polygon({{1, 1, 0}, {9, 9, 0}, {5, 5, 1}}).build();
    CHECK(scene->polygons[0].edge_on);
    CHECK(render(Method::zbuffer, scene, K{}) == Picture(area_16, white));
}

TEST_CASE("WholeLines: the picture is that of a run with a visitor, which follows each line") {
    struct Visitor : NoTrace {};
    static_assert(ComparesLines<Filtered> && ComparesLines<Grid8> && !ComparesLines<Double>);
    RandomScenes random(7);
    for (int i = 0; i < 200; ++i) {
        CAPTURE(i);
        const AdmittedScene scene = random.scene();
        CHECK(render(Method::zbuffer, scene, Filtered{}) == render(Method::zbuffer, scene, Filtered{}, Visitor{}));
    }
}
