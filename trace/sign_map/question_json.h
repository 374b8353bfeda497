/// Question files, `vidno-question/1`: reading with every rule checked. lessons/maps/README.md says what they hold.
#pragma once

#include <string>
#include <string_view>

#include "sign_map/question.h"

namespace vidno {

/// `text` is the JSON, `file` its name in messages. Throws Refused.
Question read_question(std::string_view text, const std::string& file);

}  // namespace vidno
