/// The titles of methods in figures and worksheets.
#pragma once

#include <string>

#include "choice/method.h"

namespace vidno::figures {

/// The title of a method; a variant of Warnock's algorithm has its own title behind it.
inline std::string title_of(Method method, Language language) {
    if (!is_family(method)) return std::string(choice_of(method).title.in(language));
    return std::string(choice_of(Method::warnock).title.in(language)) + " (" +
           std::string(choice_of(method).title.in(language)) + ")";
}

}  // namespace vidno::figures
