#include "run/untraced.h"

namespace vidno {

namespace {

/// The units that run a kernel without a trace; none where it does not run these methods.
struct Units {
    Picture (*course)(const RunRequest&);
    Picture (*family)(const RunRequest&);
    Picture (*weiler_atherton)(const RunRequest&);
};

/// By the places of KernelKind.
constexpr std::array<Units, kernel_choices.size()> units{{
    {untraced_float, untraced_family_float, untraced_weiler_atherton_float},
    {untraced_double, untraced_family_double, untraced_weiler_atherton_double},
    {untraced_bits, untraced_family_bits, untraced_weiler_atherton_bits},
    {untraced_depth, nullptr, nullptr},
    {untraced_filtered, untraced_family_filtered, untraced_weiler_atherton_filtered},
    {untraced_grid, untraced_family_grid, nullptr},
    {untraced_exact, untraced_family_exact, untraced_weiler_atherton_exact},
}};

}  // namespace

Picture untraced_run(const RunRequest& request) {
    const Units& of = units[std::size_t(request.kernel.kind())];
    if (request.method == Method::weiler_atherton) return of.weiler_atherton(request);
    return is_family(request.method) ? of.family(request) : of.course(request);
}

}  // namespace vidno
