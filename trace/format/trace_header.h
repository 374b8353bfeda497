/// The first line of a trace, for readers.
#pragma once

#include <initializer_list>
#include <nlohmann/json_fwd.hpp>
#include <string_view>
#include <variant>

#include "format/floating_horizon_trace.h"
#include "format/trace_writer.h"

namespace vidno {

class JsonNode;

/// The header of a trace of polygons or of curves.
using AnyHeader = std::variant<TraceHeader, FloatingHorizonHeader>;

/// Reads the first line of a trace. Throws Refused.
AnyHeader read_header(std::string_view first_line);

/// Whether the first line is that of a trace; otherwise throws Refused.
void expect_trace(const nlohmann::json& first_line);
bool is_of_curves(const nlohmann::json& first_line);

/// Throws Refused.
TraceHeader read_trace_header(const JsonNode& object);
FloatingHorizonHeader read_floating_horizon_header(const JsonNode& object);

/// Throws Refused if the object has any other key.
void expect_keys(const JsonNode& object, std::initializer_list<std::string_view> keys);

}  // namespace vidno
