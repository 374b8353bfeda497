/// The Warnock family is not in the page's library, which it would make much larger: live.cpp refuses to run it.

#include <cstdlib>

#include "check_family.h"
#include "method.h"

namespace vidno {

Picture run_family_float(const RunRequest&) { std::abort(); }
Picture run_family_double(const RunRequest&) { std::abort(); }
Picture run_family_bits(const RunRequest&) { std::abort(); }
Picture run_family_filtered(const RunRequest&) { std::abort(); }
Picture run_family_grid(const RunRequest&) { std::abort(); }
Picture run_family_exact(const RunRequest&) { std::abort(); }
Picture told_family(const RunRequest&, const Checked<Float>&, const HearEvent&) { std::abort(); }
Picture told_family(const RunRequest&, const Checked<Double>&, const HearEvent&) { std::abort(); }
Picture told_family(const RunRequest&, const Checked<Bits>&, const HearEvent&) { std::abort(); }
Picture told_family(const RunRequest&, const FilteredBy<StageTally>&, const HearEvent&) { std::abort(); }
Picture told_family(const RunRequest&, const Grid&, const HearEvent&) { std::abort(); }
Picture told_family(const RunRequest&, const Exact&, const HearEvent&) { std::abort(); }
std::optional<std::string> refuses_bodies(const Scene&) { std::abort(); }

}  // namespace vidno
