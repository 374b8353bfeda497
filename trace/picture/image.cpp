#include "picture/image.h"

#include "refused.h"

namespace vidno {

std::string encode_image(const Picture& picture, const std::string& name) {
    if (name.ends_with(".png")) return encode_png(picture, name);
    if (name.ends_with(".ppm") || name == "-") {
        const auto& area = picture.area();
        return "P6\n" + std::to_string(area.width) + " " + std::to_string(area.height) + "\n255\n" + rgb_rows(picture);
    }
    throw Refused(name + ": a picture is written as .png or .ppm");
}

}  // namespace vidno
