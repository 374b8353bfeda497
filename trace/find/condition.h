/// Condition: an expression over what is counted and measured in a scene and its run.
///
/// The expression is muParser's: && || == != < <= > >= + - * / ^ ?:, min, max, abs. Its names are the labels of the
/// listings and those of `quantities`. The whole of it also has a distance from being met, which leads a search.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "choice/kernel_choice.h"
#include "vidno/line.h"

namespace vidno {

/// What a name stands for; `line` has the label of a line as its name.
enum class Quantity : unsigned char {
    line,
    windows,
    splits,
    depth_of_stack,
    events,
    polygons,
    vertices,
    curves,
    samples,
    coordinates,
    pixels,
    wrong,
    zeros,
    ulps
};

/// The scenes that a quantity is of.
enum class QuantityOf : unsigned char { all, polygons, curves };

struct QuantityChoice {
    std::string_view name;
    std::string_view says;
    QuantityOf of = QuantityOf::all;
    std::string_view argument{};  // in parentheses
    bool grows = false;           // it is known while a run goes on, and does not fall
    bool of_scene = false;        // it is known without a run
};

/// Indexed by Quantity.
inline constexpr std::array quantities{
    QuantityChoice{.name = "LABEL",
                   .says =
                       "how often the run came to this line; where a line repeats something, each time counts, such "
                       "as each corner at PW5 and each pixel at L6",
                   .grows = true},
    QuantityChoice{
        .name = "windows",
        .says = "the windows that Warnock's algorithm takes from its stack; for Weiler and Atherton's, lists",
        .of = QuantityOf::polygons,
        .grows = true},
    QuantityChoice{.name = "splits", .says = "the windows that are split", .of = QuantityOf::polygons, .grows = true},
    QuantityChoice{.name = "depth_of_stack",
                   .says = "the most windows, or lists, that are on the stack at once",
                   .of = QuantityOf::polygons,
                   .grows = true},
    QuantityChoice{.name = "events", .says = "the steps of a trace of level signs", .grows = true},
    QuantityChoice{
        .name = "polygons", .says = "the polygons of the scene", .of = QuantityOf::polygons, .of_scene = true},
    QuantityChoice{
        .name = "vertices", .says = "the vertices of all polygons", .of = QuantityOf::polygons, .of_scene = true},
    QuantityChoice{.name = "curves", .says = "the curves of the surface", .of = QuantityOf::curves, .of_scene = true},
    QuantityChoice{.name = "samples", .says = "the samples of all curves", .of = QuantityOf::curves, .of_scene = true},
    QuantityChoice{.name = "coordinates",
                   .says = "the greatest whole number that is needed to write the vertices, x and y in units of the "
                           "coarsest 1/2^k that suits all, z in units of its own; or the heights of curves",
                   .of_scene = true},
    QuantityChoice{.name = "pixels",
                   .says = "the pixels that show the polygon with this id",
                   .of = QuantityOf::polygons,
                   .argument = "ID"},
    QuantityChoice{.name = "wrong",
                   .says = "the pixels that the same run paints wrong under this kernel, such as float or bits:9; for "
                           "curves, the columns over which it draws a hidden one, or does not draw a visible one",
                   .argument = "KERNEL"},
    QuantityChoice{.name = "zeros", .says = "the decisions that rest on an exact coincidence"},
    QuantityChoice{.name = "ulps",
                   .says = "how narrow the narrowest of the other decisions is, in ulps of double; infinite if there "
                           "is none"},
};

/// A name as it stands in a condition.
struct Name {
    Quantity quantity{};
    Line line{};           // of the quantity `line`
    std::string argument;  // the id of a polygon, or a kernel
    NamedKernel kernel{};  // of the quantity `wrong`

    std::string text() const;
    const QuantityChoice& choice() const { return quantities[std::size_t(quantity)]; }
};

/// Whether a step of some run is reported at the line, so that it can be counted.
bool is_counted(Line line);

class Condition {
public:
    /// Throws Refused, which says at which character the text is no condition.
    explicit Condition(const std::string& text);
    ~Condition();
    Condition(Condition&&) noexcept;
    Condition& operator=(Condition&&) noexcept;

    /// The names in it, each once.
    const std::vector<Name>& names() const;
    /// What && joins, as it is written.
    const std::vector<std::string>& parts() const;

    // They take the values of the names, in their order.

    bool is_met(const std::vector<double>& values) const;
    bool is_met(const std::vector<double>& values, std::size_t part) const;
    /// 0 if it is met. The sides of a comparison tell how far off it is.
    double distance(const std::vector<double>& values) const;

private:
    class Expression;
    std::unique_ptr<Expression> expression_;
};

}  // namespace vidno
