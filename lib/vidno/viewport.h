/// Viewport: from the canonical view volume, -1 to 1 in x, y and z, to the pixels of the area.
///
/// x' = (Wx/2) x + (Wcx + Wx/2) w     y' = -(Wy/2) y + (Wcy + Wy/2) w     z' = z
///
/// y changes its sign, since it grows downward on the screen: y = 1 is row Wcy. The printed text moves y by Wcy - Wy/2,
/// which puts the picture above the area.
#pragma once

#include <glm/mat4x4.hpp>

#include "scene.h"

namespace vidno {

inline glm::dmat4 viewport_matrix(const Area& area) {
    const double half_width = area.width / 2.0;
    const double half_height = area.height / 2.0;
    glm::dmat4 matrix(1.0);  // matrix[column][row]
    matrix[0][0] = half_width;
    matrix[3][0] = area.x + half_width;
    matrix[1][1] = -half_height;
    matrix[3][1] = area.y + half_height;
    return matrix;
}

}  // namespace vidno
