// Campaigns: the families and perturbations, the counts of a trial, and that results add up to the same whether the campaign runs
// whole, in shards, or is continued after a kill.

#include "stability/stability.h"

#include <doctest/doctest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "output.h"
#include "refused.h"
#include "run/floating_horizon_run.h"
#include "scene/failure.h"
#include "stability/journal.h"
#include "stability/shrink.h"
#include "stability/witness.h"
#include "support/curves.h"
#include "support/scenes.h"

using namespace vidno;
using namespace vidno::test;

namespace {

const Experiment& experiment_of(Experiment::Kind kind, std::string_view how) {
    return *std::find_if(experiments.begin(), experiments.end(),
                         [&](const auto& each) { return each.kind == kind && each.how == how; });
}

Tally tally_of(const Experiment& experiment, const std::vector<AdmittedScene>& series, const char* kernel,
               Method method) {
    return try_out(experiment, series, {*kernel_named(kernel)}, {method}).front();
}

std::vector<std::string> names_of_families() {
    std::vector<std::string> names;
    for (std::size_t n = 0; n < std::size(families); n += thinning) names.emplace_back(families[n].name);
    return names;
}

void run_all(Results& results) {
    for (const auto& block : results.blocks()) {
        if (!results.has(block)) results.add(block, run_block(results.campaign(), block));
    }
}

Results whole(const Campaign& campaign) {
    Results results(campaign);
    run_all(results);
    return results;
}

Picture picture_of(const AdmittedScene& scene, Method method, const char* kernel) {
    return run({method, *kernel_named(kernel), Edition::corrected, scene});
}

const Campaign small{7, 2, {"slivers", "vertices"}, {"float", "double"}, {"zbuffer"}};

/// A file that is removed with the test.
struct TemporaryFile {
    std::string name;

    explicit TemporaryFile(const std::string& text)
        : name((std::filesystem::temp_directory_path() / ("vidno-journal-" + std::to_string(getpid()))).string()) {
        std::ofstream(name, std::ios::binary) << text;
    }
    ~TemporaryFile() { std::filesystem::remove(name); }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
};

}  // namespace

TEST_CASE("Moved by an ulp: each coordinate is the double before, itself or the one after, and z stays in range") {
    const AdmittedScene scene = SceneBuilder({0, 0, 8, 8}).polygon({{-1, 4, 1}, {8, 0, -.5}, {1, 8, 0}}).build();
    RandomPolygons random(std::mt19937(5));
    int moved = 0;
    for (int i = 0; i < 100; ++i) {
        const AdmittedScene other = moved_by_ulps(scene, 1, random);
        for (std::size_t v = 0; v < 3; ++v) {
            for (int axis = 0; axis < 3; ++axis) {
                const double was = scene->polygons[0].vertices[v][axis];
                const double is = other->polygons[0].vertices[v][axis];
                const double next = std::nextafter(was, is);
                CHECK((is == was || is == next));
                CHECK((axis < 2 || std::abs(is) <= 1));
                moved += is == was ? 0 : 1;
            }
        }
    }
    CHECK(moved > 100 * 9 / 2);
}

TEST_CASE("A quad that is moved far is no longer planar and becomes two triangles of its colour") {
    const AdmittedScene scene = SceneBuilder({0, 0, 8, 8}).quad(1, 1, 7, 7, .5).build();
    RandomPolygons random(std::mt19937(5));
    const AdmittedScene other = moved_by_ulps(scene, std::int64_t{1} << 32, random);
    REQUIRE(other->polygons.size() == 2);
    for (const auto& triangle : other->polygons) {
        CHECK(triangle.vertices.size() == 3);
        CHECK(triangle.color == scene->polygons[0].color);
    }
}

TEST_CASE("A few thousand scenes, random and degenerate: no wrong pixel under filtered, and some under double") {
    int wrong_in_double = 0;
    for (const auto& family : families) {
        RandomPolygons random(std::mt19937(2));
        for (int i = 0; i < 250; i += thinning) {
            CAPTURE(family.name);
            CAPTURE(i);
            const AdmittedScene scene = moved_by_ulps(random_scene(family, random), std::int64_t{1} << i % 10, random);
            const Picture right = picture_of(scene, Method::zbuffer, "exact");
            for (const Method method : {Method::warnock, Method::zbuffer}) {
                CHECK(different_pixels(picture_of(scene, method, "filtered"), right) == 0);
                wrong_in_double += different_pixels(picture_of(scene, method, "double"), right) > 0 ? 1 : 0;
            }
        }
    }
    CHECK(wrong_in_double > 100 / thinning);
}

TEST_CASE("Decisions and pixels: double is wrong next to coincidences, in degenerate families" *
          doctest::skip(sanitized)) {
    const Results results = whole({1, 6, {"coplanar", "edges", "vertices"}, {"double"}, {"warnock", "zbuffer"}});
    for (const auto& family : results.campaign().families) {
        CAPTURE(family);
        for (const Tally& tally : results.sum(family, experiment_of(Experiment::Kind::moved, "1"))) {
            CHECK(tally.runs == 6);
            CHECK(tally.pixels == 6 * 64);
            CHECK(tally.wrong_decisions > 0);
        }
    }
}

TEST_CASE("Kernels that are always right are right on every scene, grid on the snapped one") {
    Results results({3, 1, names_of_families(), {"filtered", "grid:8"}, {"warnock", "zbuffer"}});
    for (const auto& block : results.blocks()) {
        if (block.experiment->kind == Experiment::Kind::grown) continue;
        CAPTURE(block.number);
        const Tallies tallies = run_block(results.campaign(), block);
        for (const auto& tally : tallies) CHECK(tally.all_right());
        results.add(block, tallies);
    }
    CHECK(results.as_promised());
}

TEST_CASE("A wrong result breaks the promise of an always right kernel only") {
    for (const std::string kernel : {"double", "filtered"}) {
        Results results({1, 1, {"edges"}, {kernel}, {"zbuffer"}});
        Tally tally;
        tally.wrong_pixels = 1;
        results.add(results.blocks().front(), {tally});
        CHECK(results.as_promised() == (kernel == "double"));
    }
}

TEST_CASE("Flicker: a pixel that changes though it should not") {
    // Both left sides lie right of the centres of the first column, which should stay white. As floats, which have steps of
    // 2^-24 there, the first is 1/2 and holds them, the second is 1/2 + 2^-24 and does not.
    const auto scene_from = [](double left) { return SceneBuilder({0, 0, 8, 8}).quad(left, 0, 8, 8, 0).build(); };
    const std::vector<AdmittedScene> series{scene_from(.5 + 0x1p-26), scene_from(.5 + 3 * 0x1p-26)};
    for (const Method method : {Method::warnock, Method::zbuffer}) {
        const auto& swept = experiment_of(Experiment::Kind::swept, "by ulps");
        const Tally in_float = tally_of(swept, series, "float", method);
        CHECK(in_float.runs == 2);
        CHECK(in_float.wrong_runs == 1);
        CHECK(in_float.wrong_pixels == 8);
        CHECK(in_float.steady == 64);
        CHECK(in_float.flickers == 8);
        CHECK(tally_of(swept, series, "double", method).all_right());
    }
}

TEST_CASE("No flicker: a pixel that changes because it should") {
    // The left side passes over the centres of the first column.
    const auto scene_from = [](double left) { return SceneBuilder({0, 0, 8, 8}).quad(left, 0, 8, 8, 0).build(); };
    const Tally tally = tally_of(experiment_of(Experiment::Kind::swept, "by a pixel"),
                                 {scene_from(.25), scene_from(.75)}, "double", Method::zbuffer);
    CHECK(tally.steady == 64 - 8);
    CHECK(tally.flickers == 0);
    CHECK(tally.wrong_pixels == 0);
}

TEST_CASE("Growth of windows: beside a triangle, the windows in its box split down to pixels") {
    // A triangle on one side of the diagonal, in front of a backdrop. A window of side 2^m on the diagonal counts itself, two such windows
    // of half the side, one in the triangle, which covers it, and one beside the triangle: still in its box, so it splits down to pixels.
    std::array<std::uint64_t, 6> beside{1}, on_diagonal{1};
    for (std::size_t m = 1; m < beside.size(); ++m) {
        beside[m] = 1 + 4 * beside[m - 1];
        on_diagonal[m] = 1 + 2 * on_diagonal[m - 1] + 1 + beside[m - 1];
    }
    for (std::size_t m = 3; m < beside.size(); ++m) {
        const int side = 1 << m;
        const double far = side;
        const AdmittedScene scene = SceneBuilder({0, 0, side, side})
                                        .quad(0, 0, far, far, 0)
                                        .polygon({{0, 0, .5}, {far, 0, .5}, {far, far, .5}})
                                        .build();
        const auto& grown = experiment_of(Experiment::Kind::grown, std::to_string(side));
        CHECK(tally_of(grown, {scene}, "double", Method::warnock).windows == on_diagonal[m]);
        CHECK_MESSAGE(tally_of(grown, {scene}, "double", Method::zbuffer).runs == 0, "there are none to count");
    }
}

TEST_CASE("Results in shards, in any order, are those of a single run, byte for byte") {
    const std::string expected = whole(small).text();
    Results merged(small);
    for (const std::size_t shard : {2, 0, 1}) {
        Results part(small);
        for (std::size_t i = shard; i < part.blocks().size(); i += 3) {
            part.add(part.blocks()[i], run_block(small, part.blocks()[i]));
        }
        merged.add(part.text(), "part");
    }
    CHECK(merged.missing() == 0);
    CHECK(merged.text() == expected);
}

TEST_CASE("A killed run is continued: its partial block runs again") {
    const std::string expected = whole(small).text();
    for (const std::size_t cut : {expected.size() - 1, expected.size() / 2, expected.find('\n') + 1}) {
        Results resumed(small);
        resumed.add(expected.substr(0, cut), "cut");
        CHECK(resumed.missing() > 0);
        run_all(resumed);
        CHECK(resumed.text() == expected);
    }
}

TEST_CASE("A file written before campaigns had all methods is continued byte for byte") {
    // Written by an earlier program: vidno stability --seed 5 --count 1 --family triangles steep --kernel double. The decisions of the
    // Z-buffer were counted again later, since it now sorts its active edges with fewer comparisons.
    const std::string file = VIDNO_ROOT "/tests/stability/campaign-of-before.jsonl";
    const std::string expected = read_file(file);
    const TemporaryFile half(expected.substr(0, expected.size() / 2));
    Results resumed = Results::merged({half.name});
    CHECK(resumed.missing() > 20);
    run_all(resumed);
    CHECK(resumed.text() == expected);
}

TEST_CASE("Results of another campaign, and files of another kind, are refused") {
    const Results results = whole({1, 1, {"edges"}, {"double"}, {"zbuffer"}});
    const std::string header = results.header();
    const std::string line = results.line(results.blocks().front());
    const auto changed = [](std::string text, const std::string& from, const std::string& to) {
        return text.replace(text.find(from), from.size(), to);
    };
    const auto refused = [&](const std::string& text) {
        Results again(results.campaign());
        CHECK_THROWS_AS(again.add(text, "file"), Refused);
    };
    refused("");
    refused(changed(header, "\"seed\":1", "\"seed\":2") + line);
    refused(header + "{}\n");
    refused(header + "nothing\n");
    refused(header + changed(line, "\"block\":0", "\"block\":1000"));
    refused(header + changed(line, "\"runs\":1", "\"runs\":-1"));
    refused(header + changed(line, "moved", "swept"));
    refused(header + line + changed(line, "\"runs\":1", "\"runs\":2"));
    Results again(results.campaign());
    again.add(header + line + line, "file");
    CHECK_MESSAGE(again.missing() + 1 == again.blocks().size(), "told twice alike, a block counts once");
}

TEST_CASE("A campaign with an unknown name is refused") {
    CHECK_THROWS_WITH_AS(Results({1, 1, {"cubes"}, {"double"}, {"zbuffer"}}), "there is no family cubes", Refused);
    CHECK_THROWS_WITH_AS(Results({1, 1, {"edges"}, {"half"}, {"zbuffer"}}), "there is no kernel half", Refused);
    CHECK_THROWS_WITH_AS(Results({1, 1, {"edges"}, {"double"}, {"painter"}}), "there is no method painter", Refused);
}

TEST_CASE("Journal: continues after the last whole line that a killed run left") {
    for (const std::string left : {"", "fir", "first\n", "first\nsecond\n", "first\nsecond\nthi"}) {
        const TemporaryFile file(left);
        const std::string whole_lines = left.find('\n') == left.npos ? "first\n" : left.substr(0, left.rfind('\n') + 1);
        {
            Journal journal(file.name, "first\n");
            CHECK(journal.text() == whole_lines);
            journal.append("another\n");
        }
        CHECK(read_file(file.name) == whole_lines + "another\n");
    }
}

TEST_CASE("Journal: a file with another first line is refused and does not change") {
    for (const std::string other : {"second\n", "no line", "first, but longer"}) {
        const TemporaryFile file(other);
        CHECK_THROWS_AS(Journal(file.name, "first\n"), Refused);
        CHECK(read_file(file.name) == other);
    }
}

TEST_CASE("Journal: two runs do not write one file") {
    const TemporaryFile file("");
    const Journal journal(file.name, "first\n");
    CHECK_THROWS_AS(Journal(file.name, "first\n"), Refused);
}

TEST_CASE("Touching: a vertex of the second triangle lies on an edge of the first, exactly") {
    // Corners are whole numbers and the place on the edge an eighth: the cross product is one of whole numbers, without rounding.
    const Family& family = family_of("touching");
    RandomPolygons random(std::mt19937(4));
    for (int i = 0; i < 200; ++i) {
        const auto group = family.group(random, {3, -5, 8, 8});
        REQUIRE(group.size() == 2);
        const glm::dvec3 a = group[0][0], b = group[0][1], p = group[1][0];
        CHECK((b.x - a.x) * (p.y - a.y) == (b.y - a.y) * (p.x - a.x));
        CHECK(std::min(a.x, b.x) <= p.x);
        CHECK(p.x <= std::max(a.x, b.x));
    }
}

TEST_CASE("All methods: filtered and exact are never wrong, on families of polygons and of curves" *
          doctest::skip(sanitized)) {
    std::vector<std::string> methods(method_names.begin(), method_names.end());
    methods.emplace_back("floating-horizon");
    constexpr std::uint64_t trials = 4;
    const Results results = whole({5,
                                   trials,
                                   {"touching", "shared-edges", "octants", "horizon-ties", "crossing-curves"},
                                   {"double", "filtered", "exact"},
                                   methods});
    CHECK(results.as_promised());
    const Tallies of_curves = results.sum("horizon-ties", experiment_of(Experiment::Kind::moved, "0"));
    const Tallies of_polygons = results.sum("touching", experiment_of(Experiment::Kind::moved, "0"));
    REQUIRE(of_curves.size() == 3 * methods.size());
    for (std::size_t i = 0; i < of_curves.size(); ++i) {
        const bool is_horizon = methods[i % methods.size()] == "floating-horizon";
        const bool takes_bodies_alone = methods[i % methods.size()] == "warnock-bodies";
        CHECK(of_curves[i].runs == (is_horizon ? trials : 0));
        if (!takes_bodies_alone) CHECK(of_polygons[i].runs == (is_horizon ? 0 : trials));
    }
}

TEST_CASE("Shrinking keeps only the curves, samples and binary places that a property needs") {
    // The property: a curve is above 2 over column 3. One curve of two samples with whole heights, 3 and 0 or 1, has it.
    const AdmittedCurves scene = CurveSceneBuilder({0, 0, 9, 9})
                                     .curve({{0, 1.25}, {4, 1}, {8, 1}})
                                     .curve({{0, 1}, {3, 2.625}, {5, 0.5}, {8, 1.75}})
                                     .curve({{1, 0}, {8, 1}})
                                     .build();
    const auto is_above = [](const AdmittedCurves& curves) {
        for (const auto& [samples] : curves->curves) {
            for (const auto& sample : samples) {
                if (sample.x == 3 && sample.y > 2) return true;
            }
        }
        return false;
    };
    const AdmittedCurves smallest = shrunk(scene, is_above);
    REQUIRE(smallest->curves.size() == 1);
    REQUIRE(smallest->curves[0].samples.size() == 2);
    for (const auto& sample : smallest->curves[0].samples) CHECK(binary_places(sample.y) == 0);
}

TEST_CASE("A witness is a failure: its scene is wrong at the place that it shows, and right under filtered") {
    const Campaign campaign{1, 40, {"horizon-ties"}, {"float"}, {"floating-horizon"}};
    const auto text = witness(campaign, family_of("horizon-ties"), "floating-horizon", "float", [] {});
    REQUIRE(text);
    const Failure failure = read_failure(*text, "witness.json");
    const auto& curves = std::get<Surface>(*failure.scene).curves;
    const auto drawn = [&](const NamedKernel& kernel) {
        return columns_drawn(run(FloatingHorizonRequest{kernel, Edition::corrected, curves}), curves);
    };
    REQUIRE(failure.shows.column);
    const auto curve = std::size_t(failure.shows.column->first);
    const auto column = std::size_t(failure.shows.column->second - curves->curves[curve].samples.front().x);
    CHECK(drawn(failure.fails.kernel)[curve][column] != drawn(failure.holds.kernel)[curve][column]);
}
