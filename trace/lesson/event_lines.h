/// EventLines: splits a trace, as it is written, into the lines of its events.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace vidno {

class EventLines {
public:
    /// Calls `hear(step, line)` for each event that ends in this piece. The header and the last line are not events.
    void take(std::string_view text, auto&& hear) {
        rest_ += text;
        std::size_t begin = 0;
        for (auto end = rest_.find('\n'); end != rest_.npos; end = rest_.find('\n', begin)) {
            const std::string_view line(rest_.data() + begin, end - begin);
            if (line.starts_with(R"({"e":)")) hear(++step_, line);
            begin = end + 1;
        }
        rest_.erase(0, begin);
    }

private:
    std::string rest_;
    std::uint64_t step_ = 0;
};

}  // namespace vidno
