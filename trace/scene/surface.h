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
    AdmittedCurves curves;
    bool operator==(const Surface&) const = default;
};

/// The contents of a scene file: polygons, or curves.
using AnyScene = std::variant<AdmittedScene, Surface>;

/// The name that its file gives it; may be empty.
std::string name_of(const AnyScene& scene);

/// The total number of samples.
std::size_t sample_count(const CurveScene& curves);

/// The total number of columns over which the curves have points.
std::size_t column_count(const CurveScene& curves);

/// The gaps of the curves in a sentence: how many samples have no point, and where the first is; empty if there are
/// none. A gap is no loss: the surface is not there.
std::string gaps_in_words(const CurveScene& curves);

/// Whether a scene file is a surface, by its contents.
bool is_surface(std::string_view text);

/// `text` is the JSON, `file` is its name in messages. A function is replaced by its samples. Format, name and window
/// have defaults: the window is the span of the samples. Throws Refused, with a line for each fault.
Surface read_surface(std::string_view text, const std::string& file);

/// Reads a surface inside another document. Throws Misread.
Surface read_surface(const JsonNode& node);

/// A surface with its window and its samples, as in the header of a trace. Throws Misread.
Surface read_whole_surface(const JsonNode& node);

/// A surface given as a function, which may be sampled in other ways.
struct Function {
    std::string name;
    Area area;
    FunctionSurface surface;
    std::string file{};  // the JSON it was read from, on one line
};

/// Reads the function of a file. Throws Refused, also if there is none.
Function read_function(std::string_view text, const std::string& file);
/// Reads the function of a surface inside another document. Throws Misread.
Function read_function(const JsonNode& node);

/// The surface as JSON on one line, sample by sample, always the same bytes; read_surface reads back the same surface.
std::string surface_json(const Surface& surface);

}  // namespace vidno
