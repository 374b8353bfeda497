/// Witness: the smallest scene of a family on which a method fails under a kernel, as a failure that opens in the page.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "stability/stability.h"

namespace vidno {

/// Finds the first trial of a campaign that moves coordinates so that the method paints a wrong pixel or draws a wrong column of a curve.
/// It is shrunk and returned as the text of a file `vidno-failure/1`; none if there is no such trial. `method` and `kernel` are names in
/// the campaign; `progress` is called at each scene that is run.
std::optional<std::string> witness(const Campaign& campaign, const Family& family, const std::string& method,
                                   const std::string& kernel, const std::function<void()>& progress);

}  // namespace vidno
