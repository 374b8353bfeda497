#include "say/verdict.h"

#include <algorithm>

#include "say/words.h"

namespace vidno::say {

namespace {

constexpr Plurals step_forms{{"step", "", "steps"}, {"шаг", "шага", "шагов"}};

/// Whether a right colour may be that of a wrong polygon.
bool shares_colors(const Scene& scene) {
    std::vector<Color> colors{scene.background};
    for (const auto& polygon : scene.polygons) {
        if (std::find(colors.begin(), colors.end(), polygon.color) != colors.end()) return true;
        colors.push_back(polygon.color);
    }
    return false;
}

/// What is said of each kind of comparison, where nothing is known of it or not yet.
std::string unknown(Comparison::Is is, const Words& words) {
    return is == Comparison::Is::awaited
               ? words.say("being compared with exact arithmetic", "идёт сверка с точной арифметикой")
               : words.say("not compared with exact arithmetic", "с точной арифметикой не сверено");
}

std::string compared(const TraceHeader& header, const Comparison& comparison, const Words& words) {
    if (comparison.is != Comparison::Is::known) return unknown(comparison.is, words);
    if (comparison.wrong == 0) {
        return shares_colors(header.scene)
                   ? words.say("all colours as in exact arithmetic", "все цвета — как в точной арифметике")
                   : words.say("all as in exact arithmetic", "все как в точной арифметике");
    }
    const std::string wrong = std::to_string(comparison.wrong);
    const std::string_view differ = comparison.wrong == 1 ? "differs" : "differ";
    // The arithmetic of a text that is not the corrected one may be right.
    return header.edition == Edition::corrected
               ? words.say("{0} {1} from exact arithmetic", "не как в точной арифметике: {0}", wrong, differ)
               : words.say("{0} {1} from the correct picture", "не как в правильном изображении: {0}", wrong, differ);
}

std::string compared(const FloatingHorizonHeader& header, const Comparison& comparison, const Words& words) {
    if (comparison.is != Comparison::Is::known) return unknown(comparison.is, words);
    if (comparison.wrong > 0) {
        return words.say("wrong decisions at {1}", "шагов с неверными решениями: {0}", std::to_string(comparison.wrong),
                         words.counted((long long)(comparison.wrong), step_forms));
    }
    // The picture of a text that is not the corrected one may be wrong nevertheless.
    return header.edition == Edition::corrected
               ? words.say("every decision as in exact arithmetic", "все решения как в точной арифметике")
               : words.say("every decision as in exact arithmetic, but this is not the corrected text",
                           "все решения как в точной арифметике, но текст не исправлен");
}

/// The first of these that the run has: "21 windows".
std::string work(const Tally& tally, const Words& words) {
    const auto count = [&](auto... places) {
        long long sum = 0;
        ((sum += (long long)(tally[places])), ...);
        return sum;
    };
    struct Counted {
        long long count;
        Plurals forms;
    };
    const Counted all[] = {
        {count(event_place<event::Pop>), {{"window", "", "windows"}, {"окно", "окна", "окон"}}},
        {count(event_place<event::Show>),
         {{"visible region", "", "visible regions"}, {"видимая область", "видимые области", "видимых областей"}}},
        {count(event_place<event::Curve>), {{"curve", "", "curves"}, {"кривая", "кривые", "кривых"}}},
        {count(event_place<event::Compare>, event_place<event::Pixel>, event_place<event::Behind>,
               event_place<event::Order>),
         {{"depth comparison", "", "depth comparisons"}, {"сравнение глубин", "сравнения глубин", "сравнений глубин"}}},
    };
    for (const auto& [n, forms] : all) {
        if (n > 0) return words.counted(n, forms);
    }
    return {};
}

std::vector<std::string> parts(const TraceHeader& header, const Tally& tally, const Comparison& comparison,
                               const Words& words) {
    const auto& area = header.scene.area;
    const std::string pixels = words.counted((long long)(area.width) * area.height, pixel_forms);
    return {pixels + ", " + compared(header, comparison, words), work(tally, words)};
}

std::vector<std::string> parts(const FloatingHorizonHeader& header, const Tally& tally, const Comparison& comparison,
                               const Words& words) {
    return {work(tally, words), compared(header, comparison, words)};
}

}  // namespace

std::string verdict(const AnyHeader& header, const Tally& tally, const Comparison& comparison, Language language) {
    const Words words(language);
    auto all = std::visit([&](const auto& of) { return parts(of, tally, comparison, words); }, header);
    std::erase(all, "");
    const std::string text = joined(all, "; ");
    return comparison.is == Comparison::Is::awaited ? words.say("Finished: {}…", "Готово: {}…", text)
                                                    : words.say("Finished: {}.", "Готово: {}.", text);
}

}  // namespace vidno::say
