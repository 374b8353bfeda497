/// SceneTruth: what lies where in a scene, in exact rationals, and how far a program may be off that computes with rounding.
///
/// Rounding   an answer is open, and a program may give either, where the exact value is nearer to the borderline than
///            2^10 units in the last place of the largest coordinate: what some hundred operations can add up to.
/// Outline    who owns a point of an outline is a rule of its own. The rule of the picture gives it to every polygon that has
///            it; another one is as right if it shows there what is seen beside the point in some direction. So points
///            of an outline may belong to nobody, but where two polygons share an edge and nothing else is beside it, one of
///            them must show.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "format/event.h"
#include "vidno/scene.h"
#include "vidno/window.h"

namespace vidno {

class Words;

/// The numbers of a program.
enum class Precision : unsigned char { single, twice };

/// What may be seen at the centre of a pixel.
struct SeenPixel {
    static constexpr int background = -1;

    int by_rule = background;  // a polygon by its place
    int by_none = background;  // if points of outlines belonged to nobody
    std::vector<int> allowed;  // that one among them
    bool on_outline = false;   // of any polygon
    bool is_open = false;      // rounding may decide between two depths that differ
};

/// The least box around a polygon.
struct PlainBox {
    double xmin, ymin, xmax, ymax;
};

class SceneTruth {
public:
    enum class Place : unsigned char { outside, outline, inside };

    /// The scene is copied.
    SceneTruth(const Scene& scene, Precision precision);
    ~SceneTruth();

    const Scene& scene() const;

    /// Whether the polygon can show at all: it is not edge-on.
    bool has_inside(int polygon) const;
    Place place(int polygon, double x, double y) const;
    /// As a double, for messages, not a number where the point is none; of a polygon that has an inside, as for all that follows.
    double depth(int polygon, double x, double y) const;
    bool is_depth(int polygon, double x, double y, double z) const;
    /// 1 if the first is nearer at the point, -1 if the other, 0 if they are equally near.
    int nearer(int polygon, int than, double x, double y) const;
    /// Whether rounding may decide between two depths that a program has computed.
    bool nearly_equal(double z, double other) const;
    /// Whether the plane a x + b y + c z + d = 0 is the polygon's.
    bool is_plane(int polygon, const std::array<double, 4>& plane) const;
    /// The polygon's least depth at a vertex.
    double farthest(int polygon) const;
    PlainBox box(int polygon) const;
    /// What its depth changes by from a column to the next.
    double depth_slope(int polygon) const;

    /// On which side of an edge a point is: the sign of (edge's end - its begin) x (point - its begin); 0 if open.
    int side(int polygon, int edge, double x, double y) const;
    /// Where an edge is at a height: x and z; none if it is level.
    struct Crossing {
        double x, z;
    };
    std::optional<Crossing> crossing(int polygon, int edge, double y) const;
    /// The ends of the polygon on a horizontal line, from the left; none if it does not meet it.
    std::optional<std::pair<Crossing, Crossing>> ends(int polygon, double y) const;
    /// The same of its part in a window.
    std::optional<std::pair<Crossing, Crossing>> ends_in(int polygon, const Window& window, double y) const;
    /// Whether two coordinates are the same but for rounding; depths along an outline too.
    bool same_coordinate(double v, double w) const;

    /// Whether the insides of polygon and window meet.
    bool meets(int polygon, const Window& window) const;
    /// Whether the polygon holds the whole window.
    bool holds(int polygon, const Window& window) const;
    /// A polygon that is nearer than this one somewhere in the window; none if this one hides all others that reach into it.
    std::optional<int> nearer_in(int polygon, const Window& window) const;
    /// Whether the point is on the polygon, and on its plane; as exact as a clipped vertex.
    bool has_vertex(int polygon, const glm::dvec3& vertex) const;
    /// The part of the window in the area.
    Window in_area(const Window& window) const;
    /// Why the vertices, in any order round the outline, are not those of the polygon's part in the window; none if they are.
    std::optional<std::string> no_part(int polygon, const Window& window, const std::vector<glm::dvec3>& vertices,
                                       const Words& say) const;

    // Regions: loops, holes the other way round.
    static double area_of(const RegionLoops& region);
    double area_in(int polygon, const Window& window) const;
    /// How much of the area the polygons cover together.
    double covered_area() const;
    bool same_area(double told, double right) const;
    /// Whether the point is in the polygon, or on its outline as exactly as a clipped vertex.
    bool has_point(int polygon, double x, double y) const;
    /// A polygon that is nearer than this one in a part of the region, and the area of that part.
    std::optional<std::pair<int, double>> hidden_by(int polygon, const RegionLoops& region) const;

    const SeenPixel& seen(int column, int row) const;
    Color color_of(int polygon) const;  // or of the background
    bool allows(int column, int row, Color color) const;

private:
    struct Exactly;
    std::unique_ptr<const Exactly> exactly_;
};

/// As messages have it: the shortest form.
std::string in_words(double value);
std::string in_words(Color color);
std::string in_words(const Window& window);

}  // namespace vidno
