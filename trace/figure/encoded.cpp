#include "encoded.h"

#include "refused.h"

namespace vidno::figures {

Format format_of(const std::string& output) {
    if (output == "-" || output.ends_with(".svg")) return Format::svg;
    if (output.ends_with(".pdf")) return Format::pdf;
    if (output.ends_with(".png")) return Format::png;
    if (output.ends_with(".tex")) return Format::tikz;
    throw Refused(output + ": not .svg, .pdf, .png or .tex");
}

std::string encoded(const Drawing& drawing, const About& about, const std::string& output, int dots_an_inch) {
    const Format format = format_of(output);
    if (format == Format::tikz) return tikz_of(drawing, about);
    std::string svg = svg_of(drawing, about);
    switch (format) {
        case Format::pdf: return pdf_of({svg}, about);
        case Format::png: return png_of(svg, dots_an_inch);
        default: return svg;
    }
}

}  // namespace vidno::figures
