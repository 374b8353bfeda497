/// Pin: a name for a step of a run. It is found by what happens there, so it survives changes in earlier steps.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vidno {

struct Pin {
    std::string name, run;
    int line = 1;  // of lesson.json, where it stands
    /// A path of partial events: the first event with the first fields, then the first one after it with the next
    /// fields, ...
    std::vector<nlohmann::json> find;
    nlohmann::json says = nlohmann::json::object();  // further fields that the last event must have
    std::optional<std::uint64_t> times;              // how many events of the whole run are like the last one
};

/// Follows a run, and finds the step of a pin.
class PinSearch {
public:
    explicit PinSearch(const Pin& pin) : pin_(&pin) {}

    /// Hears a line of the trace, and its step.
    void hear(std::uint64_t step, std::string_view line);

    const Pin& pin() const { return *pin_; }

    /// Call it after the last line: the step; none if the run has no such step.
    std::optional<std::uint64_t> step() const { return step_; }
    /// How the run differs from the pin; empty if it does not.
    std::string objection() const;

private:
    const Pin* pin_;
    std::size_t found_ = 0;  // of the path
    std::uint64_t last_step_ = 0;
    std::optional<std::uint64_t> step_;
    nlohmann::json event_;
    std::uint64_t times_ = 0;
};

}  // namespace vidno
