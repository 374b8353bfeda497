/// Checks that the quick readers and the tree readers agree: for every text that a quick reader accepts, both give the
/// same result.
#pragma once

#include <string>

#include "format/quick_event.h"
#include "scene/quick_scene.h"
#include "scene/scene_json.h"

namespace vidno::test {

struct Agreement {
    bool is_quick = false;  // the quick reader took it
    bool agrees = true;
};

inline Agreement agreement_on_event(const std::string& line, const EventContext& context, const PolygonNames& names) {
    EventText text(names);
    const auto written = [&](const EventView& event) {
        Text out;
        text.line(out, event);
        return out.string();
    };
    QuickEvents quick(context);
    const auto read = quick.read(line);
    if (!read) return {};
    try {
        const auto tree = parse_json(line);
        return {true, written(*read) == written(read_event(JsonNode(tree), context))};
    } catch (const Refused&) {
        return {true, false};
    }
}

inline Agreement agreement_on_scene(std::string_view text) {
    const auto read = read_quickly(text);
    if (!read) return {};
    try {
        const auto tree = parse_json(text);
        return {true, *read == read_scene(JsonNode(tree), "").scene};
    } catch (const Refused&) {
        return {true, false};
    }
}

}  // namespace vidno::test
