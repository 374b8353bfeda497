/// Need: how little of a scene suffices for the same picture.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "vidno/admitted.h"

namespace vidno {

/// How much of one thing the picture needs, and the pixel that becomes wrong with one less.
struct Need {
    std::string what;       // "polygons"
    std::string amount;     // "2 of 5"
    std::string one_lower;  // "without \"B\" pixel (4, 4) is #ffffff, not #1f77b4"; empty if nothing is lower
};

struct NeedReport {
    std::vector<Need> needs;
    AdmittedScene least;  // with the polygons and vertices that are needed
};

/// The picture is that of the picture rule. The function first leaves out polygons and vertices, and then tests
/// everything else on the remaining scene, one thing at a time. `progress` is called at each picture.
NeedReport needs_of(const AdmittedScene& scene, const std::function<void()>& progress);

}  // namespace vidno
