/// Pin: a name for a step of a run, which is found by what happens there and so outlives a change of the steps before.
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
    /// A path of partial events: the first event with these fields, then the first one after it with those, ...
    std::vector<nlohmann::json> find;
    nlohmann::json says = nlohmann::json::object();  // fields that the last one has besides
    std::optional<std::uint64_t> times;              // of the whole run's events, how many are like the last one
};

/// Follows a run, and finds where a pin stands.
class PinSearch {
public:
    explicit PinSearch(const Pin& pin) : pin_(&pin) {}

    /// A line of the trace, and the step that it is.
    void hear(std::uint64_t step, std::string_view line);

    const Pin& pin() const { return *pin_; }

    /// After the last line: the step, none if there is none.
    std::optional<std::uint64_t> step() const { return step_; }
    /// What is not as the pin says; empty if all is.
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
