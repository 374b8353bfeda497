#include "import/mesh_soup.h"

#include "import/words.h"

namespace vidno {

namespace {

MeshSoup read_by_ending(std::string_view bytes, std::string_view ending) {
    for (const auto& format : mesh_formats) {
        if (format.ending == ending) return format.read(bytes);
    }
    throw Refused("the name must end in that of a mesh: " + mesh_endings());
}

}  // namespace

std::string mesh_endings() {
    std::string endings;
    for (std::size_t i = 0; i < mesh_formats.size(); ++i) {
        if (i > 0) endings += i + 1 == mesh_formats.size() ? " or " : ", ";
        endings += '.';
        endings += mesh_formats[i].ending;
    }
    return endings;
}

MeshSoup read_mesh_soup(std::string_view bytes, const std::string& file) {
    try {
        const std::size_t dot = file.rfind('.');
        MeshSoup soup = read_by_ending(bytes, dot == std::string::npos ? "" : lower_case(file.substr(dot + 1)));
        if (soup.points.empty() || soup.faces.empty()) throw Refused("contains no faces");
        return soup;
    } catch (const Refused& refused) {
        throw Refused(file + ": " + refused.what());
    }
}

}  // namespace vidno
