#include "format/floating_horizon_trace.h"

#include "format/trace_writer.h"

namespace vidno {

std::string header_json(const FloatingHorizonHeader& header) {
    std::string text = R"({"format":"vidno-trace/1","method":")";
    text += floating_horizon_method;
    text += R"(","edition":")";
    text += name_of(header.edition);
    text += R"(","kernel":")" + header.kernel + R"(","detail":")";
    text += detail_names[std::size_t(header.detail)];
    text += R"(","scene":)" + surface_json(header.scene) + "}\n";
    return text;
}

std::string lines_hash(const DrawnLines& lines) {
    Text text;
    EventText numbers({});
    const auto point = [&](const Point<Value>& p) {
        text += ",[";
        numbers.value(text, p.x);
        text += ',';
        numbers.value(text, p.y);
        text += ']';
    };
    for (const auto& line : lines) {
        text += '[';
        append_integer(text, line.segment.curve);
        point(line.from.point);
        point(line.to.point);
        text += std::string_view("]\n");
    }
    return hash_text(text.view());
}

}  // namespace vidno
