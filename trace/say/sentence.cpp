#include "say/sentence.h"

#include "say/tables.h"

namespace vidno::say {

namespace {

/// `x ≈ 0.3`, not `x = ≈0.3`.
std::string without_doubled_signs(std::string text) {
    constexpr std::string_view doubled = "= ≈", single = "≈ ";
    for (auto at = text.find(doubled); at != text.npos; at = text.find(doubled, at)) {
        text.replace(at, doubled.size(), single);
    }
    return text;
}

std::string of_algorithm(const EventView& event, const PolygonWords& words) {
    switch (algorithm_of(words.header().method)) {
        case Algorithm::warnock: return warnock_sentence(event, words);
        case Algorithm::z_buffer: return z_buffer_sentence(event, words);
        case Algorithm::weiler_atherton: return weiler_atherton_sentence(event, words);
    }
    return {};
}

std::string of_algorithm(const EventView& event, const CurveWords& words) {
    return floating_horizon_sentence(event, words);
}

std::string note_of_algorithm(const EventView& event, const PolygonWords& words) {
    switch (algorithm_of(words.header().method)) {
        case Algorithm::warnock: return warnock_note(event, words);
        case Algorithm::z_buffer: return z_buffer_note(event, words);
        case Algorithm::weiler_atherton: return weiler_atherton_note(event, words);
    }
    return {};
}

Statement sentence_with(const EventView& event, const auto& words) {
    auto exact = exactly(event, words);
    if (exact) exact->text = without_doubled_signs(std::move(exact->text));
    return stated(without_doubled_signs(of_algorithm(event, words)), exact, words);
}

}  // namespace

Statement sentence(const EventView& event, const State& after, Language language) {
    return sentence_with(event, PolygonWords(after, language));
}

Statement sentence(const EventView& event, const FloatingHorizonState& after, Language language) {
    return sentence_with(event, CurveWords(after, language));
}

std::string note(const EventView& event, const State& run, Language language) {
    return without_doubled_signs(note_of_algorithm(event, PolygonWords(run, language)));
}

std::string note(const EventView& event, const FloatingHorizonState& run, Language language) {
    return without_doubled_signs(floating_horizon_note(event, CurveWords(run, language)));
}

bool has_note(std::size_t event) {
    return noted_by_warnock[event] || noted_by_z_buffer[event] || noted_by_weiler_atherton[event] ||
           noted_by_floating_horizon[event];
}

}  // namespace vidno::say
