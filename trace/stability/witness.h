/// Witness: the smallest scene of a family on which a method fails under a kernel, as a failure that opens in the page.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "stability/stability.h"

namespace vidno {

/// Of the trials of a campaign that move coordinates, the first after which the method paints a pixel wrong, or draws a column of a
/// curve wrong, shrunk: the text of a file `vidno-failure/1`. None if no trial does. `method` and `kernel` are names that the campaign
/// has; `progress` is called at each scene that is run.
std::optional<std::string> witness(const Campaign& campaign, const Family& family, const std::string& method,
                                   const std::string& kernel, const std::function<void()>& progress);

}  // namespace vidno
