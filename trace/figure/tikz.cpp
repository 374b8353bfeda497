#include <array>
#include <utility>

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

/// These lines make the figure a complete document, unless another document inputs it.
std::string document(std::string_view classes, const About& about, const std::string& body) {
    // Debian's cm-super has the outlines of T2A.
    constexpr Bilingual encodings{"\\usepackage[T1]{fontenc}\n\\usepackage{lmodern}\n", "\\usepackage[T2A]{fontenc}\n"};
    std::string title = about.title;
    std::replace(title.begin(), title.end(), '\n', ' ');
    return "% " + title +
           "\n"
           "% Stands alone under pdfLaTeX; \\input it where the package tikz is loaded.\n"
           "\\def\\vidnofit#1#2{\\setbox0=\\hbox{#2}\\ifdim\\wd0>#1\\resizebox{#1}{\\height}{\\box0}\\else\\box0\\fi}\n"
           "\\expandafter\\ifx\\csname @nodocument\\endcsname\\relax\n"
           "\\let\\vidnoend\\relax\n"
           "\\else\n"
           "\\def\\vidnoend{\\end{document}}\n" +
           std::string(classes) + "\\usepackage{cmap}\n" + std::string(encodings.in(about.language)) +
           "\\usepackage[utf8]{inputenc}\n\\usepackage{tikz}\n"
           "\\begin{document}\n"
           "\\fi\n" +
           body + "\\vidnoend\n";
}

}  // namespace

std::string tikz_of(const Drawing& drawing, const About& about) {
    return document("\\documentclass{standalone}\n", about, environment(drawing));
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
                    body + "\\end{frame}\n");
}

}  // namespace vidno::figures
