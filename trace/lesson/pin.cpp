#include "pin.h"

namespace vidno {

using nlohmann::json;

namespace {

/// Most lines have another event than the one searched for; the name is enough to skip them without reading the rest.
bool may_match(std::string_view line, const json& pattern) {
    const auto kind = pattern.find("e");
    return kind == pattern.end() || line.starts_with(R"({"e":)" + kind->dump() + ",");
}

bool has_fields(const json& event, const json& fields) {
    for (const auto& [key, value] : fields.items()) {
        const auto field = event.find(key);
        if (field == event.end() || *field != value) return false;
    }
    return true;
}

bool matches(std::string_view line, const json& pattern) {
    return may_match(line, pattern) && has_fields(json::parse(line), pattern);
}

}  // namespace

void PinSearch::hear(std::uint64_t step, std::string_view line) {
    const auto& path = pin_->find;
    if (pin_->times && matches(line, path.back())) ++times_;
    if (found_ == path.size() || !matches(line, path[found_])) return;
    last_step_ = step;
    if (++found_ < path.size()) return;
    step_ = step;
    event_ = json::parse(line);
}

std::string PinSearch::objection() const {
    if (!step_) {
        const std::string where = found_ == 0 ? "in the run" : "after step " + std::to_string(last_step_);
        return "there is no " + pin_->find[found_].dump() + ' ' + where;
    }
    for (const auto& [key, value] : pin_->says.items()) {
        const auto field = event_.find(key);
        const std::string is = field == event_.end() ? "nothing" : field->dump();
        if (field == event_.end() || *field != value) {
            return "step " + std::to_string(*step_) + " says " + is + " of " + key + ", not " + value.dump();
        }
    }
    if (pin_->times && times_ != *pin_->times) {
        return "there are " + std::to_string(times_) + ", not " + std::to_string(*pin_->times);
    }
    return "";
}

}  // namespace vidno
