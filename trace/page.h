/// Page: the built pages that come with the program.
#pragma once

#include <string>

namespace vidno {

/// The page that shows a chart, with the chart in it. Throws Refused if no page was built.
std::string chart_page(const std::string& json);

}  // namespace vidno
