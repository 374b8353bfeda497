// Campaigns: the families and perturbations, the counts of a trial, and that results add up to the same whether the
// campaign runs whole, in shards, or is continued after a kill.

#include "stability/results.h"

#include <doctest/doctest.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstddef>
#include <map>

#include "output.h"
#include "refused.h"
#include "run/floating_horizon_run.h"
#include "scene/failure.h"
#include "stability/journal.h"
#include "stability/shrink.h"
#include "stability/witness.h"
#include "support/curves.h"
#include "support/scenes.h"
#include "support/workplace.h"

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

std::vector<Block> blocks_of(const Results& results) {
    std::vector<Block> all;
    for (std::uint64_t number = 0; number < results.blocks().size(); ++number) {
        const Block block = results.blocks().at(number);
        if (block.first < block.end) all.push_back(block);
    }
    return all;
}

Results whole(const Campaign& campaign) {
    Results results(campaign);
    for (const Block& block : blocks_of(results)) results.add(block, run_block(campaign, block));
    return results;
}

/// The text of a run's file: a line for each of these blocks of a campaign, those that the file does not have yet.
std::string text_of_run(const Campaign& campaign, const std::vector<Block>& blocks, const std::string& begun = "") {
    std::string text = begun.empty() ? header_of(campaign) : begun;
    for (const Block& block : blocks) text += line_of(campaign, block, run_block(campaign, block));
    return text;
}

std::string text_of_all(const Campaign& campaign) { return text_of_run(campaign, blocks_of(Results(campaign))); }

/// Continues a file as the program does.
void continue_run(const std::string& file) {
    Results results(campaign_in(file));
    Journal journal(file, header_of(results.campaign()));
    results.add_file(file);
    for (const Block& block : blocks_of(results)) {
        if (!results.has(block))
            journal.append(line_of(results.campaign(), block, run_block(results.campaign(), block)));
    }
}

Picture picture_of(const AdmittedScene& scene, Method method, const char* kernel) {
    return run({method, *kernel_named(kernel), Edition::corrected, scene});
}

const Campaign small{"1.0.0", 7, 2, {"slivers", "vertices"}, {"float", "double"}, {"zbuffer"}};

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
    const Results results =
        whole({"1.0.0", 1, 6, {"coplanar", "edges", "vertices"}, {"double"}, {"warnock", "zbuffer"}});
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
    Results results({"1.0.0", 3, 1, names_of_families(), {"filtered", "grid:8"}, {"warnock", "zbuffer"}});
    for (const Block& block : blocks_of(results)) {
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
        Results results({"1.0.0", 1, 1, {"edges"}, {kernel}, {"zbuffer"}});
        Tally tally;
        tally.wrong_pixels = 1;
        results.add(results.blocks().at(0), {tally});
        CHECK(results.as_promised() == (kernel == "double"));
    }
}

TEST_CASE("Flicker: a pixel that changes though it should not") {
    // Both left sides lie right of the centres of the first column, which should stay white. As floats, which have
    // steps of 2^-24 there, the first is 1/2 and holds them, the second is 1/2 + 2^-24 and does not.
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
    // A triangle on one side of the diagonal, in front of a backdrop. A window of side 2^m on the diagonal counts
    // itself, two such windows of half the side, one in the triangle, which covers it, and one beside the triangle:
    // still in its box, so it splits down to pixels.
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

TEST_CASE("Results in shards, in any order and some twice, merge to those of a single run, byte for byte") {
    const Workplace work;
    const std::vector<Block> all = blocks_of(Results(small));
    std::vector<std::string> files;
    for (const std::size_t shard : {2, 0, 1}) {
        std::vector<Block> blocks;
        for (std::size_t i = shard; i < all.size(); i += 3) blocks.push_back(all[i]);
        if (shard == 0) std::reverse(blocks.begin(), blocks.end());  // a file that is out of order
        if (shard == 1) blocks.push_back(all[3]);                    // a block of another shard
        files.push_back(work.write("part" + std::to_string(shard), text_of_run(small, blocks)));
    }
    OutputFile output(work.file("merged"));
    CHECK(merged(files, &output).missing() == 0);
    output.commit();
    CHECK(work.read("merged") == text_of_all(small));
}

TEST_CASE("A killed run is continued: its partial block runs again") {
    const Workplace work;
    const std::string expected = text_of_all(small);
    for (const std::size_t cut : {expected.size() - 1, expected.size() / 2, expected.find('\n') + 1}) {
        const std::string file = work.write("cut", expected.substr(0, cut));
        continue_run(file);
        CHECK(work.read("cut") == expected);
    }
}

TEST_CASE("A campaign that is extended has the bytes of one that had as many trials from the start" *
          doctest::skip(sanitized)) {
    const Workplace work;
    // Rounds have 128 trials that move coordinates: the last is whole, or grows, and `swept` has a trial in every other
    // one.
    for (const auto& counts : {std::pair(128, 300), std::pair(2, 3), std::pair(130, 257)}) {
        const auto before = std::uint64_t(counts.first), after = std::uint64_t(counts.second);
        CAPTURE(after);
        Campaign campaign{"1.0.0", 7, before, {"horizon-ties"}, {"double"}, {"floating-horizon"}};
        const std::string file = work.write("extended", text_of_all(campaign));
        extend(file, after);
        continue_run(file);
        campaign.count = after;
        CHECK(work.read("extended") == text_of_all(campaign));
        CHECK_THROWS_AS(extend(file, after), Refused);
    }
}

TEST_CASE("Each trial of a campaign is in one block, before and after files named the version") {
    for (const std::string version : {"", "1.0.0"}) {
        for (const std::uint64_t count : {1, 2, 64, 128, 129, 255, 256, 257, 1000}) {
            const Results results({version, 1, count, {"edges", "slivers"}, {"double"}, {"zbuffer"}});
            CAPTURE(version);
            CAPTURE(count);
            std::map<std::pair<const Family*, const Experiment*>, std::uint64_t> trials;
            for (const Block& block : blocks_of(results)) {
                auto& next = trials[{block.family, block.experiment}];
                CHECK(block.first == next);
                next = block.end;
            }
            CHECK(trials.size() == 2 * experiments.size());
            CHECK(results.missing() == blocks_of(results).size());
            for (const auto& [of, end] : trials) CHECK(end == (count + of.second->price - 1) / of.second->price);
        }
    }
}

TEST_CASE("A file written before campaigns had all methods is continued byte for byte") {
    // Written by an earlier program: vidno stability --seed 5 --count 1 --family triangles steep --kernel double. The
    // decisions of the Z-buffer were counted again later, since it now sorts its active edges with fewer comparisons.
    const Workplace work;
    const std::string expected = read_file(VIDNO_ROOT "/tests/stability/campaign-of-before.jsonl");
    const std::string file = work.write("half", expected.substr(0, expected.size() / 2));
    CHECK(merged({file}, nullptr).missing() > 20);
    continue_run(file);
    CHECK(work.read("half") == expected);
}

TEST_CASE("Results of another campaign, and files of another kind, are refused") {
    const Campaign campaign{"1.0.0", 1, 1, {"edges"}, {"double"}, {"zbuffer"}};
    const std::string header = header_of(campaign);
    const Block first = Blocks(campaign).at(0);
    const std::string line = line_of(campaign, first, run_block(campaign, first));
    const auto changed = [](std::string text, const std::string& from, const std::string& to) {
        return text.replace(text.find(from), from.size(), to);
    };
    const Workplace work;
    const std::string right = work.write("right", header + line);
    const auto refusal = [&](const std::string& text) -> std::string {
        const std::string file = work.write("file", text);
        try {
            merged({right, file}, nullptr);
        } catch (const Refused& refused) {
            return std::string(refused.what()).substr(file.size());
        }
        return "none";
    };
    const std::string no_line = ": not a line of vidno-stability/1, or a block that came out otherwise before";
    CHECK(refusal("") == ":1" + no_line);
    CHECK(refusal(changed(header, "\"seed\":1", "\"seed\":2") + line) == ": belongs to another campaign");
    CHECK(refusal(changed(header, "1.0.0", "1.0.1") + line) ==
          ": was made by version 1.0.1, not 1.0.0; results of different versions are not added");
    CHECK(refusal(header + "{}\n") == ":2" + no_line);
    CHECK(refusal(header + "nothing\n") == ":2" + no_line);
    CHECK(refusal(header + changed(line, "\"block\":0", "\"block\":1000")) == ":2" + no_line);
    CHECK(refusal(header + changed(line, "\"runs\":1", "\"runs\":-1")) == ":2" + no_line);
    CHECK(refusal(header + changed(line, "moved", "swept")) == ":2" + no_line);
    CHECK(refusal(header + changed(line, "\"runs\":1", "\"runs\":2")) == ":2" + no_line);
    CHECK(refusal(header + line + line) == "none");
}

TEST_CASE("A block keeps the first failing trials, and each of them fails again alone") {
    const Campaign campaign{"1.0.0", 1, 100, {"edges"}, {"float"}, {"zbuffer"}};
    const Family& family = family_of("edges");
    const Experiment& moved = experiment_of("moved-1");
    std::vector<std::uint64_t> failing;
    for (std::uint64_t trial = 0; trial < campaign.count; ++trial) {
        const auto scenes = std::get<std::vector<AdmittedScene>>(scenes_of(campaign.seed, family, moved, trial));
        const Picture right = picture_of(scenes.front(), Method::zbuffer, "exact");
        if (different_pixels(picture_of(scenes.front(), Method::zbuffer, "float"), right) > 0) failing.push_back(trial);
    }
    REQUIRE(failing.size() > most_failing);
    failing.resize(most_failing);
    const Blocks blocks(campaign);
    for (std::uint64_t number = 0; number < blocks.size(); ++number) {
        if (blocks.at(number).experiment == &moved)
            CHECK(run_block(campaign, blocks.at(number)).front().failing == failing);
    }
}

TEST_CASE("A campaign with an unknown name is refused") {
    CHECK_THROWS_WITH_AS(Results({"1.0.0", 1, 1, {"cubes"}, {"double"}, {"zbuffer"}}), "there is no family cubes",
                         Refused);
    CHECK_THROWS_WITH_AS(Results({"1.0.0", 1, 1, {"edges"}, {"half"}, {"zbuffer"}}), "there is no kernel half",
                         Refused);
    CHECK_THROWS_WITH_AS(Results({"1.0.0", 1, 1, {"edges"}, {"double"}, {"painter"}}), "there is no method painter",
                         Refused);
}

TEST_CASE("Journal: continues after the last whole line that a killed run left") {
    const Workplace work;
    for (const std::string left : {"", "fir", "first\n", "first\nsecond\n", "first\nsecond\nthi"}) {
        const std::string file = work.write("journal", left);
        const std::string whole_lines = left.find('\n') == left.npos ? "first\n" : left.substr(0, left.rfind('\n') + 1);
        Journal(file, "first\n").append("another\n");
        CHECK(work.read("journal") == whole_lines + "another\n");
    }
}

TEST_CASE("Journal: a partial line that is longer than what is read at a time is dropped") {
    const Workplace work;
    const std::string file = work.write("journal", "first\nsecond\n" + std::string(200'000, 'x'));
    Journal(file, "first\n").append("third\n");
    CHECK(work.read("journal") == "first\nsecond\nthird\n");
}

TEST_CASE("Journal: a file with another first line is refused and does not change") {
    const Workplace work;
    for (const std::string other : {"second\n", "no line", "first, but longer"}) {
        const std::string file = work.write("journal", other);
        CHECK_THROWS_AS(Journal(file, "first\n"), Refused);
        CHECK(work.read("journal") == other);
    }
}

TEST_CASE("Journal: two runs do not write one file") {
    const Workplace work;
    const Journal journal(work.file("journal"), "first\n");
    CHECK_THROWS_AS(Journal(work.file("journal"), "first\n"), Refused);
}

TEST_CASE("Journal: a file system without locks is refused for what it is") {
    const Workplace work;
    const std::string file = work.file("journal");
    const pid_t child = fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        // From here on, the system answers each request for a lock as a file system without locks does.
        std::array<sock_filter, 4> rules{{BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
                                          BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_flock, 0, 1),
                                          BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | ENOLCK),
                                          BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW)}};
        const sock_fprog all{rules.size(), rules.data()};
        if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 || prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &all) != 0)
            _exit(3);
        try {
            const Journal journal(file, "first\n");
        } catch (const Refused& refused) {
            const std::string_view said = refused.what();
            _exit(said.starts_with(file + ": cannot be locked (No locks available): put the results on a file system")
                      ? 0
                      : 1);
        }
        _exit(2);
    }
    int status = 0;
    REQUIRE(waitpid(child, &status, 0) == child);
    CHECK_MESSAGE(status == 0, "status of the child");
}

TEST_CASE("Touching: a vertex of the second triangle lies on an edge of the first, exactly") {
    // Corners are whole numbers and the place on the edge an eighth: the cross product is one of whole numbers, without
    // rounding.
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
    const Results results = whole({"1.0.0",
                                   5,
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
    // The property: a curve is above 2 over column 3. One curve of two samples with whole heights, 3 and 0 or 1, has
    // it.
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
    const Campaign campaign{"1.0.0", 1, 40, {"horizon-ties"}, {"float"}, {"floating-horizon"}};
    const auto text = witness(campaign, family_of("horizon-ties"), experiment_of("moved-1"), 0, "floating-horizon",
                              "float", {}, [] {});
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

TEST_CASE("A witness meets the condition on its scene: the one of all, if it does, or else another") {
    struct Failing {
        std::string family, method;
    };
    const auto parts_of = [](const AnyScene& scene) {
        const auto* surface = std::get_if<Surface>(&scene);
        return surface ? surface->curves->curves.size() : std::get<AdmittedScene>(scene)->polygons.size();
    };
    for (const Failing& failing : {Failing{"neighbours", "zbuffer"}, Failing{"horizon-ties", "floating-horizon"}}) {
        const auto& family = failing.family;
        const auto& method = failing.method;
        CAPTURE(family);
        const Campaign campaign{"1.0.0", 1, 60, {family}, {"float"}, {method}};
        const auto parts_of_witness = [&](const Where& where) -> std::optional<std::size_t> {
            const auto text =
                witness(campaign, family_of(family), experiment_of("moved-1"), 0, method, "float", where, [] {});
            if (!text) return std::nullopt;
            return parts_of(*read_failure(*text, "witness.json").scene);
        };
        const auto has = [&](std::size_t parts) {
            return [&parts_of, parts](const AnyScene& scene) { return parts_of(scene) == parts; };
        };
        const auto least = parts_of_witness({});
        REQUIRE(least);
        CHECK(parts_of_witness(has(*least)) == least);
        CHECK_FALSE(parts_of_witness(has(1000)));
        // All scenes of the family have more parts than the witness, so this one keeps what the condition asks for.
        const auto of_more = [&](const AnyScene& scene) { return parts_of(scene) > *least; };
        CHECK(parts_of_witness(of_more) == *least + 1);
    }
}
