// The procedures of the floating horizon on cases computed by hand, over all kernels, and against the rule by brute
// force. y grows downward: a curve with a smaller y is above.

#include "vidno/floating_horizon.h"

#include <doctest/doctest.h>

#include "support/kernels.h"
#include "support/random_curves.h"
#include "vidno/kernels/filtered_heights.h"
#include "vidno/printed_floating_horizon.h"

using namespace vidno;
using namespace vidno::test;

#define VIDNO_HORIZON_KERNELS VIDNO_PRINTED_KERNELS, Filtered

namespace {

/// A visible line in doubles.
struct Drawn {
    int curve;
    double x1, y1, x2, y2;
    bool operator==(const Drawn&) const = default;
};
using Lines = std::vector<Drawn>;

Lines in_doubles(const auto& lines) {
    Lines drawn;
    for (const auto& [segment, from, to] : lines) {
        drawn.push_back({segment.curve, as_double(from.point.x), as_double(from.point.y), as_double(to.point.x),
                         as_double(to.point.y)});
    }
    return drawn;
}

/// The visible lines of the last curve of a scene.
template <class K, class Set = CorrectedFloatingHorizon>
Lines last_lines(const AdmittedCurves& scene) {
    Lines drawn = in_doubles(visible_lines<Set>(scene, K{}).lines);
    std::erase_if(drawn, [&](const Drawn& line) { return line.curve != int(scene->curves.size()) - 1; });
    return drawn;
}

constexpr Area columns_17{0, 0, 17, 17};
const double no_point = std::nan("");

/// Level curves at 4 and 12, and one more: between them it is hidden.
AdmittedCurves between_4_and_12(std::vector<Sample> samples) {
    return CurveSceneBuilder(columns_17)
        .curve({{0, 12}, {16, 12}})
        .curve({{0, 4}, {16, 4}})
        .curve(std::move(samples))
        .build();
}

/// The left edge of the first two curves, from (left, 12) to (left + 4, 4), is at 10, 8, 6 over the columns between.
/// Behind it is the third curve, at 11; the edge that leads to this one, from (left + 4, 4) to (left - 1, 24), is at
/// 16, 12, 8 there.
AdmittedCurves behind_an_edge(int left) {
    return CurveSceneBuilder(columns_17)
        .curve({{left, 12}, {12, 12}})
        .curve({{left + 4, 4}, {12, 4}})
        .curve({{left - 1, 24}, {left, 11}, {12, 11}})
        .build();
}

/// A run whose horizons a scene has raised, for calling single procedures.
template <class K>
struct FloatingHorizonStage {
    AdmittedCurves scene;
    FloatingHorizonRun<CorrectedFloatingHorizon, OnColumns<K>, NoTrace> run;

    explicit FloatingHorizonStage(AdmittedCurves given)
        : scene(std::move(given)), run(scene, OnColumns<K>{}, NoTrace{}) {
        CorrectedFloatingHorizon::floating_horizon(run);
    }

    VisibilityFlag flag(double y, int column) {
        return CorrectedFloatingHorizon::visibility(run, Segment{0, {column, y}, {column + 1, y}}, column,
                                                    run.horizons);
    }
    double upper(int column) const { return as_double(*run.horizons.upper[column]); }
    double lower(int column) const { return as_double(*run.horizons.lower[column]); }
};

}  // namespace

TEST_CASE_TEMPLATE("Visibility: a point on a horizon is visible, one strictly between the two is not", K,
                   VIDNO_HORIZON_KERNELS) {
    using enum VisibilityFlag;
    FloatingHorizonStage<K> stage(
        CurveSceneBuilder(columns_17).curve({{0, 4}, {8, 4}}).curve({{0, 12}, {8, 4}}).build());
    // Over column 4 the second curve is at 8, over column 8 the two meet, and over column 9 there is nothing.
    CHECK(stage.flag(3, 4) == above);
    CHECK(stage.flag(4, 4) == above);
    CHECK(stage.flag(4.25, 4) == hidden);
    CHECK(stage.flag(7.75, 4) == hidden);
    CHECK(stage.flag(8, 4) == below);
    CHECK(stage.flag(9, 4) == below);
    CHECK(stage.flag(3, 8) == above);
    CHECK(stage.flag(4, 8) == both);
    CHECK(stage.flag(5, 8) == below);
    CHECK(stage.flag(5, 9) == both);
}

TEST_CASE_TEMPLATE("Horizon: higher points raise the upper horizon, lower points lower the lower one", K,
                   VIDNO_HORIZON_KERNELS) {
    // From (0, 2) to (8, 18) the segment is at 2 + 2 x.
    FloatingHorizonStage<K> stage(CurveSceneBuilder(columns_17).curve({{0, 8}, {8, 8}}).build());
    CorrectedFloatingHorizon::horizon(stage.run, Segment{1, {0, 2}, {8, 18}}, 1, 5);
    const double upper[]{8, 4, 6, 8, 8, 8, 8};
    const double lower[]{8, 8, 8, 8, 10, 12, 8};
    for (int x = 0; x < 7; ++x) {
        CAPTURE(x);
        CHECK(as_double(*stage.run.horizons.upper[x]) == upper[x]);
        CHECK(as_double(*stage.run.horizons.lower[x]) == lower[x]);
    }
    CHECK_FALSE(stage.run.horizons.upper[9].has_value());
}

TEST_CASE_TEMPLATE("Intersection: the first change on the way, between columns or on one", K, VIDNO_HORIZON_KERNELS) {
    // The horizon goes down from 2 at x = 0 to 6 at x = 4, and up again.
    FloatingHorizonStage<K> stage(CurveSceneBuilder(columns_17).curve({{0, 2}, {4, 6}, {8, 2}}).build());
    const auto meets = [&](const Segment& segment, int first, int last) {
        return CorrectedFloatingHorizon::intersection(stage.run, segment, first, last, stage.run.horizons.upper,
                                                      VisibilityFlag::above);
    };
    // A level one at 4.5 meets it at 2.5 and 5.5, one at 4 on the columns 2 and 6.
    const auto between = meets({1, {0, 4.5}, {8, 4.5}}, 0, 8);
    CHECK(as_double(between.point.x) == 2.5);
    CHECK(as_double(between.point.y) == 4.5);
    CHECK(between.left == 2);
    CHECK(between.right == 3);
    CHECK(as_double(meets({1, {0, 4.5}, {8, 4.5}}, 3, 8).point.x) == 5.5);
    const auto on_column = meets({1, {0, 4}, {8, 4}}, 0, 8);
    CHECK(as_double(on_column.point.x) == 2);
    CHECK(on_column.on_column());
    CHECK_MESSAGE(meets({1, {0, 1}, {8, 1}}, 0, 8).left == 8, "none: the last column");
    CHECK_MESSAGE(meets({1, {6, 7}, {10, 7}}, 6, 10).left == 8, "where the horizon ends");
}

TEST_CASE_TEMPLATE("SideEdge: over the columns between the ends of two curves, either way", K, VIDNO_HORIZON_KERNELS) {
    // The left edge from (6, 4) to (2, 12) is at 10, 8, 6 over the columns 3, 4, 5, the right one from (10, 4) to (14,
    // 12) at 6, 8, 10 over 11, 12, 13.
    FloatingHorizonStage<K> stage(
        CurveSceneBuilder(columns_17).curve({{6, 4}, {10, 4}}).curve({{2, 12}, {14, 12}}).build());
    const double upper[]{12, 10, 8, 6, 4, 4, 4, 4, 4, 6, 8, 10, 12};
    for (int x = 2; x <= 14; ++x) {
        CAPTURE(x);
        CHECK(stage.upper(x) == upper[x - 2]);
        CHECK(stage.lower(x) == 12);
    }
    CHECK_FALSE(stage.run.horizons.upper[1].has_value());
    CHECK_FALSE(stage.run.horizons.lower[15].has_value());
}

TEST_CASE_TEMPLATE("Two lines that cross between columns are cut there", K, VIDNO_HORIZON_KERNELS) {
    // 13.5 - x is 8 at x = 5.5: below the first line before, above it after.
    const auto scene = CurveSceneBuilder(columns_17).curve({{0, 8}, {12, 8}}).curve({{0, 13.5}, {12, 1.5}}).build();
    CHECK(in_doubles(visible_lines(scene, K{}).lines) ==
          Lines{{0, 0, 8, 12, 8}, {1, 0, 13.5, 5.5, 8}, {1, 5.5, 8, 12, 1.5}});
}

TEST_CASE_TEMPLATE("Two lines that cross on a column: the second is not broken", K, VIDNO_HORIZON_KERNELS) {
    const auto scene = CurveSceneBuilder(columns_17).curve({{0, 8}, {12, 8}}).curve({{0, 14}, {12, 2}}).build();
    CHECK(last_lines<K>(scene) == Lines{{1, 0, 14, 12, 2}});
}

TEST_CASE_TEMPLATE("From above to below in one segment, and back: hidden in the middle", K, VIDNO_HORIZON_KERNELS) {
    // 2.5 + x is 4 at 1.5 and 12 at 9.5; 14.5 - x is 12 at 2.5 and 4 at 10.5.
    CHECK(last_lines<K>(between_4_and_12({{0, 2.5}, {12, 14.5}})) ==
          Lines{{2, 0, 2.5, 1.5, 4}, {2, 9.5, 12, 12, 14.5}});
    CHECK(last_lines<K>(between_4_and_12({{0, 14.5}, {12, 2.5}})) ==
          Lines{{2, 0, 14.5, 2.5, 12}, {2, 10.5, 4, 12, 2.5}});
    // Within a single column: from 0 to 16 it is 4 at 1/4 and 12 at 3/4 of the way.
    CHECK(last_lines<K>(between_4_and_12({{5, 0}, {6, 16}})) == Lines{{2, 5, 0, 5.25, 4}, {2, 5.75, 12, 6, 16}});
}

TEST_CASE_TEMPLATE("A segment that is hidden at both ends is hidden everywhere", K, VIDNO_HORIZON_KERNELS) {
    CHECK(last_lines<K>(between_4_and_12({{0, 4.25}, {7, 11.75}, {12, 5}})).empty());
}

TEST_CASE_TEMPLATE("A curve that touches a horizon is visible there: a point", K, VIDNO_HORIZON_KERNELS) {
    CHECK_MESSAGE((last_lines<K>(between_4_and_12({{0, 8}, {4, 4}, {8, 8}})) == Lines{{2, 4, 4, 4, 4}}), "at a sample");
    CHECK(last_lines<K>(between_4_and_12({{0, 8}, {4, 12}, {8, 8}})) == Lines{{2, 4, 12, 4, 12}});
    CHECK_MESSAGE((last_lines<K>(between_4_and_12({{0, 4}, {4, 8}})) == Lines{{2, 0, 4, 0, 4}}), "at its beginning");
    CHECK_MESSAGE((last_lines<K>(between_4_and_12({{0, 8}, {4, 12}})) == Lines{{2, 4, 12, 4, 12}}), "at its end");
    // A horizon that is lowest at 6, over column 4, in the middle of a segment at 6.
    const auto scene = CurveSceneBuilder(columns_17)
                           .curve({{0, 12}, {8, 12}})
                           .curve({{0, 2}, {4, 6}, {8, 2}})
                           .curve({{0, 6}, {8, 6}})
                           .build();
    CHECK(last_lines<K>(scene) == Lines{{2, 4, 6, 4, 6}});
}

TEST_CASE_TEMPLATE("A curve on a horizon is visible all along, and so is the same curve again", K,
                   VIDNO_HORIZON_KERNELS) {
    CHECK(last_lines<K>(between_4_and_12({{0, 4}, {12, 4}})) == Lines{{2, 0, 4, 12, 4}});
    const auto scene =
        CurveSceneBuilder(columns_17).curve({{0, 4}, {3, 8}, {5, 1}}).curve({{0, 4}, {3, 8}, {5, 1}}).build();
    CHECK(last_lines<K>(scene) == Lines{{1, 0, 4, 3, 8}, {1, 3, 8, 5, 1}});
}

TEST_CASE_TEMPLATE("What begins where both horizons meet, and goes on below, is one line", K, VIDNO_HORIZON_KERNELS) {
    const auto scene = CurveSceneBuilder(columns_17).curve({{0, 8}, {8, 8}}).curve({{0, 8}, {8, 16}}).build();
    CHECK(last_lines<K>(scene) == Lines{{1, 0, 8, 8, 16}});
}

TEST_CASE_TEMPLATE("A peak between two samples hides what is behind it", K, VIDNO_HORIZON_KERNELS) {
    // The peak rises from 8 at x = 4 to 2 at x = 6: it is at 5 at x = 5 and, going down, at x = 7.
    const auto scene = CurveSceneBuilder(columns_17)
                           .curve({{0, 8}, {4, 8}, {6, 2}, {8, 8}, {12, 8}})
                           .curve({{0, 14}, {12, 14}})
                           .curve({{0, 5}, {12, 5}})
                           .build();
    CHECK(last_lines<K>(scene) == Lines{{2, 0, 5, 5, 5}, {2, 7, 5, 12, 5}});
}

TEST_CASE_TEMPLATE("A curve does not hide itself", K, VIDNO_HORIZON_KERNELS) {
    // From (1, 3) to (2, 7) it dips under the horizon at 4 a quarter of the way.
    CHECK(last_lines<K>(between_4_and_12({{0, 2}, {1, 3}, {2, 7}})) == Lines{{2, 0, 2, 1, 3}, {2, 1, 3, 1.25, 4}});
    CHECK_MESSAGE((last_lines<K>(between_4_and_12({{2, 3}, {3, 7}})) == Lines{{2, 2, 3, 2.25, 4}}),
                  "nor does the side edge that leads to it");
}

TEST_CASE_TEMPLATE("There is no horizon beside the nearer curves", K, VIDNO_HORIZON_KERNELS) {
    const auto scene =
        CurveSceneBuilder(columns_17).curve({{4, 12}, {8, 12}}).curve({{4, 4}, {8, 4}}).curve({{3, 8}, {9, 8}}).build();
    CHECK(last_lines<K>(scene) == Lines{{2, 3, 8, 4, 8}, {2, 8, 8, 9, 8}});
}

TEST_CASE_TEMPLATE("The side of the surface hides what is behind it, also from x = 1", K, VIDNO_HORIZON_KERNELS) {
    // At `left` the upper horizon is at 12, and by the edge over the next column at 10: 11 is halfway.
    for (const int left : {1, 2}) {
        CAPTURE(left);
        CHECK(last_lines<K>(behind_an_edge(left)) ==
              Lines{{2, left - 1., 24, left + 0., 11}, {2, left + 0., 11, left + .5, 11}});
    }
}

TEST_CASE_TEMPLATE("Curves beyond the screen and columns left of 0 are treated like others", K, VIDNO_HORIZON_KERNELS) {
    const auto scene = CurveSceneBuilder({-8, 0, 9, 8})
                           .curve({{-8, 20}, {0, 20}})
                           .curve({{-8, 14}, {0, 14}})
                           .curve({{-8, 13}, {0, 21}})
                           .build();
    CHECK(in_doubles(visible_lines(scene, K{}).lines) ==
          Lines{{0, -8, 20, 0, 20}, {1, -8, 14, 0, 14}, {2, -8, 13, -7, 14}, {2, -1, 20, 0, 21}});
}

TEST_CASE("Pieces of a curve: samples that have points, at least two side by side") {
    const auto columns = [](const std::vector<Sample>& samples) {
        std::vector<std::vector<int>> found;
        const Curve curve{samples};
        for (const Piece& piece : pieces_of(curve)) {
            found.emplace_back();
            for (const Sample& sample : piece) found.back().push_back(sample.x);
        }
        return found;
    };
    using Columns = std::vector<std::vector<int>>;
    CHECK(columns({{0, 1}, {2, 1}, {5, 1}}) == Columns{{0, 2, 5}});
    CHECK(columns({{0, no_point}, {1, 1}, {2, 1}, {3, no_point}, {4, no_point}, {5, 1}, {6, 1}}) ==
          Columns{{1, 2}, {5, 6}});
    CHECK(columns({{0, 1}, {1, HUGE_VAL}, {2, 1}, {3, -HUGE_VAL}, {4, 1}, {5, 1}}) == Columns{{4, 5}});
    CHECK(columns({{0, no_point}, {1, 1}, {2, no_point}}).empty());
}

TEST_CASE_TEMPLATE("A gap is not drawn, hides nothing, and leaves the horizons as they are", K, VIDNO_HORIZON_KERNELS) {
    const std::vector<Sample> with_gap{{0, 4}, {4, 4}, {8, no_point}, {12, 4}, {16, 4}};
    FloatingHorizonStage<K> alone(CurveSceneBuilder(columns_17).curve(with_gap).build());
    CHECK(in_doubles(alone.run.lines) == Lines{{0, 0, 4, 4, 4}, {0, 12, 4, 16, 4}});
    for (int x = 0; x < 17; ++x) {
        CAPTURE(x);
        CHECK(alone.run.horizons.upper[x].has_value() == (x <= 4 || x >= 12));
        CHECK(alone.run.horizons.lower[x].has_value() == (x <= 4 || x >= 12));
    }
    // A curve at 8 is hidden between those at 4 and at 12. Over the gap both horizons are at 12. From column 4 to
    // column 5 the upper one goes from 4 down to 12, and passes 8 halfway; likewise back from column 11 to column 12.
    const auto scene =
        CurveSceneBuilder(columns_17).curve(with_gap).curve({{0, 12}, {16, 12}}).curve({{0, 8}, {16, 8}}).build();
    CHECK(last_lines<K>(scene) == Lines{{2, 4.5, 8, 11.5, 8}});
}

TEST_CASE_TEMPLATE("Side edges lead to the outer ends of a curve's pieces", K, VIDNO_HORIZON_KERNELS) {
    // The edges are at 10, 8, 6 over the columns 3, 4, 5, and at 6, 8, 10 over 11, 12, 13, as without gaps.
    FloatingHorizonStage<K> stage(
        CurveSceneBuilder(columns_17)
            .curve({{6, 4}, {10, 4}})
            .curve({{0, no_point}, {2, 12}, {4, 12}, {6, no_point}, {12, 12}, {14, 12}, {16, no_point}})
            .build());
    const double upper[]{12, 10, 8, 6, 4, 4, 4, 4, 4, 6, 8, 10, 12};
    const double lower[]{12, 12, 12, 6, 4, 4, 4, 4, 4, 6, 12, 12, 12};
    for (int x = 2; x <= 14; ++x) {
        CAPTURE(x);
        CHECK(stage.upper(x) == upper[x - 2]);
        CHECK(stage.lower(x) == lower[x - 2]);
    }
    CHECK_FALSE(stage.run.horizons.upper[1].has_value());
    CHECK_FALSE(stage.run.horizons.upper[15].has_value());
}

TEST_CASE_TEMPLATE("Side edges end before a curve that has no piece", K, VIDNO_HORIZON_KERNELS) {
    // One curve has no points, the other a single one, over column 8, to which nothing leads.
    const std::vector<std::vector<Sample>> without_piece{{{2, no_point}, {14, no_point}},
                                                         {{2, no_point}, {8, 20}, {14, no_point}}};
    for (const auto& samples : without_piece) {
        FloatingHorizonStage<K> stage(
            CurveSceneBuilder(columns_17).curve({{6, 4}, {10, 4}}).curve(samples).curve({{2, 12}, {14, 12}}).build());
        for (int x = 2; x <= 14; ++x) {
            CAPTURE(x);
            CHECK(stage.upper(x) == (6 <= x && x <= 10 ? 4 : 12));
            CHECK(stage.lower(x) == 12);
        }
        CHECK(in_doubles(stage.run.lines) == Lines{{0, 6, 4, 10, 4}, {2, 2, 12, 14, 12}});
    }
}

TEST_CASE_TEMPLATE("No curves: no lines, no horizons", K, VIDNO_HORIZON_KERNELS) {
    const auto visible = visible_lines(CurveSceneBuilder(columns_17).build(), K{});
    CHECK(visible.lines.empty());
    for (int x = 0; x < 17; ++x) CHECK_FALSE((visible.horizons.upper[x] || visible.horizons.lower[x]));
}

namespace {

/// The labels of the listing's lines, in the order of the run's events.
struct HearLabels : NoTrace {
    std::string* reported;
    explicit HearLabels(std::string& to) : reported(&to) {}

    void hear(Line at) { *reported += std::string(line_names[std::size_t(at)]) + ' '; }
    void horizons(Line at, const auto&) { hear(at); }
    void curve(Line at, int) { hear(at); }
    void side_edge(Line at, const auto&) { hear(at); }
    void horizon(Line at, const auto&, int, int) { hear(at); }
    void visibility(Line at, const auto&, int, auto) { hear(at); }
    void intersection(Line at, const auto&, const auto&) { hear(at); }
    void draw_line(Line at, const auto&, const auto&, const auto&) { hear(at); }
    void raise(Line at, int, const auto&) { hear(at); }
    void lower(Line at, int, const auto&) { hear(at); }
    void step(Line at, int, bool) { hear(at); }
};

}  // namespace

TEST_CASE("A run of the floating horizon reports each line of the listing that it reaches") {
    // The second curve is below the first over column 0, and crosses it halfway to column 1.
    std::string reported;
    const auto scene = CurveSceneBuilder({0, 0, 2, 4}).curve({{0, 2}, {1, 2}}).curve({{0, 3}, {1, 1}}).build();
    visible_lines(scene, Double{}, HearLabels(reported));
    CHECK(reported ==
          "FH1 FH2 FH3 FH4 FH5 FH6 H2 H3 H2 H3 FH6 FH10 "
          "FH2 SE2 FH3 FH4 FH5 IN2 FH7 FH7 H3 FH7 IN2 FH8 FH8 H2 FH8 SE2 FH10 ");
}

// ------------------------------------------------------------------------------------- against the rule

namespace {

/// For each curve, whether it is found visible over its columns.
struct HearVisibility : NoTrace {
    std::vector<std::vector<bool>>* reported;
    explicit HearVisibility(std::vector<std::vector<bool>>& to) : reported(&to) {}

    void curve(Line, int) { reported->emplace_back(); }
    void visibility(Line, const auto&, int, VisibilityFlag flag) {
        reported->back().push_back(flag != VisibilityFlag::hidden);
    }
};

template <class K>
auto seen_by(const AdmittedCurves& scene) {
    struct Seen {
        VisibleCurves<OnColumns<K>> result;
        std::vector<std::vector<bool>> visible;
    };
    std::vector<std::vector<bool>> visible;
    auto result = visible_lines(scene, K{}, HearVisibility(visible));
    return Seen{std::move(result), std::move(visible)};
}

std::vector<std::vector<bool>> visible_by(const FloatingHorizonReference& reference) {
    std::vector<std::vector<bool>> visible;
    for (const auto& curve : reference.curves()) visible.push_back(curve.visible);
    return visible;
}

const Rational& exactly(const Rational& height) { return height; }
Rational exactly(const OnColumns<Filtered>::Height& height) { return height.exactly(); }

void check_horizons(const auto& horizons, const FloatingHorizonReference& reference, const Area& area) {
    const auto same = [](const auto& cell, const FloatingHorizonReference::Cell& expected) {
        return cell.has_value() == expected.has_value() && (!cell || exactly(*cell) == *expected);
    };
    for (int x = area.x; x < area.right(); ++x) {
        CHECK(same(horizons.upper[x], reference.upper(x)));
        CHECK(same(horizons.lower[x], reference.lower(x)));
    }
}

/// Checks that the exact lines are the parts of the rule, cut at samples, none twice.
void check_lines(const auto& lines, const FloatingHorizonReference& reference, const AdmittedCurves& scene) {
    std::vector<std::vector<FloatingHorizonReference::Interval>> drawn(scene->curves.size());
    for (const auto& [segment, from, to] : lines) {
        const Curve& curve = scene->curves[std::size_t(segment.curve)];
        CHECK(segment.from.x <= from.point.x);
        CHECK(from.point.x <= to.point.x);
        CHECK(to.point.x <= segment.to.x);
        for (const auto& [point, left, right] : {from, to}) {
            CHECK(point.y == FloatingHorizonReference::height(curve, point.x));
            CHECK((left == right ? point.x == left : left < point.x && point.x < right && right == left + 1));
        }
        auto& parts = drawn[std::size_t(segment.curve)];
        CHECK_MESSAGE((parts.empty() || parts.back().last <= from.point.x), "from left to right");
        parts.push_back({from.point.x, to.point.x});
    }
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        CHECK(FloatingHorizonReference::united(drawn[i]) == reference.curves()[i].parts);
    }
}

/// Checks that the ends differ only by rounding, invisibly and within the bound, and are next to the same columns.
void check_same_lines(const auto& filtered, const auto& exact) {
    REQUIRE(filtered.size() == exact.size());
    const auto near = [](const Bounded& a, const Rational& b) {
        return a.error <= 0x1p-20 && Rational(a.low()) <= b && b <= Rational(a.high());
    };
    const auto same = [&](const auto& a, const auto& b) {
        return a.left == b.left && a.right == b.right && near(a.point.x, b.point.x) && near(a.point.y, b.point.y);
    };
    for (std::size_t i = 0; i < exact.size(); ++i) {
        CHECK(filtered[i].segment == exact[i].segment);
        CHECK(same(filtered[i].from, exact[i].from));
        CHECK(same(filtered[i].to, exact[i].to));
    }
}

void check_against_rule(const AdmittedCurves& scene, const FloatingHorizonReference& reference) {
    const auto exact = seen_by<Exact>(scene);
    CHECK(exact.visible == visible_by(reference));
    check_horizons(exact.result.horizons, reference, scene->area);
    check_lines(exact.result.lines, reference, scene);

    const auto filtered = seen_by<Filtered>(scene);
    CHECK(filtered.visible == exact.visible);
    check_horizons(filtered.result.horizons, reference, scene->area);
    check_same_lines(filtered.result.lines, exact.result.lines);
}

}  // namespace

TEST_CASE("Exact and filtered draw what the rule says, on thousands of random and degenerate curves") {
    RandomCurves random(11);
    int points = 0, cuts = 0, hidden = 0;
    for (int i = 0; i < 4000; ++i) {
        CAPTURE(i);
        const AdmittedCurves scene = random.scene();
        const FloatingHorizonReference reference(scene);
        check_against_rule(scene, reference);
        for (const auto& curve : reference.curves()) {
            hidden += curve.parts.empty() ? 1 : 0;
            cuts += curve.parts.size() > 1 ? 1 : 0;
            for (const auto& [first, last] : curve.parts) points += first == last ? 1 : 0;
        }
    }
    CHECK(points > 500);
    CHECK(cuts > 500);
    CHECK(hidden > 300);
}

TEST_CASE("Exact and filtered draw what the rule says, on random curves with gaps") {
    RandomCurves random(14);
    int in_pieces = 0, without_piece = 0;
    for (int i = 0; i < 3000; ++i) {
        CAPTURE(i);
        const AdmittedCurves scene = with_gaps(random.scene(), random);
        check_against_rule(scene, FloatingHorizonReference(scene));
        for (const Curve& curve : scene->curves) {
            in_pieces += pieces_of(curve).size() > 1 ? 1 : 0;
            without_piece += pieces_of(curve).empty() ? 1 : 0;
        }
    }
    CHECK(in_pieces > 500);
    CHECK(without_piece > 1000);
}

TEST_CASE("Next to coincidences: filtered is right, and double is not") {
    RandomCurves random(13);
    int wrong_in_double = 0;
    for (int i = 0; i < 2000; ++i) {
        CAPTURE(i);
        const AdmittedCurves scene = moved_by_ulps(random.scene(), random);
        const FloatingHorizonReference reference(scene);
        check_against_rule(scene, reference);
        wrong_in_double += seen_by<Double>(scene).visible == visible_by(reference) ? 0 : 1;
    }
    CHECK(wrong_in_double > 100);
}

namespace {

struct CountExact {
    int* exact;
    void operator()(FilterStage stage) const { *exact += stage == FilterStage::exact ? 1 : 0; }
};

}  // namespace

TEST_CASE("Filtered uses exact arithmetic only where heights are nearly equal") {
    const auto asked = [](std::vector<Sample> samples) {
        int exact = 0;
        visible_lines(between_4_and_12(std::move(samples)), FilteredBy(CountExact{&exact}));
        return exact;
    };
    CHECK(asked({{0, 2.5}, {7, 9.1}, {12, 14.5}}) == 0);
    // At x = 3 it is at 3 + 3/3 = 4, which no bound distinguishes from the horizon's 4.
    CHECK(asked({{0, 3}, {9, 6}}) > 0);
}

TEST_CASE("Heights that overflow are still compared right") {
    // From -1.5 * 2^1023 to 1.5 * 2^1023 is a longer way than any double holds; halfway the curve is at 0, and hidden.
    const double far = 0x1.8p1023;
    const auto scene = CurveSceneBuilder({0, 0, 5, 8})
                           .curve({{0, 1}, {4, 1}})
                           .curve({{0, -1}, {4, -1}})
                           .curve({{0, -far}, {4, far}})
                           .build();
    const FloatingHorizonReference reference(scene);
    const auto filtered = seen_by<Filtered>(scene);
    CHECK(filtered.visible == visible_by(reference));
    CHECK_FALSE(filtered.visible[2][2]);
    check_horizons(filtered.result.horizons, reference, scene->area);
    const auto& lines = filtered.result.lines;
    REQUIRE(lines.size() == 4);
    CHECK(lines[2].to.point.x.value == doctest::Approx(2));
    CHECK(std::abs(lines[2].to.point.y.value + 1) < 1e-12);
}

// ------------------------------------------------------------------------------------- every kernel and edition, over
// gaps

namespace {

template <class Set, class K>
void check_gaps(const AdmittedCurves& scene) {
    for (const auto& line : visible_lines<Set>(scene, K{}).lines) {
        const Curve& curve = scene->curves[std::size_t(line.segment.curve)];
        CHECK(line.segment.from.has_point());
        CHECK(line.segment.to.has_point());
        CHECK(FloatingHorizonReference::reaches(curve, as_double(line.from.point.x)));
        CHECK(FloatingHorizonReference::reaches(curve, as_double(line.to.point.x)));
    }
    const auto of_first = visible_lines<Set>(admit(CurveScene{scene->area, {scene->curves[0]}}), K{}).horizons;
    const auto initial = Set::first_horizons(OnColumns<K>{}, scene->area);
    const auto same = [](const auto& one, const auto& other) {
        return one.has_value() == other.has_value() && (!one || as_double(*one) == as_double(*other));
    };
    for (int x = scene->area.x; x < scene->area.right(); ++x) {
        if (FloatingHorizonReference::reaches(scene->curves[0], x)) continue;
        CHECK(same(of_first.upper[x], initial.upper[x]));
        CHECK(same(of_first.lower[x], initial.lower[x]));
    }
}

}  // namespace

TEST_CASE_TEMPLATE("Over random gaps no kernel and no edition draws a line, or moves a horizon", K,
                   VIDNO_HORIZON_KERNELS) {
    RandomCurves random(18);
    for (int i = 0; i < 300; ++i) {
        CAPTURE(i);
        const AdmittedCurves scene = with_gaps(random.scene(), random);
        check_gaps<CorrectedFloatingHorizon, K>(scene);
        if constexpr (PrintedKernel<K>) check_gaps<PrintedFloatingHorizon, K>(scene);
    }
}

// ------------------------------------------------------------------------------------- the printed text

namespace {

// Sets with one defect each.
struct OnlyEdgeStart : CorrectedFloatingHorizon {
    static bool no_edge_yet(const std::optional<Sample>& edge) { return PrintedFloatingHorizon::no_edge_yet(edge); }
};
struct OnlyFlagTest : CorrectedFloatingHorizon {
    static bool draws(VisibilityFlag side) { return PrintedFloatingHorizon::draws(side); }
};
struct OnlyXH2 : CorrectedFloatingHorizon {
    static VisibilityFlag horizon_met(VisibilityFlag was, VisibilityFlag is) {
        return PrintedFloatingHorizon::horizon_met(was, is);
    }
};
struct OnlyXH3 : CorrectedFloatingHorizon {
    static auto first_horizons(const auto& kernel, const Area& area) {
        return PrintedFloatingHorizon::first_horizons(kernel, area);
    }
};
struct OnlyOwnHorizon : CorrectedFloatingHorizon {
    static const auto& horizons_before(const auto& horizons, auto& kept) {
        return PrintedFloatingHorizon::horizons_before(horizons, kept);
    }
};
struct OnlyEdgeEnds : CorrectedFloatingHorizon {
    static auto edge_columns(const Segment& edge) { return PrintedFloatingHorizon::edge_columns(edge); }
};
struct OnlyXH5 : CorrectedFloatingHorizon {
    static int next_column(const Segment& segment, int column) {
        return PrintedFloatingHorizon::next_column(segment, column);
    }
};
struct OnlyXH6 : CorrectedFloatingHorizon {
    static VisibilityFlag flag_on_both() { return PrintedFloatingHorizon::flag_on_both(); }
};

}  // namespace

TEST_CASE_TEMPLATE("X-H1: a side edge at x = 1 counts as no edge", K, VIDNO_PRINTED_KERNELS) {
    // Without the edge the upper horizon stays at 12 up to x = 3, and goes to 8 over the next column: it is at 11 a
    // quarter of the way.
    CHECK(last_lines<K, CorrectedFloatingHorizon>(behind_an_edge(1)) == Lines{{2, 0, 24, 1, 11}, {2, 1, 11, 1.5, 11}});
    CHECK(last_lines<K, OnlyEdgeStart>(behind_an_edge(1)) == Lines{{2, 0, 24, 1, 11}, {2, 1, 11, 3.25, 11}});
    CHECK_MESSAGE(
        (last_lines<K, OnlyEdgeStart>(behind_an_edge(2)) == last_lines<K, CorrectedFloatingHorizon>(behind_an_edge(2))),
        "at x = 2 it is one");
}

TEST_CASE_TEMPLATE("X-H1: a segment that is below at both ends is not drawn and lowers no horizon", K,
                   VIDNO_PRINTED_KERNELS) {
    const auto scene = CurveSceneBuilder(columns_17).curve({{0, 4}, {8, 4}}).curve({{0, 12}, {8, 12}}).build();
    CHECK(last_lines<K, CorrectedFloatingHorizon>(scene) == Lines{{1, 0, 12, 8, 12}});
    CHECK(last_lines<K, OnlyFlagTest>(scene).empty());
    const auto printed = visible_lines<PrintedFloatingHorizon>(scene, K{});
    CHECK(printed.lines.size() == 1);
    CHECK(as_double(*printed.horizons.lower[4]) == 4);
}

TEST_CASE_TEMPLATE("X-H2: a segment that emerges below is cut by the upper horizon", K, VIDNO_PRINTED_KERNELS) {
    // 9.5 + x is 12 at 2.5. It never meets the upper horizon, so the cut is at the end of the step: the next column or,
    // as printed, the next sample.
    const auto scene = between_4_and_12({{0, 9.5}, {8, 17.5}});
    CHECK(last_lines<K, CorrectedFloatingHorizon>(scene) == Lines{{2, 2.5, 12, 8, 17.5}});
    CHECK(last_lines<K, OnlyXH2>(scene) == Lines{{2, 3, 12.5, 8, 17.5}});
    CHECK(last_lines<K, PrintedFloatingHorizon>(scene) == Lines{{2, 8, 17.5, 8, 17.5}});
}

TEST_CASE_TEMPLATE("X-H3: a curve beyond the screen hides curves that are not behind it", K, VIDNO_PRINTED_KERNELS) {
    // Both are below the screen; the second is above the first, and below the upper horizon's start.
    const auto scene = CurveSceneBuilder({0, 0, 9, 8}).curve({{0, 20}, {8, 20}}).curve({{0, 14}, {8, 14}}).build();
    CHECK(last_lines<K, CorrectedFloatingHorizon>(scene) == Lines{{1, 0, 14, 8, 14}});
    CHECK(last_lines<K, OnlyXH3>(scene).empty());
}

TEST_CASE_TEMPLATE("X-H4: a curve is compared with horizons that it raised itself, and with its own side edge", K,
                   VIDNO_PRINTED_KERNELS) {
    const auto dips = between_4_and_12({{0, 2}, {1, 3}, {2, 7}});
    CHECK(last_lines<K, CorrectedFloatingHorizon>(dips) == Lines{{2, 0, 2, 1, 3}, {2, 1, 3, 1.25, 4}});
    CHECK(last_lines<K, OnlyOwnHorizon>(dips) == Lines{{2, 0, 2, 1, 3}});
    const auto begins = between_4_and_12({{2, 3}, {3, 7}});
    CHECK(last_lines<K, CorrectedFloatingHorizon>(begins) == Lines{{2, 2, 3, 2.25, 4}});
    CHECK(last_lines<K, OnlyEdgeEnds>(begins) == Lines{{2, 2, 3, 2, 3}});
}

TEST_CASE_TEMPLATE("X-H5: a peak between two samples hides nothing", K, VIDNO_PRINTED_KERNELS) {
    const auto scene = CurveSceneBuilder(columns_17)
                           .curve({{0, 14}, {12, 14}})
                           .curve({{0, 8}, {4, 8}, {6, 2}, {8, 8}, {12, 8}})
                           .curve({{0, 5}, {12, 5}})
                           .build();
    CHECK(last_lines<K, CorrectedFloatingHorizon>(scene) == Lines{{2, 0, 5, 5, 5}, {2, 7, 5, 12, 5}});
    CHECK(last_lines<K, OnlyXH5>(scene) == Lines{{2, 0, 5, 12, 5}});
    CHECK(last_lines<K, PrintedFloatingHorizon>(scene) == Lines{{2, 0, 5, 12, 5}});
}

TEST_CASE_TEMPLATE("X-H6: a segment from where both horizons meet to below them counts as a crossing", K,
                   VIDNO_PRINTED_KERNELS) {
    // The curve reaches the lower horizon over both columns, so there is no change, and the line begins at the second.
    const auto scene = CurveSceneBuilder(columns_17).curve({{0, 8}, {8, 8}}).curve({{0, 8}, {8, 16}}).build();
    CHECK(last_lines<K, CorrectedFloatingHorizon>(scene) == Lines{{1, 0, 8, 8, 16}});
    CHECK(last_lines<K, OnlyXH6>(scene) == Lines{{1, 0, 8, 0, 8}, {1, 1, 9, 8, 16}});
}

TEST_CASE_TEMPLATE("The printed floating horizon runs to its end on all curves", K, VIDNO_PRINTED_KERNELS) {
    RandomCurves random(17);
    for (int i = 0; i < 300; ++i) {
        const AdmittedCurves scene = random.scene();
        CHECK_FALSE(visible_lines<PrintedFloatingHorizon>(scene, K{}).lines.empty());
    }
}
