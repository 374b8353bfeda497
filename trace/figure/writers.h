/// Writers for drawings. The same drawing gives the same bytes, except that PDF and PNG depend on the fonts of the
/// system.
#pragma once

#include <string>
#include <vector>

#include "drawing.h"
#include "figure_words.h"

namespace vidno::figures {

/// The title and language that a document states.
struct About {
    std::string title;
    Language language = Language::english;
};

/// An SVG document of lines, areas and live text, in millimetres.
std::string svg_of(const Drawing& drawing, const About& about);

/// An animated SVG document that shows drawings of one size one after the other, again and again. Without animation it
/// shows the last.
std::string film_of(const std::vector<Drawing>& frames, double frames_a_second, const About& about);

/// How much wider than Helvetica the letters of TeX's usual fonts may be; wider text is compressed.
inline constexpr double letters_of_tex = 1.16;

/// The characters of the labels that the fonts of pdfLaTeX lack, each once. With such characters `tikz_of` and
/// `beamer_of` write a document for LuaLaTeX or XeLaTeX, which says so in its second line.
std::string beyond_pdflatex(const std::vector<Drawing>& drawings);

/// A document for pdfLaTeX with the size of the drawing. Another document may also \input it; its font is then used.
/// Its letters and `about` determine the font encodings.
std::string tikz_of(const Drawing& drawing, const About& about);

/// For beamer: a frame with one overlay per drawing; all drawings have the same size.
std::string beamer_of(const std::vector<Drawing>& drawings, const About& about);

/// SVG documents as the pages of a PDF with live text and embedded fonts, without a date. Throws Refused if librsvg
/// rejects one.
std::string pdf_of(const std::vector<std::string>& pages, const About& about);

/// The SVG as PNG with the given dots per inch.
std::string png_of(const std::string& svg, int dots_an_inch);

}  // namespace vidno::figures
