/// Surface files, `vidno-surface/1`: curves for the floating horizon, sample by sample or from a function of x and z.
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "scene/sampling.h"

namespace vidno {

class JsonNode;

struct Surface {
    std::string name;
    CurveScene curves;
    bool operator==(const Surface&) const = default;
};

/// What a scene file holds: polygons, or curves.
using AnyScene = std::variant<Scene, Surface>;

/// How many samples the curves have together.
std::size_t sample_count(const CurveScene& curves);

/// Over how many columns they are together.
std::size_t column_count(const CurveScene& curves);

/// Whether a scene file is one of these, by what is in it.
bool is_surface(std::string_view text);

/// `text` is the JSON, `file` its name in messages. Of a function its samples remain. Format, name and window have defaults: the window is
/// what the samples reach over. Throws Refused, with a line for each fault.
Surface read_surface(std::string_view text, const std::string& file);

/// The same of a surface inside another document. Throws Misread.
Surface read_surface(const JsonNode& node);

/// A surface with its window and its samples, as in the header of a trace. Throws Misread.
Surface read_whole_surface(const JsonNode& node);

/// A surface that is given as a function, which may be sampled in other ways.
struct Function {
    std::string name;
    Area area;
    FunctionSurface surface;
    std::string file{};  // what it was read from, on one line
};

/// The same of a file. Throws Refused, also where there is no function, or it is not finite over some column.
Function read_function(std::string_view text, const std::string& file);

/// The surface as JSON on one line, sample by sample, the same bytes each time; read_surface gives the same surface again.
std::string surface_json(const Surface& surface);

}  // namespace vidno
