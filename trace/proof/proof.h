/// Proof: what shows at each pixel of a scene, and for every other polygon the reason why it does not. ../PROOF.md
/// defines the file.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "json/json_text.h"
#include "vidno/admitted.h"
#include "vidno/picture.h"

namespace vidno {

/// The edge separates all pixel centres of a rectangle strictly from its polygon.
struct BesideEdge {
    int polygon, edge;
};

/// The polygon in front holds all pixel centres of a rectangle. At each of them the other is farther, or equally deep
/// and later.
struct Behind {
    int polygon, front;
};

/// A rectangle of pixels, with the reasons that hold in it but not in all of the rectangle around it. A polygon is
/// named by its place in the scene, an edge by its first vertex.
struct ProvedRectangle {
    PixelRectangle pixels;
    std::vector<int> edge_on;
    std::vector<BesideEdge> beside;
    std::vector<Behind> behind;
    bool is_whole = false;       // no other rectangle lies in it
    std::optional<int> owner{};  // if it is whole: the polygon that shows; none for the background
};

/// Tells the rectangles of a proof, each before those in it, and returns the picture that they prove: the one by the
/// picture rule.
Picture prove(const AdmittedScene& scene, const std::function<void(const ProvedRectangle&)>& tell);

/// The first line of a proof.
inline constexpr std::string_view proof_header = "{\"format\":\"vidno-proof/1\"}\n";

/// The line of a rectangle.
void append_rectangle(Text& out, const ProvedRectangle& rectangle);

/// Whether the file of a scene states everything as the checkers of proofs read it: no camera, no default, no polygon
/// that was cut.
bool is_plain(std::string_view text, const Scene& scene);

}  // namespace vidno
