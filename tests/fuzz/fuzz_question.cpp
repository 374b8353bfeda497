/// Fuzz target: any bytes as a question file are refused, or give a question whose places all differ.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "refused.h"
#include "sign_map/question_json.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    vidno::Question question;
    try {
        question = vidno::read_question(text, "fuzz.json");
    } catch (const vidno::Refused&) {
        return 0;
    }
    for (int i = 1; i < vidno::Question::side; ++i) {
        const auto before = question.place(i - 1, i - 1);
        const auto place = question.place(i, i);
        if (!(before.x < place.x && before.y < place.y)) std::abort();
    }
    return 0;
}
