/// Mesh soup: the points and faces of a mesh, and a reader for each format.
///
/// The readers do not trust the counts in a file: they refuse a header that promises more than the file can hold, and a face with a
/// vertex that does not exist. They skip everything but points and faces.
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace vidno {

struct MeshSoup {
    std::vector<glm::dvec3> points;               // finite
    std::vector<std::vector<std::size_t>> faces;  // at most most_polygons, of points that exist; corners may be too few
};

// Each throws Refused, without the file's name.
MeshSoup read_obj(std::string_view bytes);
MeshSoup read_off(std::string_view bytes);
MeshSoup read_ply(std::string_view bytes);
MeshSoup read_stl(std::string_view bytes);

struct MeshFormat {
    std::string_view ending;
    MeshSoup (*read)(std::string_view bytes);
};
inline constexpr std::array mesh_formats{MeshFormat{"obj", read_obj}, MeshFormat{"off", read_off},
                                         MeshFormat{"ply", read_ply}, MeshFormat{"stl", read_stl}};

/// The extensions of mesh files: ".obj, .off, .ply or .stl".
std::string mesh_endings();

/// `bytes` are the file's contents, `file` is its name, whose extension gives the format. Throws Refused.
MeshSoup read_mesh_soup(std::string_view bytes, const std::string& file);

}  // namespace vidno
