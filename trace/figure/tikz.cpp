#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "characters.h"
#include "writers.h"

namespace vidno::figures {

namespace {

// Characters that a text font may lack, or that are special in TeX.
constexpr auto in_tex = std::to_array<std::pair<char32_t, std::string_view>>({
    {U'\\', "\\textbackslash{}"},
    {U'{', "\\{"},
    {U'}', "\\}"},
    {U'$', "\\$"},
    {U'&', "\\&"},
    {U'#', "\\#"},
    {U'%', "\\%"},
    {U'_', "\\_"},
    {U'^', "\\textasciicircum{}"},
    {U'~', "\\textasciitilde{}"},
    {U'<', "\\ensuremath{<}"},
    {U'>', "\\ensuremath{>}"},
    {U'|', "\\ensuremath{|}"},
    {U'·', "\\ensuremath{\\cdot}"},
    {U'±', "\\ensuremath{\\pm}"},
    {U'×', "\\ensuremath{\\times}"},
    {U'Δ', "\\ensuremath{\\Delta}"},
    {U'Σ', "\\ensuremath{\\Sigma}"},
    {U'σ', "\\ensuremath{\\sigma}"},
    {U'δ', "\\ensuremath{\\delta}"},
    {U'ᵐ', "\\ensuremath{{}^m}"},
    {U'ᵢ', "\\ensuremath{{}_i}"},
    {U'ⱼ', "\\ensuremath{{}_j}"},
    {U'–', "--"},
    {U'—', "---"},
    {U'…', "\\ldots{}"},
    {U'′', "\\ensuremath{'}"},
    {U'″', "\\ensuremath{''}"},
    {U'₀', "\\ensuremath{{}_0}"},
    {U'₁', "\\ensuremath{{}_1}"},
    {U'₂', "\\ensuremath{{}_2}"},
    {U'₃', "\\ensuremath{{}_3}"},
    {U'₄', "\\ensuremath{{}_4}"},
    {U'ₑ', "\\ensuremath{{}_e}"},
    {U'₊', "\\ensuremath{{}_+}"},
    {U'₋', "\\ensuremath{{}_-}"},
    {U'ₙ', "\\ensuremath{{}_n}"},
    {U'ₜ', "\\ensuremath{{}_t}"},
    {U'→', "\\ensuremath{\\rightarrow}"},
    {U'↓', "\\ensuremath{\\downarrow}"},
    {U'∅', "\\ensuremath{\\emptyset}"},
    {U'−', "\\ensuremath{-}"},
    {U'∞', "\\ensuremath{\\infty}"},
    {U'∩', "\\ensuremath{\\cap}"},
    {U'∪', "\\ensuremath{\\cup}"},
    {U'≈', "\\ensuremath{\\approx}"},
    {U'≠', "\\ensuremath{\\neq}"},
    {U'≤', "\\ensuremath{\\leq}"},
    {U'≥', "\\ensuremath{\\geq}"},
    {U'≯', "\\ensuremath{\\not>}"},
    {U'≮', "\\ensuremath{\\not<}"},
});

std::string escaped_for_tex(std::string_view text) {
    std::string written;
    for (const char32_t c : characters_of(text)) {
        const auto found =
            std::find_if(in_tex.begin(), in_tex.end(), [&](const auto& each) { return each.first == c; });
        if (found != in_tex.end()) {
            written += found->second;
        } else {
            written += c < 0x20 ? " " : utf8(c);
        }
    }
    return written;
}

std::string at(Point point) { return "(" + decimal(point.x) + "," + decimal(point.y) + ")"; }

std::string option(std::string_view name, const Color& color) {
    return std::string(name) + "={rgb,255:red," + std::to_string(color.red) + ";green," + std::to_string(color.green) +
           ";blue," + std::to_string(color.blue) + "}";
}

/// TeX's own points are smaller.
std::string points(double length) { return decimal(length) + "bp"; }

std::string command(const Path& path) {
    std::string options = path.fill ? option("fill", *path.fill) : "";
    if (const auto& stroke = path.stroke) {
        if (!options.empty()) options += ", ";
        options += option("draw", stroke->color) + ", line width=" + points(stroke->width);
        std::string dashes;
        for (const double dash : stroke->dashes) dashes += (dashes.empty() ? "on " : " off ") + points(dash);
        if (!dashes.empty()) options += ", dash pattern=" + dashes;
    }
    std::string text = "\\path[" + options + "]";
    for (const auto& line : path.lines) {
        std::string_view to = "\n  ";
        for (const auto& point : line) text += std::string(std::exchange(to, "--")) + at(point);
        if (path.closed) text += "--cycle";
    }
    return text + ";\n";
}

std::string command(const Label& label) {
    constexpr std::array<std::string_view, 3> anchors{"base west", "base", "base east"};
    std::string options = std::string(anchors[std::size_t(label.anchor)]);
    if (!(label.color == Color{})) options += ", " + option("text", label.color);
    const std::string font = "\\fontsize{" + decimal(label.size) + "bp}{" + decimal(1.2 * label.size) +
                             "bp}\\selectfont" + (label.bold ? "\\bfseries" : "");
    return "\\node[anchor=" + options + ", font=" + font + "] at " + at(label.at) + " {\\vidnofit{" +
           decimal(letters_of_tex * width_of(label.text, label.size, label.bold)) + "mm}{" +
           escaped_for_tex(label.text) + "}};\n";
}

std::string environment(const Drawing& drawing) {
    std::string text =
        "\\begin{tikzpicture}[x=1mm, y=-1mm, line join=round, inner sep=0pt, outer sep=0pt]\n"
        "\\path[use as bounding box] (0,0) rectangle " +
        at({drawing.width, drawing.height}) + ";\n";
    for (const auto& thing : drawing.things) {
        text += std::visit([](const auto& each) { return command(each); }, thing);
    }
    return text + "\\end{tikzpicture}";
}

struct Range {
    char32_t first, last;
};

// What LaTeX's own tables give these font encodings; the text symbols are in every document.
constexpr auto in_t1 = std::to_array<Range>({{0xC0, 0xD6},
                                             {0xD8, 0xF6},
                                             {0xF8, 0xFF},
                                             {0x102, 0x107},
                                             {0x10C, 0x111},
                                             {0x118, 0x11B},
                                             {0x139, 0x13E},
                                             {0x141, 0x144},
                                             {0x147, 0x148},
                                             {0x150, 0x155},
                                             {0x158, 0x15B},
                                             {0x15E, 0x165},
                                             {0x16E, 0x171},
                                             {0x178, 0x17E},
                                             {0x201A, 0x201A}});
constexpr auto in_t2a = std::to_array<Range>({{0x401, 0x401},
                                              {0x404, 0x404},
                                              {0x406, 0x407},
                                              {0x40E, 0x40E},
                                              {0x410, 0x44F},
                                              {0x451, 0x451},
                                              {0x454, 0x454},
                                              {0x456, 0x457},
                                              {0x45E, 0x45E},
                                              {0x490, 0x491}});
constexpr auto in_every_encoding = std::to_array<Range>({{0, 0x7E},
                                                         {0xA1, 0xAC},
                                                         {0xAE, 0xBF},
                                                         {0xD7, 0xD7},
                                                         {0xF7, 0xF7},
                                                         {0x2018, 0x2019},
                                                         {0x201C, 0x201E},
                                                         {0x2022, 0x2022},
                                                         {0x20AC, 0x20AC},
                                                         {0x2116, 0x2116}});

bool is_among(char32_t character, const auto& ranges) {
    return std::any_of(ranges.begin(), ranges.end(),
                       [&](const Range& range) { return range.first <= character && character <= range.last; });
}

/// The alphabets of a figure's labels.
struct Alphabets {
    bool is_western = false, is_cyrillic = false;
    std::u32string others;  // characters that pdfLaTeX's fonts lack, each once
};

Alphabets alphabets_in(const std::vector<Drawing>& drawings) {
    Alphabets found;
    const auto add = [&](char32_t c) {
        const auto special = [&](const auto& each) { return each.first == c; };
        if (std::any_of(in_tex.begin(), in_tex.end(), special) || is_among(c, in_every_encoding)) return;
        if (is_among(c, in_t1)) {
            found.is_western = true;
        } else if (is_among(c, in_t2a)) {
            found.is_cyrillic = true;
        } else if (found.others.find(c) == found.others.npos) {
            found.others += c;
        }
    };
    for (const auto& drawing : drawings) {
        for (const auto& thing : drawing.things) {
            const auto* label = std::get_if<Label>(&thing);
            if (!label) continue;
            for (const char32_t c : characters_of(label->text)) add(c);
        }
    }
    return found;
}

std::string utf8_of(const std::u32string& characters) {
    std::string text;
    for (const char32_t c : characters) text += utf8(c);
    return text;
}

/// The fonts of a document with these alphabets.
std::string fonts_for(const Alphabets& alphabets, Language language) {
    if (!alphabets.others.empty()) {
        return "\\usepackage{fontspec}\n"
               "\\IfFontExistsTF{Noto Serif CJK SC}{\\setmainfont{Noto Serif CJK SC}}{}\n";
    }
    const bool is_cyrillic = alphabets.is_cyrillic || language == Language::russian;
    const bool is_western = alphabets.is_western || language == Language::english;
    // Debian's cm-super has the outlines of T2A. The last encoding is the document's; symbols that it lacks come from
    // the other.
    std::string of_both = "\\usepackage[T1,T2A]{fontenc}\n";
    for (const char* symbol : {"DH", "DJ", "TH", "dh", "dj", "th", "quotesinglbase"}) {
        of_both += std::string("\\DeclareTextSymbolDefault{\\") + symbol + "}{T1}\n";
    }
    const std::string encodings = !is_cyrillic ? "\\usepackage[T1]{fontenc}\n\\usepackage{lmodern}\n"
                                  : is_western ? of_both
                                               : "\\usepackage[T2A]{fontenc}\n";
    return "\\usepackage{cmap}\n" + encodings + "\\usepackage[utf8]{inputenc}\n";
}

/// Which engine typesets the document.
std::string engine_for(const Alphabets& alphabets) {
    if (alphabets.others.empty()) return "Stands alone under pdfLaTeX";
    return "Needs LuaLaTeX or XeLaTeX and a font with " + utf8_of(alphabets.others) +
           ", which pdfLaTeX lacks; stands alone there";
}

/// These lines make the figure a complete document, unless another document inputs it.
std::string document(std::string_view classes, const About& about, const Alphabets& alphabets,
                     const std::string& body) {
    std::string title = about.title;
    std::replace(title.begin(), title.end(), '\n', ' ');
    return "% " + title +
           "\n"
           "% " +
           engine_for(alphabets) +
           "; \\input it where the package tikz is loaded.\n"
           "\\def\\vidnofit#1#2{\\setbox0=\\hbox{#2}\\ifdim\\wd0>#1\\resizebox{#1}{\\height}{\\box0}\\else\\box0\\fi}\n"
           "\\expandafter\\ifx\\csname @nodocument\\endcsname\\relax\n"
           "\\let\\vidnoend\\relax\n"
           "\\else\n"
           "\\def\\vidnoend{\\end{document}}\n" +
           std::string(classes) + fonts_for(alphabets, about.language) +
           "\\usepackage{tikz}\n"
           "\\begin{document}\n"
           "\\fi\n" +
           body + "\\vidnoend\n";
}

}  // namespace

std::string beyond_pdflatex(const std::vector<Drawing>& drawings) { return utf8_of(alphabets_in(drawings).others); }

std::string tikz_of(const Drawing& drawing, const About& about) {
    return document("\\documentclass{standalone}\n", about, alphabets_in({drawing}), environment(drawing));
}

std::string beamer_of(const std::vector<Drawing>& drawings, const About& about) {
    constexpr double room = 78;  // millimetres of a slide's height
    double height = 0;
    for (const auto& drawing : drawings) height = std::max(height, drawing.height);
    const std::string scale = decimal(std::min(1., room / height));
    std::string body = "\\begin{frame}\n\\centering\n";
    for (std::size_t i = 0; i < drawings.size(); ++i) {
        body +=
            "\\only<" + std::to_string(i + 1) + ">{\\scalebox{" + scale + "}{%\n" + environment(drawings[i]) + "}}%\n";
    }
    return document("\\documentclass[aspectratio=169]{beamer}\n\\setbeamertemplate{navigation symbols}{}\n", about,
                    alphabets_in(drawings), body + "\\end{frame}\n");
}

}  // namespace vidno::figures
