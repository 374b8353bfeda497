#include "picture/image.h"

#include <png.h>

#include "refused.h"

namespace vidno {

namespace {

std::string encode_png(const Picture& picture, const std::string& name) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = png_uint_32(picture.area().width);
    image.height = png_uint_32(picture.area().height);
    image.format = PNG_FORMAT_RGB;
    const std::string rows = rgb_rows(picture);
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
    std::string bytes(size, '\0');
    if (!png_image_write_to_memory(&image, bytes.data(), &size, 0, rows.data(), 0, nullptr)) {
        throw Refused(name + ": " + image.message);
    }
    bytes.resize(size);
    return bytes;
}

}  // namespace

std::string encode_image(const Picture& picture, const std::string& name) {
    if (name.ends_with(".png")) return encode_png(picture, name);
    if (name.ends_with(".ppm") || name == "-") {
        const auto& area = picture.area();
        return "P6\n" + std::to_string(area.width) + " " + std::to_string(area.height) + "\n255\n" + rgb_rows(picture);
    }
    throw Refused(name + ": a picture is written as .png or .ppm");
}

}  // namespace vidno
