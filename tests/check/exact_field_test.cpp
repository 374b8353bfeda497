// FORMAT.md: which events have `exact` in a checked trace. It names them; each of them has it under every kernel and
// method.

#include <doctest/doctest.h>

#include <map>
#include <set>
#include <sstream>

#include "check/checked_trace.h"
#include "choice/method.h"
#include "support/scenes.h"

using namespace vidno;
using namespace vidno::test;

namespace {

std::string name_in(const std::string& line) {
    const auto from = line.find("{\"e\":\"") + 6;
    return line.substr(from, line.find('"', from) - from);
}

/// In FORMAT.md.
const std::set<std::string> decisions{"box",     "compare", "insider",    "orient", "clip_sign", "row",
                                      "columns", "pixel",   "visibility", "behind", "order"};

}  // namespace

TEST_CASE("A checked trace has `exact` at each decision that FORMAT.md names, and nowhere else") {
    std::map<std::string, std::size_t> seen;
    RandomPolygons random(std::mt19937(9));
    for (int trial = 0; trial < 24 / thinning; ++trial) {
        const AdmittedScene scene = random_scene(families[std::size_t(trial) % families.size()], random);
        for (std::size_t place = 0; place < method_names.size(); ++place) {
            const auto method = Method(place);
            if (refusal_of(method, scene)) continue;
            for (const std::string kernel : {"float", "double", "bits:24", "filtered", "exact"}) {
                const NamedKernel named = *kernel_named(kernel);
                if (!named.choice->runs(method, Edition::corrected)) continue;
                std::ostringstream text;
                TraceWriter writer(TraceHeader{method, Edition::corrected, kernel, Detail::signs, scene},
                                   [&](std::string_view part) { text << part; });
                write_checked_trace({method, named, Edition::corrected, scene, Detail::signs}, writer);
                std::istringstream lines(text.str());
                std::string line;
                std::getline(lines, line);  // the header
                while (std::getline(lines, line)) {
                    if (line.starts_with("{\"end\"")) break;
                    const std::string name = name_in(line);
                    if (name == "disagree") continue;
                    const bool has_exact = line.find(",\"exact\":") != std::string::npos;
                    if (has_exact != (decisions.count(name) > 0)) {
                        FAIL_CHECK(method_names[place], " under ", kernel, ": ", line);
                    }
                    seen[name] += has_exact ? 1 : 0;
                }
            }
        }
    }
    for (const auto& name : decisions) {
        CAPTURE(name);
        if (name != "visibility") CHECK(seen[name] > 0);  // of curves
    }
}
