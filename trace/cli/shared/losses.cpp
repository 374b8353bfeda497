#include "cli/shared/losses.h"

#include <algorithm>
#include <iostream>

#include "counted.h"

namespace vidno::cli {

namespace {

constexpr std::size_t most_listed = 40;  // of a file

}  // namespace

void Losses::add(const std::string& file, const std::vector<Loss>& losses) {
    say(file, losses);
    any_ = any_ || !losses.empty();
}

void Losses::note(const std::string& file, const std::vector<Loss>& without_effect, const std::string& reason) {
    say(file, without_effect);
    messages_.push_back(file + ": " + reason);
}

void Losses::say(const std::string& file, const std::vector<Loss>& losses) {
    for (std::size_t i = 0; i < std::min(losses.size(), most_listed); ++i) {
        const auto& [what, where] = losses[i];
        messages_.push_back(file + ": " + where + (where.empty() ? "" : ": ") + what);
    }
    if (losses.size() <= most_listed) return;
    messages_.push_back(file + ": " + counted(losses.size() - most_listed, "more loss", "more losses"));
}

void Losses::add(TraceFile& trace) {
    const std::vector<Loss> of_run = trace.losses();
    trace.skip_rest();
    add(trace.file(), of_run);
    if (const auto lack = trace.lacks()) add(trace.place(), {*lack});
}

int Losses::report() const {
    for (const auto& message : messages_) std::cerr << message << '\n';
    return any() ? 1 : 0;
}

}  // namespace vidno::cli
