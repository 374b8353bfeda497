/// The first line of a trace, for readers.
#pragma once

#include <initializer_list>
#include <string_view>

#include "format/floating_horizon_trace.h"
#include "format/trace_writer.h"

namespace vidno {

class JsonNode;

/// Throws Refused.
TraceHeader read_trace_header(const JsonNode& object);
FloatingHorizonHeader read_floating_horizon_header(const JsonNode& object);

/// Throws Refused if the object has any other key.
void expect_keys(const JsonNode& object, std::initializer_list<std::string_view> keys);

}  // namespace vidno
