#include "run.h"

#include <stdexcept>

#include "untraced.h"

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

/// The usual mistakes are compiled for recorded runs only.
Picture untraced_mistake(RunRequest request) {
    HeardBy sink([&](const EventView& event) {
        if (event.get_if<event::Pop>() || event.get_if<event::Polygon>()) request.progress();
    });
    request.detail = Detail::windows;
    request.sink = &sink;
    return told_run(request);
}

}  // namespace

Picture run(const RunRequest& request) {
    if (!request.kernel.choice->runs(request.method, request.edition)) {
        throw std::invalid_argument(request.kernel.name() + " does not run this method in this edition");
    }
    if (request.sink) return told_run(request);
    if (is_mistake(request.edition)) return untraced_mistake(request);
    const Units& of = units[std::size_t(request.kernel.kind())];
    if (request.method == Method::weiler_atherton) return of.regions(request);
    return is_family(request.method) ? of.family(request) : of.course(request);
}

}  // namespace vidno
