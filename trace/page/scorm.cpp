#include "page/scorm.h"

#include "characters.h"
#include "format/sha256.h"
#include "zip.h"

namespace vidno {

namespace {

/// A name for the package that no other page has.
std::string identifier_of(const std::string& page) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string name = "vidno-";
    for (const unsigned char byte : sha256(page)) name.append({digits[byte >> 4], digits[byte & 15]});
    return name;
}

/// Moodle's database has room for 255 characters.
std::string shortened(const std::string& title) {
    constexpr std::size_t most = 200;
    const auto characters = characters_of(title);
    if (characters.size() <= most) return title;
    std::string text;
    for (const char32_t c : characters.substr(0, most - 1)) text += utf8(c);
    return text + "\u2026";
}

// It names no schema: a package must then contain it, and no system needs it.
std::string manifest(const std::string& identifier, const std::string& title, int questions) {
    const std::string name = "<title>" + escaped_for_xml(shortened(title)) + "</title>";
    return R"(<?xml version="1.0" encoding="UTF-8"?>
<manifest identifier=")" +
           identifier + R"(" version="1.0" xmlns="http://www.imsproject.org/xsd/imscp_rootv1p1p2"
          xmlns:adlcp="http://www.adlnet.org/xsd/adlcp_rootv1p2">
  <metadata>
    <schema>ADL SCORM</schema>
    <schemaversion>1.2</schemaversion>
  </metadata>
  <organizations default="course">
    <organization identifier="course">
      )" + name +
           R"(
      <item identifier="lesson" identifierref="page">
        )" +
           name + R"(
        <adlcp:datafromlms>)" +
           std::to_string(questions) + R"(</adlcp:datafromlms>
      </item>
    </organization>
  </organizations>
  <resources>
    <resource identifier="page" type="webcontent" adlcp:scormtype="sco" href="index.html">
      <file href="index.html"/>
    </resource>
  </resources>
</manifest>
)";
}

}  // namespace

std::string scorm_package(const std::string& page, const std::string& title, int questions) {
    const std::string described = manifest(identifier_of(page), title, questions);
    return zipped({{"imsmanifest.xml", described}, {"index.html", page}});
}

}  // namespace vidno
