/// The Warnock family in the page's library: told to a trace always, and never held against the truth, which would make the
/// library twice as large; live.cpp refuses to check it.

#include "run_family.h"

#include <cstdlib>

#include "check_family.h"
#include "vidno/kernels/bits.h"

namespace vidno {

namespace {

template <Kernel K>
Picture told(const RunRequest& request, const K& kernel) {
    Recording<TraceWriter> recording{request.detail, *request.writer};
    const Recorder<K, TraceWriter> recorder(recording);
    return family::with_set_of(request.method, [&]<class Set>(Set) {
        return render<Set>(request.method, request.scene, kernel, recorder, request.smallest_window);
    });
}

}  // namespace

Picture run_family_float(const RunRequest& request) { return told(request, Float{}); }
Picture run_family_double(const RunRequest& request) { return told(request, Double{}); }
Picture run_family_bits(const RunRequest& request) { return told(request, Bits(request.kernel.parameter)); }
Picture run_family_filtered(const RunRequest& request) { return told(request, Filtered{}); }
Picture run_family_grid(const RunRequest& request) { return told(request, Grid(request.kernel.parameter)); }
Picture run_family_exact(const RunRequest& request) { return told(request, Exact{}); }

Picture told_family(const RunRequest&, const Checked<Float>&, const HearEvent&) { std::abort(); }
Picture told_family(const RunRequest&, const Checked<Double>&, const HearEvent&) { std::abort(); }
Picture told_family(const RunRequest&, const Checked<Bits>&, const HearEvent&) { std::abort(); }
Picture told_family(const RunRequest&, const FilteredBy<StageTally>&, const HearEvent&) { std::abort(); }
Picture told_family(const RunRequest&, const Grid&, const HearEvent&) { std::abort(); }
Picture told_family(const RunRequest&, const Exact&, const HearEvent&) { std::abort(); }

}  // namespace vidno
