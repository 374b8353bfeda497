#include <iostream>

#include "choice/choices_json.h"
#include "choice/kernel_choice.h"
#include "choice/method.h"
#include "cli/commands.h"

namespace vidno::cli {

namespace {

void print(std::string_view name, const MethodChoice& choice) {
    std::cout << "  " << name << std::string(18 - name.size(), ' ') << choice.does;
    if (choice.rule.domain != picture_rule.domain) std::cout << "; domain: " << choice.rule.domain;
    if (choice.rule.rule != picture_rule.rule) std::cout << "; rule: " << choice.rule.rule;
    std::cout << '\n';
}

/// The lines and methods of the deviation.
void print_place(const DeviationChoice& choice) {
    std::string_view before = "; ";
    for (const Line line : choice.lines) {
        std::cout << before << line_names[std::size_t(line)];
        before = ", ";
    }
    before = " of ";
    for (const Method method : choice.methods) {
        std::cout << before << method_names[std::size_t(method)];
        before = " and ";
    }
    if (choice.methods.empty()) std::cout << before << floating_horizon_method;
}

int print_methods(bool as_json) {
    if (as_json) {
        std::cout << choices_json();
        return 0;
    }
    std::cout << "methods    (unless stated otherwise, domain: " << picture_rule.domain
              << ";\n    rule: " << picture_rule.rule << ")\n";
    for (std::size_t i = 0; i < method_choices.size(); ++i) print(method_names[i], method_choices[i]);
    print(floating_horizon_method, floating_horizon_choice);
    std::cout << "kernels    (the arithmetic; warnock-... not under " << kernels_that(&KernelChoice::runs_family, false)
              << ",\n            weiler-atherton and floating-horizon not under "
              << kernels_that(&KernelChoice::constructs_points, false) << ")\n";
    for (const auto& kernel : kernel_choices) {
        std::string name(kernel.name);
        if (kernel.parameter) (name += ':') += kernel.parameter->letter;
        std::cout << "  " << name << std::string(11 - name.size(), ' ') << kernel.rule << '\n';
    }
    std::cout << "editions    (from the third on with one usual mistake, under "
              << kernels_that(&KernelChoice::runs_mistakes) << ")\n";
    for (const auto& [edition, name, rule, title] : named_editions) {
        std::cout << "  " << name << std::string(21 - name.size(), ' ') << rule;
        if (const auto mistake = single_deviation(edition)) print_place(choice_of(*mistake));
        std::cout << '\n';
    }
    std::cout << "single defects of the printed text    (--edition printed:x-w2+x-w4 has two of them)\n";
    for (const auto& choice : deviations) {
        if (choice.defect.empty()) continue;
        std::cout << "  " << choice.defect << std::string(21 - choice.defect.size(), ' ') << choice.says.english;
        print_place(choice);
        std::cout << '\n';
    }
    std::cout << "levels of detail (each adds events to the one before)\n"
                 "  windows    windows, cases and fills; polygons, scanlines and painted runs; lists and regions\n"
                 "  polygons   relations, corner depths and clips; the active edge list and stored depths\n"
                 "  signs      every orientation test and every depth comparison\n";
    return 0;
}

}  // namespace

void add_methods(CLI::App& program, int& status) {
    auto& command = *program.add_subcommand("methods", "List the methods, kernels, editions and levels of detail");
    const auto as_json = std::make_shared<bool>();
    command.add_flag("--json", *as_json, "As JSON: also which edition of which method runs under which kernel");
    command.callback([as_json, &status] { status = print_methods(*as_json); });
}

}  // namespace vidno::cli
