/// Why: for a pixel, which polygon shows and why the others do not, in exact numbers; and the smallest changes that
/// would let another show.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "choice/language.h"
#include "format/verdict.h"
#include "json/json_text.h"
#include "vidno/scene.h"

namespace vidno {

/// How a polygon stands at a pixel.
enum class Standing : unsigned char { shows, behind, beside, edge_on };
inline constexpr std::array<std::string_view, 4> standing_names{"shows", "behind", "beside", "edge_on"};

/// Where the line of an edge passes the centre of a pixel: along the pixel's row, or its column, whichever is nearer.
struct PassingEdge {
    int edge;  // by its first vertex
    bool in_row;
    Sign side;      // negative: to the left, or above
    Fraction away;  // in pixels
};

/// A polygon at a pixel. The owner is the polygon that shows there.
struct AtPixel {
    int polygon = 0;
    Standing standing{};
    std::optional<Fraction> depth{};  // of its plane, unless it is edge-on
    /// Beside: those that have the centre outside; all must reach it before the polygon holds it. Shows: the one
    /// nearest to the centre; once it has passed the centre, the polygon does not hold it.
    std::vector<PassingEdge> edges{};
    /// By how much the owner is nearer at the centre; none if it is not, or nothing shows. Shows: by how much the owner
    /// is nearer than the next polygon that holds the centre.
    std::optional<Fraction> gap{};
    /// Whether equal depths would do: of two, the first in the scene shows.
    bool wins_ties = false;
    std::optional<int> next{};  // shows: the next polygon
};

/// Finds the reasons in an admitted scene, which outlives it.
class Reasons {
public:
    explicit Reasons(const Scene& scene);
    ~Reasons();
    Reasons(const Reasons&) = delete;
    Reasons& operator=(const Reasons&) = delete;

    /// The polygons that hold the centre of a pixel, in the order of the scene.
    std::vector<int> holding(int x, int y) const;
    /// The polygon that shows at a pixel by the picture rule.
    std::optional<int> owner(int x, int y) const;
    /// `owner` is the pixel's.
    AtPixel at(int x, int y, int polygon, std::optional<int> owner) const;

private:
    struct Polygons;
    std::unique_ptr<Polygons> polygons_;
};

/// What to say of a polygon at a pixel, one sentence without a full stop.
std::string sentence(const AtPixel& found, const Scene& scene, Language language);
/// The owner's, or that there is none.
std::string sentence_of_owner(const Reasons& reasons, int x, int y, std::optional<int> owner, const Scene& scene,
                              Language language);

/// Appends what `vidno-why/1` has of a polygon.
void append_at_pixel(Text& out, const AtPixel& found, const Scene& scene);

/// All of a pixel as JSON, `vidno-why/1`, or as text, a line for each polygon; the owner first.
std::string why_json(const Reasons& reasons, int x, int y, const Scene& scene);
std::string why_text(const Reasons& reasons, int x, int y, const Scene& scene, Language language);

}  // namespace vidno
