/// FlatParts: the faces of a mesh that together are one flat face, as the two triangles into which a program has cut a
/// square.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "import/mesh_soup.h"

namespace vidno {

/// For each face the first one of its flat part: faces of one colour and group that lie exactly in one plane and are
/// joined by common edges. `colors` are those of the faces, if the file gives them. A face is alone in its part if its
/// corners are collinear. Points at one place count as the same.
std::vector<std::size_t> flat_parts(const MeshSoup& mesh, const std::vector<std::optional<Color>>& colors);

}  // namespace vidno
