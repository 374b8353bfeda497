/// SceneTruth: answers questions about a scene in exact rationals, with a tolerance for programs that compute with
/// rounding.
///
/// Rounding   An answer is open if the exact value is within the tolerance of the borderline; then a program may give
///            either answer. In double the tolerance is 2^10 units in the last place of the largest coordinate, and for
///            a depth of the terms that make it: some hundred operations can add up to it. In float it is 2^6 units. A
///            number that the program tells is judged by its own precision: if no float has its value, it was not
///            computed in float alone, and the tolerance is that of double.
/// Outline    A program may use its own rule for points of an outline. By the picture rule, such a point belongs to
///            every polygon on whose outline it lies. Another rule is as right if it shows what is visible next to the
///            point in some direction. So a point of an outline may belong to no polygon. But if two polygons share an
///            edge and nothing else lies next to it, one of them must show.
#pragma once

#include <array>
#include <cmath>
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

/// The floating-point type of a program: float or double.
enum class Precision : unsigned char { single, twice };

inline bool is_float(double value) { return double(float(value)) == value; }

/// The tolerance of a program of that precision, in units of the largest value.
inline double rounding(Precision precision) { return precision == Precision::single ? 0x1p-18 : 0x1p-43; }
/// By how much the tolerance of a claimed number is less than that of its program.
inline double strictness(Precision precision, double claimed) {
    return precision == Precision::single && !is_float(claimed) ? rounding(Precision::twice) / rounding(precision) : 1;
}

/// What may be seen at the centre of a pixel.
struct SeenPixel {
    static constexpr int background = -1;

    int by_rule = background;  // the index of the visible polygon by the picture rule
    int by_none = background;  // the same if points of outlines belonged to no polygon
    std::vector<int> allowed;  // all right answers, `by_rule` among them
    bool on_outline = false;   // the centre lies on the outline of some polygon
    bool is_open = false;      // rounding may decide between two different depths
};

/// The bounding box of a polygon.
struct PlainBox {
    double xmin, ymin, xmax, ymax;
};

class SceneTruth {
public:
    enum class Place : unsigned char { outside, outline, inside };

    /// Copies the scene.
    SceneTruth(const Scene& scene, Precision precision);
    ~SceneTruth();

    const Scene& scene() const;

    /// Whether the polygon can be visible, that is, it is not edge-on. Functions of its depth or plane require it.
    bool has_inside(int polygon) const;
    Place place(int polygon, double x, double y) const;
    /// The depth at a point, rounded to a double, for messages. NaN if x or y is not finite.
    double depth(int polygon, double x, double y) const;
    /// Whether z is the depth at the point, within the tolerance.
    bool is_depth(int polygon, double x, double y, double z) const;
    /// 1 if `polygon` is nearer at the point, -1 if `than` is, 0 if the depths agree within the tolerance.
    int nearer(int polygon, int than, double x, double y) const;
    /// Whether a claimed depth is the right one. An error may have been multiplied by `times`.
    bool same_depth(double claimed, double right, double times = 1) const;
    /// Whether two depths that a program computed and stored agree within the tolerance.
    bool nearly_equal(double z, double other) const;
    /// Whether a program that compares these depths may take either for the nearer one. It compares what it tells, up
    /// to the digits that `long double` has besides.
    bool equally_near(double z, double other) const;
    /// Whether a judged depth was that of a program in float: a float, though the right one is not.
    bool shows_single() const;
    /// Whether the plane a x + b y + c z + d = 0 is the polygon's.
    bool is_plane(int polygon, const std::array<double, 4>& plane) const;
    /// The polygon's least depth at a vertex.
    double farthest(int polygon) const;
    PlainBox box(int polygon) const;
    /// The change of the polygon's depth from one column to the next.
    double depth_slope(int polygon) const;

    /// The side of an edge on which a point lies: the sign of (edge's end - its start) x (point - its start); 0 within
    /// the tolerance.
    int side(int polygon, int edge, double x, double y) const;
    /// A point of an outline on a given horizontal line.
    struct Crossing {
        double x, z;
    };
    using Ends = std::pair<Crossing, Crossing>;
    /// Where the line of an edge crosses the height y; none if the edge is horizontal.
    std::optional<Crossing> crossing(int polygon, int edge, double y) const;
    /// The left and the right end of the polygon on the horizontal line at y; none if the line misses the polygon.
    std::optional<Ends> ends(int polygon, double y) const;
    /// Whether a claimed coordinate is the right one, within 64 times the tolerance. An error may have been multiplied
    /// by `times`.
    bool same_coordinate(double claimed, double right, double times = 1) const;
    /// Whether a program may take two coordinates for the same: they differ by at most `coincidence`, 64 times the
    /// tolerance.
    bool may_coincide(double v, double w) const { return std::abs(v - w) <= coincidence(); }
    double coincidence() const;

    /// Whether the interiors of polygon and window overlap.
    bool meets(int polygon, const Window& window) const;
    /// Whether the polygon contains the whole window.
    bool holds(int polygon, const Window& window) const;
    /// A polygon that is nearer than this one somewhere in the window; none if this one hides all others there.
    std::optional<int> nearer_in(int polygon, const Window& window) const;
    /// Whether the point lies on the polygon and in its plane, within the tolerance of a clipped vertex.
    bool has_vertex(int polygon, const glm::dvec3& vertex) const;
    /// The part of the window in the area.
    Window in_area(const Window& window) const;
    /// Why the vertices do not form the polygon's part in the window; none if they do. They may start anywhere, in
    /// either direction.
    std::optional<std::string> no_part(int polygon, const Window& window, const std::vector<glm::dvec3>& vertices,
                                       const Words& say) const;

    // Areas are in square pixels. On the screen an outline runs clockwise, and a hole counterclockwise.
    /// Negative if the outline runs the wrong way.
    static double area_of(const RegionLoops& region);
    /// The area around which the loops of a region run the wrong way, and that around which they run more than once.
    struct Astray {
        double reversed, repeated;
    };
    static Astray astray(const RegionLoops& region);
    /// Whether a point lies in a region, up to rounding.
    static bool is_in(const RegionLoops& region, double x, double y);
    double common_area(const RegionLoops& region, const RegionLoops& other) const;
    /// The area by which two regions differ from the parts of a region inside and outside of another one.
    struct PartsAstray {
        double inside, outside;
    };
    static PartsAstray parts_astray(const RegionLoops& whole, const RegionLoops& clip, const RegionLoops& inside,
                                    const RegionLoops& outside);
    double area_in(int polygon, const Window& window) const;
    /// The area that the polygons cover together.
    double covered_area() const;
    /// Whether two areas agree within the tolerance. `in_floats`: all regions that make the claimed one are.
    bool same_area(double claimed, double right, bool in_floats) const;
    /// Whether a float has each coordinate of the region.
    static bool in_floats(const RegionLoops& region);
    /// Whether the point lies in the polygon or, within the tolerance of a clipped vertex, on its outline.
    bool has_point(int polygon, double x, double y) const;
    /// A polygon that is nearer than this one in a part of the region, and the area of that part.
    std::optional<std::pair<int, double>> hidden_by(int polygon, const RegionLoops& region) const;

    const SeenPixel& seen(int column, int row) const;
    /// The colour of the polygon, or of the background for SeenPixel::background.
    Color color_of(int polygon) const;
    /// Whether a pixel that shows the colour is right.
    bool allows(int column, int row, Color color) const;

private:
    struct Exactly;
    std::unique_ptr<const Exactly> exactly_;
};

/// As messages write it: a number in its shortest form, a colour as #rrggbb, a window as x, y, width and height.
std::string in_words(double value);
std::string in_words(Color color);
std::string in_words(const Window& window);

}  // namespace vidno
