/// Which run a command makes: how it is said on the command line, and what is refused.
#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "run/floating_horizon_run.h"
#include "run/run.h"
#include "scene/surface.h"

namespace vidno::cli {

/// What is not said is that of the failure, if the file is one; else as the help of the options says.
struct RunOptions {
    std::string scene;
    std::optional<std::string> method, kernel, edition;
    std::string detail = "signs";

    std::string kernel_name() const { return kernel.value_or("double"); }
    std::string edition_name() const { return edition.value_or("corrected"); }
};

/// The names as CLI11 takes them.
std::vector<std::string> words(const auto& names) { return {names.begin(), names.end()}; }

/// The methods of polygons, and that of curves.
std::vector<std::string> all_methods();

CLI::Validator a_kernel();
CLI::Validator an_edition();

/// The scene, and everything of its run but the detail. `scene` and `method` are the help for these.
void add_run_options(CLI::App& command, RunOptions& options, const std::string& scene, const std::string& method,
                     const std::vector<std::string>& methods);
/// The same where the scene may be of polygons or of curves.
void add_any_run_options(CLI::App& command, RunOptions& options);

/// The place of a name that the command line has checked.
std::size_t place_in(const auto& names, const std::string& name) {
    return std::size_t(std::find(names.begin(), names.end(), name) - names.begin());
}

/// Of polygons.
inline Method method_of(const RunOptions& options) {
    return Method(place_in(method_names, options.method.value_or("warnock")));
}
inline Edition edition_of(const RunOptions& options) { return *edition_named(options.edition_name()); }
inline Detail detail_of(const RunOptions& options) { return Detail(place_in(detail_names, options.detail)); }

/// The kernel of the options, if it runs their method and edition.
NamedKernel kernel_of(const RunOptions& options);

RunRequest request_of(const RunOptions& options, const NamedKernel& kernel, const Scene& scene);
/// Refuses a kernel or an edition that does not run curves.
FloatingHorizonRequest request_of(const RunOptions& options, const Surface& surface);

/// Refuses a method or an edition that the kernel does not run.
void expect_run(const NamedKernel& kernel, Method method, Edition edition);

/// Refuses a kernel or an edition that does not run curves.
void expect_floating_horizon_run(const NamedKernel& kernel, Edition edition);

/// Refuses a scene outside the method's domain.
void expect_admitted(Method method, const Scene& scene, const std::string& file);

}  // namespace vidno::cli
