// Reads a PNG or a binary PPM with 8 bits each of red, green and blue. For verify.cpp.
#include <png.h>

#include <fstream>
#include <set>
#include <stdexcept>
#include <string>

#include "rectangle.h"

inline long number_of(const std::string& color) { return std::stol(color.substr(1), nullptr, 16); }  // #rrggbb

// The pixels of a picture that fills the window: x, y and the colour as the number 0xRRGGBB.
inline std::set<std::array<long, 3>> read_picture(const char* file, const Rectangle& window) {
    std::ifstream picture(file, std::ios::binary);
    const std::string bytes(std::istreambuf_iterator<char>(picture), {});
    const std::string size = std::to_string(window.width) + " " + std::to_string(window.height);
    const std::string ppm = "P6\n" + size + "\n255\n";
    std::string rgb(3 * std::size_t(window.width * window.height), '\0');
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    if (bytes.starts_with(ppm) && bytes.size() == ppm.size() + rgb.size()) {
        rgb = bytes.substr(ppm.size());
    } else if (!png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) || png.format != PNG_FORMAT_RGB ||
               png.width != window.width || png.height != window.height ||
               !png_image_finish_read(&png, nullptr, rgb.data(), 0, nullptr)) {
        throw std::runtime_error("picture: not a PPM or PNG of " + size + " pixels, each of 3 times 8 bits");
    }
    std::set<std::array<long, 3>> pixels;
    auto next = [byte = rgb.begin()]() mutable { return long(static_cast<unsigned char>(*byte++)); };
    for (const auto& [x, y] : window.pixels()) {
        const long red = next(), green = next(), blue = next();
        pixels.insert({x, y, red << 16 | green << 8 | blue});
    }
    return pixels;
}
