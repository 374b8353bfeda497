/// The choices as JSON, for `vidno methods --json` and the page.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace vidno {

/// {"methods": {NAME: {does, title, says, domain, rule, editions: {NAME: [KERNEL, ...]}}},
/// "kernels": {NAME: {rule, alwaysRight, snaps, parameter?: {letter, least, most, offered}}}, "editions": {NAME: {rule, title, isMistake}},
/// "deviations": {EDITION: {title, says, defect?, lines, methods, witness}}}.
/// The editions of a method are those of which there is a text, each with the kernels under which it runs. A
/// single defect, `printed:x-w1`, runs where `printed` does. `title` and `says` are {"en": TEXT, "ru": TEXT}; `offered` are the numbers
/// that the page offers; `witness` is a file of lessons/failures.
std::string choices_json();

/// {EDITION: {method, kernel, title, scene}}: of each deviation the smallest scene that shows it, and the run that does. `read` gives the
/// text of a witness, a file of lessons/failures.
std::string witnesses_json(const std::function<std::string(std::string_view witness)>& read);

}  // namespace vidno
