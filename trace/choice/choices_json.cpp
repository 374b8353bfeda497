#include "choice/choices_json.h"

#include <nlohmann/json.hpp>

#include "choice/kernel_choice.h"
#include "choice/method.h"
#include "choice/palette.h"
#include "json/document_format.h"
#include "json/json_text.h"

namespace vidno {

namespace {

using Json = nlohmann::ordered_json;

/// The named editions of a method, each with the kernels that run it according to `runs`.
Json editions_of(auto&& runs) {
    Json editions;
    for (const auto& named : named_editions) {
        Json kernels = Json::array();
        for (const auto& kernel : kernel_choices) {
            if (runs(kernel, named.edition)) kernels.push_back(kernel.name);
        }
        if (!kernels.empty()) editions[std::string(named.name)] = kernels;
    }
    return editions;
}

Json json_of(const Bilingual& text) { return object_of<Json>(text); }

Json method_json(const MethodChoice& choice, std::string_view reference, const Json& editions) {
    return {{"does", choice.does},          {"title", json_of(choice.title)},
            {"says", json_of(choice.says)}, {"procedure", procedure_names[std::size_t(choice.procedure)]},
            {"domain", choice.rule.domain}, {"rule", choice.rule.rule},
            {"reference", reference},       {"cutsAnywhere", choice.cuts_anywhere},
            {"editions", editions}};
}

Json kernel_json(const KernelChoice& choice) {
    Json kernel{{"rule", choice.rule},
                {"says", json_of(choice.says)},
                {"alwaysRight", choice.is_always_right},
                {"snaps", choice.snaps}};
    if (choice.parameter) {
        const auto [letter, least, most, offered, if_not_said] = *choice.parameter;
        kernel["parameter"] = {
            {"letter", std::string(1, letter)}, {"least", least}, {"most", most}, {"offered", offered}};
    }
    return kernel;
}

Json deviation_json(const DeviationChoice& choice) {
    Json deviation{{"title", json_of(choice.title)}, {"says", json_of(choice.says)}};
    if (!choice.defect.empty()) deviation["defect"] = choice.defect;
    for (std::size_t i = 0; i < choice.lines.size(); ++i) {
        deviation["lines"].push_back(line_names[std::size_t(choice.lines[i])]);
        if (!choice.mistake.empty()) deviation["reads"].push_back(json_of(choice.reads[i]));
    }
    for (const Method method : choice.methods) deviation["methods"].push_back(method_names[std::size_t(method)]);
    if (choice.methods.empty()) deviation["methods"].push_back(floating_horizon_method);
    deviation["witness"] = choice.witness;
    return deviation;
}

}  // namespace

std::string choices_json() {
    Json methods, kernels, editions, all_deviations;
    for (std::size_t i = 0; i < method_choices.size(); ++i) {
        methods[std::string(method_names[i])] = method_json(
            method_choices[i], method_names[std::size_t(reference_of(Method(i)))],
            editions_of([i](const KernelChoice& kernel, Edition edition) { return kernel.runs(Method(i), edition); }));
    }
    methods[std::string(floating_horizon_method)] = method_json(
        floating_horizon_choice, floating_horizon_method,
        editions_of([](const KernelChoice& kernel, Edition edition) { return kernel.runs_floating_horizon(edition); }));
    for (const auto& choice : kernel_choices) kernels[std::string(choice.name)] = kernel_json(choice);
    for (const auto& [edition, name, rule, title] : named_editions) {
        editions[std::string(name)] = {{"rule", rule}, {"title", json_of(title)}, {"isMistake", is_mistake(edition)}};
    }
    for (std::size_t i = 0; i < deviations.size(); ++i) {
        all_deviations[name_of(Deviation(i))] = deviation_json(deviations[i]);
    }
    Json colors = Json::array();
    for (const Color& color : palette) colors.push_back(hex_of(color));
    return Json{{"methods", methods},
                {"kernels", kernels},
                {"editions", editions},
                {"deviations", all_deviations},
                {"palette", colors}}
               .dump(2) +
           "\n";
}

std::string format_words_json() {
    const auto& [other, newer, older] = english_format_words;
    const auto& russian = russian_format_words;
    const Json words{{"other", json_of({other, russian.other})},
                     {"newer", json_of({newer, russian.newer})},
                     {"older", json_of({older, russian.older})}};
    return words.dump() + "\n";
}

std::string witnesses_json(const std::function<std::string(std::string_view)>& read) {
    Json witnesses;
    for (std::size_t i = 0; i < deviations.size(); ++i) {
        const Json entry = Json::parse(read(deviations[i].witness));
        const Json& fails = entry.at("fails");
        witnesses[name_of(Deviation(i))] = {{"method", fails.at("method")},
                                            {"kernel", fails.at("kernel")},
                                            {"title", entry.at("title")},
                                            {"scene", entry.at("scene")}};
    }
    return witnesses.dump() + "\n";
}

}  // namespace vidno
