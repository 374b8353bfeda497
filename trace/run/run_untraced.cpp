#include "run/untraced.h"

namespace vidno {

namespace {

/// The units that run a kernel without a trace; none where it does not run these methods.
struct Units {
    Picture (*course)(const RunRequest&);
    Picture (*family)(const RunRequest&);
    Picture (*regions)(const RunRequest&);
};

/// By the places of KernelKind.
constexpr std::array<Units, kernel_choices.size()> units{{
    {untraced_float, untraced_family_float, untraced_regions_float},
    {untraced_double, untraced_family_double, untraced_regions_double},
    {untraced_bits, untraced_family_bits, untraced_regions_bits},
    {untraced_depth, nullptr, nullptr},
    {untraced_filtered, untraced_family_filtered, untraced_regions_filtered},
    {untraced_grid, untraced_family_grid, nullptr},
    {untraced_exact, untraced_family_exact, untraced_regions_exact},
}};

}  // namespace

Picture untraced_run(const RunRequest& request) {
    const Units& of = units[std::size_t(request.kernel.kind())];
    if (request.method == Method::weiler_atherton) return of.regions(request);
    return is_family(request.method) ? of.family(request) : of.course(request);
}

}  // namespace vidno
