/// What a Drawing is written as. The same drawing gives the same bytes, except that PDF and PNG depend on the fonts that
/// the system has.
#pragma once

#include <string>
#include <vector>

#include "drawing.h"
#include "figure_words.h"

namespace vidno::figures {

/// A document that says of itself what it shows.
struct About {
    std::string title;
    Language language = Language::english;
};

/// An SVG document of lines, areas and live text, in millimetres.
std::string svg_of(const Drawing& drawing, const About& about);

/// How much wider than Helvetica the letters of TeX's usual fonts may be; what is wider still is squeezed.
inline constexpr double letters_of_tex = 1.16;

/// A document for pdfLaTeX, which has the size of the drawing, and which another one may \input as well: then its font is
/// used. `about` decides the encoding of fonts.
std::string tikz_of(const Drawing& drawing, const About& about);

/// The same for beamer: a frame with an overlay a drawing; they are of one size.
std::string beamer_of(const std::vector<Drawing>& drawings, const About& about);

/// SVG documents as the pages of a PDF with live text and embedded fonts, without a date. Throws Refused if librsvg does
/// not take one.
std::string pdf_of(const std::vector<std::string>& pages, const About& about);

/// The SVG as PNG with so many dots an inch.
std::string png_of(const std::string& svg, int dots_an_inch);

}  // namespace vidno::figures
