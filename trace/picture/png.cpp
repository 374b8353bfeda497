#include <png.h>

#include "picture/image.h"
#include "refused.h"

namespace vidno {

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

Picture decode_png(std::string_view bytes, const Area& area, const std::string& name) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    if (!png_image_begin_read_from_memory(&image, bytes.data(), bytes.size())) {
        throw Refused(name + ": " + image.message);
    }
    const auto refuse = [&](const std::string& reason) {
        png_image_free(&image);
        throw Refused(name + ": " + reason);
    };
    if (image.format & PNG_FORMAT_FLAG_LINEAR) refuse("a PNG with 16 bits for each colour");
    if (image.format & PNG_FORMAT_FLAG_ALPHA) refuse("a PNG with transparency");
    if (image.width != png_uint_32(area.width) || image.height != png_uint_32(area.height)) {
        png_image_free(&image);
        expect_size(image.width, image.height, area, name);
    }
    image.format = PNG_FORMAT_RGB;
    std::string rows(PNG_IMAGE_SIZE(image), '\0');
    if (!png_image_finish_read(&image, nullptr, rows.data(), 0, nullptr)) throw Refused(name + ": " + image.message);
    return picture_of_rows(rows, area);
}

}  // namespace vidno
