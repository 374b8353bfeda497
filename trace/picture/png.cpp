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

}  // namespace vidno
