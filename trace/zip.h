/// Zip: an archive of files in memory.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vidno {

/// The files, by their names in ASCII, compressed. All have the same date, so that the same files give the same bytes.
/// Throws Refused if the archive would be larger than 2 GB.
std::string zipped(const std::vector<std::pair<std::string_view, std::string_view>>& files);

}  // namespace vidno
