/// Surface files, `vidno-surface/1`: curves for the floating horizon, sample by sample or from a function of x and z.
#pragma once

#include <string>
#include <string_view>

#include "vidno/floating_horizon/curves.h"

namespace vidno {

struct Surface {
    std::string name;
    CurveScene curves;
    bool operator==(const Surface&) const = default;
};

/// How many samples the curves have together.
std::size_t sample_count(const CurveScene& curves);

/// Whether a scene file says that it is one of these.
bool is_surface(std::string_view text);

/// `text` is the JSON, `file` its name in messages. Of a function its samples remain. Throws Refused.
Surface read_surface(std::string_view text, const std::string& file);

/// The surface as JSON on one line, sample by sample, the same bytes each time; read_surface gives the same surface again.
std::string surface_json(const Surface& surface);

}  // namespace vidno
