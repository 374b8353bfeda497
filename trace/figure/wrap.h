/// Breaks a line of text or of a listing where a reader expects it.
#pragma once

#include <string>
#include <vector>

namespace vidno::figures {

/// The pieces of a text, each as wide as `width` in millimetres at most, the first as `first_width`; a longer word remains whole.
/// A piece preferably ends after a semicolon, a comma or a colon. It rarely ends within brackets, and beside an
/// operator only if nothing else fits.
std::vector<std::string> wrapped(const std::string& text, double size, double width, double first_width);

}  // namespace vidno::figures
