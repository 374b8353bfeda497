#include "choice/choices_json.h"

#include <nlohmann/json.hpp>

#include "choice/kernel_choice.h"
#include "choice/method.h"
#include "choice/palette.h"
#include "json/json_text.h"

namespace vidno {

namespace {

using Json = nlohmann::ordered_json;

/// The editions of a method, each with the kernels under which `runs` says that it runs.
Json editions_of(auto&& runs) {
    Json editions;
    for (std::size_t i = 0; i < edition_choices.size(); ++i) {
        Json kernels = Json::array();
        for (const auto& kernel : kernel_choices) {
            if (runs(kernel, Edition(i))) kernels.push_back(kernel.name);
        }
        if (!kernels.empty()) editions[std::string(edition_names[i])] = kernels;
    }
    return editions;
}

Json json_of(const Bilingual& text) { return {{"en", text.english}, {"ru", text.russian}}; }

Json method_json(const MethodChoice& choice, const Json& editions) {
    return {{"does", choice.does},          {"title", json_of(choice.title)}, {"says", json_of(choice.says)},
            {"domain", choice.rule.domain}, {"rule", choice.rule.rule},       {"editions", editions}};
}

Json kernel_json(const KernelChoice& choice) {
    Json kernel{{"rule", choice.rule}, {"alwaysRight", choice.is_always_right}, {"snaps", choice.snaps}};
    if (choice.parameter) {
        const auto [letter, least, most, offered, if_not_said] = *choice.parameter;
        kernel["parameter"] = {
            {"letter", std::string(1, letter)}, {"least", least}, {"most", most}, {"offered", offered}};
    }
    return kernel;
}

}  // namespace

std::string choices_json() {
    Json methods, kernels, editions;
    for (std::size_t i = 0; i < method_choices.size(); ++i) {
        methods[std::string(method_names[i])] = method_json(
            method_choices[i],
            editions_of([i](const KernelChoice& kernel, Edition edition) { return kernel.runs(Method(i), edition); }));
    }
    methods[std::string(floating_horizon_method)] = method_json(
        floating_horizon_choice,
        editions_of([](const KernelChoice& kernel, Edition edition) { return kernel.runs_floating_horizon(edition); }));
    for (const auto& choice : kernel_choices) kernels[std::string(choice.name)] = kernel_json(choice);
    for (std::size_t i = 0; i < edition_choices.size(); ++i) {
        editions[std::string(edition_names[i])] = {{"rule", edition_choices[i].rule},
                                                   {"title", json_of(edition_choices[i].title)},
                                                   {"isMistake", is_mistake(Edition(i))}};
    }
    Json colors = Json::array();
    for (const Color& color : palette) {
        Text hex;
        append_hex(hex, color);
        colors.push_back(hex.string());
    }
    return Json{{"methods", methods}, {"kernels", kernels}, {"editions", editions}, {"palette", colors}}.dump(2) + "\n";
}

}  // namespace vidno
