/// Mesh soup: the points and faces of an OBJ, OFF, PLY or STL file.
///
/// CGAL's readers do the reading. They trust what a file says of itself: they reserve what a header promises and index
/// by what a line claims. So a first pass goes over the file, refuses what cannot be, and hands on only the points and
/// faces, in the plainest form of the format.
#pragma once

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

/// `bytes` are the file's, `file` its name, whose ending says the format. Throws Refused.
MeshSoup read_mesh_soup(std::string_view bytes, const std::string& file);

}  // namespace vidno
