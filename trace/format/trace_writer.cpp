#include "format/trace_writer.h"

#include "format/sha256.h"
#include "picture/image.h"
#include "scene/scene_json.h"

namespace vidno {

std::string header_json(const TraceHeader& header) {
    std::string text = R"({"format":"vidno-trace/1","method":")";
    text += method_names[std::size_t(header.method)];
    text += R"(","edition":")";
    text += name_of(header.edition);
    text += R"(","kernel":")" + header.kernel + R"(","detail":")";
    text += detail_names[std::size_t(header.detail)];
    text += R"(","scene":)" + scene_json(header.scene) + "}\n";
    return text;
}

std::string hash_text(std::string_view bytes) {
    std::string text = "sha256:";
    for (const unsigned char byte : sha256(bytes)) {
        text += "0123456789abcdef"[byte / 16];
        text += "0123456789abcdef"[byte % 16];
    }
    return text;
}

std::string picture_hash(const Picture& picture) { return hash_text(rgb_rows(picture)); }

TraceWriter::TraceWriter(std::string_view first_line, PolygonNames names, std::string_view kernel, Write write,
                         std::uint64_t most_events)
    : lines_(std::move(names)), losses_(kernel), write_(std::move(write)), most_events_(most_events) {
    text_ += first_line;
}

void TraceWriter::hear(const EventView& event) {
    if (events_ == most_events_) throw EventLimitReached{};
    ++events_;
    lines_.line(text_, event);
    losses_.hear(event);
    if (text_.size() > block) flush();
}

void TraceWriter::finish(std::string_view result, const std::string& hash) {
    finish_with('"' + std::string(result) + R"(":")" + hash + '"');
}

void TraceWriter::finish_partial() { finish_with(R"("partial":true)"); }

void TraceWriter::finish_with(std::string_view rest) {
    text_ += std::string_view(R"({"end":{"events":)");
    append_integer(text_, events_);
    text_ += ',';
    text_ += rest;
    text_ += std::string_view("}}\n");
    flush();
}

void TraceWriter::flush() {
    write_(text_.view());
    text_.clear();
}

}  // namespace vidno
