/// Pictures as bytes and as image files.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

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

/// The picture as the bytes of a PNG or PPM file. The extension of `name` selects the format: .png or .ppm. Throws
/// Refused for any other.
std::string encode_image(const Picture& picture, const std::string& name);

/// The picture of an area in the bytes of an image file, PNG or binary PPM, with 8 bits for each colour and no
/// transparency. Throws Refused if the bytes are something else or the size is another.
Picture decode_image(std::string_view bytes, const Area& area, const std::string& name);

/// The rows from top to bottom of an area's picture, as rgb_rows gives them.
Picture picture_of_rows(std::string_view rgb, const Area& area);

/// decode_image for PNG.
Picture decode_png(std::string_view bytes, const Area& area, const std::string& name);

/// Refuses a picture that has not the size of the area.
void expect_size(std::uint64_t width, std::uint64_t height, const Area& area, const std::string& name);

}  // namespace vidno
