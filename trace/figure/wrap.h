/// Breaks a line of text or of a listing where a reader expects it.
#pragma once

#include <string>
#include <vector>

namespace vidno::figures {

/// The lines of a text, each as wide as `width` in millimetres at most, the first as `first_width`; a longer word
/// remains whole. There are few lines, and they end after a semicolon, a comma or a colon rather than elsewhere; hardly
/// after a preposition, in a list of names or in brackets; and beside an operator only if nothing else fits.
std::vector<std::string> wrapped(const std::string& text, double size, double width, double first_width);

}  // namespace vidno::figures
