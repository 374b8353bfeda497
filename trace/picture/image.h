/// Pictures as bytes and as image files.
#pragma once

#include <string>

#include "vidno/picture.h"

namespace vidno {

/// The rows from the top, three bytes R, G, B a pixel.
inline std::string rgb_rows(const Picture& picture) {
    std::string bytes;
    bytes.reserve(picture.pixels().size() * 3);
    for (const auto& [red, green, blue] : picture.pixels()) bytes.append({char(red), char(green), char(blue)});
    return bytes;
}

/// The bytes of the file; the extension, .png or .ppm, decides which. Throws Refused for any other.
std::string encode_image(const Picture& picture, const std::string& name);

}  // namespace vidno
