/// The choices as JSON, for `vidno methods --json` and the page.
#pragma once

#include <string>

namespace vidno {

/// {"methods": {NAME: {does, title, says, domain, rule, editions: {NAME: [KERNEL, ...]}}},
/// "kernels": {NAME: {rule, alwaysRight, snaps, parameter?: {letter, least, most, offered}}}, "editions": {NAME: {rule, title, isMistake}}}.
/// The editions of a method are those of which there is a text, each with the kernels under which it runs. `title` and `says` are
/// {"en": TEXT, "ru": TEXT}; `offered` are the numbers that the page offers.
std::string choices_json();

}  // namespace vidno
