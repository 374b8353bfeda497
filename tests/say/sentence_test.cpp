// Sentences: what they call things, and that they claim no more than the trace tells.

#include "say/sentence.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <regex>

#include "output.h"
#include "support/scenes.h"

using namespace vidno;
using namespace vidno::say;

namespace {

using Both = std::pair<std::string, std::string>;

const Window whole{0, 0, 16, 16};

TraceHeader header_of(Method method, Detail detail = Detail::signs) {
    const AdmittedScene scene =
        test::SceneBuilder(test::area_16).polygon(test::far_quad).polygon(test::near_square).build();
    return {method, Edition::corrected, "exact", detail, scene};
}

State after(const TraceHeader& header, const std::vector<Event>& events) {
    State state(header);
    for (const auto& event : events) state.apply(event);
    return state;
}

/// What is said of an event, in English and in Russian.
Both said(const EventView& event, const State& state) {
    return {sentence(event, state, Language::english).whole(), sentence(event, state, Language::russian).whole()};
}

const std::vector<AplEntry> only_a{{{0}, false}};

/// The first window is taken, with these polygons in its list.
std::vector<Event> in_window(const std::vector<AplEntry>& list = only_a) {
    return {event::Push{Line::W3, whole, list, {}}, event::Pop{Line::W5, whole}};
}

/// What is said of an event there.
Both said_in_window(const EventView& event, const std::vector<AplEntry>& list = only_a) {
    const TraceHeader header = header_of(Method::warnock);
    return said(event, after(header, in_window(list)));
}

}  // namespace

TEST_CASE("corners are named by their places on the screen, where y grows downward") {
    const event::Nearer nearer{Line::PW6, {1}, {Corner::left_bottom, Corner::left_top}, 2};
    CHECK(said_in_window(nearer) == Both("B is nearer at 2 of 4 corners (top left, bottom left).",
                                         "B ближе в 2 из 4 углов (левый верхний, левый нижний)."));
    const event::Depth depth{Line::PW5, {0}, {16, 0}, -0.125};
    CHECK(said_in_window(depth) == Both("At the top right corner the plane of A has depth −0.125.",
                                        "В правом верхнем углу глубина плоскости A равна −0,125."));
}

TEST_CASE("the only polygon of a list is named if the trace tells which it is") {
    const event::Decide single{Line::W10, Case::single};
    CHECK(said_in_window(single).first == "Only A is left in the window: background first, then A.");
    CHECK(said_in_window(single, {{{0}, false}, {{1}, false}}).first ==
          "Only one polygon is left in the window: background first, then the polygon.");
}

TEST_CASE("the polygon that hid everything is named when it no longer does") {
    const event::Uncover uncover{Line::PW7, {1}};
    CHECK(said_in_window(uncover).first == "B is nearer somewhere: for now nothing is known to hide everything.");
    auto events = in_window();
    events.insert(events.end(), {event::Cover{Line::PW9, {0}, test::red}, uncover});
    const TraceHeader header = header_of(Method::warnock);
    CHECK(said(uncover, after(header, events)) == Both("B is nearer somewhere, so A no longer hides everything.",
                                                       "B где-то ближе, и A больше не закрывает всего."));
    CHECK(said_in_window(event::Decide{Line::W8, Case::surrounded}).first.starts_with("One polygon hides everything"));
}

// A and B have the same colour, and C has that of the background.
TEST_CASE("a colour is that of the polygon that the trace tells, not of another one with the same") {
    const Color shared{0x11, 0x22, 0x33};
    const AdmittedScene twins = test::SceneBuilder(test::area_16)
                                    .polygon("A", shared, test::far_quad)
                                    .polygon("B", shared, test::near_square)
                                    .polygon("C", test::white, test::near_square)
                                    .build();
    TraceHeader header{Method::warnock, Edition::corrected, "exact", Detail::signs, twins};
    const auto after_event = [&](std::optional<Event> event) {
        auto events = in_window();
        if (event) events.push_back(*event);
        return after(header, events);
    };
    const auto color = [](const Color& seen) { return event::PointColor{Line::W9, {.5, .5}, seen}; };
    const auto fill = [](Line at, const Color& seen) { return event::Fill{at, {0, 0, 2, 1}, seen}; };

    SUBCASE("of the one that PointColor found") {
        const State found_b = after_event(event::Nearest{Line::PC4, {1}, .5, shared});
        CHECK(said(color(shared), found_b) == Both("At (0.5, 0.5) the viewer sees B.", "В точке (0,5; 0,5) виден B."));
        CHECK(said(fill(Line::W9, shared), found_b).first == "2 pixels take the colour of B.");
        const State found_c = after_event(event::Nearest{Line::PC4, {2}, .5, test::white});
        CHECK(said(color(test::white), found_c).first == "At (0.5, 0.5) the viewer sees C.");
        CHECK(said(color(test::white), after_event({})).first == "At (0.5, 0.5) the viewer sees the background.");
    }
    SUBCASE("of nobody if the trace contradicts itself") {
        const State found_b = after_event(event::Nearest{Line::PC4, {1}, .5, shared});
        CHECK(said(color(test::white), found_b).first == "At (0.5, 0.5) the viewer sees #ffffff.");
        CHECK(said(fill(Line::W9, test::white), found_b) ==
              Both("2 pixels take the colour #ffffff.", "2 пикселя получают цвет #ffffff."));
    }
    SUBCASE("of the one that hides the others") {
        const State covered = after_event(event::Cover{Line::PW9, {1}, shared});
        CHECK(said(fill(Line::W8, shared), covered) ==
              Both("2 pixels take the colour of B.", "2 пикселя получают цвет B."));
        CHECK(said(fill(Line::W7, test::white), covered).first == "2 pixels take the background.");
        header.method = Method::warnock_full;
        const State joined = after_event(event::Join{Line::WF4, {0}, OtherList::surrounding, 0});
        CHECK(said(fill(Line::WF9, shared), joined).first == "2 pixels take the colour of A.");
    }
    SUBCASE("of all that have it if the trace tells none") {
        header.detail = Detail::windows;
        const State coarse = after_event({});
        CHECK(said(fill(Line::W8, shared), coarse) ==
              Both("2 pixels take the colour that A and B share.", "2 пикселя получают общий цвет A и B."));
        CHECK(said(fill(Line::W9, test::white), coarse).first ==
              "2 pixels take the colour that C and the background share.");
        CHECK(said(fill(Line::W8, test::blue), coarse).first == "2 pixels take the colour #0000ff.");
    }
}

TEST_CASE("a number of pixels has the plural forms, too") {
    const auto fill = [](int n) { return said_in_window(event::Fill{Line::W7, {0, 0, n, 1}, test::white}); };
    CHECK(fill(1) == Both("1 pixel takes the background.", "1 пиксель получает цвет фона."));
    CHECK(fill(3).second == "3 пикселя получают цвет фона.");
    CHECK(fill(12).second == "12 пикселей получают цвет фона.");
}

TEST_CASE("nouns have the plural forms of the language") {
    const auto list = [](int count) { return said_in_window(event::ClipList{Line::PL7, count}); };
    CHECK(list(1) == Both("This side is done: 1 vertex in the list.", "Сторона пройдена: в списке 1 вершина."));
    CHECK(list(2).second == "Сторона пройдена: в списке 2 вершины.");
    CHECK(list(5).second == "Сторона пройдена: в списке 5 вершин.");
    CHECK(list(11).second == "Сторона пройдена: в списке 11 вершин.");
    CHECK(list(21) == Both("This side is done: 21 vertices in the list.", "Сторона пройдена: в списке 21 вершина."));
}

TEST_CASE("edges that end are named, one or several") {
    const TraceHeader header = header_of(Method::zbuffer);
    const State state(header);
    const auto drop = [&](const std::vector<int>& edges) { return said(event::AelDrop{Line::Z16, edges, 7}, state); };
    CHECK(drop({1}) == Both("Edge 1 ends here and leaves the AEL; the next change is in row 7.",
                            "Ребро 1 заканчивается и удаляется из AEL; следующее изменение — в строке 7."));
    CHECK(drop({2, 1, 0}).first.starts_with("Edges 2, 1 and 0 end here and leave the AEL"));
    CHECK(drop({2, 1, 0}).second.starts_with("Рёбра 2, 1 и 0 заканчиваются и удаляются из AEL"));
}

TEST_CASE("an edge has rows, but y in the printed text") {
    TraceHeader header = header_of(Method::zbuffer);
    const auto join = [&](double until) {
        return said(event::AelAdd{Line::Z8, 2, 3., 0.5, until, 1., 0.25}, State(header));
    };
    const auto leave = [&](double next) { return said(event::Leave{Line::Z10, {2}, next}, State(header)); };
    CHECK(join(7) == Both("Edge 2 begins: it joins the AEL at x = 3, z = 0.5; its last row is 7.",
                          "Ребро 2 начинается: входит в AEL с x = 3, z = 0,5; последняя строка — 7."));
    CHECK(leave(4) == Both("Edge 2 leaves S; the next begins in row 4.",
                           "Ребро 2 удаляется из S; следующее начинается в строке 4."));
    header.edition = Edition::printed;
    CHECK(join(7.5) == Both("Edge 2 begins: it joins the AEL at x = 3, z = 0.5 and ends at y = 7.5.",
                            "Ребро 2 начинается: входит в AEL с x = 3, z = 0,5 и кончается при y = 7,5."));
    CHECK(leave(4.25) == Both("Edge 2 leaves S; the next begins at y = 4.25.",
                              "Ребро 2 удаляется из S; следующее начинается при y = 4,25."));
}

TEST_CASE("the mark of a shortened number stands in place of the equals sign") {
    const event::Nearest nearest{Line::PC4, {0}, 1 / 3., test::red};
    CHECK(said_in_window(nearest) ==
          Both("A is the nearest at the point so far: z ≈ 0.3333.", "Пока в этой точке ближе всех A: z ≈ 0,3333."));
}

TEST_CASE("every reason for a fault that the procedures give is said in Russian") {
    const TraceHeader header = header_of(Method::zbuffer);
    const State state(header);
    const auto in_russian = [&](const std::string& reason) {
        return sentence(event::Fault{Line::Z15, reason, {}, {}}, state, Language::russian).whole();
    };
    CHECK_MESSAGE(in_russian("out of memory").find("out of memory") != std::string::npos,
                  "the reason of another program stays as it is");
    const std::regex reason("[Ff]ault[{(][A-Za-z0-9_:]+, \"([^\"]+)\"");
    int found = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(VIDNO_ROOT "/lib/vidno")) {
        if (entry.path().extension() != ".h") continue;
        const std::string text = read_file(entry.path().string());
        for (std::sregex_iterator at(text.begin(), text.end(), reason), end; at != end; ++at, ++found) {
            CHECK_MESSAGE(in_russian((*at)[1]).find(std::string((*at)[1])) == std::string::npos, std::string((*at)[1]));
        }
    }
    CHECK(found > 5);
}
