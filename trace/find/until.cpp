#include "find/until.h"

#include <vector>

#include "choice/method.h"
#include "find/measures.h"
#include "refused.h"

namespace vidno {

namespace {

/// Hears a run at level `signs`, and passes on what the request's level reports.
class UntilMet final : public EventSink {
public:
    UntilMet(const std::string& text, std::string_view method, const auto& request, TraceWriter& writer)
        : condition_(text), level_(request.detail), writer_(writer) {
        expect_suits(condition_, method);
        for (const Name& name : condition_.names()) {
            const auto& choice = name.choice();
            if (!choice.grows && !choice.of_scene) {
                throw Refused("--until " + text + ": " + name.text() + " is known only once the run has ended");
            }
            values_.push_back(choice.of_scene ? of_scene(name, request.scene) : 0);
        }
    }

    void hear(const EventView& event) override {
        if (event.visit([](const auto& e) { return event::level_of(e); }) <= level_) writer_.hear(event);
        counts_.hear(event);
        for (std::size_t i = 0; i < values_.size(); ++i) {
            const Name& name = condition_.names()[i];
            if (name.choice().grows) values_[i] = counts_.of(name);
        }
        if (condition_.is_met(values_)) throw EventLimitReached{};
    }

private:
    Condition condition_;
    Detail level_;
    TraceWriter& writer_;
    RunCounts counts_;
    std::vector<double> values_;  // of the names
};

bool written_until(const std::string& text, std::string_view method, auto request, TraceWriter& writer) {
    UntilMet until(text, method, request, writer);
    request.detail = Detail::signs;
    request.sink = &until;
    return write_run(writer, [&] { return run(request); });
}

}  // namespace

bool write_trace_until(const std::string& condition, const RunRequest& request, TraceWriter& writer) {
    return written_until(condition, method_names[std::size_t(request.method)], request, writer);
}

bool write_trace_until(const std::string& condition, const FloatingHorizonRequest& request, TraceWriter& writer) {
    return written_until(condition, floating_horizon_method, request, writer);
}

}  // namespace vidno
