#include "cli/shared/run_options.h"

#include "choice/method.h"
#include "refused.h"

namespace vidno::cli {

std::vector<std::string> all_methods() {
    auto methods = words(method_names);
    methods.emplace_back(floating_horizon_method);
    return methods;
}

CLI::Validator a_kernel() {
    return CLI::Validator(
        [](const std::string& name) { return kernel_named(name) ? "" : name + " is not one of " + kernel_names(); },
        kernel_names());
}

CLI::Validator a_count() {
    return CLI::Validator(
        [](const std::string& text) {
            const bool is_count = text.find_first_not_of("0123456789") == text.npos;
            return is_count ? "" : text + " is not a whole number from 0";
        },
        "");
}

CLI::Validator an_edition() {
    return CLI::Validator(
        [](const std::string& name) {
            return edition_named(name) ? "" : name + " is not an edition: see vidno methods";
        },
        "");
}

void add_run_options(CLI::App& command, RunOptions& options, const std::string& scene, const std::string& method,
                     const std::vector<std::string>& methods) {
    command.add_option("SCENE", options.scene, scene)->required();
    command.add_option("--method", options.method, method)->check(CLI::IsMember(methods));
    command.add_option("--kernel", options.kernel, "The arithmetic [double]")->check(a_kernel());
    command.add_option("--edition", options.edition, "The text of the procedures; see vidno methods [corrected]")
        ->check(an_edition())
        ->type_name("EDITION");
}

void add_any_run_options(CLI::App& command, RunOptions& options) {
    add_run_options(
        command, options,
        "A scene file, vidno-scene/1 or vidno-surface/1; or a failure, vidno-failure/1, whose failing run is "
        "the default; - for standard input",
        "The algorithm [warnock; for a surface floating-horizon]", all_methods());
}

namespace {

/// Why there is no such text: the first deviation that does not concern the method.
Refused refused_text(Edition edition, auto&& concerns) {
    for (std::size_t i = 0; i < deviations.size(); ++i) {
        const auto& methods = deviations[i].methods;
        if (!edition.has(Deviation(i)) || concerns(methods)) continue;
        std::string text = "--edition " + name_of(edition) + ": ";
        text += is_mistake(edition) ? "a mistake" : std::string(deviations[i].defect) + " is a defect";
        std::string_view before = " of --method ";
        for (const Method method : methods) {
            (text += before) += method_names[std::size_t(method)];
            before = " and ";
        }
        if (methods.empty()) (text += before) += floating_horizon_method;
        return Refused(text + " alone");
    }
    return Refused("--edition " + name_of(edition) + ": this method has no such text");
}

/// Refuses an edition that the kernel does not run, for any method.
void expect_text(const NamedKernel& kernel, Edition edition) {
    const std::string refused = "--edition " + name_of(edition) + ": not under --kernel " + kernel.name();
    if (is_mistake(edition) && !kernel.choice->runs_mistakes) {
        throw Refused(refused + ", but under " + kernels_that(&KernelChoice::runs_mistakes));
    }
    if (edition != Edition::corrected && !kernel.choice->runs_printed) {
        throw Refused(refused + ", whose decisions are always right");
    }
}

}  // namespace

NamedKernel kernel_of(const RunOptions& options) {
    const NamedKernel kernel = *kernel_named(options.kernel_name());
    expect_run(kernel, method_of(options), edition_of(options));
    return kernel;
}

RunRequest request_of(const RunOptions& options, const NamedKernel& kernel, const AdmittedScene& scene) {
    return {method_of(options), kernel, edition_of(options), scene, detail_of(options)};
}

FloatingHorizonRequest request_of(const RunOptions& options, const Surface& surface) {
    const NamedKernel kernel = *kernel_named(options.kernel_name());
    expect_floating_horizon_run(kernel, edition_of(options));
    return {kernel, edition_of(options), surface.curves, detail_of(options)};
}

void expect_run(const NamedKernel& kernel, Method method, Edition edition) {
    const std::string named_method = "--method " + std::string(method_names[std::size_t(method)]);
    if (is_warnock(method) && !kernel.choice->runs_warnock) {
        throw Refused(named_method + ": not under --kernel " + kernel.name() + ", since it has no Z-buffer");
    }
    if (!is_of_course(method) && !kernel.choice->runs(method, Edition::corrected)) {
        throw Refused(named_method + ": not under --kernel " + kernel.name());
    }
    if (!has_text(edition, method)) {
        if (!is_of_course(method)) {
            const std::string_view mistakes = is_family(method) ? " and the mistakes of this method" : "";
            throw Refused(named_method + ": only --edition corrected" + std::string(mistakes));
        }
        throw refused_text(edition, [method](const auto& methods) {
            return std::find(methods.begin(), methods.end(), method) != methods.end();
        });
    }
    expect_text(kernel, edition);
}

void expect_floating_horizon_run(const NamedKernel& kernel, Edition edition) {
    if (kernel.choice->runs_floating_horizon(edition)) return;
    if (!has_text_of_curves(edition)) {
        throw refused_text(edition, [](const auto& methods) { return methods.empty(); });
    }
    expect_text(kernel, edition);
    throw Refused("--kernel " + kernel.name() + ": only for polygons");
}

void expect_admitted(Method method, const Scene& scene, const std::string& file) {
    const auto reason = refusal_of(method, scene);
    if (!reason) return;
    throw Refused(file + ": --method " + std::string(method_names[std::size_t(method)]) + " takes " +
                  std::string(choice_of(method).rule.domain) + ": " + *reason);
}

}  // namespace vidno::cli
