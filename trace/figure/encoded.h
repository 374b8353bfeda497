/// A drawing in the format given by the name of its file.
#pragma once

#include "writers.h"

namespace vidno::figures {

enum class Format { svg, pdf, png, tikz };

/// SVG for "-", otherwise by the extension. Throws Refused for any other.
Format format_of(const std::string& output);

inline constexpr int usual_dots_an_inch = 300;

std::string encoded(const Drawing& drawing, const About& about, const std::string& output,
                    int dots_an_inch = usual_dots_an_inch);

}  // namespace vidno::figures
