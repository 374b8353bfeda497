#include "find/until.h"

#include <algorithm>
#include <concepts>

#include "find/measures.h"
#include "refused.h"

namespace vidno {

namespace {

/// Thrown to end a run.
struct Met {};

}  // namespace

std::optional<std::uint64_t> events_until(const std::string& text, RunRequest request) {
    const Condition condition(text);
    expect_suits(condition, request.method);
    std::vector<double> values;
    for (const Name& name : condition.names()) {
        const auto& choice = name.choice();
        if (!choice.grows && !choice.of_scene) {
            throw Refused("--until " + text + ": " + name.text() + " is known only once the run has ended");
        }
        values.push_back(choice.of_scene ? of_scene(name, request.scene) : 0);
    }
    RunCounts counts;
    std::uint64_t events = 0;
    FunctionSink sink([&](const EventView& event) {
        counts.hear(event);
        if (event.visit([](const auto& e) { return event::level_of(e); }) <= request.detail) ++events;
        for (std::size_t i = 0; i < values.size(); ++i) {
            const Name& name = condition.names()[i];
            if (name.choice().grows) values[i] = counts.of(name);
        }
        if (condition.is_met(values)) throw Met{};
    });
    RunRequest counted = request;
    counted.detail = Detail::signs;
    counted.sink = &sink;
    try {
        traced_run(counted);
    } catch (const Met&) {
        return events;
    }
    return std::nullopt;
}

}  // namespace vidno
