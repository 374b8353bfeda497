/// YFlipped: the picture is upside down.
///
/// Believed   that y grows upward on the screen, as it does in the view volume: the viewport has lost its minus.
/// Goes wrong a vertex lands in the row that is as far from the bottom as its own is from the top.
/// Seen       everywhere, except in a picture that is its own mirror image.
#pragma once

#include "../corrected.h"

namespace vidno::mistakes {

struct YFlipped : Corrected {
    static constexpr std::string_view name = "y-flipped";

    /// I1
    static auto on_screen(const auto& kernel, const Area& area, const glm::dvec3& vertex) {
        auto mirrored = kernel.vertex(vertex);
        mirrored.y = kernel.number(double(area.y) + area.bottom()) - mirrored.y;
        return mirrored;
    }
};

}  // namespace vidno::mistakes
