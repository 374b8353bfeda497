/// Pictures as bytes and as image files.
#pragma once

#include <string>

#include "vidno/picture.h"

namespace vidno {

/// The rows from top to bottom, with three bytes R, G, B for each pixel.
inline std::string rgb_rows(const Picture& picture) {
    std::string bytes;
    bytes.reserve(picture.pixels().size() * 3);
    for (const auto& [red, green, blue] : picture.pixels()) bytes.append({char(red), char(green), char(blue)});
    return bytes;
}

/// The picture as the bytes of a PNG file. Throws Refused if it is too large; `name` is the file in the reason.
std::string encode_png(const Picture& picture, const std::string& name);

/// The picture as the bytes of a PNG or PPM file. The extension of `name` selects the format: .png or .ppm. Throws Refused for any other.
std::string encode_image(const Picture& picture, const std::string& name);

}  // namespace vidno
