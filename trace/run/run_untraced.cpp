#include <utility>

#include "run/untraced.h"

namespace vidno {

namespace {

/// The functions by which a kernel runs without a trace; none if it does not run these methods.
struct Runs {
    Picture (*course)(const RunRequest&);
    Picture (*family)(const RunRequest&) = nullptr;
    Picture (*weiler_atherton)(const RunRequest&) = nullptr;
    DrawnLines (*floating_horizon)(const FloatingHorizonRequest&) = nullptr;
};

template <KernelKind kind>
constexpr Runs runs_under() {
    constexpr const KernelChoice& choice = kernel_choices[std::size_t(kind)];
    using Under = Untraced<kind>;
    Runs runs{&Under::course};
    if constexpr (choice.runs_family) runs.family = &Under::family;
    if constexpr (choice.constructs_points) runs.weiler_atherton = &Under::weiler_atherton;
    if constexpr (choice.runs_floating_horizon(Edition::corrected)) runs.floating_horizon = &Under::floating_horizon;
    return runs;
}

template <std::size_t... kinds>
constexpr std::array<Runs, sizeof...(kinds)> runs_of(std::index_sequence<kinds...>) {
    return {runs_under<KernelKind(kinds)>()...};
}

/// Indexed by KernelKind.
constexpr auto runs = runs_of(std::make_index_sequence<kernel_choices.size()>());

}  // namespace

Picture untraced_run(const RunRequest& request) {
    const Runs& kernel = runs[std::size_t(request.kernel.kind())];
    switch (algorithm_of(request.method)) {
        case Algorithm::warnock: return is_family(request.method) ? kernel.family(request) : kernel.course(request);
        case Algorithm::z_buffer: return kernel.course(request);
        case Algorithm::weiler_atherton: return kernel.weiler_atherton(request);
    }
    std::abort();
}

DrawnLines untraced_run(const FloatingHorizonRequest& request) {
    return runs[std::size_t(request.kernel.kind())].floating_horizon(request);
}

}  // namespace vidno
