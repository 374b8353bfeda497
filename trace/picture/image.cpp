#include "picture/image.h"

#include <algorithm>
#include <charconv>

#include "refused.h"

namespace vidno {

namespace {

/// The next number of a PPM's header, after white space and comments; 0 if there is none.
std::uint64_t next_number(std::string_view& rest) {
    while (!rest.empty() && (rest.front() == '#' || std::string_view(" \t\r\n").find(rest.front()) != rest.npos)) {
        rest.remove_prefix(rest.front() == '#' ? std::min(rest.find('\n'), rest.size()) : 1);
    }
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
    rest.remove_prefix(std::size_t(end - rest.data()));
    return error == std::errc{} ? number : 0;
}

Picture decode_ppm(std::string_view bytes, const Area& area, const std::string& name) {
    std::string_view rest = bytes.substr(2);
    const std::uint64_t width = next_number(rest), height = next_number(rest), most = next_number(rest);
    if (most != 255) throw Refused(name + ": a PPM without 8 bits for each colour");
    expect_size(width, height, area, name);
    const std::size_t size = std::size_t(area.width) * std::size_t(area.height) * 3;
    if (rest.size() != size + 1) throw Refused(name + ": the PPM is cut short or has more than one picture");
    return picture_of_rows(rest.substr(1), area);
}

}  // namespace

void expect_size(std::uint64_t width, std::uint64_t height, const Area& area, const std::string& name) {
    if (width == std::uint64_t(area.width) && height == std::uint64_t(area.height)) return;
    throw Refused(name + ": the picture has " + std::to_string(width) + " x " + std::to_string(height) +
                  " pixels, the scene's window " + std::to_string(area.width) + " x " + std::to_string(area.height));
}

Picture picture_of_rows(std::string_view rgb, const Area& area) {
    Picture picture(area, {});
    auto next = rgb.begin();
    for (int y = area.y; y < area.bottom(); ++y) {
        for (int x = area.x; x < area.right(); ++x, next += 3) {
            picture.paint(x, y, {std::uint8_t(next[0]), std::uint8_t(next[1]), std::uint8_t(next[2])});
        }
    }
    return picture;
}

Picture decode_image(std::string_view bytes, const Area& area, const std::string& name) {
    if (bytes.starts_with("\x89PNG")) return decode_png(bytes, area, name);
    if (bytes.starts_with("P6")) return decode_ppm(bytes, area, name);
    throw Refused(name + ": not a picture, PNG or binary PPM");
}

std::string encode_image(const Picture& picture, const std::string& name) {
    if (name.ends_with(".png")) return encode_png(picture, name);
    if (name.ends_with(".ppm") || name == "-") {
        const auto& area = picture.area();
        return "P6\n" + std::to_string(area.width) + " " + std::to_string(area.height) + "\n255\n" + rgb_rows(picture);
    }
    throw Refused(name + ": a picture is written as .png or .ppm");
}

}  // namespace vidno
