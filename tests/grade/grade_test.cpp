// Which claims a judge calls right or wrong, and which differences it accepts.

#include "grade/judge.h"

#include <doctest/doctest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "check/check.h"
#include "grade/curve_truth.h"
#include "grade/grade.h"
#include "grade/report.h"
#include "grade/scenes.h"
#include "grade/table.h"
#include "run/write_trace.h"
#include "scene/exact_scene.h"
#include "support/random_curves.h"
#include "support/scenes.h"

using namespace vidno;
using namespace vidno::test;

namespace {

using Place = SceneTruth::Place;

StudentRun run_of(const AdmittedScene& scene, Method method, const char* kernel, Edition edition = Edition::corrected,
                  Detail detail = Detail::signs) {
    const NamedKernel named = *kernel_named(kernel);
    std::string text;
    TraceWriter writer({method, edition, named.name(), detail, scene}, [&](std::string_view part) { text += part; });
    write_trace({method, named, edition, scene, detail}, writer);
    return read_student_trace(std::move(text));
}

StudentRun run_of(const Surface& surface, const char* kernel, Edition edition = Edition::corrected,
                  Detail detail = Detail::signs) {
    const NamedKernel named = *kernel_named(kernel);
    std::string text;
    TraceWriter writer(FloatingHorizonHeader{edition, named.name(), detail, surface},
                       [&](std::string_view part) { text += part; });
    write_trace(FloatingHorizonRequest{named, edition, surface.curves, detail}, writer);
    return read_student_trace(std::move(text));
}

Judgement judgement_of(const StudentRun& run) {
    return judge(*run.header, run.events, run.complete,
                 kernel_of(*run.header) == "float" ? Precision::single : Precision::twice);
}

/// Judges a run in which `change` has altered events of the kind E, until it returns true.
template <class E>
Judgement with_changed(StudentRun run, auto change) {
    for (auto& event : run.events) {
        const E* found = event.get_if<E>();
        if (!found) continue;
        E changed = *found;
        const bool done = change(changed);
        event = changed;
        if (done) break;
    }
    return judgement_of(run);
}

template <class E>
Judgement with_changed(const AdmittedScene& scene, Method method, auto change, Detail detail = Detail::signs) {
    return with_changed<E>(run_of(scene, method, "double", Edition::corrected, detail), change);
}

std::string wrong_of(const Judgement& judgement) {
    return judgement.wrong ? judgement.wrong->at + ": " + judgement.wrong->claimed + ": " + judgement.wrong->right
                           : "right";
}

/// Two squares side by side on the line x = 4.5, through the centres of column 4.
AdmittedScene neighbours() {
    return SceneBuilder({0, 0, 8, 8}).quad(1, 1, 4.5, 7, .25).quad(4.5, 1, 7, 7, .25).build();
}

}  // namespace

TEST_CASE("The truth of a scene: depths and places, by hand") {
    // z = x / 8 - 1/2, from -1/2 at x = 0 to 1/2 at x = 8.
    const AdmittedScene scene = SceneBuilder({0, 0, 8, 8})
                                    .polygon({{0, 0, -.5}, {8, 0, .5}, {8, 4, .5}, {0, 4, -.5}})
                                    .quad(0, 0, 8, 8, 0)
                                    .build();
    const SceneTruth truth(scene, Precision::twice);
    CHECK(truth.depth(0, 2, 3) == -.25);
    CHECK(truth.is_depth(0, 2, 3, -.25));
    CHECK(truth.is_depth(0, 2, 3, -.25 + 0x1p-44));
    CHECK_FALSE(truth.is_depth(0, 2, 3, -.25 + 0x1p-30));
    CHECK_FALSE(truth.is_depth(0, 2, 3, std::numeric_limits<double>::quiet_NaN()));
    CHECK(truth.nearer(0, 1, 6, 1) == 1);
    CHECK(truth.nearer(0, 1, 2, 1) == -1);
    CHECK(truth.nearer(0, 1, 4, 1) == 0);
    CHECK(truth.place(0, 3, 3) == Place::inside);
    CHECK(truth.place(0, 3, 4) == Place::outline);
    CHECK(truth.place(0, 3, 5) == Place::outside);
    CHECK(truth.meets(0, {2, 2, 4, 4}));
    CHECK_FALSE(truth.meets(0, {0, 4, 4, 4}));  // they share a side
    CHECK(truth.holds(0, {0, 0, 4, 4}));
    CHECK_FALSE(truth.holds(0, {0, 0, 8, 8}));
    CHECK(truth.is_plane(0, {-1, 0, 8, 4}));
    CHECK(truth.is_plane(0, {.5, 0, -4, -2}));
    CHECK_FALSE(truth.is_plane(0, {-1, 0, 8, 5}));
}

TEST_CASE("The truth of a scene: the part of a polygon in a window, in any order of its corners") {
    const AdmittedScene scene = SceneBuilder({0, 0, 8, 8}).quad(-2, 1, 3, 5, .5).build();
    const SceneTruth truth(scene, Precision::twice);
    const Window window{0, 0, 4, 4};  // the part is (0, 1) to (3, 4), of area 9
    const Corners part{{0, 1, .5}, {3, 1, .5}, {3, 4, .5}, {0, 4, .5}};
    CHECK_FALSE(truth.no_part(0, window, part, Words()));
    CHECK_FALSE(truth.no_part(0, window, {part.rbegin(), part.rend()}, Words()));
    CHECK_FALSE(
        truth.no_part(0, window, {part[2], part[3], part[0], {1, 1, .5}, part[1]}, Words()));  // one more on an edge
    CHECK(*truth.no_part(0, window, {part[0], part[1], part[2]}, Words()) ==
          "its area is 4.5, and that of the part in the window is 9");
    CHECK(*truth.no_part(0, window, {part[0], part[2], part[1], part[3]}, Words()) ==
          "its area is 0, and that of the part in the window is 9");
    CHECK(*truth.no_part(0, window, {part[0], part[1], {3, 5, .5}, {0, 5, .5}}, Words()) ==
          "(3, 5, 0.5) lies outside the window");
    CHECK(*truth.no_part(0, window, {part[0], {4, 1, .5}, {4, 4, .5}, part[3]}, Words()) ==
          "(4, 1, 0.5) lies outside the polygon");
    CHECK(*truth.no_part(0, window, {part[0], part[1], part[2], {0, 4, .25}}, Words()) ==
          "(0, 4, 0.25) is not on the polygon's plane: its depth there is 0.5");
    CHECK(*truth.no_part(0, window, {}, Words()) ==
          "nothing is left of it, but its part in the window has an area of 9");
}

TEST_CASE("The truth of a scene: an outline may show what is next to it, but a common edge must have no hole") {
    const AdmittedScene scene = neighbours();
    const SceneTruth truth(scene, Precision::twice);
    const auto allows = [&](int column, int row, Color color) { return truth.allows(column, row, color); };
    const Color left = scene->polygons[0].color, right = scene->polygons[1].color, behind = scene->background;
    CHECK(truth.seen(4, 3).by_rule == 0);
    CHECK(allows(4, 3, left));
    CHECK(allows(4, 3, right));
    CHECK_FALSE(allows(4, 3, behind));
    CHECK(allows(2, 3, left));
    CHECK_FALSE(allows(2, 3, right));
    CHECK(allows(0, 0, behind));
    // At the end of the common edge, the background is next to the point too.
    const AdmittedScene ends = SceneBuilder({0, 0, 8, 8}).quad(1, 1.5, 4.5, 7, .25).quad(4.5, 1.5, 7, 7, .25).build();
    const SceneTruth end_truth(ends, Precision::twice);
    CHECK(end_truth.allows(4, 1, left));
    CHECK(end_truth.allows(4, 1, right));
    CHECK(end_truth.allows(4, 1, behind));
}

TEST_CASE("Judging: our own runs are right, in double and in float, on random and degenerate scenes") {
    RandomScenes random(77);
    for (int trial = 0; trial < 60; ++trial) {
        const AdmittedScene scene = random.scene();
        for (const Method method : {Method::warnock, Method::zbuffer}) {
            for (const char* kernel : {"double", "float"}) {
                CAPTURE(trial);
                CAPTURE(kernel);
                CAPTURE(int(method));
                CHECK(wrong_of(judgement_of(run_of(scene, method, kernel))) == "right");
            }
        }
    }
}

TEST_CASE("Judging: our own runs are right on the scenes for students, at every level") {
    for (const AdmittedScene& scene : scenes_to_grade()) {
        CAPTURE(scene->name);
        for (const Method method : {Method::warnock, Method::zbuffer}) {
            for (const Detail detail : {Detail::windows, Detail::polygons, Detail::signs}) {
                const Judgement judgement = judgement_of(run_of(scene, method, "double", Edition::corrected, detail));
                CHECK(wrong_of(judgement) == "right");
                CHECK(judgement.differences.empty());
            }
        }
    }
}

TEST_CASE("Judging: a changed claim is the one that the judge finds") {
    const AdmittedScene scene = SceneBuilder(area_16).polygon(far_quad).polygon(near_square).build();
    const auto symptom = [](const Judgement& judgement) {
        return judgement.wrong ? judgement.wrong->symptom : Symptom::impossible;
    };
    SUBCASE("a depth") {
        const auto change = [](event::Depth& e) { return e.z = e.z.number + .125, true; };
        CHECK(symptom(with_changed<event::Depth>(scene, Method::warnock, change)) == Symptom::depth);
    }
    SUBCASE("whether a point is inside") {
        const auto change = [](event::Surround& e) { return e.inside = !e.inside, true; };
        CHECK(symptom(with_changed<event::Surround>(scene, Method::warnock, change)) == Symptom::point_in_polygon);
    }
    SUBCASE("which depth is nearer") {
        const auto change = [](event::Compare& e) { return e.nearer = !e.nearer, true; };
        CHECK(symptom(with_changed<event::Compare>(scene, Method::warnock, change)) == Symptom::comparison);
    }
    SUBCASE("the case of a window") {
        const auto change = [](event::Decide& e) { return e.which = Case::empty, true; };
        CHECK(symptom(with_changed<event::Decide>(scene, Method::warnock, change)) == Symptom::not_plain);
    }
    SUBCASE("the sign for an edge, after earlier signs have set the positive side") {
        auto change = [seen = 0](event::Orient& e) mutable {
            if (e.sign == Sign::zero || ++seen < 3) return false;
            e.sign = -e.sign;
            e.value = -e.value.number;
            return true;
        };
        CHECK(symptom(with_changed<event::Orient>(scene, Method::warnock, change)) == Symptom::point_in_polygon);
    }
    SUBCASE("the pixels of a row") {
        const auto change = [](event::Span& e) { return e.runs = {{e.runs[0].first, e.runs[0].end - 1}}, true; };
        CHECK(symptom(with_changed<event::Span>(scene, Method::zbuffer, change, Detail::windows)) ==
              Symptom::not_painted);
    }
    SUBCASE("where an edge is on a row") {
        const auto change = [](event::AelStep& e) { return e.x = e.x.number + 1, true; };
        CHECK(symptom(with_changed<event::AelStep>(scene, Method::zbuffer, change)) == Symptom::edge);
    }
    SUBCASE("the number of a side that clips") {
        const auto change = [](event::ClipSide& e) { return e.side = 2, true; };
        CHECK(wrong_of(with_changed<event::ClipSide>(neighbours(), Method::warnock, change))
                  .find("by its place this is side") != std::string::npos);
    }
}

TEST_CASE("Judging: the rows at which edges begin and have ended are those of their ends") {
    // The square from y = 1 to 7: its lower side begins at row 7, and at row 7 its left and right sides have ended.
    const AdmittedScene scene = SceneBuilder({0, 0, 8, 8}).quad(1, 1, 6, 7, .25).build();
    const auto wrong = [&]<class E>(double by) {
        const auto change = [&](E& e) { return e.next = e.next.number + by, true; };
        return wrong_of(with_changed<E>(scene, Method::zbuffer, change));
    };
    CHECK(wrong.operator()<event::Leave>(0) == "right");
    CHECK(wrong.operator()<event::Leave>(1) ==
          "Z10: the next edges of S begin at row 8: the highest of them begins at y = 7");
    CHECK(wrong.operator()<event::Leave>(-1) ==
          "Z10: the next edges of S begin at row 6: the highest of them begins at y = 7");
    CHECK(wrong.operator()<event::AelSort>(1) ==
          "Z12: the first edge of AEL has ended at row 8: that edge goes down to y = 7");
    CHECK(wrong.operator()<event::AelSort>(-1) ==
          "Z12: the first edge of AEL has ended at row 6: that edge goes down to y = 7");
    const auto never = [](event::AelDrop& e) { return e.next = 7, true; };
    CHECK(wrong_of(with_changed<event::AelDrop>(scene, Method::zbuffer, never)) ==
          "Z16: the first edge of AEL has ended at row 7: AEL is empty");
}

TEST_CASE("Judging: the printed text is wrong where its defect X-W1 shows") {
    // X-W1: polygons that surround the window leave the list. The far quad surrounds the first window.
    const AdmittedScene scene = SceneBuilder(area_16).polygon(far_quad).polygon(near_square).build();
    CHECK(judgement_of(run_of(scene, Method::warnock, "double", Edition::printed)).wrong.has_value());
}

TEST_CASE("Judging: NaN and infinity are false claims") {
    const double none = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
    const auto found = [](const Judgement& judgement) { return judgement.wrong.has_value(); };
    for (const double value : {none, infinite}) {
        CHECK(found(with_changed<event::Depth>(neighbours(), Method::warnock,
                                               [&](event::Depth& e) { return e.point.x = value, true; })));
        CHECK(found(with_changed<event::Depth>(neighbours(), Method::warnock,
                                               [&](event::Depth& e) { return e.z = value, true; })));
        CHECK(found(with_changed<event::PointColor>(neighbours(), Method::warnock,
                                                    [&](event::PointColor& e) { return e.point.y = value, true; })));
        CHECK(found(with_changed<event::AelAdd>(neighbours(), Method::zbuffer,
                                                [&](event::AelAdd& e) { return e.x = value, true; })));
        CHECK(found(with_changed<event::ShownLine>(neighbours(), Method::zbuffer,
                                                   [&](event::ShownLine& e) { return e.from.x = value, true; })));
        // Events about a point that is not finite claim nothing, so the judge must only not fail on them.
        with_changed<event::Orient>(neighbours(), Method::warnock,
                                    [&](event::Orient& e) { return e.point.x = value, true; });
        with_changed<event::Surround>(neighbours(), Method::warnock,
                                      [&](event::Surround& e) { return e.point.x = value, true; });
    }
}

/// The grader's view of a program that runs as the edition does, on all scenes for students.
struct Graded {
    std::vector<StudentRun> runs;
    std::vector<Judgement> judgements;

    Graded(Method method, Edition edition) {
        for (const AdmittedScene& scene : scenes_to_grade()) add(run_of(scene, method, "double", edition));
    }
    /// Grades a run of the floating horizon.
    explicit Graded(Edition edition) {
        for (const Surface& surface : surfaces_to_grade()) add(run_of(surface, "double", edition));
    }
    void add(StudentRun run) {
        judgements.push_back(judgement_of(run));
        runs.push_back(std::move(run));
    }
    bool is_wrong() const {
        return std::any_of(judgements.begin(), judgements.end(),
                           [](const auto& each) { return each.wrong.has_value(); });
    }
    std::optional<Deviation> deviation() const {
        std::vector<Observation> observed;
        for (std::size_t i = 0; i < runs.size(); ++i)
            observed.push_back({&*runs[i].header, &runs[i].events, &judgements[i], runs[i].complete});
        return deviation_of(observed, Precision::twice);
    }
};

/// Deviations whose runs claim nothing false that a program in `double` could avoid.
bool is_as_right(Deviation deviation) {
    switch (deviation) {
        case Deviation::x_w1:  // polygons outside a window stay in its list: more windows, the same picture
        case Deviation::x_z2:  // lines beside the area are followed, and have no pixel in it
        case Deviation::x_w4:  // all edges of a polygon lie on one line as computed: rounding decides what is there
        case Deviation::x_w8:  // a polygon is seen edge-on, but not as computed
            return true;
        default: return false;
    }
}

TEST_CASE(
    "Judging: on the scenes for students each deviation is found and named from its traces, unless it is as right" *
    doctest::skip(sanitized)) {
    for (std::size_t i = 0; i < deviations.size(); ++i) {
        const Edition edition{Deviation(i)};
        for (const Method method : {Method::warnock, Method::zbuffer}) {
            if (!kernel_named("double")->choice->runs(method, edition)) continue;
            const std::string name = name_of(edition);
            CAPTURE(name);
            CAPTURE(int(method));
            const Graded graded(method, edition);
            CHECK(graded.is_wrong() != is_as_right(Deviation(i)));
            CHECK(graded.deviation() == (graded.is_wrong() ? std::optional(Deviation(i)) : std::nullopt));
        }
    }
}

TEST_CASE("Judging: a line at which the printed text fails is a false claim") {
    // The quad reaches beyond the area of one pixel; with X-Z3 the column just past the area is drawn, too.
    const AdmittedScene scene = SceneBuilder({0, 0, 1, 1}).quad(0, 0, 2, 2, 0).build();
    const Judgement beside = judgement_of(run_of(scene, Method::zbuffer, "double", Deviation::x_z3));
    CHECK(wrong_of(beside) == "L6: a polygon is drawn at pixel (1, 0): that is not in the area");
    const AdmittedScene line =
        SceneBuilder(area_16).polygon({{6.1, .61, 0}, {8.4, .8400000000000001, 0}, {2, .2, 0}}).build();
    CHECK(wrong_of(judgement_of(run_of(line, Method::warnock, "double", Deviation::x_w4))) ==
          "S2: this line fails: the list of vertices is read past its end: the corrected procedure goes on");
}

TEST_CASE("Judging Weiler and Atherton: our own certain runs are right on the scenes for students, at every level") {
    for (const AdmittedScene& scene : scenes_to_grade()) {
        CAPTURE(scene->name);
        for (const Detail detail : {Detail::windows, Detail::polygons, Detail::signs}) {
            const StudentRun run = run_of(scene, Method::weiler_atherton, "filtered", Edition::corrected, detail);
            CHECK(wrong_of(judgement_of(run)) == "right");
        }
    }
}

TEST_CASE("Judging Weiler and Atherton: our own runs in double are wrong only where rounding loses a part") {
    std::vector<std::string> wrong_scenes;
    for (const AdmittedScene& scene : scenes_to_grade()) {
        CAPTURE(scene->name);
        const std::string wrong = wrong_of(judgement_of(run_of(scene, Method::weiler_atherton, "double")));
        if (wrong == "right") continue;
        CAPTURE(wrong);
        CHECK(wrong.ends_with("an outline does not close"));
        wrong_scenes.push_back(scene->name);
    }
    // In exact arithmetic the run of this scene is right, and so is a program in `double` that keeps the vertices which
    // its pieces share (right/weiler_atherton.cpp).
    CHECK(wrong_scenes == std::vector<std::string>{"An area of 16 x 3"});
}

TEST_CASE("Judging Weiler and Atherton: a changed claim is the one that the judge finds") {
    // The near square from (4, 4) to (12, 12) hides 64 of the area 256 that the far one covers.
    const AdmittedScene scene = SceneBuilder(area_16).quad(-1, -1, 17, 17, .125).quad(4, 4, 12, 12, .5).build();
    const auto wrong = [&]<class E>(auto change, Detail detail = Detail::signs) {
        return wrong_of(with_changed<E>(scene, Method::weiler_atherton, change, detail));
    };
    SUBCASE("the part of a polygon in the area") {
        // Its corner (0, y) moves to (1, y): a triangle of base 1 and height 16 is missing.
        const auto change = [](event::CutToArea& e) { return e.region.front()[0].x = 1, true; };
        CHECK(wrong.operator()<event::CutToArea>(change) ==
              "WA1: the part of A in the area has the area 248: its area is 256");
    }
    SUBCASE("a part inside of another polygon that reaches out of it") {
        const auto change = [](event::Clipped& e) {
            if (e.inside.empty() || e.outside.empty()) return false;
            return e.inside.front()[0].x = 2, true;
        };
        CHECK(wrong.operator()<event::Clipped>(change) ==
              "WA5: the part of A inside of B has a vertex at (2, 12): that lies outside of B");
    }
    SUBCASE("which of two depths is nearer") {
        const auto change = [](event::Behind& e) { return e.order = -e.order, true; };
        CHECK(wrong.operator()<event::Behind>(change).ends_with("the greater z is the nearer"));
    }
    SUBCASE("whether a part is hidden") {
        const auto change = [](event::Behind& e) { return e.behind = !e.behind, true; };
        CHECK(wrong.operator()<event::Behind>(change) ==
              "RB3: A is not hidden by B: its depth is 0.125, the other's 0.5");
    }
    SUBCASE("a depth") {
        const auto change = [](event::Behind& e) { return e.z = e.z.number + .0625, true; };
        CHECK(wrong.operator()<event::Behind>(change) == "RB3: the depth of A at (8, 8) is 0.1875: it is 0.125");
    }
    SUBCASE("the far square is visible without a hole") {
        const auto change = [](event::Show& e) {
            if (e.polygon.index != 0) return false;
            e.region = {{{0, 0}, {16, 0}, {16, 16}, {0, 16}}};
            return true;
        };
        CHECK(wrong.operator()<event::Show>(change, Detail::windows) ==
              "WA8: A is visible in a region of area 256: B is nearer in 64 of it");
    }
    SUBCASE("a visible region is only half as large") {
        const auto change = [](event::Show& e) {
            if (e.polygon.index != 1) return false;
            e.region = {{{4, 4}, {12, 4}, {12, 8}, {4, 8}}};
            return true;
        };
        CHECK(wrong.operator()<event::Show>(change, Detail::windows) ==
              "PR3: the visible regions have the area 224: the polygons cover 256 of the area; B shows at pixel (4, "
              "8), and "
              "none of them has it");
    }
    SUBCASE("a pixel beside the region is painted") {
        const auto change = [](event::Paint& e) {
            if (e.polygon.index != 1) return false;
            e.runs.front().end += 1;
            return true;
        };
        CHECK(wrong.operator()<event::Paint>(change, Detail::windows) ==
              "PR3: B is drawn at pixel (12, 4): its centre lies outside of B");
    }
}

namespace {

using ClaimedLoop = std::vector<ValuePoint>;

ClaimedLoop rectangle(double left, double top, double right, double bottom) {
    return {{left, top}, {right, top}, {right, bottom}, {left, bottom}};
}

ClaimedLoop reversed(ClaimedLoop loop) {
    std::reverse(loop.begin(), loop.end());
    return loop;
}

}  // namespace

TEST_CASE(
    "Judging Weiler and Atherton: of a visible region the judge tells what it covers, how often, and its direction") {
    // A and B are squares of area 9, side by side.
    const AdmittedScene scene = SceneBuilder({0, 0, 8, 4}).quad(.5, .5, 3.5, 3.5, 0).quad(4.5, .5, 7.5, 3.5, 0).build();
    const ClaimedLoop a = rectangle(.5, .5, 3.5, 3.5), b = rectangle(4.5, .5, 7.5, 3.5), hole = rectangle(1, 1, 3, 3);
    struct Case {
        const char* reported;
        std::vector<std::pair<int, RegionLoops>> shown;  // a polygon and a visible region of it
        const char* wrong;
    };
    const std::string reverse = ": on the screen outlines run clockwise, and holes counterclockwise";
    const std::vector<Case> cases{
        {"both", {{0, {a}}, {1, {b}}}, "right"},
        {"the other one first", {{1, {b}}, {0, {a}}}, "right"},
        {"in parts", {{1, {b}}, {0, {rectangle(.5, .5, 2, 3.5)}}, {0, {rectangle(2, .5, 3.5, 3.5)}}}, "right"},
        {"with a hole, which is another part", {{0, {a, reversed(hole)}}, {0, {hole}}, {1, {b}}}, "right"},
        {"two parts as one region", {{0, {rectangle(.5, .5, 2, 3.5), rectangle(2, .5, 3.5, 3.5)}}, {1, {b}}}, "right"},
        {"A twice instead of B",
         {{0, {a}}, {0, {a}}},
         "WA8: A is visible in a region of area 9: 9 of it is in a visible region of A that was shown before"},
        {"a part of A twice",
         {{0, {a}}, {0, {hole}}, {1, {b}}},
         "WA8: A is visible in a region of area 4: 4 of it is in a visible region of A that was shown before"},
        {"A as B",
         {{0, {a}}, {1, {a}}},
         "WA8: the visible region of B has a vertex at (0.5, 0.5): that lies outside of B"},
        {"A only",
         {{0, {a}}},
         "WA8: the visible regions have the area 9: the polygons cover 18 of the area; B shows at pixel (5, 1), and "
         "none "
         "of them has it"},
        {"the loop twice in one region",
         {{0, {a, a}}},
         "WA8: the visible region of A has an area of 9 more than once: the loops of a region do not overlap"},
        {"both loops reversed",
         {{0, {reversed(a)}}, {1, {reversed(b)}}},
         "WA8: the visible region of A runs counterclockwise around an area of 9"},
        {"the second one reversed",
         {{0, {a}}, {1, {reversed(b)}}},
         "WA8: the visible region of B runs counterclockwise around an area of 9"},
        {"a hole in the direction of the outline",
         {{0, {a, hole}}, {0, {hole}}, {1, {b}}},
         "WA8: the visible region of A has an area of 4 more than once: the loops of a region do not overlap"},
        // Its two halves have the areas 4.5 / 2 each, one of them negative.
        {"a loop that crosses itself",
         {{0, {{{.5, .5}, {3.5, 3.5}, {3.5, .5}, {.5, 3.5}}}}, {1, {b}}},
         "WA8: the visible region of A runs counterclockwise around an area of 2.25"},
    };
    for (const Case& each : cases) {
        CAPTURE(each.reported);
        StudentRun run = run_of(scene, Method::weiler_atherton, "double", Edition::corrected, Detail::windows);
        std::erase_if(run.events, [](const Event& e) { return e.get_if<event::Show>() || e.get_if<event::Paint>(); });
        for (const auto& [polygon, region] : each.shown)
            run.events.push_back(event::Show{Line::WA8, PolygonPlace{polygon}, region});
        const std::string wrong = wrong_of(judgement_of(run)),
                          end = std::string(each.wrong).find("counterclockwise") == std::string::npos ? "" : reverse;
        CHECK(wrong == each.wrong + end);
    }
}

TEST_CASE("Judging Weiler and Atherton: the parts of a piece are those inside and outside of the clip piece") {
    // The near square B from (4, 4) to (12, 12) clips the far one, A.
    const AdmittedScene scene = SceneBuilder(area_16).quad(-1, -1, 17, 17, .125).quad(4, 4, 12, 12, .5).build();
    const auto wrong = [&](auto change) {
        return wrong_of(with_changed<event::Clipped>(scene, Method::weiler_atherton, change));
    };
    const ClaimedLoop b = rectangle(4, 4, 12, 12);
    CHECK(wrong([&](event::Clipped& e) { return e.inside = {rectangle(4, 4, 12, 8)}, true; }) ==
          "WA5: of the piece of A an area of 32 lies inside of that of B: its area there is 64, and 32 of the told "
          "area is wrong");
    CHECK(wrong([&](event::Clipped& e) { return e.inside = {}, true; }) ==
          "WA5: of the piece of A an area of 0 lies inside of that of B: its area there is 64, and 64 of the told "
          "area is wrong");
    CHECK(wrong([&](event::Clipped& e) { return e.outside = {rectangle(0, 0, 16, 16)}, true; }) ==
          "WA5: of the piece of A an area of 256 lies outside of that of B: its area there is 192, and 64 of the "
          "told area is wrong");
    // As large as the part outside, but 64 of it lie inside, so that as much is missing.
    CHECK(wrong([&](event::Clipped& e) { return e.outside = {rectangle(0, 0, 16, 12)}, true; }) ==
          "WA5: of the piece of A an area of 192 lies outside of that of B: its area there is 192, and 128 of the "
          "told area is wrong");
    CHECK(wrong([&](event::Clipped& e) { return e.inside = {reversed(b)}, true; }) ==
          "WA5: the part of A inside of B runs counterclockwise around an area of 64: on the screen outlines run "
          "clockwise, and holes "
          "counterclockwise");
    StudentRun run = run_of(scene, Method::weiler_atherton, "double", Edition::corrected, Detail::polygons);
    const auto clipped =
        std::find_if(run.events.begin(), run.events.end(), [](const Event& e) { return e.get_if<event::Clipped>(); });
    REQUIRE(clipped != run.events.end());
    *clipped = event::Beside{Line::WA5, PolygonPlace{0}};
    CHECK(wrong_of(judgement_of(run)) == "WA5: the piece of A lies outside of that of B: an area of 64 lies in both");
}

TEST_CASE("Judging Weiler and Atherton: a row reaches from one outline of a visible region to another, through it") {
    // The near square B from (4, 4) to (12, 12) hides the middle of A. Row 6 meets A's visible region from 0 to 4 and
    // from 12 to 16.
    const AdmittedScene scene = SceneBuilder(area_16).quad(-1, -1, 17, 17, .125).quad(4, 4, 12, 12, .5).build();
    struct Case {
        double left, right;
        bool is_right;
    };
    for (const Case& each : {Case{0, 4, true}, Case{12, 16, true}, Case{4, 12, true}, Case{0, 16, false},
                             Case{0, 4.25, false}, Case{0, 3.75, false}, Case{0.25, 4, false}, Case{-1, 4, false}}) {
        CAPTURE(each.left);
        CAPTURE(each.right);
        const auto change = [&](event::Row& e) {
            if (e.row != 6 || e.left.number != 0) return false;
            return e.left = each.left, e.right = each.right, true;
        };
        CHECK(with_changed<event::Row>(scene, Method::weiler_atherton, change).wrong.has_value() != each.is_right);
    }
    const auto too_long = [](event::Row& e) { return e.row == 6 && e.left.number == 0 && (e.right = 5, true); };
    CHECK(wrong_of(with_changed<event::Row>(scene, Method::weiler_atherton, too_long)) ==
          "PR1: on row 6 a visible region goes from x = 0 to 5: the outlines of the visible regions meet that row at "
          "x = 0, 4, 12, 16");
}

namespace {

/// A curve at height 4 and one at height 8, and a third that comes down from 1 to 11 through both, at x = 3 and 7.
Surface two_horizons() {
    return {"", CurveSceneBuilder({0, 0, 11, 12})
                    .curve({{0, 4}, {10, 4}})
                    .curve({{0, 8}, {10, 8}})
                    .curve({{0, 1}, {10, 11}})
                    .build()};
}

}  // namespace

TEST_CASE("The truth of curves: heights, horizons and what is hidden, by hand") {
    using Side = CurveTruth::Side;
    using When = CurveTruth::When;
    const CurveTruth truth(two_horizons().curves, Precision::twice);
    CHECK(truth.height(2, 2.5) == 3.5);
    CHECK_FALSE(truth.height(2, 10.5).has_value());
    CHECK(truth.is_on_curve(2, 2.5, 3.5 + 0x1p-44));
    CHECK_FALSE(truth.is_on_curve(2, 2.5, 3.5 + 0x1p-30));
    CHECK_FALSE(truth.horizon(0, When::before, Side::upper, 5).has_value());
    CHECK(truth.horizon(1, When::before, Side::lower, 5) == 4);
    CHECK(truth.horizon(2, When::before, Side::lower, 5) == 8);
    CHECK(truth.horizon(2, When::after, Side::upper, 1) == 2);
    CHECK(truth.may_be(2, 2, VisibilityFlag::above));
    CHECK_FALSE(truth.may_be(2, 2, VisibilityFlag::hidden));
    CHECK(truth.may_be(2, 3, VisibilityFlag::hidden));  // it touches the horizon
    CHECK(truth.may_be(2, 3, VisibilityFlag::above));
    CHECK_FALSE(truth.may_be(2, 4, VisibilityFlag::above));
    CHECK(truth.may_be(2, 8, VisibilityFlag::below));
    CHECK(truth.meets_horizon(2, 7));
    CHECK_FALSE(truth.meets_horizon(2, 6));
    CHECK(truth.hidden_between(2, 2, 4) == 3.5);
    CHECK_FALSE(truth.hidden_between(2, 7, 10).has_value());
    CHECK_FALSE(truth.left_out(2, {{0, 3}, {7, 10}}).has_value());
    CHECK(truth.left_out(2, {{0, 3}, {7.5, 10}}) == 7.25);
    CHECK(truth.left_out(2, {{0, 3}}) == 7.5);
}

TEST_CASE("The truth of curves: a side edge counts over the columns between its ends") {
    // From (4, 2) the left edge leads to (0, 6), so over column 2 it is at 4.
    const CurveScene scene = CurveSceneBuilder({0, 0, 9, 8}).curve({{4, 2}, {8, 2}}).curve({{0, 6}, {8, 6}}).build();
    const CurveTruth truth(scene, Precision::twice);
    const auto upper = [&](int x) { return truth.horizon(1, CurveTruth::When::before, CurveTruth::Side::upper, x); };
    CHECK_FALSE(upper(0).has_value());
    CHECK(upper(2) == 4);
    CHECK(upper(4) == 2);
}

namespace {

const double no_height = std::numeric_limits<double>::quiet_NaN();

/// A level curve at 4 with a gap from x = 2 to 6, a curve without a piece, and a level curve at 4.
Surface with_gap() {
    return {"", CurveSceneBuilder({0, 0, 9, 8})
                    .curve({{0, 4}, {2, 4}, {4, no_height}, {6, 4}, {8, 4}})
                    .curve({{0, no_height}, {8, no_height}})
                    .curve({{2, 4}, {6, 4}})
                    .build()};
}

}  // namespace

TEST_CASE("The truth of curves: a gap has no height, hides nothing, and must not be drawn") {
    using Side = CurveTruth::Side;
    using When = CurveTruth::When;
    const CurveTruth truth(with_gap().curves, Precision::twice);
    CHECK(truth.height(0, 2) == 4);
    for (const double x : {2.5, 3., 4., 5.5}) {
        CAPTURE(x);
        CHECK_FALSE(truth.height(0, x).has_value());
        CHECK_FALSE(truth.may_show(0, x));
        CHECK(truth.may_be_left_out(0, x));
    }
    CHECK(truth.may_show(0, 2));
    CHECK_FALSE(truth.may_be_left_out(0, 6));
    CHECK(truth.hidden_between(0, 1, 7) == 2.5);
    CHECK_FALSE(truth.hidden_between(0, 6, 8).has_value());
    CHECK_FALSE(truth.left_out(0, {{0, 2}, {6, 8}}).has_value());
    CHECK(truth.left_out(0, {{0, 2}}) == 6);
    CHECK_FALSE(truth.left_out(1, {}).has_value());
    CHECK_FALSE(truth.horizon(0, When::after, Side::upper, 4).has_value());
    CHECK_MESSAGE(!truth.horizon(2, When::before, Side::upper, 3).has_value(), "no edge leads over the curve before");
    CHECK(truth.horizon(2, When::after, Side::upper, 3) == 4);
}

TEST_CASE("Judging curves: a claim about a gap is false") {
    const auto wrong = []<class E>(auto change, Detail detail = Detail::signs) {
        return wrong_of(with_changed<E>(run_of(with_gap(), "double", Edition::corrected, detail), change));
    };
    const auto draws_across = [](event::DrawLine& e) {
        e.to = {8, 4};
        return true;
    };
    CHECK(wrong.operator()<event::DrawLine>(draws_across, Detail::windows) ==
          "FH6: curve 0 is visible from x = 0 to 8: at x = 2.5 it has a gap");
    CHECK(wrong.operator()<event::Height>([](event::Height& e) { return e.x = 4, true; }) ==
          "V1: curve 0 is examined over column 4: it has a gap there");
    const auto raises = [](event::Raise& e) { return e.x = 3, true; };
    CHECK(wrong.operator()<event::Raise>(raises).find("the upper horizon over column 3 is at y = 4") !=
          std::string::npos);
    const auto comes_to = [](event::SideEdge& e) {
        if (e.at != Line::FH10) return false;
        return e.sample = {2, 4}, true;
    };
    CHECK(wrong.operator()<event::SideEdge>(comes_to) ==
          "FH10: the right edge comes to (2, 4): the end of curve 0 there is (8, 4)");
}

TEST_CASE("Judging curves: our own runs are right at every level, in double and in float, also on random curves") {
    std::vector<Surface> surfaces = surfaces_to_grade();
    for (Surface& surface : random_surfaces_to_grade(5, 60)) surfaces.push_back(std::move(surface));
    RandomCurves random(3);
    for (int trial = 0; trial < 60; ++trial) surfaces.push_back({"", moved_by_ulps(random.scene(), random)});
    for (int trial = 0; trial < 60; ++trial) {
        const AdmittedCurves curves = with_gaps(random.scene(), random);
        if (column_count(curves) > 0) surfaces.push_back({"", curves});  // others are refused
    }
    for (const Surface& surface : surfaces) {
        CAPTURE(surface_json(surface));
        for (const char* kernel : {"double", "float"}) {
            for (const Detail detail : {Detail::windows, Detail::signs}) {
                CHECK(wrong_of(judgement_of(run_of(surface, kernel, Edition::corrected, detail))) == "right");
            }
        }
    }
}

TEST_CASE("Judging curves: each defect of the printed text is found and named from its traces") {
    for (std::size_t i = 0; i < deviations.size(); ++i) {
        const Edition edition{Deviation(i)};
        if (!has_text_of_curves(edition)) continue;
        const std::string name = name_of(edition);
        CAPTURE(name);
        const Graded graded(edition);
        CHECK(graded.is_wrong());
        CHECK(graded.deviation() == Deviation(i));
    }
}

TEST_CASE("Judging curves: a changed claim is the one that the judge finds") {
    const auto wrong = []<class E>(auto change, Detail detail = Detail::signs) {
        return wrong_of(with_changed<E>(run_of(two_horizons(), "double", Edition::corrected, detail), change));
    };
    SUBCASE("where the upper horizon starts") {
        const auto change = [](event::Horizons& e) { return e.upper = 5, true; };
        CHECK(wrong.operator()<event::Horizons>(change) ==
              "FH1: the upper horizon starts at y = 5: a curve goes beyond it, and nothing hides the curve there");
    }
    SUBCASE("the height of a curve") {
        const auto change = [](event::Height& e) { return e.y = 5, true; };
        CHECK(wrong.operator()<event::Height>(change) == "V1: at x = 0 curve 0 is at y = 5: it is at y = 4");
    }
    SUBCASE("the height of a horizon") {
        const auto change = [](event::Height& e) {
            if (!e.upper || e.x != 5) return false;
            return e.upper = 3, true;
        };
        CHECK(
            wrong.operator()<event::Height>(change) ==
            "V1: the upper horizon over column 5 is at y = 3: by the curves and edges before it the upper horizon over "
            "column 5 is at y = 4");
    }
    SUBCASE("a flag") {
        const auto change = [curve = 0](event::Visibility& e) mutable {
            if (e.at == Line::FH4) ++curve;
            if (curve < 3 || e.x != 5) return false;
            return e.flag = VisibilityFlag::above, true;
        };
        CHECK(wrong.operator()<event::Visibility>(change) ==
              "FH5: the flag of curve 2 over column 5 is 1: it is at y = 6 there, and the horizons are at 4 and 8");
    }
    SUBCASE("a line across what is hidden") {
        const auto change = [](event::DrawLine& e) {
            if (e.from.y.number != 3) return false;
            e.to = {4, 5};
            e.to_columns = {4, 4};
            return true;
        };
        CHECK(wrong.operator()<event::DrawLine>(change, Detail::windows) ==
              "FH6: curve 2 is visible from x = 2 to 4: at x = 3.5 it is hidden: there it is at y = 4.5, between the "
              "horizons");
    }
    SUBCASE("a line that is missing") {
        StudentRun run = run_of(two_horizons(), "double", Edition::corrected, Detail::windows);
        const auto is_low = [](const Event& event) {
            const auto* line = event.get_if<event::DrawLine>();
            return line && line->from.y.number == 8 && line->to.y.number == 9;
        };
        std::erase_if(run.events, is_low);
        CHECK(wrong_of(judgement_of(run))
                  .ends_with("curve 2 is done, and it is not drawn at x = 7.5: it is visible there, at y = 8.5"));
    }
    SUBCASE("a horizon that is not raised") {
        const auto change = [](event::Horizon& e) {
            if (e.upper.empty()) return false;
            return e.upper.clear(), true;
        };
        CHECK(
            wrong.operator()<event::Horizon>(change, Detail::polygons).find("there is no upper horizon over column") !=
            std::string::npos);
    }
    SUBCASE("the end of a side edge") {
        const auto change = [](event::SideEdge& e) { return e.sample = {0, 5}, true; };
        CHECK(wrong.operator()<event::SideEdge>(change) ==
              "FH3: the left edge comes to (0, 5): the end of curve 0 there is (0, 4)");
    }
}

namespace {

/// The events with one more before each of the kind E: the last one of the kind Before again.
template <class Before, class E>
std::vector<Event> with_repeated(const std::vector<Event>& events) {
    std::vector<Event> all;
    std::optional<Before> last;
    for (const Event& event : events) {
        if (const auto* before = event.get_if<Before>()) last = *before;
        if (event.get_if<E>() && last) all.push_back(*last);
        all.push_back(event);
    }
    return all;
}

}  // namespace

TEST_CASE("Judging: a program may return to a polygon or a curve, and is done with it after the last time") {
    SUBCASE("a polygon before each of its rows, and the rows of all polygons from the top") {
        const AdmittedScene scene = SceneBuilder(area_16).polygon(far_quad).polygon(near_square).build();
        StudentRun run = run_of(scene, Method::zbuffer, "double", Edition::corrected, Detail::windows);
        std::erase_if(run.events, [](const Event& e) { return e.get_if<event::Scanline>(); });
        run.events = with_repeated<event::Polygon, event::Span>(run.events);
        CHECK(wrong_of(judgement_of(run)) == "right");
        std::vector<std::pair<Event, Event>> rows;  // a polygon and a span
        for (std::size_t i = 0; i + 1 < run.events.size(); ++i) {
            if (run.events[i + 1].get_if<event::Span>()) rows.emplace_back(run.events[i], run.events[i + 1]);
        }
        std::stable_sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) {
            return a.second.template get_if<event::Span>()->row < b.second.template get_if<event::Span>()->row;
        });
        run.events.erase(run.events.begin() + 1, run.events.end());  // `clear` stays
        for (const auto& [polygon, span] : rows) {
            run.events.push_back(polygon);
            run.events.push_back(span);
        }
        CHECK(wrong_of(judgement_of(run)) == "right");
        run.events.erase(run.events.end() - 2, run.events.end());
        CHECK(wrong_of(judgement_of(run))
                  .ends_with("A is done, and pixel (0, 15) shows nothing of what came so far: its centre is inside A"));
    }
    SUBCASE("a curve before each of its lines") {
        StudentRun run = run_of(two_horizons(), "double", Edition::corrected, Detail::windows);
        run.events = with_repeated<event::Curve, event::DrawLine>(run.events);
        CHECK(wrong_of(judgement_of(run)) == "right");
        run.events.pop_back();  // from (7, 8) to (10, 11)
        CHECK(judgement_of(run).wrong.has_value());
    }
}

TEST_CASE("Judging: a row may be cut at the area, but nowhere else") {
    // The rectangle from x = 1 to 12.5 goes on beyond the area, which ends at x = 8.
    const AdmittedScene scene = SceneBuilder({0, 0, 8, 8}).quad(1, 1, 12.5, 7, .25).build();
    struct Case {
        double left, right;
        bool is_right;
    };
    for (const Case& each : {Case{1, 12.5, true}, Case{1, 8, true}, Case{1, 8.25, false}, Case{1, 7.75, false},
                             Case{0, 8, false}, Case{0, 12.5, false}}) {
        CAPTURE(each.left);
        CAPTURE(each.right);
        const auto row = [&](event::Row& e) { return e.left = each.left, e.right = each.right, true; };
        CHECK(with_changed<event::Row>(scene, Method::warnock, row).wrong.has_value() != each.is_right);
        const auto line = [&](event::ShownLine& e) { return e.from.x = each.left, e.to.x = each.right, true; };
        CHECK(with_changed<event::ShownLine>(scene, Method::zbuffer, line).wrong.has_value() != each.is_right);
    }
}

TEST_CASE("Judging: the false claim of the first step is named, also if it is found after others") {
    // The window has four parts. The program reports one, and calls it empty, though the square covers it.
    const AdmittedScene scene = SceneBuilder({0, 0, 8, 8}).quad(-1, -1, 9, 9, .25).build();
    StudentRun run = run_of(scene, Method::warnock, "double", Edition::corrected, Detail::windows);
    run.events.erase(run.events.begin() + 2, run.events.end());  // the first window is pushed and popped
    run.events.push_back(event::Decide{Line::W13, Case::split});
    run.events.push_back(event::Push{Line::W13, {0, 0, 4, 4}, std::nullopt, std::nullopt});
    run.events.push_back(event::Pop{Line::W5, {0, 0, 4, 4}});
    run.events.push_back(event::Decide{Line::W7, Case::empty});
    run.events.push_back(event::Fill{Line::W7, {0, 0, 4, 4}, scene->background});
    CHECK(wrong_of(judgement_of(run)) ==
          "W13: these are all parts of the window (0, 0) of 8 x 8: pixel (4, 0) is in none of them");
}

TEST_CASE("Judging: a program that says float is judged by its numbers") {
    // z = x / 6, for example 1/12 at the first centre, which no float has.
    const AdmittedScene scene =
        SceneBuilder({0, 0, 4, 4}).polygon({{0, 0, 0}, {3, 0, .5}, {3, 3, .5}, {0, 3, 0}}).build();
    const auto reported = [&](auto depth) {
        const auto change = [&](event::Pixel& e) { return e.z = depth(e.z.number), false; };
        return with_changed<event::Pixel>(run_of(scene, Method::zbuffer, "float", Edition::corrected, Detail::signs),
                                          change);
    };
    const auto symptom = [](const Judgement& judgement) {
        return judgement.wrong ? std::optional(judgement.wrong->symptom) : std::nullopt;
    };
    CHECK_FALSE(symptom(reported([](double z) { return z; })));
    CHECK(symptom(reported([](double z) { return z + 4e-3; })) == Symptom::depth);
    CHECK(symptom(reported([](double z) { return double(float(z + 4e-3)); })) == Symptom::depth);
    CHECK_FALSE(symptom(reported([](double z) { return double(float(z + 0x1p-21)); })));
    // A float may be off by what 2^6 roundings add up to, but a number that is no float was not rounded to one.
    CHECK(symptom(reported([](double z) { return z + 0x1p-24 * (1 + 0x1p-20); })) == Symptom::depth);
}

TEST_CASE("Judging: numbers that happen to be floats do not make a program one in float") {
    // The text of a program's trace that says nothing of its precision: "double" is what the header writes by itself.
    const auto graded = [](const AdmittedScene& scene, const char* kernel, const std::string& from,
                           const std::string& to) {
        std::string text = run_of(scene, Method::zbuffer, kernel).trace;
        for (const auto& [old, by] : {std::pair<std::string, std::string>{"\"float\"", "\"double\""}, {from, to}}) {
            if (const auto at = text.find(old); at != std::string::npos) text.replace(at, old.size(), by);
        }
        return grade_trace(text, Grading{{}, Words()});
    };
    const AdmittedScene level = SceneBuilder({0, 0, 4, 4}).quad(0, 0, 4, 4, .25).build();
    CHECK(graded(level, "double", "", "").right());
    // 1/4 + 2^-24 is a float, too.
    const ProgramGrade off =
        graded(level, "double", "\"x\":0,\"y\":0,\"z\":0.25", "\"x\":0,\"y\":0,\"z\":0.250000059604644775390625");
    CHECK(off.precision == Precision::twice);
    REQUIRE(off.scenes.front().judgement);
    CHECK(wrong_of(*off.scenes.front().judgement) ==
          "L6: the depth of A at (0.5, 0.5) is 0.2500000596046448: it is 0.25");
    // z = x / 6: floats where the right depths are none.
    const AdmittedScene sixths =
        SceneBuilder({0, 0, 4, 4}).polygon({{0, 0, 0}, {3, 0, .5}, {3, 3, .5}, {0, 3, 0}}).build();
    const ProgramGrade single = graded(sixths, "float", "", "");
    CHECK(single.precision == Precision::single);
    CHECK(single.right());
}

TEST_CASE("Judging: the scenes for students show a bias of the depths, however the program computes") {
    // Painted by the depths z + 0.004 i of the polygons i, with nothing else reported, as a program in float.
    const auto is_wrong = [](const AdmittedScene& scene, double bias) {
        Scene biased = *scene;
        for (std::size_t i = 0; i < biased.polygons.size(); ++i) {
            for (auto& v : biased.polygons[i].vertices) v.z = std::clamp(v.z + bias * double(i), -1., 1.);
        }
        const AdmittedScene drawn = exact_scene::admit(std::move(biased));
        StudentRun run = run_of(drawn, Method::zbuffer, "float", Edition::corrected, Detail::windows);
        std::get<TraceHeader>(*run.header).scene = scene;
        std::erase_if(run.events, [](const Event& e) { return e.get_if<event::Clear>(); });
        return judgement_of(run).wrong.has_value();
    };
    int to_us = 0, away = 0;
    for (const AdmittedScene& scene : scenes_to_grade()) {
        if (!scene->name.starts_with("Depths")) continue;
        CAPTURE(scene->name);
        CHECK_FALSE(is_wrong(scene, 0));
        to_us += int(is_wrong(scene, 4e-3));
        away += int(is_wrong(scene, -4e-3));
    }
    // At the least those where depths are 2^-13 and 2^-10 apart, less than 0.004, and more than `float` leaves open.
    CHECK(to_us >= 2);
    CHECK(away >= 2);
}

TEST_CASE("Grading: wherever a trace is cut, it is cut short") {
    const std::string text = run_of(neighbours(), Method::zbuffer, "double").trace;
    const std::size_t first_line = text.find('\n') + 1, second_line = text.find('\n', first_line) + 1;
    for (const std::size_t length :
         {std::size_t(20), first_line - 1, first_line, first_line + 9, second_line, text.size() - 9}) {
        CAPTURE(length);
        const ProgramGrade grade = grade_trace(text.substr(0, length), Grading{{}, Words()});
        CHECK_FALSE(grade.right());
        const SceneGrade& scene = grade.scenes.front();
        CHECK(why_incomplete(scene.run, Words()) == "the trace is cut short");
        if (length > first_line)
            CHECK(report_of(grade, Grading{{}, Words()}).find("the trace is cut short.") != std::string::npos);
    }
}

TEST_CASE("Grading: a row between two rows is refused") {
    std::string text = run_of(neighbours(), Method::zbuffer, "double").trace;
    const std::string row = "\"row\":2,";
    text.replace(text.find(row), row.size(), "\"row\":2.5,");
    const ProgramGrade grade = grade_trace(text, Grading{{}, Words()});
    CHECK_FALSE(grade.right());
    CHECK(report_of(grade, Grading{{}, Words()}).find("/row: not a whole number") != std::string::npos);
}

TEST_CASE("Grading: a table has the faults that a trace reports") {
    // Row 4 and column 4 are outside, and the printed text paints them.
    const AdmittedScene scene = SceneBuilder({0, 0, 4, 4}).quad(0, 0, 4, 4, 0).build();
    const std::string text = run_of(scene, Method::zbuffer, "exact", Edition::printed).trace;
    const ProgramGrade grade = grade_trace(text, Grading{{}, Words()});
    REQUIRE(grade.faults().size() == 1);
    const auto json = nlohmann::json::parse(line_of("a.jsonl", grade, TableFormat::json, Words()).text);
    CHECK(json["faults"][0]["reason"] == "outside the area");
    CHECK(json["faults"][0]["at"] == "L6");
    const std::string csv = line_of("a.jsonl", grade, TableFormat::csv, Words(Language::russian)).text;
    CHECK(csv.ends_with(", L6: выход за пределы области\""));
    const std::string right = run_of(scene, Method::zbuffer, "exact").trace;
    CHECK(line_of("a.jsonl", grade_trace(right, Grading{{}, Words()}), TableFormat::csv, Words())
              .text.ends_with(",\"\""));
}

TEST_CASE("Grading: a report opens with the verdict and has one language") {
    const auto has_english = [](const std::string& text) {  // two Latin letters in a row, as not in the names x and y
        const auto is_small = [](char c) { return 'a' <= c && c <= 'z'; };
        const auto both = [&](char a, char b) { return is_small(a) && is_small(b); };
        return std::adjacent_find(text.begin(), text.end(), both) != text.end();
    };
    const Grading russian{{}, Words(Language::russian)};
    const auto report = [&](const std::string& text) { return report_of(grade_trace(text, russian), russian); };
    const AdmittedScene scene = SceneBuilder(area_16).polygon(far_quad).polygon(near_square).build();
    const std::string right = run_of(scene, Method::warnock, "double").trace;
    CHECK(report(right).starts_with("Верно, насколько сообщено: "));
    CHECK(report(run_of(scene, Method::warnock, "double", Edition::printed).trace).starts_with("Неверно: 1 из 1, "));
    std::string half = right;
    half.replace(half.find("\"count\":1"), 9, "\"count\":0.5");
    for (const std::string& text : {right, right.substr(0, right.size() / 2), half,
                                    run_of(scene, Method::zbuffer, "double", Edition::printed).trace}) {
        const std::string said = report(text);
        CAPTURE(said);
        CHECK_FALSE(has_english(said));
    }
    for (const AdmittedScene& each : scenes_to_grade(Language::russian)) {
        CAPTURE(each->name);
        CHECK_FALSE(has_english(each->name));
    }
    for (const Surface& each : surfaces_to_grade(Language::russian)) {
        CAPTURE(each.name);
        CHECK_FALSE(has_english(each.name));
    }
}

TEST_CASE("Judging: an incomplete trace is judged as far as it goes") {
    StudentRun run = run_of(neighbours(), Method::warnock, "double");
    run.events.erase(run.events.begin() + std::ptrdiff_t(run.events.size() / 2), run.events.end());
    run.complete = false;
    CHECK(wrong_of(judgement_of(run)) == "right");
    run.complete = true;
    CHECK(judgement_of(run).wrong.has_value());  // pixels are missing
}

TEST_CASE("A judge ignores the order of polygons and vertices in a scene") {
    const AdmittedScene scene = neighbours();
    Scene other = scene;
    std::swap(other.polygons[0], other.polygons[1]);
    std::reverse(other.polygons[0].vertices.begin(), other.polygons[0].vertices.end());
    CHECK(same_scene(other, scene));
    other.polygons[0].vertices[0].z = 0;
    CHECK_FALSE(same_scene(other, scene));
}

TEST_CASE("The text of a surface for a student's program") {
    const Surface surface{" Two lines",
                          CurveSceneBuilder({-2, 0, 3, 4}).curve({{-2, .1}, {0, 1}}).curve({{-1, 3}, {0, 2}}).build()};
    CHECK(scene_text(surface) == ": Two lines\n-2 0 3 4 \n2 \n2 \n-2 0.1 \n0 1 \n2 \n-1 3 \n0 2 \n");
}

TEST_CASE("The text of a scene for a student's program") {
    Scene scene = SceneBuilder({-2, 0, 3, 4}).polygon("a b", red, {{.1, 0, 0}, {1, 0, 0}, {0, 1, -.5}}).build();
    scene.name = "Of one\ntriangle";
    CHECK(scene_text(scene) ==
          ":Of one triangle\n-2 0 3 4 \n255 255 255 \n1 \n:a b\n255 0 0 \n3 \n0.1 0 0 \n1 0 0 \n0 1 -0.5 \n");
}
