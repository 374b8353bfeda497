/// The run that a command executes: its options on the command line, and refusals.
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

/// Options that are not given are taken from the failure, if the file is one; otherwise the help states the defaults.
struct RunOptions {
    std::string scene;
    std::optional<std::string> method, kernel, edition;
    std::string detail = "signs";

    std::string kernel_name() const { return kernel.value_or("double"); }
    std::string edition_name() const { return edition.value_or("corrected"); }
};

/// The names in CLI11's form.
std::vector<std::string> words(const auto& names) { return {names.begin(), names.end()}; }

/// The methods for polygons, and the one for curves.
std::vector<std::string> all_methods();

CLI::Validator a_kernel();
CLI::Validator an_edition();
/// CLI11's check of a range would print its bounds, of hundreds of digits.
CLI::Validator a_count();

/// Adds the scene and all options of its run except the detail. `scene` and `method` are their help texts.
void add_run_options(CLI::App& command, RunOptions& options, const std::string& scene, const std::string& method,
                     const std::vector<std::string>& methods);
/// Adds them where the scene may be of polygons or of curves.
void add_any_run_options(CLI::App& command, RunOptions& options);

/// The index of a name that the command line has checked.
std::size_t place_in(const auto& names, const std::string& name) {
    return std::size_t(std::find(names.begin(), names.end(), name) - names.begin());
}

/// The method for polygons.
inline Method method_of(const RunOptions& options) { return method_named(options.method.value_or("warnock")); }
inline Edition edition_of(const RunOptions& options) { return *edition_named(options.edition_name()); }
inline Detail detail_of(const RunOptions& options) { return Detail(place_in(detail_names, options.detail)); }

/// The kernel of the options, if it runs their method and edition.
NamedKernel kernel_of(const RunOptions& options);

RunRequest request_of(const RunOptions& options, const NamedKernel& kernel, const AdmittedScene& scene);
/// Refuses a kernel or an edition that does not run curves.
FloatingHorizonRequest request_of(const RunOptions& options, const Surface& surface);

/// Refuses a method or an edition that the kernel does not run.
void expect_run(const NamedKernel& kernel, Method method, Edition edition);

/// Refuses a kernel or an edition that does not run curves.
void expect_floating_horizon_run(const NamedKernel& kernel, Edition edition);

/// Refuses a scene outside the method's domain.
void expect_admitted(Method method, const Scene& scene, const std::string& file);

}  // namespace vidno::cli
