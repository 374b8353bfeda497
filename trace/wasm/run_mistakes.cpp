/// The usual mistakes are not in the page's library, which they would make larger by half: live.cpp refuses to run them.

#include "run_mistakes.h"

#include <cstdlib>

namespace vidno {

Picture run_mistake(const RunRequest&) { std::abort(); }
Picture told_mistake(const RunRequest&, const Exact&, const Hear&) { std::abort(); }
Picture told_mistake(const RunRequest&, const Checked<Double>&, const Hear&) { std::abort(); }

}  // namespace vidno
