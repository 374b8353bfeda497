/// Fuzz target: the reader of decision files refuses any bytes or returns a decision whose places all differ.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "refused.h"
#include "sign_map/mapped_decision_json.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    vidno::MappedDecision decision;
    try {
        decision = vidno::read_mapped_decision(text, "fuzz.json");
    } catch (const vidno::Refused&) {
        return 0;
    }
    for (int i = 1; i < vidno::MappedDecision::side; ++i) {
        const auto before = decision.place(i - 1, i - 1);
        const auto place = decision.place(i, i);
        if (!(before.x < place.x && before.y < place.y)) std::abort();
    }
    return 0;
}
