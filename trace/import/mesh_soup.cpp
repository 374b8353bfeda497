#include "import/mesh_soup.h"

#include <glm/common.hpp>

#include "characters.h"
#include "counted.h"
#include "import/words.h"

namespace vidno {

namespace {

MeshSoup read_by_ending(std::string_view bytes, std::string_view ending, const Beside& beside) {
    for (const auto& format : mesh_formats) {
        if (format.ending == ending) return format.read(without_mark(bytes), beside);
    }
    throw Refused("the name must end in that of a mesh: " + mesh_endings());
}

void check_corners(const MeshSoup& soup) {
    for (std::size_t i = 0; i < soup.faces.size(); ++i) {
        for (const std::size_t corner : soup.faces[i].corners) {
            if (corner >= soup.points.size()) {
                throw Refused(soup.place_of(i) + ": a face has a vertex that does not exist, of " +
                              std::to_string(soup.points.size()));
            }
        }
    }
}

/// What the file has instead of faces.
std::string without_faces(const MeshSoup& soup) {
    std::string text = "contains no faces, only " + counted(soup.points.size(), "vertex", "vertices");
    for (const auto& [what, where] : soup.left_out.losses()) text += "; " + where + ": " + what;
    return text;
}

bool is_between_0_and_1(const std::optional<WrittenColor>& color) {
    return !color || color->most || std::max({color->parts.x, color->parts.y, color->parts.z}) <= 1;
}

}  // namespace

void LeftOut::add(std::string_view kind, std::string place) {
    for (Kind& known : kinds_) {
        if (known.name == kind) {
            ++known.count;
            return;
        }
    }
    kinds_.push_back({std::string(kind), std::move(place), 1});
}

std::vector<Loss> LeftOut::losses() const {
    std::vector<Loss> all;
    for (const auto& [name, first_place, count] : kinds_) {
        const std::string times = count > 1 ? " (" + std::to_string(count) + " times, here first)" : "";
        all.push_back({"left out: " + name + times, first_place});
    }
    return all;
}

std::string without_folders(const std::string& file) { return file.substr(file.find_last_of("/\\") + 1); }

std::string MeshSoup::place_of(std::size_t face) const {
    const std::size_t line = faces[face].line;
    return line > 0 ? "line " + std::to_string(line) : "face " + std::to_string(face);
}

bool has_plausible_faces(const MeshSoup& soup) {
    return std::all_of(soup.faces.begin(), soup.faces.end(), [&](const MeshFace& face) {
        return face.corners.size() >= 3 && std::all_of(face.corners.begin(), face.corners.end(),
                                                       [&](std::size_t corner) { return corner < soup.points.size(); });
    });
}

std::string mesh_endings() {
    std::string endings;
    for (std::size_t i = 0; i < mesh_formats.size(); ++i) {
        if (i > 0) endings += i + 1 == mesh_formats.size() ? " or " : ", ";
        endings += '.';
        endings += mesh_formats[i].ending;
    }
    return endings;
}

MeshSoup read_mesh_soup(std::string_view bytes, const std::string& file, const Beside& beside) {
    try {
        const std::size_t dot = file.rfind('.');
        MeshSoup soup = read_by_ending(bytes, dot == std::string::npos ? "" : lower_case(file.substr(dot + 1)), beside);
        check_corners(soup);
        if (soup.points.empty() || soup.faces.empty()) throw Refused(without_faces(soup));
        return soup;
    } catch (const Refused& refused) {
        throw Refused(file + ": " + refused.what());
    }
}

std::vector<std::optional<Color>> face_colors(MeshSoup& soup) {
    const bool small = std::all_of(soup.point_colors.begin(), soup.point_colors.end(), is_between_0_and_1) &&
                       std::all_of(soup.faces.begin(), soup.faces.end(),
                                   [](const MeshFace& face) { return is_between_0_and_1(face.color); });
    const auto scaled = [&](const WrittenColor& color) {
        return glm::clamp(color.parts / color.most.value_or(small ? 1 : 255), 0.0, 1.0);
    };
    std::vector<std::optional<Color>> colors(soup.faces.size());
    for (std::size_t i = 0; i < colors.size(); ++i) {
        const MeshFace& face = soup.faces[i];
        glm::dvec3 sum(0), first(0);
        std::size_t count = 0;
        bool is_uniform = true;
        if (!soup.point_colors.empty()) {
            for (const std::size_t corner : face.corners) {
                if (const auto& color = soup.point_colors[corner]) {
                    if (count++ == 0) first = scaled(*color);
                    is_uniform = is_uniform && scaled(*color) == first;
                    sum += scaled(*color);
                } else {
                    is_uniform = false;
                }
            }
        }
        if (count == 0 && !face.color) continue;
        glm::dvec3 mean = is_uniform ? first : sum / double(count);
        if (face.color) {
            mean = scaled(*face.color);
            if (count > 0 && (!is_uniform || first != mean)) {
                soup.left_out.add("colours of vertices, since their face has its own", soup.place_of(i));
            }
        } else if (!is_uniform) {
            soup.left_out.add("a change of colour within a face, which has the mean", soup.place_of(i));
        }
        const auto part = [](double value) { return std::uint8_t(std::lround(value * 255)); };
        colors[i] = Color{part(mean.x), part(mean.y), part(mean.z)};
    }
    return colors;
}

}  // namespace vidno
