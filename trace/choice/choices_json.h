/// The choices as JSON, for `vidno methods --json` and the page.
#pragma once

#include <string>

namespace vidno {

/// {"methods": {NAME: {does, domain, rule, editions: {NAME: [KERNEL, ...]}}}, "kernels": {NAME: {rule, alwaysRight, parameter?: {letter,
/// least, most}}}, "editions": {NAME: {rule, isMistake}}}: the editions of a method are those of which there is a text, each with the
/// kernels under which it runs.
std::string choices_json();

}  // namespace vidno
