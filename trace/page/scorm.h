/// Scorm: a page as a package for a learning management system.
#pragma once

#include <string>

namespace vidno {

/// A package of SCORM 1.2: a zip of the page and of a manifest, which has the title and how many answered questions
/// complete it.
std::string scorm_package(const std::string& page, const std::string& title, int questions);

}  // namespace vidno
