// The alphabets of a .tex figure: its font encodings, or the engine that it needs.

#include <doctest/doctest.h>

#include <string>

#include "figure/writers.h"

using namespace vidno;
using namespace vidno::figures;

namespace {

Drawing labelled(const std::string& text) {
    Drawing drawing{20, 10};
    drawing.add(Label{text, {1, 5}, 8, Anchor::start, false, {}});
    return drawing;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

struct Lettered {
    std::string label;
    Language language;
    std::string fonts, beyond;
};

}  // namespace

TEST_CASE("A .tex figure loads the encodings of its letters, whatever its language") {
    constexpr auto english = Language::english, russian = Language::russian;
    const std::string t1 = "[T1]{fontenc}", t2a = "[T2A]{fontenc}", both = "[T1,T2A]{fontenc}", other = "{fontspec}";
    for (const auto& [label, language, fonts, beyond] : {
             Lettered{"A, z = 1/2", english, t1, ""},
             Lettered{"Łódź", english, t1, ""},
             Lettered{"σ ≤ ∞ · →", english, t1, ""},
             Lettered{"Куб", english, both, ""},
             Lettered{"Куб", russian, t2a, ""},
             Lettered{"A", russian, t2a, ""},
             Lettered{"Đà", russian, both, ""},
             Lettered{"Їжак и Łódź", english, both, ""},
             Lettered{"立方体", english, other, "立方体"},
             Lettered{"立方体", russian, other, "立方体"},
             Lettered{"αβα", english, other, "αβ"},
             Lettered{"🙂", english, other, "🙂"},
             Lettered{"שלום", russian, other, "שלום"},
         }) {
        const auto& shown_label = label;
        CAPTURE(shown_label);
        const Drawing drawing = labelled(label);
        CHECK(beyond_pdflatex({drawing}) == beyond);
        for (const std::string& text : {tikz_of(drawing, {"", language}), beamer_of({drawing}, {"", language})}) {
            CHECK(has(text, fonts));
            CHECK(has(text.substr(0, text.find("\\def")),
                      beyond.empty() ? "under pdfLaTeX" : "Needs LuaLaTeX or XeLaTeX"));
        }
    }
}

TEST_CASE("The title of a figure is a comment, so its letters need no font") {
    CHECK(has(tikz_of(labelled("A"), {"立方体", Language::english}), "[T1]{fontenc}"));
}
