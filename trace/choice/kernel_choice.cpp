#include "choice/kernel_choice.h"

#include <algorithm>
#include <charconv>
#include <vector>

namespace vidno {

namespace {

/// The whole text as a number.
std::optional<int> whole_number(std::string_view text) {
    int number = 0;
    const auto [end, error] = std::from_chars(text.begin(), text.end(), number);
    if (error != std::errc{} || end != text.end()) return std::nullopt;
    return number;
}

}  // namespace

std::string NamedKernel::name() const {
    std::string name(choice->name);
    if (choice->parameter) name += ":" + std::to_string(parameter);
    return name;
}

std::optional<NamedKernel> kernel_named(std::string_view name) {
    const auto colon = name.find(':');
    const auto choice = std::find_if(kernel_choices.begin(), kernel_choices.end(),
                                     [&](const auto& each) { return each.name == name.substr(0, colon); });
    if (choice == kernel_choices.end() || (colon != name.npos && !choice->parameter)) return std::nullopt;
    if (!choice->parameter) return NamedKernel{choice};
    const auto [letter, least, most, offered, if_not_said] = *choice->parameter;
    const auto parameter = colon == name.npos ? if_not_said : whole_number(name.substr(colon + 1));
    if (!parameter || *parameter < least || *parameter > most) return std::nullopt;
    return NamedKernel{choice, *parameter};
}

bool is_always_right(std::string_view kernel) {
    const auto named = kernel_named(kernel);
    return named && named->is_always_right();
}

NamedKernel kernel_of(KernelKind kind) { return kernel_named(kernel_choices[std::size_t(kind)].name).value(); }

std::string kernel_names() {
    std::string names;
    for (const auto& choice : kernel_choices) {
        if (!names.empty()) names += ", ";
        names += choice.name;
        if (const auto& parameter = choice.parameter) {
            names += std::string(":") + parameter->letter + " (" + std::to_string(parameter->least) +
                     " <= " + parameter->letter + " <= " + std::to_string(parameter->most) + ")";
        }
    }
    return names;
}

std::string kernels_that(bool KernelChoice::*can, bool it) {
    std::vector<std::string_view> found;
    for (const auto& choice : kernel_choices) {
        if (choice.*can == it) found.push_back(choice.name);
    }
    std::string names;
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (i > 0) names += i + 1 == found.size() ? " and " : ", ";
        names += found[i];
    }
    return names;
}

}  // namespace vidno
