/// StateText: the building blocks of the JSON of every state.
#pragma once

#include <utility>

#include "format/event_text.h"
#include "replay/call_stack.h"

namespace vidno {

/// Each function appends one value.
class StateText {
protected:
    void null() { out_ += "null"; }
    void boolean(bool value) { out_ += value ? "true" : "false"; }

    void list(const auto& items, auto&& append) {
        out_ += '[';
        bool first = true;
        for (const auto& item : items) {
            if (!std::exchange(first, false)) out_ += ',';
            append(item);
        }
        out_ += ']';
    }
    void optional(const auto& value, auto&& append) { value ? append(*value) : null(); }

    void number(const Value& v) { v.fraction ? append_string(out_, *v.fraction) : shortest_.append(out_, v.number); }
    void integer(int value) { append_integer(out_, value); }

    void loops(const RegionLoops& region) {
        list(region, [this](const auto& loop) {
            list(loop, [this](const ValuePoint& p) {
                list(std::array{p.x, p.y}, [this](const Value& coordinate) { number(coordinate); });
            });
        });
    }

    /// The beginning of every state: `{"step":N,"calls":[...]`.
    void begin(const auto& state) {
        out_ += "{\"step\":";
        append_integer(out_, state.step());
        out_ += ",\"calls\":";
        list(state.calls(), [this](const auto& frame) { call(frame); });
    }

    Text out_;

private:
    void call(const CallStack::Frame& frame) {
        out_ += "{\"of\":\"";
        out_ += procedure_names[std::size_t(frame.of)];
        out_ += "\",\"at\":";
        optional(frame.at, [this](Line at) { append_string(out_, line_names[std::size_t(at)]); });
        out_ += '}';
    }

    RememberedShortest shortest_;
};

}  // namespace vidno
