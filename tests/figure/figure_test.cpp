// Figures: the layout of small drawings that can be computed by hand, and the contents of the files.

#include "figure/figure.h"

#include <doctest/doctest.h>

#include <cctype>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "characters.h"
#include "figure/notation.h"
#include "figure/patches.h"
#include "figure/table.h"
#include "figure/wrap.h"
#include "figure/writers.h"
#include "output.h"
#include "page/program.h"
#include "refused.h"
#include "scene/scene_names.h"
#include "support/scenes.h"
#include "support/workplace.h"

namespace vidno::figures {

namespace {

TraceHeader header_of(AdmittedScene scene, Method method = Method::warnock, Detail detail = Detail::signs) {
    return {method, Edition::corrected, "exact", detail, std::move(scene)};
}

AdmittedScene near_before_far() {
    return test::SceneBuilder(test::area_16).polygon(test::far_quad).polygon(test::near_square).build();
}

/// The area of 16 x 16 at 5 mm a pixel, without a margin.
const Plane plane_80{test::area_16, 5, {0, 0}, {0, 0, 80, 80}};

/// All things of one kind in a drawing.
template <class Thing>
std::vector<Thing> all(const Drawing& drawing) {
    std::vector<Thing> found;
    for (const auto& thing : drawing.things) {
        if (const auto* each = std::get_if<Thing>(&thing)) found.push_back(*each);
    }
    return found;
}

std::vector<std::string> texts_of(const Drawing& drawing) {
    std::vector<std::string> texts;
    for (const auto& label : all<Label>(drawing)) texts.push_back(label.text);
    return texts;
}

bool has_text(const Drawing& drawing, const std::string& text) {
    const auto texts = texts_of(drawing);
    return std::find(texts.begin(), texts.end(), text) != texts.end();
}

/// Whether a line of text begins so.
bool has_line(const Drawing& drawing, const std::string& beginning) {
    const auto texts = texts_of(drawing);
    return std::any_of(texts.begin(), texts.end(), [&](const auto& text) { return text.starts_with(beginning); });
}

std::size_t count_of(std::string_view text, std::string_view part) {
    std::size_t count = 0;
    for (auto at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++count;
    return count;
}

Moment after(const TraceHeader& header, const std::vector<Event>& events) {
    Moment moment(header);
    for (const auto& event : events) moment.take(event);
    return moment;
}

const Window whole{0, 0, 16, 16}, upper_left{0, 0, 8, 8}, lower_right{8, 8, 8, 8};
const std::vector<AplEntry> both{{{0}, true}, {{1}, false}};

event::Push pushed(const Window& window, std::optional<std::vector<AplEntry>> apl = {}) {
    const Line line = apl ? Line::W3 : Line::W13;
    event::Push e{line, window, std::move(apl), {}};
    return e;
}

/// The first window is divided, two of its quarters are on the stack, and the lower right one is taken.
std::vector<Event> a_division() {
    return {pushed(whole, both), event::Pop{Line::W5, whole}, pushed(upper_left), pushed(lower_right),
            event::Pop{Line::W5, lower_right}};
}

}  // namespace

TEST_CASE("patches: equal runs in consecutive rows are one rectangle") {
    // r r w
    // r r r   the run of three is another one
    Picture picture({4, 7, 3, 2}, test::red);
    picture.paint(6, 7, test::white);
    const auto patches = patches_of(picture);
    REQUIRE(patches.size() == 2);
    CHECK(patches[0].color == test::red);
    CHECK(patches[0].rectangles == std::vector<PixelRectangle>{{4, 7, 2, 1}, {4, 8, 3, 1}});
    CHECK(patches[1].rectangles == std::vector<PixelRectangle>{{6, 7, 1, 1}});

    const auto one = patches_of(Picture({0, 0, 5, 9}, test::red));
    REQUIRE(one.size() == 1);
    CHECK(one[0].rectangles == std::vector<PixelRectangle>{{0, 0, 5, 9}});
}

TEST_CASE("lines are cut where they leave a box") {
    // From (-1, 1) to (3, 1): inside from x = 0 to x = 2.
    const Box box{0, 0, 2, 2};
    CHECK(clipped({{-1, 1}, {3, 1}}, false, box) == std::vector<Polyline>{{{0, 1}, {2, 1}}});
    CHECK(clipped({{-1, 3}, {3, 3}}, false, box).empty());
    // The hypotenuse of (1, 1), (5, 1), (1, 5) is outside; the legs end at x = 2 and y = 2.
    const auto legs = clipped({{1, 1}, {5, 1}, {1, 5}}, true, box);
    CHECK(legs == std::vector<Polyline>{{{1, 1}, {2, 1}}, {{1, 2}, {1, 1}}});
}

TEST_CASE("the picture: a filled window is one rectangle of its colour at its place") {
    const TraceHeader header = header_of(near_before_far());
    const Color color = header.scene.polygons[1].color;
    const Moment moment = after(header, {event::Fill{Line::W8, {4, 4, 8, 8}, color}});
    Drawing drawing{80, 80};
    draw_picture(drawing, moment, plane_80, {});
    bool found = false;
    for (const auto& path : all<Path>(drawing)) {
        if (path.fill != tinted(color, false)) continue;
        found = true;
        CHECK(path.lines == std::vector<Polyline>{Box{20, 20, 40, 40}.corners()});
    }
    CHECK(found);
}

TEST_CASE("in grey, two polygons of one lightness differ by their texture") {
    // By ITU-R BT.709 red has 0.2126 * 255 = 54.2, green of 76 0.7152 * 76 = 54.4: both 54.
    const Color green{0, 76, 0};
    CHECK(tinted(test::red, true) == tinted(green, true));
    const AdmittedScene scene = test::SceneBuilder(test::area_16)
                                    .polygon("A", test::red, test::far_quad)
                                    .polygon("B", green, test::near_square)
                                    .build();
    const TraceHeader header = header_of(scene);
    const auto strokes_of = [&](const Color& color) {
        Drawing drawing{80, 80};
        const Moment moment = after(header, {event::Fill{Line::W8, {0, 0, 16, 16}, color}});
        draw_picture(drawing, moment, plane_80, {.greyscale = true});
        std::size_t strokes = 0;
        for (const auto& path : all<Path>(drawing)) strokes += path.fill || !path.stroke ? 0 : path.lines.size();
        return strokes;
    };
    // The hatching of 80 mm by 80 mm: lines x + y = i 1.3 sqrt(2) with 0 < i 1.838 < 160, of i = 1 to 87.
    CHECK(strokes_of(green) == strokes_of(test::red) + 87);
}

TEST_CASE("windows: those visited, those on the stack dashed, the current one heavy") {
    const TraceHeader header = header_of(near_before_far());
    Drawing drawing{80, 80};
    draw_windows(drawing, after(header, a_division()), plane_80, {});
    const auto paths = all<Path>(drawing);
    REQUIRE(paths.size() == 4);
    CHECK(paths[0].lines.size() == 2);  // the whole and its lower right quarter, visited
    CHECK(paths[1].lines.size() == 1);  // the upper left one waits
    CHECK_FALSE(paths[1].stroke->dashes.empty());
    CHECK(paths[3].lines == std::vector<Polyline>{{{40, 40}, {80, 40}, {80, 80}, {40, 80}, {40, 40}}});
    CHECK(paths[3].stroke->width == 1);
    CHECK(paths[2].stroke->width > paths[3].stroke->width);  // its light rim
}

/// Beside the upper left quarter of the area, with its top on the row of the quarter's centre.
const TraceHeader a_triangle =
    header_of(test::SceneBuilder(test::area_16).polygon("T", test::red, {{12, 4, 0}, {14, 10, 0}, {10, 10, 0}}).build(),
              Method::warnock_full);

Moment beside_a_triangle(const Event& event) {
    const std::vector<AplEntry> only{{{0}, false}};
    return after(a_triangle, {pushed(upper_left, only), event::Pop{Line::W5, upper_left}, event});
}

bool has_line(const Drawing& drawing, const Polyline& line) {
    const auto paths = all<Path>(drawing);
    return std::any_of(paths.begin(), paths.end(), [&](const Path& path) {
        return std::find(path.lines.begin(), path.lines.end(), line) != path.lines.end();
    });
}

TEST_CASE("ray crossings: the ray to the right from the window's centre, and the counts where it meets edges") {
    Drawing drawing{80, 80};
    draw_marks(drawing, beside_a_triangle(event::Ray{Line::CR3, {0}, 0, 2}), plane_80, {});
    CHECK_MESSAGE(has_line(drawing, {{20, 20}, {80, 20}}), "from (4, 4) to the side");
    CHECK_MESSAGE(has_line(drawing, {{60, 20}, {70, 50}}), "edge 0, from (12, 4) to (14, 10)");
    const auto labels = all<Label>(drawing);
    REQUIRE(labels.size() == 1);
    CHECK(labels[0].text == "2");
    CHECK(labels[0].at.x == 60);
    CHECK(labels[0].at.y < 20);
}

TEST_CASE("octant angles: the octants around the window, and by how many an edge turns, at its middle") {
    Drawing drawing{80, 80};
    draw_marks(drawing, beside_a_triangle(event::Octants{Line::OA3, {0}, 0, 3, 4, -1}), plane_80, {});
    // The octants around (0, 0) 8 x 8 that are on the drawing: right, below, and both; and the turn.
    CHECK(texts_of(drawing) == std::vector<std::string>{"3", "4", "5", "\u22121"});
    const auto labels = all<Label>(drawing);
    CHECK(labels[1].at.x > 40);
    CHECK(labels[1].at.y > 40);
    CHECK_MESSAGE(labels.back().at.x == 65, "between x = 12 and 14");
    CHECK_MESSAGE(has_line(drawing, {{40, 0}, {40, 80}}), "the line of the window's right side");
}

TEST_CASE("the list of a window: its polygons, their known relations, and the current one") {
    const TraceHeader header = header_of(near_before_far());
    auto events = a_division();
    events.insert(events.end(), {event::Corners{Line::PW1, Value::minus_infinite()}, event::Count{Line::PW4, {0}, 1}});
    for (int i = 0; i < 4; ++i) events.push_back(event::Depth{Line::PW5, {0}, {0., 0.}, 0.125});
    events.push_back(event::Nearer{Line::PW6, {0}, {Corner::left_bottom, Corner::right_top}, 2});
    const Drawing list = list_part(after(header, events), {}, 80);
    CHECK(has_text(list, "U = (8, 8) 8 × 8, on the stack: 1"));
    CHECK(has_text(list, "upper left, lower right"));
    CHECK(has_text(list, "upper left 0.125, upper right −∞"));
    CHECK(has_text(list, "lower left −∞, lower right 0.125"));
    CHECK(has_text(list_part(after(header, events), {.language = Language::russian}, 80),
                   "левый верхний, правый нижний"));
    const auto labels = all<Label>(list);
    const auto at = [&](const std::string& text) {
        return std::find_if(labels.begin(), labels.end(), [&](const Label& label) { return label.text == text; })->at;
    };
    CHECK(at("yes").y == at("A").y);  // A surrounds
    CHECK(at("no").y == at("B").y);
    // The band lies behind A's row.
    const auto paths = all<Path>(list);
    const auto marked = std::find_if(paths.begin(), paths.end(), [](const Path& path) { return path.fill == band; });
    REQUIRE(marked != paths.end());
    CHECK(marked->lines[0][0].y < at("A").y);
    CHECK(at("A").y < marked->lines[0][2].y);
    CHECK(marked->lines[0][2].y < at("B").y);
}

TEST_CASE("the list of a scanline: the active edges with their numbers") {
    const TraceHeader header = header_of(near_before_far(), Method::zbuffer);
    const Moment moment =
        after(header, {event::Polygon{Line::Z2, {1}, header.scene.polygons[1].color}, event::Scanline{Line::Z6, 4.5, 4},
                       event::AelAdd{Line::Z8, 3, 4., 0.5, 12., 0., Value("1/3")}});
    const Drawing list = list_part(moment, {.language = Language::russian}, 80);
    for (const std::string text : {"Активные рёбра (AEL)", "P = B, yₜ = 4,5", "3", "4", "0,5", "12", "0", "1/3"}) {
        CAPTURE(text);
        CHECK(has_text(list, text));
    }
}

TEST_CASE("the list of a scanline: on half a slide numbers have fewer digits, and nothing is cut") {
    const TraceHeader header = header_of(near_before_far(), Method::zbuffer);
    const Moment moment =
        after(header, {event::Polygon{Line::Z2, {1}, header.scene.polygons[1].color}, event::Scanline{Line::Z6, 4.5, 4},
                       event::AelAdd{Line::Z8, 3, -12.34375, -0.01953125, 12., -0.0234375, -1. / 3}});
    for (const auto language : {Language::english, Language::russian}) {
        const auto texts = texts_of(list_part(moment, {.language = language, .letters = letters_of_tex}, 68));
        for (std::string number : {"−12.34", "−0.02", "−0.023", "−0.333"}) {
            if (language == Language::russian) number.replace(number.find('.'), 1, ",");
            CHECK_MESSAGE(std::count(texts.begin(), texts.end(), number) > 0, number);
        }
        for (const auto& text : texts) CHECK_MESSAGE(text.find("…") == text.npos, text);
    }
    CHECK(has_text(list_part(moment, {}, 80), "−0.0195"));
}

TEST_CASE("parts that a trace does not contain are refused") {
    const TraceHeader header = header_of(near_before_far(), Method::warnock, Detail::windows);
    CHECK_THROWS_AS(list_part(Moment(header), {}, 80), Refused);
}

TEST_CASE("the listing: the current procedure, and an arrow at its current line") {
    const TraceHeader header = header_of(near_before_far());
    const Drawing listing = listing_part(after(header, a_division()), {}, 200);
    const auto labels = all<Label>(listing);
    const auto line = std::find_if(labels.begin(), labels.end(), [](const Label& each) { return each.text == "W5"; });
    REQUIRE(line != labels.end());
    CHECK(has_text(listing, "pop a window U = (Ucx, Ucy, Ux, Uy) and its APL from AW"));
    const auto paths = all<Path>(listing);
    const auto arrow = std::find_if(paths.begin(), paths.end(), [](const Path& path) { return path.fill == ink; });
    REQUIRE(arrow != paths.end());
    CHECK(std::abs(arrow->lines[0][1].y - line->at.y) < line_height / 2);
    CHECK(has_text(listing_part(after(header, a_division()), {.language = Language::russian}, 200),
                   "взять из AW окно U = (Ucx, Ucy, Ux, Uy) и его APL"));
}

TEST_CASE("corners are named by their places on the screen, where y grows downward") {
    const auto& words = words_of(Language::english);
    CHECK(places_of({Corner::left_top}, words) == "lower left");
    CHECK(places_of({Corner::left_bottom, Corner::right_bottom}, words) == "upper left, upper right");
    CHECK(places_of({Corner::left_bottom, Corner::left_top, Corner::right_bottom}, words) == "all but lower right");
    CHECK(places_of({Corner::left_bottom, Corner::left_top, Corner::right_bottom, Corner::right_top}, words) ==
          "all four");
    CHECK(places_of({}, words) == "—");
}

TEST_CASE("a caption is the sentence of its step") {
    const TraceHeader header = header_of(near_before_far());
    CHECK(caption_of(Moment(header), Language::english) == "the run begins");
    auto events = a_division();
    events.push_back(event::Box{Line::PW3, {1}, {4., 4., 12., 12.}, true, {}});
    CHECK(caption_of(after(header, events), Language::english) == "The box of B lies outside the window.");
    CHECK(caption_of(after(header, events), Language::russian) == "Габаритный прямоугольник B лежит вне окна.");
    events.push_back(event::Call{Line::PW8, Procedure::surround_test});
    CHECK(caption_of(after(header, events), Language::english) ==
          "SurroundTest begins: does the point lie in the polygon?");
}

TEST_CASE("a caption says on which side of an edge a corner lies") {
    const TraceHeader header = header_of(near_before_far());
    auto events = a_division();
    events.push_back(event::Orient{Line::S2, {1}, 2, {8., 16.}, -4., Sign::negative, {}});
    CHECK(caption_of(after(header, events), Language::english) ==
          "The point lies on the negative side of edge 2 of B (−4).");
    CHECK(caption_of(after(header, events), Language::russian) ==
          "Точка лежит по отрицательную сторону ребра 2 многоугольника B (−4).");
}

TEST_CASE("a caption writes numbers in the format of its language") {
    const TraceHeader header = header_of(near_before_far());
    auto events = a_division();
    events.push_back(event::Depth{Line::PC3, {1}, {4.5, 2.}, 0.125});
    CHECK(caption_of(after(header, events), Language::english) == "At the point (4.5, 2) B has depth 0.125.");
    CHECK(caption_of(after(header, events), Language::russian) == "В точке (4,5; 2) глубина B равна 0,125.");
}

TEST_CASE("the letters of a strip's panels") {
    CHECK(letter_of(0) == "(a)");
    CHECK(letter_of(25) == "(z)");
    CHECK(letter_of(26) == "(aa)");
    CHECK(letter_of(53) == "(bb)");
}

TEST_CASE("a listing breaks between terms, neither at an operator nor in brackets") {
    using Texts = std::vector<std::string>;
    const auto pieces = [](const std::string& text, const std::string& fitting) {
        const double width = width_of(fitting, text_size);
        return wrapped(text, text_size, width, width);
    };
    // The review's bad breaks: "z[q] / := zᵢ[q]" and "P = / P".
    CHECK(pieces("k := corners q with zᵢ[q] > z[q]; there z[q] := zᵢ[q]",
                 "k := corners q with zᵢ[q] > z[q]; there z[q] :=") ==
          Texts{"k := corners q with zᵢ[q] > z[q];", "there z[q] := zᵢ[q]"});
    CHECK(pieces("then P = P", "then P =") == Texts{"then", "P = P"});
    CHECK(pieces("push (Wcx, Wcy, s, s, APL₀) on AW", "(Wcx, Wcy, s, s, APL₀)") ==
          Texts{"push", "(Wcx, Wcy, s, s, APL₀)", "on AW"});
    CHECK(
        pieces("push (Wcx, s, APL₀) on AW, s := least 2ᵐ ≥ Wx, Wy", "push (Wcx, s, APL₀) on AW, s := least 2ᵐ ≥ Wx,") ==
        Texts{"push (Wcx, s, APL₀) on AW,", "s := least 2ᵐ ≥ Wx, Wy"});
    CHECK(pieces("for each other S of L: inside, outside := RegionClip(S, C)",
                 "for each other S of L: inside, outside") ==
          Texts{"for each other S of L:", "inside, outside := RegionClip(S, C)"});
    // A preposition stays with its noun.
    CHECK(pieces("first row centre in the area", "first row centre in the") ==
          Texts{"first row centre", "in the area"});
    CHECK(pieces("положить копии APL₀ в AW", "положить копии APL₀ в") == Texts{"положить копии APL₀", "в AW"});
    CHECK(pieces("all of it fits", "all of it fits") == Texts{"all of it fits"});
    CHECK(pieces("unbreakable b", "un") == Texts{"unbreakable", "b"});
    CHECK(pieces("", "un") == Texts{""});
}

TEST_CASE("a film shows each drawing for its share of the time") {
    Drawing drawing{80, 60};
    drawing.add(Label{"here", {1, 2}});
    const std::string film = film_of({drawing, drawing, drawing, drawing}, 2, {"A film"});
    CHECK(count_of(film, "<g ") == 4);
    CHECK(count_of(film, "dur=\"2s\"") == 4);  // four steps, two a second
    CHECK(film.find("values=\"visible;hidden\" keyTimes=\"0;0.250000\"") != film.npos);
    CHECK(film.find("values=\"hidden;visible;hidden\" keyTimes=\"0;0.250000;0.500000\"") != film.npos);
    CHECK(film.find("values=\"hidden;visible\" keyTimes=\"0;0.750000\"") != film.npos);
    CHECK_MESSAGE(count_of(film, "visibility=\"visible\"") == 1, "without animation the last one shows");
    CHECK(film_of({drawing}, 2, {}).find("<animate") == std::string::npos);
}

namespace {

/// A program in the workplace that the shell can run.
std::string script(const Workplace& work, const std::string& name, const std::string& text) {
    const std::string file = work.write(name, "#!/bin/sh\n" + text);
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    return file;
}

}  // namespace

TEST_CASE("figure --film: SVG alone, GIF and MP4 by the ffmpeg on the path, in one line refused without it") {
    const Workplace work;
    const std::string run = work.file("run.jsonl");
    REQUIRE(program("trace " VIDNO_ROOT "/lessons/01-four-relations/scene.json -o " + run).status == 0);
    const std::string film = "figure " + run + " --steps 4..6 --film --width 4cm --dpi 30 -o ";
    REQUIRE(program(film + work.file("a.svg") + " --rate 1").status == 0);
    CHECK(count_of(work.read("a.svg"), "<animate ") == 3);
    CHECK(work.read("a.svg").find("dur=\"3s\"") != std::string::npos);

    // The stand-in says with what it was called, and how many pictures came in.
    script(work, "bin/ffmpeg", "echo \"$@\"; grep -ac IHDR");
    const std::string with_it =
        script(work, "with", "PATH='" + work.file("bin") + "':$PATH exec '" VIDNO_FILE "' \"$@\"\n");
    REQUIRE(program(film + work.file("a.gif"), with_it).status == 0);
    CHECK(work.read("a.gif").find("-framerate 2 -i - ") != std::string::npos);
    CHECK(work.read("a.gif").ends_with("-f gif -\n3\n"));
    REQUIRE(program(film + work.file("a.mp4"), with_it).status == 0);
    CHECK(work.read("a.mp4").ends_with("-f mp4 -\n3\n"));

    std::filesystem::create_directory(work.file("empty"));
    const std::string without_it =
        script(work, "without", "PATH='" + work.file("empty") + "' exec '" VIDNO_FILE "' \"$@\"\n");
    for (const auto& [call, reason] :
         {std::pair(film + work.file("b.gif"), "ffmpeg"),
          std::pair(film + work.file("b.png"), "a film is .svg, .gif or .mp4"),
          std::pair("figure " + run + " --film -o " + work.file("b.svg"), "--steps A..B")}) {
        const auto refused = program(call, without_it);
        CHECK(refused.status == 2);
        CHECK_MESSAGE(refused.text.find(reason) != std::string::npos, refused.text);
        CHECK(refused.text.find('\n') == refused.text.size() - 1);
    }
    CHECK_FALSE(work.has("b.gif"));
}

TEST_CASE("figure --film: ffmpeg, where it is installed, makes a GIF and an MP4 with a picture for each step") {
    const auto frames_in = [](const std::string& file) {
        return output_of({"ffprobe", "-v", "error", "-count_frames", "-show_entries", "stream=nb_read_frames", "-of",
                          "csv=p=0", file},
                         "");
    };
    try {
        output_of({"ffprobe", "-version"}, "");
    } catch (const Refused&) {
        MESSAGE("no ffmpeg");
        return;
    }
    const Workplace work;
    const std::string run = work.file("run.jsonl");
    REQUIRE(program("trace " VIDNO_ROOT "/lessons/01-four-relations/scene.json -o " + run).status == 0);
    for (const std::string name : {"a.gif", "a.mp4"}) {
        const auto made = program("figure " + run + " --steps 4..6 --film --width 4cm --dpi 31 -o " + work.file(name));
        CHECK_MESSAGE(made.status == 0, made.text);
        CHECK(frames_in(work.file(name)) == "3\n");
    }
}

TEST_CASE("the figures of a course's scene have its name in their language") {
    CHECK(name_in(Language::russian, "Down to the pixel · 07") == "Вплоть до пикселя · 07");
    CHECK(name_in(Language::english, "Down to the pixel · 07") == "Down to the pixel · 07");
    CHECK(name_in(Language::russian, "Another scene") == "Another scene");
    const std::set<std::string> formats{"vidno-scene/1", "vidno-surface/1", "vidno-question/1"};
    for (const auto& entry : std::filesystem::recursive_directory_iterator(VIDNO_ROOT "/lessons")) {
        const std::string folder = entry.path().parent_path().filename().string();
        const bool has_scenes = std::isdigit(static_cast<unsigned char>(folder[0])) || folder == "surfaces" ||
                                folder == "charts" || folder == "maps";
        if (!has_scenes || entry.path().extension() != ".json") continue;
        const auto read = nlohmann::json::parse(read_file(entry.path().string()));
        if (!formats.contains(read.at("format"))) continue;
        const std::string name = read.at("name");
        CHECK_MESSAGE(name_in(Language::russian, name) != name, name);
    }
}

TEST_CASE("the figure of a failure has its title in the figure's language") {
    const Workplace work;
    const std::string file = VIDNO_ROOT "/lessons/failures/clip-pixel.json";
    const std::string title = nlohmann::json::parse(read_file(file)).at("title").at("ru");
    REQUIRE(program("figure " + file + " --language ru -o " + work.file("a.svg")).status == 0);
    CHECK(work.read("a.svg").find("<title>" + title + " · ") != std::string::npos);
}

TEST_CASE("the marks stay where outlines entered and left the clip polygon, until the next list") {
    const TraceHeader header = header_of(near_before_far(), Method::weiler_atherton);
    Moment moment(header);
    const std::vector<PolygonPart> parts{{{1}, {{{4., 4.}, {12., 4.}, {12., 12.}}}},
                                         {{0}, {{{0., 0.}, {16., 0.}, {16., 16.}}}}};
    moment.take(event::PushList{Line::WA3, parts});
    moment.take(event::PopList{Line::WA4, {1}, 2});
    moment.take(event::Call{Line::WA5, Procedure::region_clip});
    moment.take(event::Entering{Line::RC3, {4., 8.}});
    moment.take(event::Leaving{Line::RC3, {8., 8.}});
    moment.take(event::Clipped{Line::WA5, {0}, {1}, {}, {}});
    moment.take(event::Call{Line::WA5, Procedure::region_clip});
    CHECK(moment.entering() == std::vector<ValuePoint>{{4., 8.}});
    CHECK(moment.leaving() == std::vector<ValuePoint>{{8., 8.}});
    CHECK(has_text(list_part(moment, {}, 80), "enters C"));
    CHECK(has_text(list_part(moment, {.language = Language::russian}, 80), "выход из C"));
}

TEST_CASE("the listing of the printed text is the printed one") {
    TraceHeader header = header_of(near_before_far());
    header.edition = Edition::printed;
    CHECK(has_text(listing_part(after(header, a_division()), {}, 200), "push (Wcx, Wcy, Wx, Wy, APL₀) on AW"));
}

TEST_CASE("the listing of a usual mistake has the mistaken line") {
    TraceHeader header = header_of(near_before_far());
    header.edition = Deviation::integer_division;
    const Moment moment = after(header, a_division());
    CHECK(has_text(listing_part(moment, {}, 200), "push (Wcx, Wcy, Wx, Wy, APL₀) on AW"));
    CHECK(
        has_text(listing_part(moment, {.language = Language::russian}, 200), "положить (Wcx, Wcy, Wx, Wy, APL₀) в AW"));
    CHECK_MESSAGE(has_text(listing_part(moment, {}, 200), "while AW ≠ ∅:"), "the other lines are the corrected ones");
}

TEST_CASE("ids never overlap, and each polygon has its own if there is room") {
    test::RandomScenes random(7);
    std::size_t names = 0, polygons = 0;
    for (int i = 0; i < 100; ++i) {
        const AdmittedScene scene = random.scene();
        Drawing drawing{80, 80};
        const Plane plane = plane_in(scene->area, 80, 80);
        draw_names(drawing, scene, plane, {});
        std::vector<Box> boxes;
        for (const auto& path : all<Path>(drawing)) {
            const auto& corners = path.lines[0];
            boxes.push_back({corners[0].x, corners[0].y, corners[2].x - corners[0].x, corners[2].y - corners[0].y});
        }
        REQUIRE(boxes.size() == all<Label>(drawing).size());
        for (std::size_t a = 0; a < boxes.size(); ++a) {
            CHECK(plane.shown.holds(boxes[a]));
            for (std::size_t b = 0; b < a; ++b) CHECK_FALSE(boxes[a].overlaps(boxes[b]));
        }
        names += boxes.size();
        polygons += scene->polygons.size();
    }
    CHECK(names > 0.95 * double(polygons));  // a narrow area has no room for all
}

TEST_CASE("an id stands where there is no other polygon") {
    // The middle of the far quad, (8, 8), lies under the near square from 4 to 12.
    const AdmittedScene scene = near_before_far();
    Drawing drawing{80, 80};
    draw_names(drawing, scene, plane_80, {});
    const auto labels = all<Label>(drawing);
    REQUIRE(labels.size() == 2);
    REQUIRE(labels[0].text == "A");
    const bool within = 20 < labels[0].at.x && labels[0].at.x < 60 && 20 < labels[0].at.y && labels[0].at.y < 60;
    CHECK_FALSE(within);
}

TEST_CASE("a pixel's history: the windows it lies in, and what painted it") {
    const TraceHeader header = header_of(near_before_far());
    PixelHistory history({9, 9}, header, Language::english);
    Moment moment(header);
    for (const auto& event : a_division()) {
        moment.take(event);
        history.take(moment);
    }
    for (const Event& event : {Event(event::Fill{Line::W8, {0, 0, 8, 8}, test::red}),     // elsewhere
                               Event(event::Fill{Line::W8, {8, 8, 8, 8}, test::red})}) {  // here
        moment.take(event);
        history.take(moment);
    }
    // The whole window and its lower right quarter: pushed at 1 and 4, taken at 2 and 5. The second Fill is here.
    const auto& entries = history.entries();
    std::vector<std::uint64_t> steps;
    for (const auto& entry : entries) steps.push_back(entry.step);
    REQUIRE(steps == std::vector<std::uint64_t>{1, 2, 4, 5, 7});
    CHECK(entries[3].text == "The window (8, 8) 8 × 8 comes off the stack with A, B.");
    CHECK(entries[4].outcome == say::Outcome::paint);
}

TEST_CASE("the notation of numbers") {
    CHECK(readable(Value(-0.25), Language::english) == "−0.25");
    CHECK(readable(Value(1. / 3), Language::english) == "0.3333");
    CHECK(readable(Value(12.3456789), Language::english) == "12.35");
    CHECK(readable(Value(12.3456789), Language::english, 4) == "12.3");
    CHECK(readable(Value(1e-9), Language::english) == "1.00e−09");
    CHECK(readable(Value("-3/7"), Language::english) == "−3/7");
    CHECK(readable(Value("12/1"), Language::english) == "12");
    CHECK(readable(Value("1000000001/3000000000"), Language::english) == "≈0.3333");
    CHECK(readable(Value::minus_infinite(), Language::english) == "−∞");
    CHECK(readable(Value(-0.25), Language::russian) == "−0,25");
    CHECK(readable(Window{0.5, 1, 2, 2}, Language::english) == "(0.5, 1) 2 × 2");
    CHECK(readable(Window{0.5, 1, 2, 2}, Language::russian) == "(0,5; 1) 2 × 2");
    // 10^40 / (4 * 10^40): no double holds its parts exactly.
    CHECK(number_of(Value("1" + std::string(40, '0') + "/4" + std::string(40, '0'))) == doctest::Approx(0.25));
}

namespace {

/// A figure with every part, of two steps.
Drawing strip_of_all(const Style& style) {
    const TraceHeader header = header_of(near_before_far());
    Options options{.show = {Part::picture, Part::windows, Part::list, Part::listing}, .style = style};
    options.width = 170;
    options.moments = 2;
    Figure figure(options);
    Moment moment(header);
    for (const auto& event : a_division()) moment.take(event);
    figure.add(moment, std::nullopt);
    moment.take(event::Fill{Line::W8, {8, 8, 8, 8}, header.scene.polygons[0].color});
    figure.add(moment, std::nullopt);
    return figure.strip();
}

std::string temporary_file(const std::string& bytes, const std::string& extension) {
    const auto file = std::filesystem::temp_directory_path() / ("vidno-figure-test" + extension);
    OutputFile out(file.string());
    out.write(bytes);
    out.commit();
    return file.string();
}

}  // namespace

TEST_CASE("a strip has its captions, and each part at one height in all panels") {
    const Drawing strip = strip_of_all({});
    CHECK(strip.width == 170);
    const auto labels = all<Label>(strip);
    std::vector<Point> heads;
    for (const auto& label : labels) {
        if (label.text == "Warnock(polygons)") heads.push_back(label.at);
        CHECK(label.at.y <= strip.height);
        CHECK(label.size >= 7);
    }
    REQUIRE(heads.size() == 2);
    CHECK(heads[0].y == heads[1].y);
    CHECK(has_line(strip, "(a) The window (8, 8) 8 × 8 comes off the stack"));
    CHECK(has_line(strip, "(b) 64 pixels take the colour of A."));
    CHECK(has_line(strip_of_all({.language = Language::russian}), "(a) Окно (8; 8) 8 × 8 берётся из стека"));
}

TEST_CASE("no line is thinner than 0.25 points") {
    for (const auto& path : all<Path>(strip_of_all({}))) {
        if (path.stroke) CHECK(path.stroke->width >= 0.25);
    }
}

TEST_CASE("SVG: well formed, no bitmap, live text, and characters that XML cannot represent are replaced") {
    Drawing drawing = strip_of_all({.language = Language::russian});
    drawing.add(Label{"a<b&\"c\"\x01", {1, 1}});
    const About about{"A < B", Language::russian};
    const std::string svg = svg_of(drawing, about);
    CHECK(svg.find("<image") == svg.npos);
    CHECK(svg.find("data:") == svg.npos);
    CHECK(svg.find(">a&lt;b&amp;&quot;c&quot;\ufffd</text>") != svg.npos);
    CHECK(svg.find("width=\"170mm\"") != svg.npos);
    CHECK(svg == svg_of(drawing, about));
    const std::string file = temporary_file(svg, ".svg");
    CHECK(output_of({"xmllint", "--noout", file}, "").empty());  // throws if it is not well formed
    CHECK(output_of({"xmllint", "--xpath", "string(//*[local-name()='title'])", file}, "") == "A < B\n");
}

TEST_CASE("PDF: live text in embedded fonts, no bitmap, the same bytes each time") {
    const About about{"Two panels", Language::russian};
    const std::string svg = svg_of(strip_of_all({.language = Language::russian}), about);
    const std::string pdf = pdf_of({svg}, about);
    CHECK(pdf == pdf_of({svg}, about));
    CHECK(pdf.find("CreationDate") == pdf.npos);
    const std::string file = temporary_file(pdf, ".pdf");
    CHECK(output_of({"pdftotext", file, "-"}, "").find("Активные многоугольники (APL)") != std::string::npos);
    const std::string images = output_of({"pdfimages", "-list", file}, "");
    CHECK(std::count(images.begin(), images.end(), '\n') == 2);  // its heading alone
    const std::string fonts = output_of({"pdffonts", file}, "");
    CHECK(count_of(fonts, "TrueType") > 0);
    CHECK(count_of(fonts, " no  yes") == 0);  // embedded, subset
    // 170 mm are 481.89 points.
    CHECK(output_of({"pdfinfo", file}, "").find("481.89 x") != std::string::npos);
}

TEST_CASE("PNG: as many dots as the size and the resolution say, the same bytes each time") {
    const std::string svg = svg_of({25.4, 50.8}, {});
    const std::string png = png_of(svg, 300);
    CHECK(png == png_of(svg, 300));
    REQUIRE(png.size() > 24);
    // Width and height in the header, big endian: 300 = 0x12c, 600 = 0x258.
    CHECK(png.substr(16, 8) == std::string("\0\0\x01\x2c\0\0\x02\x58", 8));
}

TEST_CASE("TikZ: no character is left that a text font may lack") {
    const auto listings = nlohmann::json::parse(read_file(VIDNO_ROOT "/trace/listings/listings.json"));
    const auto expect_plain = [](const std::string& text) {
        const std::string tex = tikz_of({10, 10, {Label{text, {1, 1}}}}, {});
        std::string strange;
        for (const char32_t c : characters_of(tex)) {
            const bool plain = c < 0x7f || (c >= U'А' && c <= U'я') || c == U'ё' || c == U'«' || c == U'»';
            if (!plain) strange += utf8(c);
        }
        CHECK_MESSAGE(strange.empty(), strange << " in " << text);
    };
    for (const auto& procedure : listings.at("procedures")) {
        expect_plain(procedure.at("takes"));
        for (const auto& line : procedure.at("lines")) {
            for (const auto* language : {"en", "ru"}) {
                expect_plain(line.at(language));
                if (line.contains("printed")) expect_plain(line.at("printed").at(language));
            }
        }
    }
    for (const auto& deviation : deviations) {
        for (const auto& [english, russian] : deviation.reads) {
            expect_plain(std::string(english));
            expect_plain(std::string(russian));
        }
    }
    for (const auto& label : all<Label>(strip_of_all({}))) expect_plain(label.text);
    for (const double value : {-1., 1e-9, 1. / 0.}) expect_plain(readable(Value(value), Language::english));
}

TEST_CASE("TikZ: characters that are special in TeX are written as text") {
    const std::string tex = tikz_of({10, 10, {Label{"a_b{c}\\50%", {1, 1}}}}, {});
    CHECK(tex.find("a\\_b\\{c\\}\\textbackslash{}50\\%") != tex.npos);
}

TEST_CASE("a slide has an overlay a step") {
    const Drawing drawing{140, 60};
    const std::string tex = beamer_of({drawing, drawing, drawing}, {});
    CHECK(count_of(tex, "\\only<") == 3);
    CHECK(tex.find("\\only<3>") != tex.npos);
    CHECK(count_of(tex, "(0,0) rectangle (140,60)") == 3);
}

TEST_CASE("every line and every procedure has its listing") {
    const TraceHeader header = header_of(near_before_far());
    for (std::size_t i = 0; i <= std::size_t(Line::Z17); ++i) {
        const Moment moment = after(header, {event::Decide{Line(i), {}}});
        CHECK(has_text(listing_part(moment, {}, 80), std::string(line_names[i])));
    }
}

}  // namespace vidno::figures
