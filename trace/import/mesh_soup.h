/// Mesh soup: the points, faces and colours of a mesh, and a reader for each format.
///
/// The readers do not trust the counts in a file: they refuse a header that promises more than the file can hold, and a
/// face with a vertex that does not exist. They pass over normals and texture coordinates, which no picture of ours
/// has, and tell what else they leave out.
///
/// CGAL's readers of these formats (IO/OBJ.h, OFF.h, PLY.h, STL.h of 5.5) would not do. They refuse a file by `false`,
/// without line or reason, and stop at continued lines of OBJ and at PLY's strips. They pass over what they do not know
/// in silence, the materials of OBJ among it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "loss.h"
#include "vidno/scene.h"

namespace vidno {

/// What is left out, by kind: how often, and where first.
class LeftOut {
public:
    void add(std::string_view kind, std::string place);
    /// A loss for each kind, in the order in which they were met.
    std::vector<Loss> losses() const;
    bool empty() const { return kinds_.empty(); }

private:
    struct Kind {
        std::string name, first_place;
        std::size_t count;
    };
    std::vector<Kind> kinds_;
};

/// The parts of a colour as a file gives them: from 0 to `most`. If `most` is not given, from 0 to 1 or, if one of the
/// file's colours has a greater part, from 0 to 255.
struct WrittenColor {
    glm::dvec3 parts{0};
    std::optional<double> most = {};
};

struct MeshFace {
    std::vector<std::size_t> corners;        // may be too few
    std::size_t line = 0;                    // 0 in a binary file
    std::optional<WrittenColor> color = {};  // of the whole face
    std::optional<std::size_t> group = {};   // its index among the groups
};

struct MeshSoup {
    std::vector<glm::dvec3> points;                         // finite
    std::vector<std::optional<WrittenColor>> point_colors;  // none, or one for each point
    std::vector<MeshFace> faces;                            // at most most_polygons, of points that exist
    std::vector<std::string> groups;                        // names, as written
    LeftOut left_out;

    /// The number of the face, with its line if the file has lines.
    std::string place_of(std::size_t face) const;
};

/// The contents of the file of this name that lies beside the mesh; none if it cannot be read. A name with the folders
/// of another machine also stands for the file of that name beside the mesh: the readers then ask for it.
using Beside = std::function<std::optional<std::string>(const std::string& name)>;

/// The file's name without folders, of this machine or another.
std::string without_folders(const std::string& file);

// Each throws Refused, without the file's name. `read_mesh_soup` checks the faces' corners.
MeshSoup read_obj(std::string_view bytes, const Beside& beside);
MeshSoup read_off(std::string_view bytes, const Beside& beside);
MeshSoup read_ply(std::string_view bytes, const Beside& beside);
MeshSoup read_stl(std::string_view bytes, const Beside& beside);

struct MeshFormat {
    std::string_view ending;
    MeshSoup (*read)(std::string_view bytes, const Beside& beside);
};
inline constexpr std::array mesh_formats{MeshFormat{"obj", read_obj}, MeshFormat{"off", read_off},
                                         MeshFormat{"ply", read_ply}, MeshFormat{"stl", read_stl}};

/// Whether each face has three corners or more, all of points that exist. Numbers that are read in a layout which is
/// not theirs seldom make such faces.
bool has_plausible_faces(const MeshSoup& soup);

/// The extensions of mesh files: ".obj, .off, .ply or .stl".
std::string mesh_endings();

/// `bytes` are the file's contents, `file` is its name, whose extension gives the format. Throws Refused.
MeshSoup read_mesh_soup(std::string_view bytes, const std::string& file, const Beside& beside);

/// The colour of each face: its own, else the mean of its vertices' colours; none where neither is given.
std::vector<std::optional<Color>> face_colors(MeshSoup& soup);

}  // namespace vidno
