/// The choices as JSON, for `vidno methods --json` and the page.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace vidno {

///     {"methods": {NAME: {does, title, says, procedure, domain, rule, reference, cutsAnywhere,
///                         editions: {NAME: [KERNEL, ...]}}},
///      "kernels": {NAME: {rule, says, alwaysRight, snaps, parameter?: {letter, least, most, offered}}},
///      "editions": {NAME: {rule, title, isMistake}},
///      "deviations": {EDITION: {title, says, defect?, lines, reads?, methods, witness}}}
///
/// `procedure` is the one that runs first; `reference` is the method that paints the same under an always right kernel.
/// The editions of a method are those that have a text, each with the kernels that run it. A single defect,
/// `printed:x-w1`, runs where `printed` does. `title`, `says` and each of `reads` are {"en": TEXT, "ru": TEXT}; `reads`
/// are the `lines` as a usual mistake writes them; `offered` are the numbers that the page offers; `witness` is a file
/// of lessons/failures.
std::string choices_json();

/// {"other": WORDS, "newer": WORDS, "older": WORDS}, each {"en": TEXT, "ru": TEXT}: what is said of a file of another
/// format or version.
std::string format_words_json();

/// {EDITION: {method, kernel, title, scene}}: for each deviation the smallest scene that shows it, and the run that
/// does. `read` gives the text of a witness, a file of lessons/failures.
std::string witnesses_json(const std::function<std::string(std::string_view witness)>& read);

}  // namespace vidno
