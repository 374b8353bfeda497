/// Witness: the smallest scene of a family on which a method fails under a kernel, as a failure that opens in the page.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "scene/surface.h"
#include "stability/campaign.h"

namespace vidno {

using Where = std::function<bool(const AnyScene&)>;

/// Takes the first failing trial, from `first` on, of an experiment that moves coordinates: the method paints a wrong
/// pixel, or draws a wrong column of a curve. Its scene is shrunk and returned as the text of a file `vidno-failure/1`;
/// none if there is no such trial. `method` and `kernel` are names in the campaign. The result must also
/// satisfy `where`, if that is not empty. `progress` is called at each scene that is run.
std::optional<std::string> witness(const Campaign& campaign, const Family& family, const Experiment& experiment,
                                   std::uint64_t first, const std::string& method, const std::string& kernel,
                                   const Where& where, const std::function<void()>& progress);

}  // namespace vidno
