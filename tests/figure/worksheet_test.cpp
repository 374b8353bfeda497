// Worksheets: the contents of the pages, blank and filled in.

#include "figure/worksheet.h"

#include <doctest/doctest.h>

#include <cctype>

#include "figure/worksheet_words.h"
#include "output.h"
#include "page/program.h"
#include "refused.h"
#include "scene/scene_json.h"
#include "scene/surface.h"
#include "support/bodies.h"
#include "support/curves.h"
#include "support/scenes.h"
#include "support/workplace.h"

namespace vidno::figures {

namespace {

AdmittedScene read(const std::string& file) { return read_scene(read_file(file), file).scene; }

/// A covers all of 2 x 2 pixels; B, in front of it, lies in the upper left one.
AdmittedScene a_pixel_before_a_wall() {
    return test::SceneBuilder({0, 0, 2, 2}).quad(-1, -1, 3, 3, 0).quad(.25, .25, .75, .75, .5).build();
}

/// z = y / 8 over all of 4 x 4 pixels.
AdmittedScene a_slope() {
    return test::SceneBuilder({0, 0, 4, 4}).polygon({{0, 0, 0}, {4, 0, 0}, {4, 4, .5}, {0, 4, .5}}).build();
}

/// The curves of the first exercise of lesson 15.
Surface three_curves() {
    return {"", test::CurveSceneBuilder({0, 0, 5, 8})
                    .curve({{0, 4}, {4, 4}})
                    .curve({{0, 6}, {4, 2}})
                    .curve({{0, 2}, {2, 5}, {4, 2}})
                    .build()};
}

Surface read_curves(const std::string& file) { return read_surface(read_file(file), file); }

std::vector<Label> labels_of(const Drawing& page) {
    std::vector<Label> labels;
    for (const auto& thing : page.things) {
        if (const auto* label = std::get_if<Label>(&thing)) labels.push_back(*label);
    }
    return labels;
}

/// The texts of the lines that have this one in them, from left to right.
std::vector<std::vector<std::string>> lines_with(const Drawing& page, const std::string& text) {
    auto labels = labels_of(page);
    std::stable_sort(labels.begin(), labels.end(), [](const Label& a, const Label& b) { return a.at.x < b.at.x; });
    std::vector<std::vector<std::string>> lines;
    for (const Label& found : labels_of(page)) {
        if (found.text != text) continue;
        auto& line = lines.emplace_back();
        for (const Label& label : labels) {
            if (label.at.y == found.at.y) line.push_back(label.text);
        }
    }
    return lines;
}

using Texts = std::vector<std::string>;

bool has_line(const Drawing& page, const std::string& text) { return !lines_with(page, text).empty(); }

Box box_of(const Label& label) {
    const double width = width_of(label.text, label.size, label.bold);
    const double height = 0.72 * label.size / points_per_millimetre;
    const double left = label.at.x - (label.anchor == Anchor::start    ? 0
                                      : label.anchor == Anchor::middle ? width / 2
                                                                       : width);
    return {left, label.at.y - height, width, height};
}

}  // namespace

TEST_CASE("worksheet: the windows of a pixel in front of a wall, by hand") {
    const WorkedRun run(a_pixel_before_a_wall(), Method::warnock);
    const auto pages = worksheet(run, Language::english, true);
    REQUIRE(pages.size() == 2);
    // Both planes are level: A, of side 4, has c = 2 * 16 and d = 0; B, of side 1/2, c = 1/2 and d = -c / 2.
    CHECK(lines_with(pages[0], "32") == std::vector<Texts>{{"A", "0", "0", "32", "0"}});
    CHECK(lines_with(pages[0], "1/2") == std::vector<Texts>{{"B", "0", "0", "1/2", "−1/4"}});
    // B is nearer at all corners of the first window but does not surround it, so the window is split. The parts are
    // taken from the end of AW. B's box is outside three of them, and A surrounds these; the fourth is a pixel, and B
    // is nearest at its centre.
    CHECK(lines_with(pages[1], "W13 split") == std::vector<Texts>{{"1", "(0, 0) 2 × 2", "S 4", "+ 4", "W13 split"}});
    CHECK(lines_with(pages[1], "W8 surrounded") ==
          std::vector<Texts>{{"2", "(1, 1) 1 × 1", "S 4", "−", "W8 surrounded", "A"},
                             {"3", "(1, 0) 1 × 1", "S 4", "−", "W8 surrounded", "A"},
                             {"4", "(0, 1) 1 × 1", "S 4", "−", "W8 surrounded", "A"}});
    CHECK(lines_with(pages[1], "W9 pixel") == std::vector<Texts>{{"5", "(0, 0) 1 × 1", "S 4", "+ 4", "W9 pixel", "B"}});
}

TEST_CASE("worksheet: the rows of a slope and its depths, by hand") {
    const WorkedRun run(a_slope(), Method::zbuffer);
    const auto pages = worksheet(run, Language::english, true);
    REQUIRE(pages.size() == 3);
    // Row j has its centre at y = j + 1/2, where z = (2j + 1) / 16. Both edges are upright and last to row 3.
    for (int j = 0; j < 4; ++j) {
        const std::string z = std::to_string(2 * j + 1) + "/16";
        CHECK(lines_with(pages[1], z).front() ==
              Texts{"A", std::to_string(j), "0", z, "3", "0", "1/8", "4", z, "3", "0", "1/8", "0–3"});
        CHECK(lines_with(pages[2], z) == std::vector<Texts>(4, Texts(4, z)));
    }
}

TEST_CASE("worksheet: a level edge on a row's centres is shown without an AEL") {
    // From y = 1/2 to 3/2. An edge's rows end before its lower end, but for those at the polygon's lowest point: the
    // upper level edge has none; the lower one is shown on row 1, and then what is between the upright ones.
    const WorkedRun run(test::SceneBuilder({0, 0, 4, 4}).quad(0, .5, 4, 1.5, 0).build(), Method::zbuffer);
    std::vector<std::pair<int, std::size_t>> found;
    for (const auto& row : run.rows()) found.emplace_back(row.row, row.edges.size());
    CHECK(found == std::vector<std::pair<int, std::size_t>>{{0, 2}, {1, 0}, {1, 2}});
}

TEST_CASE("worksheet: the blank one is the key without the answers") {
    for (const Method method : {Method::warnock, Method::zbuffer}) {
        const WorkedRun run(method == Method::warnock ? a_pixel_before_a_wall() : a_slope(), method);
        for (const Language language : {Language::english, Language::russian}) {
            const auto blank = worksheet(run, language, false);
            const auto key = worksheet(run, language, true);
            REQUIRE(blank.size() == key.size());
            for (std::size_t i = 0; i < blank.size(); ++i) {
                const auto answered = labels_of(key[i]);
                for (const Label& label : labels_of(blank[i])) {
                    const auto& words = worksheet_words_of(language);
                    if (label.text == words.name || label.text == words.date) continue;
                    CAPTURE(label.text);
                    CHECK(std::any_of(answered.begin(), answered.end(), [&](const Label& each) {
                        return each.text == label.text && each.at == label.at;
                    }));
                }
                for (const std::string answer : {"32", "1/2", "S 4", "+ 4", "(0, 0) 2 × 2", "1/16", "0–3", "1/8"}) {
                    CHECK(lines_with(blank[i], answer).empty());
                }
            }
        }
    }
}

/// No two texts overlap, and none leaves the paper.
void expect_readable(const std::vector<Drawing>& pages) {
    const Box paper{10, 10, 190, 280};
    for (const auto& page : pages) {
        const auto labels = labels_of(page);
        for (std::size_t i = 0; i < labels.size(); ++i) {
            CAPTURE(labels[i].text);
            CHECK(paper.holds(box_of(labels[i])));
            for (std::size_t j = 0; j < i; ++j) {
                CHECK_MESSAGE(!box_of(labels[i]).overlaps(box_of(labels[j])), labels[j].text);
            }
        }
    }
}

TEST_CASE("worksheet: texts do not overlap, and all are on the paper") {
    const std::string lessons = VIDNO_ROOT "/lessons/";
    for (const auto& [file, method] : {std::pair(lessons + "01-four-relations/scene.json", Method::warnock),
                                       std::pair(lessons + "09-usual-mistakes/mistakes.json", Method::warnock),
                                       std::pair(lessons + "06-plane-and-depth/scene.json", Method::zbuffer),
                                       std::pair(lessons + "07-z-buffer-ael/scene.json", Method::zbuffer),
                                       std::pair(lessons + "08-show-line/scene.json", Method::zbuffer)}) {
        for (const Language language : {Language::english, Language::russian}) {
            const WorkedRun run(read(file), method);
            expect_readable(worksheet(run, language, true));
        }
    }
    for (const std::string name : {"scene", "edges"}) {
        const WorkedCurves run(read_curves(lessons + "15-floating-horizon/" + name + ".json"));
        for (const Language language : {Language::english, Language::russian}) {
            expect_readable(worksheet(run, language, true));
        }
    }
}

TEST_CASE("worksheet: several scenes as one PDF, its key beside it, the same bytes each time") {
    const Workplace work;
    const std::string wall = work.write("wall.json", scene_json(a_pixel_before_a_wall()));
    const std::string slope = work.write("slope.json", scene_json(a_slope()));
    const std::string call = "worksheet " + wall + " " + slope + " --language ru -o " + work.file("blank.pdf");
    REQUIRE(program(call + " --key " + work.file("key.pdf")).status == 0);
    const std::string blank = work.read("blank.pdf");
    REQUIRE(program(call).status == 0);
    CHECK(work.read("blank.pdf") == blank);
    for (const std::string file : {"blank.pdf", "key.pdf"}) {
        const std::string about = output_of({"pdfinfo", work.file(file)}, "");
        CHECK(about.find("Pages:           4\n") != std::string::npos);
        CHECK(about.find("(A4)") != std::string::npos);
        CHECK(output_of({"pdffonts", work.file(file)}, "").find(" no  yes") == std::string::npos);  // not embedded
    }
    CHECK(output_of({"pdftotext", work.file("blank.pdf"), "-"}, "").find("Фамилия") != std::string::npos);
    CHECK(output_of({"pdftotext", work.file("key.pdf"), "-"}, "").find("Ответы") != std::string::npos);
}

TEST_CASE("worksheet: chosen rows alone, with the row before them and their places filled in") {
    const WorkedRun run(a_slope(), Method::zbuffer);
    const auto blank = worksheet(run, Language::english, false, ChosenRows{2, 3});
    // Row 0 is given as a whole; of rows 1 and 2 polygon and row. Row 3 follows, and is not on the sheet.
    CHECK(lines_with(blank[1], "1/16").front().size() == 13);
    CHECK(lines_with(blank[1], "1") == std::vector<Texts>{{"A", "1"}});
    CHECK(lines_with(blank[1], "2") == std::vector<Texts>{{"A", "2"}});
    CHECK(lines_with(blank[1], "3/16").empty());
    CHECK(lines_with(worksheet(run, Language::english, true, ChosenRows{2, 3})[1], "5/16").size() == 2);
    CHECK(lines_with(worksheet(run, Language::english, true, ChosenRows{2, 3})[1], "7/16").empty());
    CHECK_THROWS_AS(worksheet(run, Language::english, true, ChosenRows{5, 9}), Refused);
}

TEST_CASE("worksheet: rows chosen by the steps at which they begin") {
    const WorkedRun run(a_slope(), Method::zbuffer);
    REQUIRE(run.rows().size() == 4);
    const std::uint64_t step = run.rows()[1].step;
    CHECK(run.rows()[0].step < step);
    const auto by_step = worksheet(run, Language::english, true, ChosenRows{step, step, true});
    CHECK(lines_with(by_step[1], "3/16") ==
          lines_with(worksheet(run, Language::english, true, ChosenRows{2, 2})[1], "3/16"));
    CHECK(lines_with(by_step[1], "5/16").empty());
}

TEST_CASE("worksheet: the windows of a member of Warnock's family, by hand") {
    // B lies inside the first window, A surrounds it. Then B's box is outside three quarters, which A surrounds; in the
    // pixel at the upper left, B is inside again.
    const WorkedRun run(a_pixel_before_a_wall(), Method::warnock_full);
    std::vector<std::pair<Case, std::optional<int>>> found;
    for (const auto& window : run.windows()) found.emplace_back(window.which, window.painted);
    using Found = std::vector<std::pair<Case, std::optional<int>>>;
    CHECK(found == Found{{Case::split, std::nullopt},
                         {Case::surrounded, 0},
                         {Case::surrounded, 0},
                         {Case::surrounded, 0},
                         {Case::pixel, 1}});
    CHECK(run.windows()[0].entries.at(0).relation == Relation::surrounding);
    CHECK(run.windows()[0].entries.at(1).relation == Relation::inside);
    CHECK(run.windows()[1].entries.at(1).relation == Relation::outside);
    const auto pages = worksheet(run, Language::english, true);
    CHECK(has_line(pages[0], "Warnock (three lists)"));
    CHECK(has_line(worksheet(run, Language::russian, true)[0], "Алгоритм Варнока (три списка)"));
    // That A still surrounds is known from the first window.
    CHECK(lines_with(pages[1], "(1, 1) 1 × 1") ==
          std::vector<Texts>{{"2", "(1, 1) 1 × 1", "−", "WF9 surrounded", "A"}});
}

TEST_CASE("worksheet: the windows of a closed body, by hand") {
    // Only face D of the box around the area, at z = 1/2, looks towards the viewer: A looks away, and the other faces
    // are edge-on.
    test::SceneBuilder builder({0, 0, 4, 4});
    test::add_body(builder, test::parallelepiped({-2, -2, 0}, {8, 0, 0}, {0, 8, 0}, {0, 0, .5}));
    const WorkedRun run(builder.build(), Method::warnock_bodies);
    const auto pages = worksheet(run, Language::english, true);
    CHECK(lines_with(pages[1], "W8 surrounded") ==
          std::vector<Texts>{{"1", "(0, 0) 4 × 4", "S 4", "W8 surrounded", "D"}});
    CHECK(has_line(pages[1], std::string(worksheet_words_of(Language::english).legend)));
}

TEST_CASE("worksheet: the lists of Weiler and Atherton's algorithm, by hand") {
    // B lies inside A's outline and in front. The list B, A: A has a part inside B, which is behind, and one outside.
    // So B is visible, and A outside B is the next list, visible as well.
    const WorkedRun run(a_pixel_before_a_wall(), Method::weiler_atherton);
    const auto pages = worksheet(run, Language::english, true);
    CHECK(lines_with(pages[1], "C visible") == std::vector<Texts>{{"1", "B", "B, A", "A", "A", "∅", "C visible"},
                                                                  {"2", "A", "A", "∅", "∅", "∅", "C visible"}});
}

TEST_CASE("worksheet: flags, horizons and meetings of three curves, by hand in lesson 15") {
    const WorkedCurves run(three_curves());
    const auto pages = worksheet(run, Language::english, true);
    REQUIRE(pages.size() == 2);
    CHECK(has_line(pages[0], "(0, 2); (2, 5); (4, 2)"));
    CHECK(lines_with(pages[1], "y") == std::vector<Texts>{{"y", "4", "4", "4", "4", "4"},
                                                          {"y", "6", "5", "4", "3", "2"},
                                                          {"y", "2", "7/2", "5", "7/2", "2"}});
    CHECK(lines_with(pages[1], "flag") == std::vector<Texts>{{"flag", "±1", "±1", "±1", "±1", "±1"},
                                                             {"flag", "−1", "−1", "±1", "1", "1"},
                                                             {"flag", "1", "1", "−1", "0", "1"}});
    CHECK(lines_with(pages[1], "upper") == std::vector<Texts>{{"upper", "4", "4", "4", "4", "4"},
                                                              {"upper", "4", "4", "4", "3", "2"},
                                                              {"upper", "2", "7/2", "4", "3", "2"}});
    CHECK(lines_with(pages[1], "lower") == std::vector<Texts>{{"lower", "4", "4", "4", "4", "4"},
                                                              {"lower", "6", "5", "4", "4", "4"},
                                                              {"lower", "6", "5", "5", "4", "4"}});
    // Curve 1 is visible throughout. Curve 2 changes sides between columns 1 and 2, ends before column 3, and touches
    // on column 4.
    CHECK(lines_with(pages[1], "meets") ==
          std::vector<Texts>{{"meets", "—"},
                             {"meets", "—"},
                             {"meets", "upper (4/3, 4);  lower (8/5, 22/5);  lower (8/3, 4);  upper (4, 2)"}});
}

TEST_CASE("worksheet: the blank sheet of curves has the samples' heights and nothing else that is found") {
    const auto blank = worksheet(WorkedCurves(three_curves()), Language::english, false);
    CHECK(lines_with(blank[1], "y") == std::vector<Texts>{{"y", "4", "4"}, {"y", "6", "2"}, {"y", "2", "5", "2"}});
    for (const std::string line : {"flag", "meets", "upper", "lower"}) {
        CHECK(lines_with(blank[1], line) == std::vector<Texts>(3, Texts{line}));
    }
}

TEST_CASE("worksheet: chosen curves alone, with the curve before them filled in") {
    const WorkedCurves run(three_curves());
    const auto third = worksheet(run, Language::english, false, ChosenRows{3, 3});
    CHECK(lines_with(third[1], "flag") == std::vector<Texts>{{"flag", "−1", "−1", "±1", "1", "1"}, {"flag"}});
    CHECK_FALSE(has_line(third[1], "curve 0"));
    const std::uint64_t step = run.curves()[1].step;
    const auto by_step = worksheet(run, Language::english, false, ChosenRows{step, step, true});
    CHECK(has_line(by_step[1], "curve 1"));
    CHECK_FALSE(has_line(by_step[1], "curve 2"));
    CHECK_THROWS_AS(worksheet(run, Language::english, false, ChosenRows{4, 9}), Refused);
}

TEST_CASE("worksheet: between the ends of two curves the side edges count") {
    // Curve 1 begins 4 columns to the right of curve 0 and 4 higher: over columns 1 to 3 the left edge is at 8, 7, 6.
    const WorkedCurves run(
        {"", test::CurveSceneBuilder({0, 0, 9, 10}).curve({{0, 9}, {4, 9}}).curve({{4, 5}, {8, 5}}).build()});
    const auto page = worksheet(run, Language::english, true)[1];
    CHECK(lines_with(page, "upper")[1] == Texts{"upper", "9", "8", "7", "6", "5", "5", "5", "5", "5"});
    CHECK(has_line(page, std::string(worksheet_words_of(Language::english).sides_legend)));
    const auto without = worksheet(WorkedCurves(three_curves()), Language::english, true)[1];
    CHECK_FALSE(has_line(without, std::string(worksheet_words_of(Language::english).sides_legend)));
}

TEST_CASE("worksheet: Russian sheets have decimal commas, and semicolons between coordinates") {
    const auto has_point = [](const std::string& text) {
        const auto is_digit = [&](std::size_t at) { return std::isdigit(static_cast<unsigned char>(text[at])); };
        for (std::size_t i = 1; i + 1 < text.size(); ++i) {
            if (text[i] == '.' && is_digit(i - 1) && is_digit(i + 1)) return true;
        }
        return false;
    };
    const auto expect_commas = [&](const std::vector<Drawing>& pages) {
        for (const auto& page : pages) {
            for (const Label& label : labels_of(page)) CHECK_MESSAGE(!has_point(label.text), label.text);
        }
    };
    for (std::size_t i = 0; i < method_names.size(); ++i) {
        if (choice_of(Method(i)).takes_closed_bodies) continue;
        CAPTURE(method_names[i]);
        const auto pages = worksheet(WorkedRun(a_pixel_before_a_wall(), Method(i)), Language::russian, true);
        expect_commas(pages);
        CHECK(has_line(pages[0], "0,25"));
    }
    CHECK(has_line(worksheet(WorkedRun(a_pixel_before_a_wall(), Method::warnock), Language::russian, true)[1],
                   "(0; 0) 2 × 2"));
    const WorkedCurves curves({"", test::CurveSceneBuilder({0, 0, 3, 4}).curve({{0, 2.5}, {2, 1}}).build()});
    expect_commas(worksheet(curves, Language::russian, true));
    CHECK(has_line(worksheet(curves, Language::russian, true)[0], "(0; 2,5); (2; 1)"));
}

TEST_CASE("worksheet: a scene of the course has its name in the sheet's language") {
    const WorkedRun run(read(VIDNO_ROOT "/lessons/01-four-relations/scene.json"), Method::warnock);
    CHECK(has_line(worksheet(run, Language::russian, false)[0], "Четыре отношения многоугольника к окну"));
    CHECK(has_line(worksheet(run, Language::english, false)[0], "Four relations of a polygon to a window"));
}

TEST_CASE("worksheet: a scene that does not fit is refused, and no file appears") {
    const Workplace work;
    test::SceneBuilder eleven({0, 0, 2, 2});
    for (int i = 0; i < 11; ++i) eleven.quad(0, 0, 1, 1, 0);
    const std::string crowd = work.write("crowd.json", scene_json(eleven.build()));
    const std::string large =
        work.write("large.json", scene_json(test::SceneBuilder({0, 0, 41, 2}).quad(0, 0, 1, 1, 0).build()));
    const std::string wall = work.write("wall.json", scene_json(a_pixel_before_a_wall()));
    const auto reason = [&](const std::string& arguments) {
        const auto refused = program("worksheet " + arguments);
        CHECK(refused.status == 2);
        CHECK(refused.text.find('\n') == refused.text.size() - 1);
        return refused.text;
    };
    const std::string to = " -o " + work.file("a.pdf");
    CHECK(reason(crowd + to).find("11 polygons, but a worksheet takes at most 10") != std::string::npos);
    CHECK(reason(large + to).find("41 pixels a side") != std::string::npos);
    CHECK(reason(wall + " " + large + to).find("41 pixels a side") != std::string::npos);
    CHECK(reason(wall + " -o " + work.file("a.svg")).find("not .pdf") != std::string::npos);
    CHECK(reason(wall + to + " --key " + work.file("a.pdf")).find("--key") != std::string::npos);
    CHECK(reason(wall + to + " --rows 9..12").find("rows in all: 5") != std::string::npos);
    CHECK(reason(wall + to + " --rows 5..2").find("this range contains no row") != std::string::npos);
    CHECK(reason(wall + to + " --rows few").find("not N or A..B") != std::string::npos);
    CHECK(work.files() == 3);
}

TEST_CASE("worksheet: a surface has the floating horizon's sheets, and no others") {
    const Workplace work;
    const std::string curves = work.write("curves.json", surface_json(three_curves()));
    const std::string wide = work.write(
        "wide.json", surface_json({"", test::CurveSceneBuilder({0, 0, 18, 4}).curve({{0, 1}, {17, 2}}).build()}));
    const std::string wall = work.write("wall.json", scene_json(a_pixel_before_a_wall()));
    const auto reason = [&](const std::string& arguments) {
        const auto refused = program("worksheet " + arguments + " -o " + work.file("refused.pdf"));
        CHECK(refused.status == 2);
        return refused.text;
    };
    CHECK(reason(wide).find("18 columns, but a worksheet takes at most 17") != std::string::npos);
    CHECK(reason(curves + " --method zbuffer").find("a surface, which only --method floating-horizon draws") !=
          std::string::npos);
    CHECK(reason(wall + " --method floating-horizon").find("is not a surface") != std::string::npos);
    CHECK(reason(curves + " --rows 4..5").find("rows in all: 3") != std::string::npos);
    CHECK_FALSE(work.has("refused.pdf"));

    const std::string call = "worksheet " + curves + " --method floating-horizon --language ru -o ";
    REQUIRE(program(call + work.file("blank.pdf") + " --key " + work.file("key.pdf")).status == 0);
    CHECK(output_of({"pdftotext", work.file("blank.pdf"), "-"}, "").find("Плавающий горизонт") != std::string::npos);
    CHECK(output_of({"pdftotext", work.file("key.pdf"), "-"}, "").find("верхний (4/3; 4)") != std::string::npos);
    CHECK_MESSAGE(program("worksheet " + wall + " " + curves + " -o " + work.file("both.pdf")).status == 0,
                  "each with its own algorithm");
}

}  // namespace vidno::figures
