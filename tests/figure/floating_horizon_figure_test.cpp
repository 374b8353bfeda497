// Figures of a run of curves: the layout of a small drawing that can be computed by hand.

#include <doctest/doctest.h>

#include <cmath>

#include "figure/figure.h"
#include "figure/floating_horizon_parts.h"
#include "figure/writers.h"
#include "refused.h"
#include "support/curves.h"

namespace vidno::figures {

namespace {

constexpr Area columns_9{0, 0, 9, 16};

/// 10 mm a pixel, without a margin.
const Plane plane_90{columns_9, 10, {0, 0}, {0, 0, 90, 160}};

/// A level curve at 8 over the columns 0 to 4, and one that comes from below and crosses it at (2.5, 8).
FloatingHorizonHeader crossing_curves() {
    return {Edition::corrected,
            "double",
            Detail::signs,
            {"", test::CurveSceneBuilder(columns_9).curve({{0, 8}, {4, 8}}).curve({{0, 13}, {4, 5}}).build()}};
}

/// The first curve is drawn and has raised both horizons; two parts of the second one are drawn.
std::vector<Event> some_events() {
    const std::vector<ColumnHeight> level{{0, 8}, {1, 8}, {2, 8}, {3, 8}, {4, 8}};
    return {event::Horizons{Line::FH1, {}, {}},
            event::Curve{Line::FH2, 0},
            event::DrawLine{Line::FH6, {0, 4}, {0, 8}, {0, 0}, {4, 8}, {4, 4}},
            event::Call{Line::FH6, Procedure::horizon},
            event::Horizon{Line::FH6, 0, 4, level, level},
            event::Curve{Line::FH2, 1},
            event::Call{Line::FH4, Procedure::visibility},
            event::Visibility{Line::FH4, {0, 4}, 0, VisibilityFlag::below, {}},
            event::DrawLine{Line::FH7, {0, 4}, {0, 13}, {0, 0}, {2.5, 8}, {2, 3}},
            event::DrawLine{Line::FH8, {0, 4}, {2.5, 8}, {2, 3}, {4, 5}, {4, 4}},
            event::Call{Line::FH5, Procedure::visibility},
            event::Height{Line::V1, 4, 5, Value(8), Value(8)}};
}

FloatingHorizonMoment after(const FloatingHorizonHeader& header, const std::vector<Event>& events) {
    FloatingHorizonMoment moment(header);
    for (const auto& event : events) moment.take(event);
    return moment;
}

std::vector<Path> paths_of(const Drawing& drawing) {
    std::vector<Path> found;
    for (const auto& thing : drawing.things) {
        if (const auto* path = std::get_if<Path>(&thing)) found.push_back(*path);
    }
    return found;
}

bool has_text(const Drawing& drawing, const std::string& text) {
    return std::any_of(drawing.things.begin(), drawing.things.end(), [&](const auto& thing) {
        const auto* label = std::get_if<Label>(&thing);
        return label && label->text == text;
    });
}

}  // namespace

TEST_CASE("curve figure: the lines so far, one line where they meet, broken where nothing is drawn") {
    const FloatingHorizonHeader header = crossing_curves();
    Drawing drawing;
    draw_lines(drawing, after(header, some_events()), plane_90);
    REQUIRE(paths_of(drawing).size() == 1);
    CHECK(paths_of(drawing)[0].lines == std::vector<Polyline>{{{0, 80}, {40, 80}}, {{0, 130}, {25, 80}, {40, 50}}});
}

TEST_CASE("curve figure: horizons only where there are any") {
    const FloatingHorizonHeader header = crossing_curves();
    Drawing drawing;
    draw_horizons(drawing, after(header, some_events()), plane_90, {});
    const Polyline level{{0, 80}, {10, 80}, {20, 80}, {30, 80}, {40, 80}};
    REQUIRE(paths_of(drawing).size() == 2);
    for (const auto& path : paths_of(drawing)) CHECK(path.lines == std::vector<Polyline>{level});
    CHECK_FALSE(*paths_of(drawing)[0].stroke == *paths_of(drawing)[1].stroke);
}

TEST_CASE("curve figure: the current segment is heavy, the compared height is a dot on its column") {
    const FloatingHorizonHeader header = crossing_curves();
    Drawing drawing;
    draw_curve_at_hand(drawing, after(header, some_events()), plane_90, {});
    const auto paths = paths_of(drawing);
    const auto has = [&](auto&& is) { return std::any_of(paths.begin(), paths.end(), is); };
    CHECK(has([](const Path& path) {
        return path.stroke && path.stroke->width == 1.5 && path.lines == std::vector<Polyline>{{{0, 130}, {40, 50}}};
    }));
    CHECK(has([](const Path& path) {  // around (4, 5)
        return path.closed && path.lines[0][0] == Point{40 - 0.7, 50 - 0.7};
    }));
}

TEST_CASE("curve figure: a curve with a gap is drawn in pieces, without the point between two gaps") {
    const double none = std::nan("");
    const FloatingHorizonHeader header{Edition::corrected,
                                       "double",
                                       Detail::signs,
                                       {"", test::CurveSceneBuilder(columns_9)
                                                .curve({{0, 8}, {1, 4}, {2, none}, {3, 1}, {4, none}, {6, 8}, {8, 6}})
                                                .build()}};
    Drawing drawing;
    draw_curve_at_hand(drawing, after(header, {event::Curve{Line::FH2, 0}}), plane_90, {});
    const auto paths = paths_of(drawing);
    REQUIRE_MESSAGE(paths.size() == 1 + 3, "the curve, and a dot for each sample of a piece, but on the left side");
    CHECK(paths[0].lines == std::vector<Polyline>{{{0, 80}, {10, 40}}, {{60, 80}, {80, 60}}});
}

TEST_CASE("curve figure: listing, legend and flags in both languages") {
    const FloatingHorizonHeader header = crossing_curves();
    const FloatingHorizonMoment moment = after(header, some_events());
    CHECK(has_text(listing_part(moment, {}, 200), "take upper[x] and lower[x]"));
    CHECK(has_text(listing_part(moment, {.language = Language::russian}, 200), "взять upper[x] и lower[x]"));
    CHECK(has_text(curve_legend(moment, {}, 90), "upper"));
    CHECK(has_text(curve_legend(moment, {}, 90), "lower"));
    CHECK(has_text(curve_legend(moment, {}, 90), "x = 0, Pflag = −1"));
    const event::Visibility next{Line::FH5, {0, 4}, 1, VisibilityFlag::above, {}};
    auto events = some_events();
    events.push_back(next);
    CHECK_MESSAGE(has_text(curve_legend(after(header, events), {}, 80), "x = 0, Pflag = −1; x′ = 1, Tflag = 1"),
                  "in 8 cm, too");
}

TEST_CASE("curve figure: a caption says what happens to the curve and the horizons") {
    FloatingHorizonHeader header = crossing_curves();
    header.kernel = "exact";  // These events are those of no run, and would be corrected.
    const event::Visibility hidden{Line::FH5, {0, 4}, 3, VisibilityFlag::hidden, {}};
    auto events = some_events();
    const auto said = [&](const std::vector<Event>& next, Language language) {
        events.insert(events.end(), next.begin(), next.end());
        return caption_of(after(header, events), language);
    };
    CHECK(said({hidden}, Language::english) ==
          "Over column 3 the curve is hidden (0): it is strictly between the horizons.");
    CHECK(said({event::Call{Line::FH7, Procedure::intersection},
                event::Intersection{Line::FH7, {0, 4}, {2.5, 8.}, {2, 3}}},
               Language::russian) ==
          "Отрезок встречается с нижним горизонтом в точке (2,5; 8), между столбцами 2 и 3.");
    CHECK(said({event::Call{Line::FH7, Procedure::horizon}, event::Raise{Line::H2, 3, 7.5}}, Language::english) ==
          "Over column 3 the upper horizon moves to 7.5.");
    CHECK(caption_of(after(header, events), Language::russian) ==
          "Над столбцом 3 ордината верхнего горизонта теперь 7,5.");
}

TEST_CASE("curve figure: the printed edition has the printed listing") {
    FloatingHorizonHeader header = crossing_curves();
    const std::vector<Event> begun{event::Horizons{Line::FH1, Value(16), Value(0)}};
    CHECK_FALSE(
        has_text(listing_part(after(header, begun), {}, 200), "upper := 0, lower := height; Xleft, Xright := 1"));
    header.edition = Edition::printed;
    CHECK(has_text(listing_part(after(header, begun), {}, 200), "upper := 0, lower := height; Xleft, Xright := 1"));
}

TEST_CASE("curve figure: the same moment gives the same bytes, and parts that curves lack are refused") {
    const FloatingHorizonHeader header = crossing_curves();
    const FloatingHorizonMoment moment = after(header, some_events());
    const auto svg = [&](const std::vector<Part>& parts) {
        Options options;
        options.show = parts;
        Figure figure(options);
        figure.add(moment);
        return svg_of(figure.strip(), {});
    };
    const std::string text = svg({Part::picture, Part::windows, Part::listing});
    CHECK(text == svg({Part::picture, Part::windows, Part::listing}));
    CHECK(text.find(">upper</text>") != text.npos);
    CHECK_THROWS_AS(svg({Part::picture, Part::list}), Refused);
    CHECK_THROWS_AS(svg({Part::history}), Refused);
}

TEST_CASE("curve figure: the lines alone are as large as the window") {
    const DrawnLines lines{{{0, {0, 8}, {4, 8}}, {{0, 8}, 0, 0}, {{4, 8}, 4, 4}}};
    const Drawing drawing = drawn_lines(lines, columns_9);
    CHECK(drawing.width == 80);
    CHECK(drawing.height == doctest::Approx(80 * 16 / 9.));
    REQUIRE(paths_of(drawing).size() == 1);
    CHECK(paths_of(drawing)[0].lines[0][1].x == doctest::Approx(80 * 4 / 9.));
}

}  // namespace vidno::figures
