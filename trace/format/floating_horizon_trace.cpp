#include "format/floating_horizon_trace.h"

#include "format/field_writer.h"
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
    RememberedShortest shortest;
    const PolygonNames names;
    FieldWriter<Text&> writer(text, names, shortest);
    for (const auto& [segment, from, to] : lines) {
        const auto point = [](const Point<Value>& p) { return ValuePoint{p.x, p.y}; };
        writer.value(std::tuple(segment.curve, point(from.point), point(to.point)));
        text += '\n';
    }
    return hash_text(text.view());
}

}  // namespace vidno
